#include "runtime/output/standard_output.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <climits>

namespace aspect {

Result<std::unique_ptr<StandardOutput>> StandardOutput::open(const LineRing& ring,
                                                             OutputCounters& counters) {
  struct stat status {};
  if (::fstat(STDOUT_FILENO, &status) != 0)
    return Error{"standard output is closed; redirect it, or set [output] stdout = false"};
  std::unique_ptr<StandardOutput> output(new StandardOutput(ring, counters));
  output->target_ = STDOUT_FILENO;
  // Opened anew, a pipe or a terminal has flags of its own: made non-blocking as it is, it would be
  // so for every process that shares it.
  if (S_ISFIFO(status.st_mode) || S_ISCHR(status.st_mode))
    output->own_.reset(::open("/proc/self/fd/1", O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (output->own_) output->target_ = output->own_.get();
  return output;
}

void StandardOutput::write_on() {
  while (!closed_ && (sent_ < size_ || take_line()))
    if (!write_piece()) return;
}

bool StandardOutput::take_line() {
  auto reading = ring_.read(next_, line_);
  if (reading.state == LineRing::Reading::State::gone) {
    skip_lost(ring_, next_, counters_);
    reading = ring_.read(next_, line_);
  }
  if (reading.state != LineRing::Reading::State::line) return false;
  ++next_;
  size_ = reading.line.size();
  sent_ = 0;
  return true;
}

// A pipe that poll calls writable takes PIPE_BUF bytes without waiting, even where it could not be
// opened anew.
bool StandardOutput::write_piece() {
  pollfd ready{target_, POLLOUT, 0};
  if (::poll(&ready, 1, 0) <= 0) return false;
  if ((ready.revents & POLLOUT) == 0) {
    close();
    return false;
  }
  const std::size_t most = std::min<std::size_t>(size_ - sent_, PIPE_BUF);
  const ssize_t written = ::write(target_, line_.data() + sent_, most);
  if (written > 0) sent_ += static_cast<std::size_t>(written);
  if (written < 0 && errno != EAGAIN && errno != EINTR) close();
  return written > 0;
}

void StandardOutput::close() {
  closed_ = true;
  counters_.standard_output_closed = true;
  warn("standard output: nobody reads it any more; the other outputs go on");
}

}  // namespace aspect
