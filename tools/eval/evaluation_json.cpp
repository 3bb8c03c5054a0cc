#include "tools/eval/evaluation_json.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace aspect {
namespace {

using Json = nlohmann::ordered_json;

Json error_json(const ErrorSummary& error) {
  return {{"median", error.median_deg},
          {"mean", error.mean_deg},
          {"p90", error.p90_deg},
          {"percent_within_5", 100 * error.within_5},
          {"percent_within_10", 100 * error.within_10},
          {"percent_within_20", 100 * error.within_20}};
}

Json ranks_json(const std::array<double, kReportedRanks.size()>& shares) {
  Json json;
  for (std::size_t k = 0; k < shares.size(); ++k)
    json[fmt::format("{}", kReportedRanks[k])] = 100 * shares[k];
  return json;
}

Json object_json(const ObjectEvaluation& object) {
  Json json{{"object", object.object},
            {"index_bytes", object.index_bytes},
            {"classes", object.classes},
            {"area_fraction", object.area_fraction},
            {"rotations", object.rotations},
            {"percent_uncovered", 100 * object.uncovered_share},
            {"percent_nothing_found", 100 * object.nothing_found},
            {"percent_right", ranks_json(object.right)},
            {"percent_right_with_symmetry", ranks_json(object.right_with_symmetry)},
            {"view_error_deg", error_json(object.error)},
            {"elapsed_ms", {{"mean", object.mean_ms}, {"median", object.median_ms}}},
            {"views", Json::array()}};
  for (const ViewOutcome& outcome : object.outcomes)
    json["views"].push_back(
        {{"view", {outcome.direction.x(), outcome.direction.y(), outcome.direction.z()}},
         {"class", outcome.right_class},
         {"rank", outcome.rank},
         {"rank_with_symmetry", outcome.rank_with_symmetry},
         {"error_deg", outcome.error_deg},
         {"elapsed_ms", outcome.elapsed_ms}});
  return json;
}

Json confusion_json(const Evaluation& evaluation) {
  Json rows = Json::array();
  for (std::size_t truth = 0; truth < evaluation.objects.size(); ++truth) {
    Json found;
    const std::vector<int>& counts = evaluation.confusion->counts[truth];
    for (std::size_t k = 0; k < evaluation.objects.size(); ++k)
      found[evaluation.objects[k].object] = counts[k];
    rows.push_back({{"object", evaluation.objects[truth].object},
                    {"found", std::move(found)},
                    {"found_none", counts.back()},
                    {"view_error_deg", error_json(evaluation.confusion->error[truth])},
                    {"elapsed_ms", {{"median", evaluation.confusion->median_ms[truth]}}}});
  }
  return rows;
}

}  // namespace

std::string evaluation_json(const Evaluation& evaluation) {
  const EvaluationSettings& settings = evaluation.settings;
  const bool by_views = settings.ranking == RecogniserParameters::Ranking::views;
  Json json{{"views", settings.views},
            {"seed", settings.seed},
            {"matching", settings.matching == Matching::simple ? "simple" : "weighted"},
            {"ranking", by_views ? "views" : "classes"},
            {"objects", Json::array()}};
  for (const ObjectEvaluation& object : evaluation.objects)
    json["objects"].push_back(object_json(object));
  if (evaluation.confusion) json["confusion"] = confusion_json(evaluation);
  return json.dump(1) + "\n";
}

}  // namespace aspect
