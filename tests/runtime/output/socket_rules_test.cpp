#include <sys/socket.h>
#include <sys/stat.h>
#include <array>
#include <catch2/catch.hpp>
#include <random>
#include <thread>
#include <vector>

#include "runtime/output/listener.h"
#include "runtime/output/outputs.h"
#include "runtime/output/stream_readers.h"
#include "tests/runtime/output/made_lines.h"
#include "tests/runtime/output/output_clients.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
namespace fs = std::filesystem;

std::unique_ptr<Outputs> opened(const OutputSettings& settings) {
  auto outputs = Outputs::open(settings);
  if (!outputs) FAIL(outputs.error());
  return std::move(outputs).value();
}

std::string error_of(const OutputSettings& settings) {
  const auto outputs = Outputs::open(settings);
  REQUIRE_FALSE(outputs.ok());
  CHECK(outputs.error().find('\n') == std::string::npos);
  return outputs.error();
}

}  // namespace

TEST_CASE("a socket's file is for owner and group, and gone at the end") {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "socket";
  {
    const auto outputs = opened({.unix_socket = path});
    struct stat status {};
    REQUIRE(::stat(path.c_str(), &status) == 0);
    CHECK(S_ISSOCK(status.st_mode));
    CHECK((status.st_mode & 0777U) == 0660U);
  }
  CHECK_FALSE(fs::exists(path));
}

TEST_CASE("a socket's file is replaced if nobody listens there, and only then") {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "socket", stale = folder.path() / "stale";
  {
    const auto first = opened({.unix_socket = path});
    CHECK_THAT(error_of({.unix_socket = path}), Contains("another process listens there"));
    const Descriptor reader = connect_unix(path);
    // What a killed process leaves behind: a file without a listener.
    fs::create_hard_link(path, stale);
  }
  REQUIRE(fs::exists(stale));
  const auto second = opened({.unix_socket = stale});
  const Descriptor reader = connect_unix(stale);
  REQUIRE(comes_true([&] { return second->counts().readers == 1; }));
  second->publish("{}\n");
  CHECK(read_some(reader.get(), 100) == "{}\n");

  const fs::path file = folder.write("file", "precious");
  CHECK_THAT(error_of({.unix_socket = file}), Contains("is no socket"));
  CHECK(read_file(file) == "precious");
}

TEST_CASE("a file that somebody put in a socket's place stays") {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "socket";
  auto outputs = opened({.unix_socket = path});
  fs::remove(path);
  folder.write("socket", "not ours");
  outputs.reset();
  CHECK(read_file(path) == "not ours");
}

TEST_CASE("places that cannot be listened at are refused with a reason") {
  const TemporaryFolder folder;
  CHECK_THAT(error_of({.unix_socket = folder.path() / "no" / "such"}),
             Contains("No such file or directory"));
  CHECK_THAT(error_of({.unix_socket = folder.path() / std::string(120, 'x')}),
             Contains("1 to 107 bytes"));
  CHECK_THAT(error_of({.tcp = TcpOutput{"localhost", 0}}), Contains("not a numeric address"));
  CHECK_THAT(error_of({.tcp = TcpOutput{"192.0.2.1", 0}}), Contains("Cannot assign"));
  const auto first = opened({.tcp = TcpOutput{}});
  CHECK_THAT(error_of({.tcp = TcpOutput{"127.0.0.1", first->tcp_port()}}),
             Contains("Address already in use"));
}

TEST_CASE("a reader that says something or closes its own direction still gets lines") {
  const auto outputs = opened({.tcp = TcpOutput{}});
  const Descriptor reader = connect_tcp(outputs->tcp_port());
  const std::string chatter(100000, 'x');
  REQUIRE(::send(reader.get(), chatter.data(), chatter.size(), 0) > 0);
  ::shutdown(reader.get(), SHUT_WR);
  REQUIRE(comes_true([&] { return outputs->counts().readers == 1; }));
  outputs->publish("{}\n");
  CHECK(read_some(reader.get(), 100) == "{}\n");
}

TEST_CASE("readers beyond the sixteenth are refused, and a place that is left is free again") {
  const auto outputs = opened({.tcp = TcpOutput{}});
  std::vector<Descriptor> readers;
  for (std::size_t k = 0; k < StreamReaders::kMost; ++k)
    readers.push_back(connect_tcp(outputs->tcp_port()));
  REQUIRE(comes_true([&] { return outputs->counts().readers == StreamReaders::kMost; }));
  const Descriptor refused = connect_tcp(outputs->tcp_port());
  CHECK(read_some(refused.get(), 1).empty());
  CHECK(outputs->counts().readers_refused == 1);
  readers.pop_back();
  // Its leaving is found out when it is sent to.
  REQUIRE(comes_true([&] {
    outputs->publish("{}\n");
    return outputs->counts().readers < StreamReaders::kMost;
  }));
  const Descriptor next = connect_tcp(outputs->tcp_port());
  CHECK(comes_true([&] { return outputs->counts().readers == StreamReaders::kMost; }));
  CHECK(outputs->counts().readers_dropped == 0);
}

TEST_CASE("readers that come and go all the time get whole lines while they are there") {
  constexpr std::size_t kLongest = 900;
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "socket";
  auto outputs = opened({.unix_socket = path, .tcp = TcpOutput{}});
  const int port = outputs->tcp_port();
  std::atomic<bool> over{false};
  std::array<LineTally, 4> tallies;
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < tallies.size(); ++k)
    threads.emplace_back([&, k] {
      for (std::mt19937 random(static_cast<unsigned>(k)); !over;) {
        const Descriptor reader = k % 2 == 0 ? connect_unix(path) : connect_tcp(port);
        LineTally tally;
        for (auto reads = random() % 20; reads > 0 && !over; --reads)
          tally.take(read_some(reader.get(), 1 + random() % 5000), kLongest);
        tallies[k].whole += tally.whole;
        tallies[k].broken += tally.broken + tally.gaps + tally.disordered;
      }
    });
  for (std::uint64_t number = 0; number < 5000; ++number) {
    outputs->publish(made_line(number, kLongest));
    if (number % 16 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  over = true;
  outputs.reset();
  for (std::thread& thread : threads) thread.join();
  for (const LineTally& tally : tallies) {
    CHECK(tally.whole > 0);
    CHECK(tally.broken == 0);
  }
}

}  // namespace aspect
