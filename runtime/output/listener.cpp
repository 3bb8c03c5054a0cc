#include "runtime/output/listener.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>
#include <cerrno>
#include <cstring>
#include <optional>

namespace aspect {
namespace {

constexpr int kWaiting = 16;
// A reader that stands still costs so much of the kernel's memory; inherited by connections.
constexpr int kSendBufferBytes = 64 << 10;
constexpr mode_t kPermissions = 0660;

void set_option(int socket, int level, int option, int value) {
  ::setsockopt(socket, level, option, &value, sizeof value);
}

Descriptor new_socket(int family) {
  return Descriptor(::socket(family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
}

// None: the place is free now.
std::optional<Error> clear_place(const std::string& path, const sockaddr_un& address) {
  struct stat found {};
  if (::lstat(path.c_str(), &found) != 0) return std::nullopt;
  if (!S_ISSOCK(found.st_mode))
    return Error{path + ": is there already and is no socket; remove it or choose another path"};
  const Descriptor trial = new_socket(AF_UNIX);
  const int status =
      ::connect(trial.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address);
  if (status != 0 && errno == ECONNREFUSED) {
    if (::unlink(path.c_str()) == 0 || errno == ENOENT) return std::nullopt;
    return Error{path + ": a socket that nobody uses, but it cannot be removed: " + system_error()};
  }
  return Error{path + ": another process listens there; stop it or choose another path"};
}

}  // namespace

Result<UnixListener> UnixListener::open(const std::filesystem::path& path) {
  const std::string name = path.string();
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (name.empty() || name.size() >= sizeof address.sun_path)
    return Error{name + ": a socket's path has 1 to 107 bytes; choose a shorter one"};
  std::memcpy(address.sun_path, name.data(), name.size());
  if (auto error = clear_place(name, address)) return *error;
  UnixListener listener;
  listener.socket_ = new_socket(AF_UNIX);
  const int socket = listener.socket_.get();
  set_option(socket, SOL_SOCKET, SO_SNDBUF, kSendBufferBytes);
  // The file gets the permissions of the socket: nobody gets in before they are as they shall be.
  ::fchmod(socket, 0600);
  if (::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0)
    return Error{name + ": no socket can be made there: " + system_error() +
                 "; check the folder and its permissions"};
  struct stat made {};
  if (::lstat(name.c_str(), &made) == 0) {
    listener.path_ = path;
    listener.device_ = made.st_dev;
    listener.file_ = made.st_ino;
  }
  if (::listen(socket, kWaiting) != 0 || ::chmod(name.c_str(), kPermissions) != 0)
    return Error{name + ": cannot be listened at: " + system_error()};
  return listener;
}

UnixListener::~UnixListener() {
  struct stat now {};
  if (!socket_ || path_.empty() || ::lstat(path_.c_str(), &now) != 0) return;
  if (now.st_dev == device_ && now.st_ino == file_) ::unlink(path_.c_str());
}

Result<NumericAddress> numeric_address(const std::string& what, const std::string& address,
                                       int port) {
  const auto network_port = htons(static_cast<std::uint16_t>(port));
  NumericAddress numeric;
  sockaddr_in v4{};
  sockaddr_in6 v6{};
  if (::inet_pton(AF_INET, address.c_str(), &v4.sin_addr) == 1) {
    v4.sin_family = AF_INET;
    v4.sin_port = network_port;
    std::memcpy(&numeric.storage, &v4, numeric.size = sizeof v4);
  } else if (::inet_pton(AF_INET6, address.c_str(), &v6.sin6_addr) == 1) {
    v6.sin6_family = AF_INET6;
    v6.sin6_port = network_port;
    std::memcpy(&numeric.storage, &v6, numeric.size = sizeof v6);
  } else {
    return Error{what + " address \"" + address +
                 "\": not a numeric address; give one as 127.0.0.1, 0.0.0.0 or ::1"};
  }
  return numeric;
}

Result<Descriptor> open_tcp_listener(const std::string& address, int port) {
  const auto numeric = numeric_address("tcp", address, port);
  if (!numeric) return Error{numeric.error()};
  const NumericAddress& to = numeric.value();
  const std::string name = "tcp " + address + " port " + std::to_string(port);
  Descriptor socket = new_socket(to.storage.ss_family);
  if (!socket) return Error{name + ": no socket of this kind: " + system_error()};
  set_option(socket.get(), SOL_SOCKET, SO_REUSEADDR, 1);
  set_option(socket.get(), SOL_SOCKET, SO_SNDBUF, kSendBufferBytes);
  if (to.storage.ss_family == AF_INET6) set_option(socket.get(), IPPROTO_IPV6, IPV6_V6ONLY, 0);
  // A reader whose machine went away without a word is found out in two minutes.
  set_option(socket.get(), SOL_SOCKET, SO_KEEPALIVE, 1);
  set_option(socket.get(), IPPROTO_TCP, TCP_KEEPIDLE, 60);
  set_option(socket.get(), IPPROTO_TCP, TCP_KEEPINTVL, 15);
  set_option(socket.get(), IPPROTO_TCP, TCP_KEEPCNT, 4);
  set_option(socket.get(), IPPROTO_TCP, TCP_NODELAY, 1);
  if (::bind(socket.get(), reinterpret_cast<const sockaddr*>(&to.storage), to.size) != 0 ||
      ::listen(socket.get(), kWaiting) != 0) {
    const bool taken = errno == EADDRINUSE;
    return Error{name + ": cannot be listened at: " + system_error() +
                 (taken ? "; stop the other process or choose another port"
                        : "; choose an address of this machine and a port that is allowed")};
  }
  return socket;
}

int bound_port(int socket) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  if (::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  if (address.ss_family == AF_INET6) {
    sockaddr_in6 v6{};
    std::memcpy(&v6, &address, sizeof v6);
    return ntohs(v6.sin6_port);
  }
  sockaddr_in v4{};
  std::memcpy(&v4, &address, sizeof v4);
  return ntohs(v4.sin_port);
}

}  // namespace aspect
