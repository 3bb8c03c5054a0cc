#include "tools/doctor/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tools/command_line/terminal_colour.h"
#include "tools/doctor/finding_lines.h"

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

void add(const Diagnosis& diagnosis, bool colours, bool all, std::string& text) {
  const std::vector<FindingLine> lines = finding_lines(diagnosis, all);
  const auto count = [&](Severity severity) {
    return static_cast<std::size_t>(
        std::count_if(lines.begin(), lines.end(),
                      [&](const FindingLine& line) { return line.severity == severity; }));
  };
  text += fmt::format("{}: {} surfaces, {}, {}, {}\n", diagnosis.object, diagnosis.primitives,
                      plural(count(Severity::error), "error"),
                      plural(count(Severity::warning), "warning"),
                      plural(count(Severity::note), "note"));
  std::string_view group;
  for (const FindingLine& line : lines) {
    if (line.group != group) text += fmt::format("  {}\n", line.group);
    group = line.group;
    text += fmt::format("    {} {} {}: {}; cure: {}\n", line.label,
                        severity_text(line.severity, colours), line.code, line.text, line.cure);
  }
}

Json json_of(const Eigen::Vector3d& v) {
  return Json::array({v.x(), v.y(), v.z()});
}

Json json_of(const Diagnosis& diagnosis) {
  Json findings = Json::array();
  const std::vector<std::size_t> numbers = kind_numbers(diagnosis);
  for (const Finding& finding : diagnosis.findings)
    findings.push_back({{"number", numbers[findings.size()]},
                        {"group", finding.group},
                        {"code", finding.code},
                        {"severity", severity_name(finding.severity)},
                        {"message", finding.message},
                        {"cure", finding.cure},
                        {"count", finding.count},
                        {"where", finding.where},
                        {"can_fix", finding.can_fix}});
  for (std::size_t k = 0; k < findings.size(); ++k) {
    if (!diagnosis.findings[k].names.empty()) findings[k]["names"] = diagnosis.findings[k].names;
    for (const FindingExample& example : diagnosis.findings[k].examples)
      findings[k]["examples"].push_back(
          {{"message", example.message}, {"count", example.count}, {"where", example.where}});
  }
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

std::string report_text(const DoctorReport& report, bool colours, bool all) {
  std::string text;
  for (const Diagnosis& object : report.objects) add(object, colours, all, text);
  for (const DoctorReport::Shown& picture : report.pictures)
    text += fmt::format("{}: written, {}\n", picture.file, picture.what);
  if (!report.fix) return text;
  text += fmt::format("{}: written\n", report.fix->output);
  for (const std::string& line : report.fix->done) text += fmt::format("    {}\n", line);
  for (const ColourMove& move : report.fix->moves)
    text += fmt::format(
        "    colour {:.4g} {:.4g} {:.4g} -> {:.4g} {:.4g} {:.4g}: separation {:.2f} -> {:.2f}\n",
        move.before.x(), move.before.y(), move.before.z(), move.after.x(), move.after.y(),
        move.after.z(), move.separation_before, move.separation_after);
  text += "after that ";
  add(report.fix->left, colours, all, text);
  return text;
}

std::string report_json(const DoctorReport& report) {
  Json json = {{"file", report.file}, {"objects", Json::array()}};
  for (const Diagnosis& object : report.objects) json["objects"].push_back(json_of(object));
  for (const DoctorReport::Shown& picture : report.pictures)
    json["pictures"].push_back(picture.file);
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
