#include <unistd.h>
#include <array>
#include <catch2/catch.hpp>

#include "runtime/output/outputs.h"
#include "tests/runtime/base/allocation_counter.h"
#include "tests/runtime/output/made_lines.h"
#include "tests/runtime/output/output_clients.h"
#include "tests/temporary_folder.h"

namespace aspect {

TEST_CASE("lines, sights and readers take no memory from the heap") {
  constexpr std::size_t kLongest = 2000;
  const TemporaryFolder folder;
  const TriggerOutput trigger{.object = "cube", .command = {"/bin/true"}, .gpio_chip = ""};
  auto outputs = Outputs::open({.file = FileOutput{folder.path() / "lines"},
                                .unix_socket = folder.path() / "socket",
                                .triggers = {trigger}});
  REQUIRE(outputs.ok());
  const Descriptor reader = connect_unix(folder.path() / "socket");
  REQUIRE(comes_true([&] { return outputs.value()->counts().readers == 1; }));
  std::vector<std::string> lines;
  for (std::uint64_t number = 0; number < 1000; ++number)
    lines.push_back(made_line(number, kLongest));
  const SeenName seen[] = {{"block", 3}};
  std::array<char, 1 << 16> read;
  std::size_t bytes = 0, expected = 0;
  // The writing threads, too: they are counted as well.
  const std::uint64_t before = allocation_count();
  for (const std::string& line : lines) {
    outputs.value()->publish(line);
    outputs.value()->report_seen(seen);
    expected += line.size();
    while (bytes < expected) {
      const ssize_t got = ::read(reader.get(), read.data(), read.size());
      if (got <= 0) break;
      bytes += static_cast<std::size_t>(got);
    }
  }
  CHECK(allocation_count() - before == 0);
  CHECK(bytes == expected);
}

}  // namespace aspect
