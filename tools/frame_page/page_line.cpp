#include "tools/frame_page/page_line.h"

#include <fmt/format.h>
#include <array>
#include <cmath>
#include <stdexcept>

#include "runtime/vision/vision_limits.h"
#include "tools/frame_page/page_block.h"

namespace aspect {
namespace {

using Json = nlohmann::json;

struct LineFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

double number_in(const Json& object, const char* key, int digits = 6) {
  const double number = object.at(key).get<double>();
  if (!std::isfinite(number)) throw LineFault(fmt::format("{} is not finite", key));
  return with_digits(number, digits);
}

std::int64_t whole_in(const Json& object, const char* key, std::int64_t most) {
  const Json& value = object.at(key);
  if (!value.is_number_integer()) throw LineFault(fmt::format("{} is no whole number", key));
  const auto number = value.get<std::int64_t>();
  if (number < 0 || number > most)
    throw LineFault(fmt::format("{} is not within 0 and {}", key, most));
  return number;
}

Json numbers_in(const Json& object, const char* key, std::size_t count, int digits) {
  const Json& list = object.at(key);
  if (!list.is_array() || list.size() != count)
    throw LineFault(fmt::format("{} does not have {} numbers", key, count));
  Json numbers = Json::array();
  for (const Json& number : list) numbers.push_back(with_digits(number.get<double>(), digits));
  return numbers;
}

template <typename Value>
void copy(const Json& from, const char* key, Json& to) {
  if (from.contains(key)) to[key] = from.at(key).get<Value>();
}

void copy_number(const Json& from, const char* key, Json& to, int digits = 4) {
  if (from.contains(key)) to[key] = number_in(from, key, digits);
}

// The first kPageRows of a list, one by one; how many there are beyond goes to KEY_more.
template <typename Row>
void copy_rows(const Json& from, const char* key, Json& to, Row row) {
  const Json& list = from.at(key);
  if (!list.is_array()) throw LineFault(fmt::format("{} is no list", key));
  Json& rows = to[key] = Json::array();
  for (const Json& entry : list) {
    if (rows.size() == kPageRows) break;
    rows.push_back(row(entry));
  }
  if (list.size() > kPageRows) to[std::string(key) + "_more"] = list.size() - kPageRows;
}

constexpr std::int64_t kMostNumber = 1'000'000;

Json contour_row(const Json& entry) {
  Json row = {{"contour", whole_in(entry, "contour", kMostNumber)}};
  row["name"] = entry.at("name").get<std::string>();
  row["surfaces"] = entry.at("surfaces").get<std::vector<int>>();
  row["colour"] = numbers_in(entry, "colour", 3, 3);
  return row;
}

Json missing_row(const Json& entry) {
  Json row = {{"colour", numbers_in(entry, "colour", 3, 3)}};
  copy<std::string>(entry, "name", row);
  copy<std::vector<int>>(entry, "surfaces", row);
  copy_number(entry, "area_px", row);
  copy_number(entry, "covered", row, 3);
  return row;
}

Json contradiction_row(const Json& entry) {
  Json row = {{"contour", whole_in(entry, "contour", kMostNumber)}};
  row["colour"] = numbers_in(entry, "colour", 3, 3);
  if (entry.contains("drawn")) row["drawn"] = numbers_in(entry, "drawn", 3, 3);
  copy_number(entry, "area_px", row);
  return row;
}

void copy_seen(const Json& from, Json& to) {
  copy_rows(from, "contours", to, contour_row);
  copy_rows(from, "missing", to, missing_row);
  copy_rows(from, "contradicts", to, contradiction_row);
}

Json rival_of(const Json& from) {
  Json rival = {{"reason", from.at("reason").get<std::string>()}};
  copy<std::string>(from, "object", rival);
  for (const char* key : {"chosen", "on_shortlist"}) copy<bool>(from, key, rival);
  for (const char* key : {"matched", "needed", "class", "rank"})
    if (from.contains(key)) rival[key] = whole_in(from, key, kMostNumber);
  copy_number(from, "score", rival, 9);
  copy_number(from, "agreement", rival);
  copy_number(from, "least_cost", rival);
  if (from.contains("contours")) copy_seen(from, rival);
  return rival;
}

Json explanation_of(const Json& from) {
  Json explanation = Json::object();
  copy_seen(from, explanation);
  if (from.contains("expected")) explanation["expected"] = rival_of(from.at("expected"));
  if (from.contains("others"))
    for (const Json& other : from.at("others")) explanation["others"].push_back(rival_of(other));
  return explanation;
}

Json pose_of(const Json& from) {
  Json pose = {{"quaternion", numbers_in(from, "quaternion", 4, 7)},
               {"translation", numbers_in(from, "translation", 3, 7)}};
  copy_number(from, "reprojection_px", pose, 3);
  double length = 0;
  for (const Json& part : pose["quaternion"]) length += part.get<double>() * part.get<double>();
  if (!(std::abs(length - 1) < 1e-3)) throw LineFault("quaternion is no unit quaternion");
  constexpr double kFarthest = 1e12;
  for (const Json& part : pose["translation"])
    if (!(std::abs(part.get<double>()) < kFarthest)) throw LineFault("translation is too large");
  return pose;
}

RigidPose rigid_pose_of(const Json& pose) {
  const auto q = pose.at("quaternion").get<std::array<double, 4>>();
  return {{q[0], q[1], q[2], q[3]}, pose.at("translation").get<Vector3d>()};
}

Json hypothesis_of(const Json& from) {
  Json hypothesis = {{"object", from.at("object").get<std::string>()},
                     {"class", whole_in(from, "class", kMostNumber)},
                     {"score", number_in(from, "score", 9)},
                     {"view", numbers_in(from, "view", 3, 4)}};
  for (const char* key : {"matched", "unmatched"})
    hypothesis[key] = whole_in(from, key, kMostNumber);
  if (from.contains("pose")) hypothesis["pose"] = pose_of(from.at("pose"));
  Json& contours = hypothesis["contours"] = Json::array();
  for (const Json& match : from.at("contours"))
    contours.push_back({match.at(0).get<int>(), match.at(1).get<std::string>()});
  return hypothesis;
}

std::string verdict_in(const Json& object) {
  if (!object.contains("verdict")) return {};
  const auto verdict = object.at("verdict").get<std::string>();
  if (verdict != "match" && verdict != "ambiguous" && verdict != "unknown")
    throw LineFault("verdict is none of match, ambiguous, unknown");
  return verdict;
}

Json summary_of(const Json& object, const Json& hypotheses) {
  Json summary = {{"box", numbers_in(object, "box", 4, 6)},
                  {"regions", whole_in(object, "regions", kMostNumber)}};
  if (const std::string verdict = verdict_in(object); !verdict.empty())
    summary["verdict"] = verdict;
  if (object.contains("probability")) summary["p"] = number_in(object, "probability", 4);
  if (object.contains("track")) summary["track"] = whole_in(object, "track", UINT32_MAX);
  if (!hypotheses.empty())
    for (const char* key : {"object", "class", "score"}) summary[key] = hypotheses.front().at(key);
  return summary;
}

void add_object(const Json& object, PageLine& line) {
  const Json& list = object.at("hypotheses");
  if (!list.is_array()) throw LineFault("hypotheses is no list");
  Json details = {{"hypotheses", Json::array()}};
  for (const Json& hypothesis : list) {
    if (details["hypotheses"].size() == kPageHypotheses) break;
    details["hypotheses"].push_back(hypothesis_of(hypothesis));
  }
  if (object.contains("rivals")) details["rivals"] = object.at("rivals").get<std::vector<int>>();
  if (object.contains("explanation"))
    details["explanation"] = explanation_of(object.at("explanation"));
  const Json& hypotheses = details["hypotheses"];
  line.summary["objects"].push_back(summary_of(object, hypotheses));
  const std::string verdict = verdict_in(object);
  if (!hypotheses.empty() && hypotheses[0].contains("pose") &&
      (verdict == "match" || verdict == "ambiguous"))
    line.poses.push_back(
        {hypotheses[0].at("object").get<std::string>(), rigid_pose_of(hypotheses[0].at("pose"))});
  line.details["objects"].push_back(std::move(details));
}

PageLine read(const Json& json) {
  PageLine line;
  line.frame = json.at("frame").get<std::string>();
  line.sequence = static_cast<std::uint64_t>(whole_in(json, "sequence", INT64_MAX));
  line.width_px = static_cast<int>(whole_in(json, "width", kMaxFrameSide_px));
  line.height_px = static_cast<int>(whole_in(json, "height", kMaxFrameSide_px));
  line.summary = {{"name", line.frame},
                  {"n", line.sequence},
                  {"w", line.width_px},
                  {"h", line.height_px},
                  {"objects", Json::array()}};
  if (json.contains("elapsed_ms")) line.summary["ms"] = number_in(json, "elapsed_ms", 4);
  line.details = {{"objects", Json::array()}};
  if (json.contains("stages_ms"))
    for (const auto& [stage, time] : json.at("stages_ms").items())
      line.details["stages_ms"][stage] = with_digits(time.get<double>(), 3);
  if (json.contains("left_undone"))
    for (const auto& [what, count] : json.at("left_undone").items())
      line.details["left_undone"][what] = count.get<int>();
  for (const char* key : {"hypotheses_cut", "objects_cut"})
    if (json.contains(key)) line.details[key] = whole_in(json, key, kMostNumber);
  for (const Json& object : json.at("objects")) add_object(object, line);
  return line;
}

}  // namespace

Result<PageLine> read_page_line(std::string_view line, const std::string& where) {
  const auto fault = [&](std::string what) {
    // It quotes what was read, all of it.
    constexpr std::size_t kMostWords = 160;
    if (what.size() > kMostWords) what.resize(kMostWords);
    for (char& c : what)
      if (c < 0x20 || c > 0x7E) c = '?';  // half a character of UTF-8, too
    return Error{fmt::format("{}: not a line of aspect-replay ({}); give its output", where, what)};
  };
  if (line.size() > kMostLineBytes)
    return fault(fmt::format("longer than {} MiB", kMostLineBytes >> 20U));
  try {
    PageLine page_line = read(Json::parse(line));
    auto found = parse_results(line, where);
    if (!found) return Error{found.error()};
    page_line.found = std::move(found.value().at(0));
    return page_line;
  } catch (const Json::exception& error) {
    return fault(error.what());
  } catch (const LineFault& error) {
    return fault(error.what());
  }
}

}  // namespace aspect
