#include "runtime/service/service_notify.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <charconv>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

namespace aspect {
namespace {

std::optional<long long> number_of(const char* name) {
  const char* text = std::getenv(name);
  if (text == nullptr) return std::nullopt;
  long long number = 0;
  const char* end = text + std::strlen(text);
  const auto read = std::from_chars(text, end, number);
  if (read.ec != std::errc{} || read.ptr != end || number <= 0) return std::nullopt;
  return number;
}

// -1 where there is no manager.
int connect_manager() {
  const char* path = std::getenv("NOTIFY_SOCKET");
  sockaddr_un address{};
  const std::size_t length = path == nullptr ? 0 : std::strlen(path);
  if (length == 0 || length >= sizeof address.sun_path) return -1;
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, path, length);
  if (path[0] == '@') address.sun_path[0] = '\0';  // an abstract name
  const int descriptor = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (descriptor < 0) return -1;
  const auto bytes = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + length);
  if (connect(descriptor, reinterpret_cast<const sockaddr*>(&address), bytes) == 0)
    return descriptor;
  close(descriptor);
  return -1;
}

}  // namespace

ServiceNotify::ServiceNotify() : socket_(connect_manager()) {
  const auto interval_us = number_of("WATCHDOG_USEC");
  const auto process = number_of("WATCHDOG_PID");
  if (socket_ < 0 || !interval_us || (process && *process != getpid())) return;
  interval_ = std::chrono::microseconds(*interval_us / 2);
}

ServiceNotify::~ServiceNotify() {
  if (socket_ >= 0) close(socket_);
}

void ServiceNotify::tell(std::string_view assignments) noexcept {
  if (socket_ < 0) return;
  static_cast<void>(send(socket_, assignments.data(), assignments.size(), MSG_NOSIGNAL));
}

void ServiceNotify::tell_reloading() noexcept {
  using std::chrono::duration_cast, std::chrono::microseconds;
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  char text[64];
  const int length =
      std::snprintf(text, sizeof text, "RELOADING=1\nMONOTONIC_USEC=%lld",
                    static_cast<long long>(duration_cast<microseconds>(now).count()));
  tell({text, static_cast<std::size_t>(length)});
}

void ServiceNotify::beat(std::chrono::steady_clock::time_point now) noexcept {
  if (interval_.count() == 0 || now < next_beat_) return;
  next_beat_ = now + interval_;
  tell("WATCHDOG=1");
}

}  // namespace aspect
