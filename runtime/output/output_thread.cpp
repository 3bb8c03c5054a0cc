#include "runtime/output/output_thread.h"

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <sys/eventfd.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>

namespace aspect {

OutputThread::~OutputThread() {
  if (!running_) return;
  request_stop();
  ::pthread_join(thread_, nullptr);
}

std::optional<Error> OutputThread::start(const char* name, std::size_t stack_bytes,
                                         std::function<void()> body) {
  woken_.reset(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC));
  if (!woken_) return Error{std::string("output thread: no eventfd: ") + system_error()};
  body_ = std::move(body);
  pthread_attr_t attributes;
  ::pthread_attr_init(&attributes);
  const int stack_failure = ::pthread_attr_setstacksize(&attributes, stack_bytes);
  // The frame loop may have a realtime priority and a processor already; outputs must share
  // neither.
  const sched_param ordinary{};
  ::pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);
  ::pthread_attr_setschedpolicy(&attributes, SCHED_OTHER);
  ::pthread_attr_setschedparam(&attributes, &ordinary);
  cpu_set_t every;
  std::memset(&every, 0xFF, sizeof every);
  ::pthread_attr_setaffinity_np(&attributes, sizeof every, &every);
  // Signals are the main thread's; SIGPIPE of a write of ours stays blocked.
  sigset_t all, before;
  ::sigfillset(&all);
  ::pthread_sigmask(SIG_SETMASK, &all, &before);
  const int failure = stack_failure != 0
                          ? stack_failure
                          : ::pthread_create(&thread_, &attributes, &OutputThread::run, this);
  ::pthread_sigmask(SIG_SETMASK, &before, nullptr);
  ::pthread_attr_destroy(&attributes);
  errno = failure;
  if (failure != 0) return Error{std::string("output thread: cannot start: ") + system_error()};
  running_ = true;
  ::pthread_setname_np(thread_, name);
  return std::nullopt;
}

void* OutputThread::run(void* thread) {
  static_cast<OutputThread*>(thread)->body_();
  return nullptr;
}

void OutputThread::wake() noexcept {
  const std::uint64_t one = 1;
  // Fails only when it is full of wakes already.
  [[maybe_unused]] const auto written = ::write(woken_.get(), &one, sizeof one);
}

void OutputThread::clear_wake() noexcept {
  std::uint64_t count = 0;
  [[maybe_unused]] const auto read = ::read(woken_.get(), &count, sizeof count);
}

void OutputThread::request_stop() noexcept {
  if (stopping()) return;
  deadline_ = std::chrono::steady_clock::now() + kFlush;
  stopping_.store(true, std::memory_order_release);
  if (woken_) wake();
}

bool OutputThread::out_of_time() const noexcept {
  return stopping() && std::chrono::steady_clock::now() >= deadline_;
}

void OutputThread::sleep(std::chrono::milliseconds longest) noexcept {
  pollfd waiting{woken_.get(), POLLIN, 0};
  ::poll(&waiting, 1, static_cast<int>(longest.count()));
  clear_wake();
}

}  // namespace aspect
