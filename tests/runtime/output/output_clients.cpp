#include "tests/runtime/output/output_clients.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>
#include <catch2/catch.hpp>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include "runtime/output/listener.h"

namespace aspect {
namespace {

Descriptor connected(int family, const sockaddr* address, socklen_t size) {
  Descriptor client(::socket(family, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const timeval patience{5, 0};
  ::setsockopt(client.get(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  // So that a reader that stands still is soon noticed.
  const int small = 16 << 10;
  ::setsockopt(client.get(), SOL_SOCKET, SO_RCVBUF, &small, sizeof small);
  if (::connect(client.get(), address, size) != 0)
    throw std::runtime_error("no connection: " + system_error());
  return client;
}

}  // namespace

Descriptor connect_unix(const std::filesystem::path& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
  return connected(AF_UNIX, reinterpret_cast<const sockaddr*>(&address), sizeof address);
}

Descriptor connect_tcp(int port, const std::string& address) {
  const auto to = numeric_address("test", address, port);
  return connected(to.value().storage.ss_family,
                   reinterpret_cast<const sockaddr*>(&to.value().storage), to.value().size);
}

std::string read_some(int descriptor, std::size_t most) {
  std::string bytes(most, '\0');
  const ssize_t got = ::read(descriptor, bytes.data(), most);
  bytes.resize(got > 0 ? static_cast<std::size_t>(got) : 0);
  return bytes;
}

StandardOutputPipe::StandardOutputPipe() {
  int ends[2];
  REQUIRE(::pipe2(ends, O_CLOEXEC) == 0);
  reader.reset(ends[0]);
  const Descriptor writer(ends[1]);
  std::fflush(stdout);
  before_.reset(::dup(STDOUT_FILENO));
  REQUIRE(::dup2(writer.get(), STDOUT_FILENO) == STDOUT_FILENO);
}

void StandardOutputPipe::restore() {
  if (!before_) return;
  std::fflush(stdout);
  ::dup2(before_.get(), STDOUT_FILENO);
  before_.reset();
}

}  // namespace aspect
