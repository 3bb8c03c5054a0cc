// What the service manager wants to know: that we are ready, alive, reloading, going (sd_notify(3)
// is a datagram to a socket; libsystemd has no static library). Does nothing without a manager.
#pragma once

#include <chrono>
#include <string_view>

namespace aspect {

class ServiceNotify {
 public:
  // Reads NOTIFY_SOCKET, WATCHDOG_USEC and WATCHDOG_PID from the environment.
  ServiceNotify();
  ~ServiceNotify();
  ServiceNotify(const ServiceNotify&) = delete;
  ServiceNotify& operator=(const ServiceNotify&) = delete;

  // "READY=1", "STATUS=streaming": one assignment a line. Never waits.
  void tell(std::string_view assignments) noexcept;
  // As tell, with the time that the manager needs to order reloads by.
  void tell_reloading() noexcept;
  // To be called often: tells that we are alive at half of the manager's interval.
  void beat(std::chrono::steady_clock::time_point now) noexcept;

 private:
  int socket_ = -1;
  std::chrono::microseconds interval_{0};
  std::chrono::steady_clock::time_point next_beat_{};
};

}  // namespace aspect
