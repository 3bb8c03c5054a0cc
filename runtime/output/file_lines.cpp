#include "runtime/output/file_lines.h"

namespace aspect {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPause{1000};  // before a full disk is tried again

}  // namespace

Result<std::unique_ptr<FileLines>> FileLines::open(const FileOutput& settings, const LineRing& ring,
                                                   OutputCounters& counters) {
  auto file = RotatedFile::open(settings);
  if (!file) return Error{file.error()};
  std::unique_ptr<FileLines> output(new FileLines(std::move(file).value(), ring, counters));
  FileLines* const self = output.get();
  if (auto error =
          self->thread_.start("aspect-file", OutputThread::kStackBytes, [self] { self->run(); }))
    return *error;
  return output;
}

void FileLines::run() {
  while (true) {
    while (write_next() && !thread_.out_of_time()) {
    }
    if (thread_.stopping()) return;
    const auto again = Clock::now() + kPause;
    do thread_.sleep(kPause);
    while (failing_ && !thread_.stopping() && Clock::now() < again);
  }
}

bool FileLines::write_next() {
  const auto [state, line] = ring_.read(next_, line_);
  if (state == LineRing::Reading::State::not_yet) return false;
  if (state == LineRing::Reading::State::gone) {
    skip_lost(ring_, next_, counters_);
    return true;
  }
  if (const auto error = file_.append(line)) {
    if (!failing_) warn(error->message);
    failing_ = true;
    return false;
  }
  if (failing_) warn("the file can be written again");
  failing_ = false;
  ++next_;
  return true;
}

}  // namespace aspect
