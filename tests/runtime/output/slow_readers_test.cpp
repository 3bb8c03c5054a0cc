#include <sys/socket.h>
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <iostream>
#include <thread>
#include <vector>

#include "runtime/output/outputs.h"
#include "tests/runtime/output/made_lines.h"
#include "tests/runtime/output/output_clients.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::size_t kLongest = 2000;

std::unique_ptr<Outputs> opened(const OutputSettings& settings) {
  auto outputs = Outputs::open(settings);
  if (!outputs) FAIL(outputs.error());
  return std::move(outputs).value();
}

void take_all(int descriptor, std::size_t at_once, LineTally& tally) {
  for (std::string bytes; !(bytes = read_some(descriptor, at_once)).empty();)
    tally.take(bytes, kLongest);
}

// Lines [1, count); microseconds of every call.
std::vector<double> publish_lines(Outputs& outputs, std::uint64_t count) {
  std::vector<double> times;
  for (std::uint64_t number = 1; number < count; ++number) {
    const std::string line = made_line(number, kLongest);
    // Faster than any camera, yet somebody who reads at once can keep up.
    if (number % 100 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const auto before = Clock::now();
    outputs.publish(line);
    times.push_back(std::chrono::duration<double, std::micro>(Clock::now() - before).count());
  }
  return times;
}

}  // namespace

TEST_CASE("readers that stand still cost the loop no time, and others nothing at all") {
  const TemporaryFolder folder;
  const auto socket = folder.path() / "socket";
  StandardOutputPipe pipe;
  auto outputs = opened({.standard_output = true,
                         .file = FileOutput{folder.path() / "f"},
                         .unix_socket = socket,
                         .tcp = TcpOutput{}});
  const Descriptor still = connect_tcp(outputs->tcp_port());
  const Descriptor slow = connect_unix(socket), quick = connect_unix(socket);
  REQUIRE(comes_true([&] { return outputs->counts().readers == 3; }));
  LineTally of_slow, of_quick;
  outputs->publish(made_line(0, kLongest));
  char first = 0;
  REQUIRE(::recv(still.get(), &first, 1, MSG_PEEK) == 1);
  std::thread slow_thread(take_all, slow.get(), 1, std::ref(of_slow));
  std::thread quick_thread(take_all, quick.get(), 1 << 16, std::ref(of_quick));

  constexpr std::uint64_t kLines = 100000;
  std::vector<double> times = publish_lines(*outputs, kLines);
  const OutputCounts counts = outputs->counts();
  LineTally of_pipe, of_still;
  std::thread pipe_thread(take_all, pipe.reader.get(), 1 << 16, std::ref(of_pipe));
  // Lines are known to be lost once their reader goes on.
  CHECK(comes_true([&] { return outputs->counts().lines_lost > 0; }));
  outputs.reset();
  pipe.restore();
  pipe_thread.join();
  quick_thread.join();
  slow_thread.join();
  take_all(still.get(), 1 << 16, of_still);

  std::sort(times.begin(), times.end());
  std::cerr << "publish: median " << times[times.size() / 2] << " us, 99 % "
            << times[times.size() * 99 / 100] << " us, worst " << times.back() << " us\n";
  // What a wait for a reader would cost is for ever; this leaves room for a busy machine.
  CHECK(times[times.size() * 99 / 100] < 1000);
  CHECK(counts.lines == kLines);
  CHECK(counts.readers_dropped >= 1);
  // The one who stands still got the beginning and then was cut off.
  CHECK(of_still.whole > 0);
  CHECK(of_still.gaps == 0);
  for (const LineTally* tally : {&of_slow, &of_quick, &of_still})
    CHECK(tally->broken + tally->disordered + tally->gaps == 0);
  // Standard output has gaps instead, between whole lines, and ends with the last one.
  CHECK(of_pipe.broken + of_pipe.disordered == 0);
  CHECK(of_pipe.gaps > 0);
  CHECK(of_pipe.rest.empty());
  CHECK(of_pipe.last == kLines - 1);
  LineTally of_file;
  for (const char* ending : {".3", ".2", ".1", ""})
    of_file.take(read_file((folder.path() / "f").string() + ending), kLongest);
  CHECK(of_file.broken + of_file.disordered == 0);
  CHECK(of_file.rest.empty());
  CHECK(of_file.last == kLines - 1);
}

TEST_CASE("a reader that keeps up gets every line while others stand still") {
  const TemporaryFolder folder;
  const auto socket = folder.path() / "socket";
  const StandardOutputPipe pipe;
  auto outputs =
      opened({.standard_output = true, .unix_socket = socket, .tcp = TcpOutput{"::1", 0}});
  const Descriptor still = connect_unix(socket);
  const Descriptor quick = connect_tcp(outputs->tcp_port(), "::1");
  REQUIRE(comes_true([&] { return outputs->counts().readers == 2; }));
  LineTally tally;
  for (std::uint64_t number = 0; number < 2000; ++number) {
    outputs->publish(made_line(number, kLongest));
    while (tally.last != number) {
      const std::string bytes = read_some(quick.get(), 1 << 16);
      REQUIRE_FALSE(bytes.empty());
      tally.take(bytes, kLongest);
    }
  }
  CHECK(tally.whole == 2000);
  CHECK(tally.broken + tally.disordered + tally.gaps == 0);
  CHECK(comes_true([&] { return outputs->counts().readers == 1; }));
  CHECK(outputs->counts().readers_dropped == 1);
}

TEST_CASE("a standard output that nobody reads any more ends alone") {
  const TemporaryFolder folder;
  StandardOutputPipe pipe;
  auto outputs = opened({.standard_output = true, .unix_socket = folder.path() / "socket"});
  const Descriptor reader = connect_unix(folder.path() / "socket");
  REQUIRE(comes_true([&] { return outputs->counts().readers == 1; }));
  pipe.reader.reset();
  outputs->publish(made_line(0, kLongest));
  CHECK(read_some(reader.get(), 1 << 16) == made_line(0, kLongest));
  CHECK(comes_true([&] { return outputs->counts().standard_output_closed; }));
  outputs->publish(made_line(1, kLongest));
  CHECK(read_some(reader.get(), 1 << 16) == made_line(1, kLongest));
}

}  // namespace aspect
