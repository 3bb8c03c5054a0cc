// A thread of an output: small, at ordinary priority, deaf to signals, asleep until there is a
// line.
#pragma once

#include <pthread.h>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>

#include "runtime/base/result.h"
#include "runtime/output/descriptor.h"

namespace aspect {

class OutputThread {
 public:
  // What may take a second when everything ends.
  static constexpr std::chrono::milliseconds kFlush{1000};
  static constexpr std::size_t kStackBytes = 128U << 10U;  // the least that arm64 has

  OutputThread() = default;
  OutputThread(const OutputThread&) = delete;
  OutputThread& operator=(const OutputThread&) = delete;
  ~OutputThread();  // waits for the body to return

  // `name` is seen in ps and top; at most 15 characters.
  [[nodiscard]] std::optional<Error> start(const char* name, std::size_t stack_bytes,
                                           std::function<void()> body);

  // From any thread, without waiting.
  void wake() noexcept;
  void request_stop() noexcept;

  // For the body: sleeps until woken or until then, or on descriptors of its own and this one.
  void sleep(std::chrono::milliseconds longest) noexcept;
  int wake_descriptor() const { return woken_.get(); }
  void clear_wake() noexcept;
  bool stopping() const noexcept { return stopping_.load(std::memory_order_acquire); }
  bool out_of_time() const noexcept;

 private:
  static void* run(void* thread);

  Descriptor woken_;
  std::atomic<bool> stopping_{false};
  std::chrono::steady_clock::time_point deadline_{};  // once it is stopping
  std::function<void()> body_;
  pthread_t thread_{};
  bool running_ = false;
};

}  // namespace aspect
