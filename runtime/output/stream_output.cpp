#include "runtime/output/stream_output.h"

#include <poll.h>
#include <algorithm>
#include <array>
#include <cerrno>

namespace aspect {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPause{1000};

}  // namespace

Result<std::unique_ptr<StreamOutput>> StreamOutput::open(const OutputSettings& settings,
                                                         const LineRing& ring,
                                                         OutputCounters& counters) {
  std::unique_ptr<StreamOutput> output(new StreamOutput(ring, counters));
  if (auto error = output->open_all(settings, ring, counters)) return *error;
  StreamOutput* const self = output.get();
  if (auto error =
          self->thread_.start("aspect-streams", OutputThread::kStackBytes, [self] { self->run(); }))
    return *error;
  return output;
}

std::optional<Error> StreamOutput::open_all(const OutputSettings& settings, const LineRing& ring,
                                            OutputCounters& counters) {
  if (settings.standard_output) {
    auto opened = StandardOutput::open(ring, counters);
    if (!opened) return Error{opened.error()};
    standard_output_ = std::move(opened).value();
  }
  if (settings.unix_socket) {
    auto opened = UnixListener::open(*settings.unix_socket);
    if (!opened) return Error{opened.error()};
    unix_ = std::move(opened).value();
  }
  if (settings.tcp) {
    auto opened = open_tcp_listener(settings.tcp->address, settings.tcp->port);
    if (!opened) return Error{opened.error()};
    tcp_ = std::move(opened).value();
  }
  return std::nullopt;
}

void StreamOutput::run() {
  const auto behind = [&] {
    return readers_.behind() || (standard_output_ && standard_output_->behind());
  };
  while (!thread_.stopping() || (behind() && !thread_.out_of_time())) {
    wait();
    for (const int listener : {unix_.descriptor(), tcp_.get()}) accept_readers(listener);
    readers_.serve();
    if (standard_output_) standard_output_->write_on();
  }
}

void StreamOutput::wait() {
  constexpr std::size_t kOthers = 4;
  std::array<pollfd, kOthers + StreamReaders::kMost> waits{};
  const bool accepts = Clock::now() >= accepts_from_;
  const bool writes = standard_output_ && standard_output_->behind();
  // Negative descriptors are skipped by poll.
  waits[0] = {thread_.wake_descriptor(), POLLIN, 0};
  waits[1] = {accepts ? unix_.descriptor() : -1, POLLIN, 0};
  waits[2] = {accepts ? tcp_.get() : -1, POLLIN, 0};
  waits[3] = {writes ? standard_output_->descriptor() : -1, POLLOUT, 0};
  const auto readers = readers_.waits();
  std::copy(readers.begin(), readers.end(), waits.begin() + kOthers);
  const auto longest = thread_.stopping() ? kPause / 50 : kPause;
  ::poll(waits.data(), kOthers + readers.size(), static_cast<int>(longest.count()));
  if (waits[0].revents != 0) thread_.clear_wake();
}

void StreamOutput::accept_readers(int listener) {
  if (listener < 0 || Clock::now() < accepts_from_) return;
  for (std::size_t k = 0; k < StreamReaders::kMost; ++k) {
    Descriptor socket(::accept4(listener, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (socket) {
      readers_.add(std::move(socket));
      continue;
    }
    const bool usual = errno == EAGAIN || errno == EINTR || errno == ECONNABORTED;
    // Out of descriptors, say: the connection waits, and asking for it at once would be in vain.
    if (!usual) accepts_from_ = Clock::now() + kPause;
    return;
  }
}

}  // namespace aspect
