#include "tools/report/report_lines.h"

#include <fmt/format.h>
#include <optional>
#include <utility>

#include "runtime/service/configuration.h"
#include "runtime/service/index_set.h"
#include "tools/frame_page/recorded_page.h"
#include "tools/replay/console.h"

namespace aspect {
namespace {

Result<std::optional<CalibratedCamera>> read_camera(const std::filesystem::path& file) {
  if (file.empty()) return std::optional<CalibratedCamera>();
  const Result<Configuration> configuration = read_configuration(file);
  if (!configuration) return Error{configuration.error()};
  RecogniserParameters parameters;
  configuration.value().apply(parameters);
  return parameters.camera;
}

Result<std::optional<PageTruth>> read_page_truth(const LineSettings& settings) {
  if (settings.truth.empty()) return std::optional<PageTruth>();
  std::optional<std::filesystem::path> symmetries;
  if (!settings.symmetries.empty()) symmetries = settings.symmetries;
  auto truth = PageTruth::read(settings.truth, symmetries);
  if (!truth) return Error{truth.error()};
  return std::optional<PageTruth>(std::move(truth).value());
}

}  // namespace

bool holds_lines(const std::filesystem::path& input) {
  const std::filesystem::path ending = input.extension();
  return ending == ".ndjson" || ending == ".jsonl";
}

Result<Done> report_lines(const ReportOptions& options) {
  const LineSettings& settings = options.lines;
  const IndexSet set = load_indexes(settings.indexes);
  if (!set.failures.empty()) return Error{set.failures.front()};
  auto camera = read_camera(settings.configuration);
  if (!camera) return Error{camera.error()};
  auto truth = read_page_truth(settings);
  if (!truth) return Error{truth.error()};
  Console console("aspect-report");
  for (const std::string& warning : set.warnings) console.warn(warning);
  const auto counts = write_recorded_page(
      {options.input, options.output, set.indexes, camera.value(), std::move(truth).value(),
       [&](std::uint64_t frame, std::string_view name) { console.progress(frame, {}, name); }});
  if (!counts) return Error{counts.error()};
  if (counts.value().without_picture > 0)
    console.warn(
        fmt::format("{}: {} of {} frames are without their picture; "
                    "run it where they were replayed",
                    options.input.native(), counts.value().without_picture, counts.value().frames));
  return Done{};
}

}  // namespace aspect
