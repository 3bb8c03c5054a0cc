#include "tools/eval/evaluation_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace aspect {
namespace {

// Grows line by line.
class Text {
 public:
  template <typename... Values>
  void add(fmt::format_string<Values...> format, Values&&... values) {
    fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
  }
  std::string text;
};

std::size_t name_width(const Evaluation& evaluation) {
  std::size_t width = 6;
  for (const ObjectEvaluation& object : evaluation.objects)
    width = std::max(width, object.object.size());
  return width;
}

void add_ranks(const Evaluation& evaluation, std::size_t width, Text& out) {
  out.add("Rank of the right class, accumulated % of the views\n\n");
  out.add("{:{}}  {:>7}  {:>6}  {:>9}  {:>9} ", "", width, "", "", "", "");
  for (const char* head : {"without symmetry", "with symmetry"})
    out.add("  {:>{}}", head, 6 * kReportedRanks.size());
  out.add("\n{:{}}  {:>7}  {:>6}  {:>9}  {:>9} ", "object", width, "classes", "area %", "uncovered",
          "rotations");
  for (int twice = 0; twice < 2; ++twice) {
    out.add("  ");
    for (const int rank : kReportedRanks) out.add("{:>6}", rank);
  }
  out.add("\n");
  for (const ObjectEvaluation& object : evaluation.objects) {
    out.add("{:{}}  {:>7}  {:>6.1f}  {:>9.1f}  {:>9} ", object.object, width, object.classes,
            100 * object.area_fraction, 100 * object.uncovered_share, object.rotations);
    for (const auto* shares : {&object.right, &object.right_with_symmetry}) {
      out.add("  ");
      for (const double share : *shares) out.add("{:>6.1f}", 100 * share);
    }
    out.add("\n");
  }
}

void add_error(const std::string& name, std::size_t width, const ErrorSummary& error, Text& out) {
  out.add("{:{}}  {:>7.2f}  {:>7.2f}  {:>7.2f}  {:>7.1f}  {:>7.1f}  {:>7.1f}", name, width,
          error.median_deg, error.mean_deg, error.p90_deg, 100 * error.within_5,
          100 * error.within_10, 100 * error.within_20);
}

void add_error_head(std::size_t width, Text& out) {
  out.add("{:{}}  {:>7}  {:>7}  {:>7}  {:>7}  {:>7}  {:>7}", "object", width, "median", "mean",
          "90 %", "<= 5 %", "<= 10 %", "<= 20 %");
}

void add_errors(const Evaluation& evaluation, std::size_t width, Text& out) {
  out.add(
      "\nError of the best hypothesis's view in degrees, modulo the object's rotations; time\n\n");
  add_error_head(width, out);
  out.add("  {:>7}  {:>7}  {:>9}\n", "mean ms", "median", "nothing %");
  for (const ObjectEvaluation& object : evaluation.objects) {
    add_error(object.object, width, object.error, out);
    out.add("  {:>7.2f}  {:>7.2f}  {:>9.1f}\n", object.mean_ms, object.median_ms,
            100 * object.nothing_found);
  }
}

void add_poses(const Evaluation& evaluation, std::size_t width, Text& out) {
  out.add(
      "\nError of the best hypothesis's pose, modulo the object's rotations: turn in degrees, "
      "place "
      "in % of\nthe distance, vertices in px (root mean square); of views with a pose, <= 5 of "
      "all\n"
      "\n{:{}}  {:>7}",
      "", width, "");
  for (const char* head : {"degrees", "% of distance", "px"}) out.add("  {:>25}", head);
  out.add("\n{:{}}  {:>7}", "object", width, "poses %");
  for (int thrice = 0; thrice < 3; ++thrice)
    out.add("  {:>7}  {:>7}  {:>7}", "median", "90 %", "<= 5 %");
  out.add("\n");
  for (const ObjectEvaluation& object : evaluation.objects) {
    out.add("{:{}}", object.object, width);
    if (object.pose) {
      out.add("  {:>7.1f}", 100 * object.pose->found_share);
      for (const ErrorSpread* spread :
           {&object.pose->rotation_deg, &object.pose->translation_percent,
            &object.pose->reprojection_px})
        out.add("  {:>7.2f}  {:>7.2f}  {:>7.1f}", spread->median, spread->p90,
                100 * spread->within_5);
    } else {
      out.add("  {:>7}", "none");
    }
    out.add("\n");
  }
}

void add_reliability_head(std::size_t width, Text& out) {
  out.add("{:{}}  {:>7}  {:>9}  {:>7}  {:>10}  {:>15}  {:>17}\n", "object", width, "match",
          "ambiguous", "unknown", "not judged", "matches right %", "calibration error");
}

void add_reliability(const std::string& name, std::size_t width, const Reliability& reliability,
                     Text& out) {
  const auto right = reliability.right_match_share(),
             error = reliability.expected_calibration_error();
  out.add("{:{}}  {:>7}  {:>9}  {:>7}  {:>10}  {:>15}  {:>17}\n", name, width, reliability.matches,
          reliability.ambiguous, reliability.unknown, reliability.not_judged,
          right ? fmt::format("{:.1f}", 100 * *right) : "-",
          error ? fmt::format("{:.3f}", *error) : "-");
}

void add_verdicts(const Evaluation& evaluation, std::size_t width, Text& out) {
  out.add("\nVerdicts, number of views, and the expected calibration error of the probability\n\n");
  add_reliability_head(width, out);
  for (const ObjectEvaluation& object : evaluation.objects)
    add_reliability(object.object, width, object.reliability, out);
}

void add_confusion(const Evaluation& evaluation, std::size_t width, Text& out) {
  const Confusion& confusion = *evaluation.confusion;
  out.add("\nAll indexes at once: which object comes first, number of views\n\n");
  out.add("{:{}}", "object", width);
  for (const ObjectEvaluation& object : evaluation.objects)
    out.add("  {:>{}}", object.object, width);
  out.add("  {:>{}}  {:>7}\n", "none", width, "right %");
  for (std::size_t truth = 0; truth < confusion.counts.size(); ++truth) {
    out.add("{:{}}", evaluation.objects[truth].object, width);
    for (const int count : confusion.counts[truth]) out.add("  {:>{}}", count, width);
    out.add("  {:>7.1f}\n", 100.0 * confusion.counts[truth][truth] / evaluation.settings.views);
  }
  out.add("\nError of the view in degrees, 180 where another object comes first; time\n\n");
  add_error_head(width, out);
  out.add("  {:>9}\n", "median ms");
  for (std::size_t truth = 0; truth < confusion.error.size(); ++truth) {
    add_error(evaluation.objects[truth].object, width, confusion.error[truth], out);
    out.add("  {:>9.2f}\n", confusion.median_ms[truth]);
  }
  out.add("\nVerdicts with all indexes, number of views, and the expected calibration error\n\n");
  add_reliability_head(width, out);
  for (std::size_t truth = 0; truth < confusion.reliability.size(); ++truth)
    add_reliability(evaluation.objects[truth].object, width, confusion.reliability[truth], out);
  add_reliability("(all)", width, confusion.total_reliability, out);
}

}  // namespace

std::string evaluation_text(const Evaluation& evaluation) {
  Text out;
  const EvaluationSettings& settings = evaluation.settings;
  const bool by_views = settings.ranking == RecogniserParameters::Ranking::views;
  out.add("{} random views an object, seed {}, matching {}, ranked by {}\n\n", settings.views,
          settings.seed, settings.matching == Matching::simple ? "simple" : "weighted",
          by_views ? "views" : "classes");
  const std::size_t width = name_width(evaluation);
  add_ranks(evaluation, width, out);
  add_errors(evaluation, width, out);
  add_poses(evaluation, width, out);
  add_verdicts(evaluation, width, out);
  if (evaluation.confusion) add_confusion(evaluation, width, out);
  return out.text;
}

}  // namespace aspect
