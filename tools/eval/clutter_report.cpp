#include "tools/eval/clutter_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tools/eval/evaluation_json.h"
#include "tools/score/scoring.h"

namespace aspect {
namespace {

using Json = nlohmann::ordered_json;

std::string range_name(const HiddenRange& range) {
  return fmt::format("{:.0f}-{:.0f}", 100 * range.from, 100 * range.to);
}

std::string percent(const Recall& recall) {
  const auto share = recall.share();
  return share ? fmt::format("{:.1f}", 100 * *share) : "-";
}

double a_frame(std::size_t count, std::size_t frames) {
  return static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(1, frames));
}

std::size_t name_width(const ClutterEvaluation& evaluation) {
  std::size_t width = 6;
  for (const ObjectClutter& object : evaluation.objects)
    width = std::max(width, object.object.size());
  return width;
}

std::string head(const ClutterEvaluation& evaluation) {
  const std::string behind =
      evaluation.backgrounds.empty()
          ? "coloured shapes"
          : fmt::format("pieces of {} pictures of {}", evaluation.pictures, evaluation.backgrounds);
  return fmt::format(
      "{} frames in clutter an object, one of four without it, seed {}, before {}, up to {:.0f} % "
      "hidden\n",
      evaluation.settings.views, evaluation.settings.seed, behind, 100 * evaluation.hidden_max);
}

std::string found_table(const ClutterEvaluation& evaluation, std::size_t width) {
  std::string text = fmt::format(
      "\nOf the frames with at least {:.0f} % of the object visible: those in which it is found, "
      "and the\nmedian error of its pose, modulo its rotations; names given to what is something "
      "else; time\n\n",
      100 * kLeastVisible);
  text += fmt::format("{:{}}  {:>6}  {:>5}  {:>8}  {:>9}  {:>7}  {:>6}  {:>13}  {:>14}  {:>9}\n",
                      "object", width, "frames", "found", "recall %", "turn deg", "place %", "px",
                      "false a frame", "false an empty", "median ms");
  for (const ObjectClutter& object : evaluation.objects) {
    text += fmt::format("{:{}}  {:>6}  {:>5}  {:>8}", object.object, width, object.recall.frames,
                        object.recall.found, percent(object.recall));
    if (object.pose)
      text +=
          fmt::format("  {:>9.2f}  {:>7.2f}  {:>6.2f}", object.pose->rotation_deg.median,
                      object.pose->translation_percent.median, object.pose->reprojection_px.median);
    else
      text += fmt::format("  {:>9}  {:>7}  {:>6}", "-", "-", "-");
    text += fmt::format("  {:>13.3f}  {:>14.3f}  {:>9.2f}\n",
                        a_frame(object.falsely_named, object.outcomes.size()),
                        a_frame(object.falsely_named_in_empty, object.empty), object.median_ms);
  }
  return text;
}

std::string hidden_table(const ClutterEvaluation& evaluation, std::size_t width) {
  std::string text =
      fmt::format("\nRecall in % (of frames) by the share hidden in %\n\n{:{}}", "object", width);
  for (const HiddenRange& range : kHiddenRanges) text += fmt::format("  {:>14}", range_name(range));
  text += "\n";
  for (const ObjectClutter& object : evaluation.objects) {
    text += fmt::format("{:{}}", object.object, width);
    for (const Recall& recall : object.by_hidden)
      text += fmt::format("  {:>14}", fmt::format("{} ({})", percent(recall), recall.frames));
    text += "\n";
  }
  return text;
}

Json recall_json(const Recall& recall) {
  const auto share = recall.share();
  return {{"frames", recall.frames},
          {"found", recall.found},
          {"percent", share ? Json(100 * *share) : Json()}};
}

Json outcomes_json(const std::vector<ClutterOutcome>& outcomes) {
  Json frames = Json::array();
  for (const ClutterOutcome& outcome : outcomes) {
    Json frame{{"object", outcome.has_object}};
    if (outcome.has_object) {
      frame["visible"] = outcome.visible;
      frame["found"] = outcome.found;
      frame["pose_error"] = pose_error_json(outcome.pose);
    }
    frame["falsely_named"] = outcome.falsely_named;
    frame["elapsed_ms"] = outcome.elapsed_ms;
    frames.push_back(std::move(frame));
  }
  return frames;
}

Json object_json(const ObjectClutter& object) {
  Json by_hidden = Json::array();
  for (std::size_t k = 0; k < kHiddenRanges.size(); ++k) {
    by_hidden.push_back(
        {{"hidden_from", kHiddenRanges[k].from}, {"hidden_to", kHiddenRanges[k].to}});
    by_hidden.back().update(recall_json(object.by_hidden[k]));
  }
  Json recall = recall_json(object.recall);
  recall["least_visible"] = kLeastVisible;
  return {{"object", object.object},
          {"index_bytes", object.index_bytes},
          {"classes", object.classes},
          {"clutter",
           {{"frames_with_object", object.with_object},
            {"frames_without", object.empty},
            {"recall", recall},
            {"recall_by_hidden", by_hidden},
            {"pose", poses_json(object.pose)},
            {"falsely_named", object.falsely_named},
            {"falsely_named_in_frames_without", object.falsely_named_in_empty},
            {"falsely_named_a_frame", a_frame(object.falsely_named, object.outcomes.size())},
            {"elapsed_ms", {{"mean", object.mean_ms}, {"median", object.median_ms}}},
            {"frames", outcomes_json(object.outcomes)}}}};
}

}  // namespace

std::string clutter_text(const ClutterEvaluation& evaluation) {
  const std::size_t width = name_width(evaluation);
  return head(evaluation) + found_table(evaluation, width) + hidden_table(evaluation, width);
}

std::string clutter_json(const ClutterEvaluation& evaluation) {
  const EvaluationSettings& settings = evaluation.settings;
  Json json{{"views", settings.views},
            {"seed", settings.seed},
            {"matching", settings.matching == Matching::simple ? "simple" : "weighted"},
            {"ranking", "views"},
            {"hidden_max", evaluation.hidden_max},
            {"backgrounds", evaluation.backgrounds.empty() ? Json() : Json(evaluation.backgrounds)},
            {"background_pictures", evaluation.pictures},
            {"objects", Json::array()}};
  for (const ObjectClutter& object : evaluation.objects)
    json["objects"].push_back(object_json(object));
  return json.dump(1) + "\n";
}

}  // namespace aspect
