#include "runtime/service/service_notify.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <cstring>
#include <string>

namespace aspect {
namespace {

using namespace std::chrono_literals;

// The service manager's end, on an abstract name of this process's own.
class Manager {
 public:
  Manager() : name_("@aspect-notify-" + std::to_string(getpid())) {
    socket_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK, 0);
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path + 1, name_.data() + 1, name_.size() - 1);
    const auto bytes = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name_.size());
    REQUIRE(bind(socket_, reinterpret_cast<const sockaddr*>(&address), bytes) == 0);
    setenv("NOTIFY_SOCKET", name_.c_str(), 1);
  }
  ~Manager() {
    for (const char* name : {"NOTIFY_SOCKET", "WATCHDOG_USEC", "WATCHDOG_PID"}) unsetenv(name);
    close(socket_);
  }
  // Empty: nothing was told.
  std::string heard() const {
    char text[256];
    const ssize_t length = recv(socket_, text, sizeof text, 0);
    return length < 0 ? "" : std::string(text, static_cast<std::size_t>(length));
  }

 private:
  std::string name_;
  int socket_ = -1;
};

TEST_CASE("The service manager hears what it is told") {
  const Manager manager;
  ServiceNotify notify;
  notify.tell("READY=1");
  CHECK(manager.heard() == "READY=1");
  notify.tell_reloading();
  CHECK(manager.heard().rfind("RELOADING=1\nMONOTONIC_USEC=", 0) == 0);
}

TEST_CASE("The watchdog is fed at half of its interval and not oftener") {
  const Manager manager;
  setenv("WATCHDOG_USEC", "2000000", 1);
  ServiceNotify notify;
  const auto start = std::chrono::steady_clock::now();
  int beats = 0;
  for (auto time = 0ms; time <= 10s; time += 100ms) {
    notify.beat(start + time);
    if (manager.heard() == "WATCHDOG=1") ++beats;
  }
  CHECK(beats == 11);
}

TEST_CASE("A watchdog of another process is not fed") {
  const Manager manager;
  setenv("WATCHDOG_USEC", "2000000", 1);
  setenv("WATCHDOG_PID", "1", 1);
  ServiceNotify notify;
  notify.beat(std::chrono::steady_clock::now());
  CHECK(manager.heard() == "");
}

TEST_CASE("Without a service manager nothing happens") {
  constexpr const char* kTooLong =
      "/a/path/that/is/longer/than/the/hundred/and/eight/bytes/that/the/address/of/a/socket/"
      "may/have/on/linux/and/so/cannot/be/one";
  for (const char* name : {"", "/no/such/socket", kTooLong}) {
    setenv("NOTIFY_SOCKET", name, 1);
    ServiceNotify notify;
    notify.tell("READY=1");
    notify.beat(std::chrono::steady_clock::now());
  }
  unsetenv("NOTIFY_SOCKET");
}

}  // namespace
}  // namespace aspect
