#include "tests/recognition_table/frame_times.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <numeric>

#include "runtime/capture/recorded_frames.h"
#include "runtime/recognition/sized_recogniser.h"
#include "runtime/service/configuration.h"
#include "runtime/service/index_set.h"

namespace aspect {
namespace {

double thread_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Result<double> time_ratio(const std::filesystem::path& frames,
                          const std::optional<std::filesystem::path>& configuration,
                          const std::vector<std::filesystem::path>& indexes) {
  const IndexSet set = load_indexes(indexes);
  if (!set.failures.empty()) return Error{set.failures.front()};
  RecogniserParameters parameters;
  parameters.vision = set.indexes.front().vision;
  if (configuration) {
    const Result<Configuration> read = read_configuration(*configuration);
    if (!read) return Error{read.error()};
    read.value().apply(parameters);
  }
  SizedRecogniser recogniser(set.indexes, parameters);
  RecordedFrames source(std::array{frames});
  CapturedFrame frame;
  std::vector<double> read_ms, recognise_ms;
  std::uint64_t sum = 0;
  while (source.next(frame) == FrameStatus::frame) {
    recogniser.make_room(frame.width_px, frame.height_px);
    const double start_ms = thread_ms();
    sum += std::accumulate(frame.pixels.begin(), frame.pixels.end(), std::uint64_t{0});
    const double between_ms = thread_ms();
    sum += recogniser.recognise(frame.view()).objects.size();
    recognise_ms.push_back(thread_ms() - between_ms);
    read_ms.push_back(between_ms - start_ms);
  }
  if (!frame.error.empty()) return Error{frame.error};
  // Asking for the sum lets the compiler not leave it out.
  if (read_ms.empty() || sum == 0) return Error{frames.native() + ": has no frames"};
  return median(std::move(recognise_ms)) / median(std::move(read_ms));
}

}  // namespace aspect
