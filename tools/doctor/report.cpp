#include "tools/doctor/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tools/command_line/terminal_colour.h"

namespace aspect {
namespace {

using Json = nlohmann::ordered_json;

std::string plural(std::size_t count, const char* word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

std::string severity_text(Severity severity, bool colours) {
  const std::string_view name = severity_name(severity);
  if (severity == Severity::note) return std::string(name);
  return toned(name, severity == Severity::error ? Tone::bad : Tone::doubtful, colours);
}

void add(const Diagnosis& diagnosis, bool colours, std::string& text) {
  text += fmt::format("{}: {} surfaces, {}, {}, {}\n", diagnosis.object, diagnosis.primitives,
                      plural(diagnosis.count(Severity::error), "error"),
                      plural(diagnosis.count(Severity::warning), "warning"),
                      plural(diagnosis.count(Severity::note), "note"));
  std::string_view group;
  for (const Finding& finding : diagnosis.findings) {
    if (finding.group != group) text += fmt::format("  {}\n", finding.group);
    group = finding.group;
    text += fmt::format("    {} {}: {}", severity_text(finding.severity, colours), finding.code,
                        finding.message);
    if (!finding.where.empty())
      text += fmt::format(
          " [at {}{}]", fmt::join(finding.where, ", "),
          finding.where.size() < finding.count && finding.where.size() == Finding::kMostPlaces
              ? ", ..."
              : "");
    if (!finding.names.empty()) text += fmt::format(" ({})", fmt::join(finding.names, ", "));
    text += fmt::format("; cure: {}\n", finding.cure);
  }
}

Json json_of(const Eigen::Vector3d& v) {
  return Json::array({v.x(), v.y(), v.z()});
}

Json json_of(const Diagnosis& diagnosis) {
  Json findings = Json::array();
  for (const Finding& finding : diagnosis.findings)
    findings.push_back({{"group", finding.group},
                        {"code", finding.code},
                        {"severity", severity_name(finding.severity)},
                        {"message", finding.message},
                        {"cure", finding.cure},
                        {"count", finding.count},
                        {"where", finding.where},
                        {"can_fix", finding.can_fix}});
  for (std::size_t k = 0; k < findings.size(); ++k)
    if (!diagnosis.findings[k].names.empty()) findings[k]["names"] = diagnosis.findings[k].names;
  return {{"object", diagnosis.object},
          {"surfaces", diagnosis.primitives},
          {"errors", diagnosis.count(Severity::error)},
          {"warnings", diagnosis.count(Severity::warning)},
          {"notes", diagnosis.count(Severity::note)},
          {"findings", findings}};
}

}  // namespace

bool DoctorReport::is_healthy() const {
  if (fix) return fix->left.is_healthy();
  return std::all_of(objects.begin(), objects.end(),
                     [](const Diagnosis& object) { return object.is_healthy(); });
}

std::string report_text(const DoctorReport& report, bool colours) {
  std::string text;
  for (const Diagnosis& object : report.objects) add(object, colours, text);
  for (const std::string& picture : report.pictures)
    text +=
        fmt::format("{}: written, as it is on the left, in merged colours on the right\n", picture);
  if (!report.fix) return text;
  text += fmt::format("{}: written\n", report.fix->output);
  for (const std::string& line : report.fix->done) text += fmt::format("    {}\n", line);
  for (const ColourMove& move : report.fix->moves)
    text += fmt::format(
        "    colour {:.4g} {:.4g} {:.4g} -> {:.4g} {:.4g} {:.4g}: separation {:.2f} -> {:.2f}\n",
        move.before.x(), move.before.y(), move.before.z(), move.after.x(), move.after.y(),
        move.after.z(), move.separation_before, move.separation_after);
  text += "after that ";
  add(report.fix->left, colours, text);
  return text;
}

std::string report_json(const DoctorReport& report) {
  Json json = {{"file", report.file}, {"objects", Json::array()}};
  for (const Diagnosis& object : report.objects) json["objects"].push_back(json_of(object));
  if (!report.pictures.empty()) json["pictures"] = report.pictures;
  if (report.fix) {
    Json moves = Json::array();
    for (const ColourMove& move : report.fix->moves)
      moves.push_back({{"before", json_of(move.before)},
                       {"after", json_of(move.after)},
                       {"separation_before", move.separation_before},
                       {"separation_after", move.separation_after}});
    json["fix"] = {{"output", report.fix->output},
                   {"done", report.fix->done},
                   {"colours", moves},
                   {"left", json_of(report.fix->left)}};
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace aspect
