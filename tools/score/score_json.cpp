#include "tools/score/score_json.h"

#include <nlohmann/json.hpp>

namespace aspect {
namespace {

using Json = nlohmann::ordered_json;

template <typename Value>
Json or_null(bool known, const Value& value) {
  return known ? Json(value) : Json(nullptr);
}

Json summary_json(const std::string& name, const ScoreSummary& summary) {
  const bool any = summary.objects > 0;
  return {{"object", name},
          {"number", summary.objects},
          {"right_percent", or_null(any, 100 * summary.right_share())},
          {"median_deg", or_null(any, summary.median_deg)},
          {"within_5_percent", or_null(any, 100 * summary.within_5)},
          {"within_10_percent", or_null(any, 100 * summary.within_10)},
          {"within_20_percent", or_null(any, 100 * summary.within_20)},
          {"median_ms", or_null(summary.median_ms.has_value(), summary.median_ms.value_or(0))}};
}

Json frame_json(const ScoredFrame& frame) {
  const bool timed = frame.line != nullptr && frame.line->elapsed_ms;
  Json objects = Json::array();
  for (const ScoredObject& object : frame.objects)
    objects.push_back({{"true", or_null(!object.truth.empty(), object.truth)},
                       {"found", or_null(!object.found.empty(), object.found)},
                       {"counts", object.counts},
                       {"right", object.right},
                       {"error_deg", or_null(object.right, object.error_deg)}});
  return {{"frame", frame.file},
          {"missing", frame.line == nullptr},
          {"ms", or_null(timed, timed ? *frame.line->elapsed_ms : 0)},
          {"objects", std::move(objects)}};
}

}  // namespace

std::string score_json(const Score& score, bool frames) {
  Json json{{"objects", Json::array()},
            {"all", summary_json("all", score.all)},
            {"frames", score.frames.size()},
            {"missing", score.missing},
            {"falsely_named", score.falsely_named}};
  for (const auto& [name, summary] : score.objects)
    json["objects"].push_back(summary_json(name, summary));
  if (frames)
    for (const ScoredFrame& frame : score.frames) json["table"].push_back(frame_json(frame));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace aspect
