// Sockets that readers connect to.
#pragma once

#include <sys/socket.h>
#include <sys/types.h>
#include <filesystem>
#include <string>

#include "runtime/base/result.h"
#include "runtime/output/descriptor.h"

namespace aspect {

// A Unix socket, removed at the end unless somebody else's is in its place by then.
class UnixListener {
 public:
  // Replaces the file of a socket that nobody listens at. Readers need write permission: the
  // owner and the group have it.
  [[nodiscard]] static Result<UnixListener> open(const std::filesystem::path& path);
  UnixListener() = default;
  UnixListener(UnixListener&&) = default;
  UnixListener& operator=(UnixListener&&) = default;
  ~UnixListener();

  int descriptor() const { return socket_.get(); }

 private:
  Descriptor socket_;
  std::filesystem::path path_;
  dev_t device_ = 0;
  ino_t file_ = 0;
};

struct NumericAddress {
  sockaddr_storage storage{};
  socklen_t size = 0;
};
// IPv4 or IPv6; names are not looked up. `what` is the output's name, for the error.
[[nodiscard]] Result<NumericAddress> numeric_address(const std::string& what,
                                                     const std::string& address, int port);

[[nodiscard]] Result<Descriptor> open_tcp_listener(const std::string& address, int port);
// Port that a socket listens at.
int bound_port(int socket);

}  // namespace aspect
