#include "tools/eval/plots.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "tools/aspectc/commands/whole_file.h"
#include "tools/eval/confusion_svg.h"
#include "tools/eval/pose_error_svg.h"
#include "tools/eval/rank_svg.h"
#include "tools/eval/recall_svg.h"
#include "tools/eval/reliability_svg.h"

namespace aspect {
namespace {

std::optional<Error> write(const std::filesystem::path& folder,
                           const std::vector<std::pair<const char*, std::string>>& plots) {
  for (const auto& [name, svg] : plots)
    if (const auto done = write_whole_text(folder / name, svg); !done) return Error{done.error()};
  return std::nullopt;
}

}  // namespace

std::optional<Error> prepare_plots(const std::filesystem::path& folder) {
  std::error_code fault;
  std::filesystem::create_directories(folder, fault);
  if (fault)
    return Error{fmt::format("{}: cannot be made ({}); name another folder", folder.native(),
                             fault.message())};
  if (const auto done = check_writable(folder / "rank.svg"); !done) return Error{done.error()};
  return std::nullopt;
}

std::optional<Error> write_plots(const Evaluation& evaluation, const ThesisRanks& thesis,
                                 const std::filesystem::path& folder) {
  std::vector<std::pair<const char*, std::string>> plots = {
      {"rank.svg", rank_svg(evaluation, thesis)}, {"pose_error.svg", pose_error_svg(evaluation)}};
  const Reliability& reliability = overall_reliability(evaluation);
  if (reliability.judged() > 0) plots.emplace_back("reliability.svg", reliability_svg(reliability));
  if (evaluation.confusion) plots.emplace_back("confusion.svg", confusion_svg(evaluation));
  return write(folder, plots);
}

std::optional<Error> write_plots(const ClutterEvaluation& evaluation,
                                 const std::filesystem::path& folder) {
  return write(folder, {{"recall.svg", recall_svg(evaluation)},
                        {"pose_error.svg", pose_error_svg(evaluation)}});
}

}  // namespace aspect
