#include "runtime/output/triggers.h"

#include <unistd.h>
#include <catch2/catch.hpp>
#include <mutex>

#include "tests/runtime/output/output_clients.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;

// Stands for a chip: remembers what was done to its one line.
struct Chip {
  std::mutex mutex;
  std::string done;  // h, l for every change; e at the end
} chip;

void note(char what) {
  const std::lock_guard lock(chip.mutex);
  chip.done += what;
}

std::string noted() {
  const std::lock_guard lock(chip.mutex);
  return chip.done;
}

class NotedLine final : public GpioLine {
 public:
  ~NotedLine() override { note('e'); }
  bool set(bool high) override {
    note(high ? 'h' : 'l');
    return true;
  }
};

Result<std::unique_ptr<GpioLine>> open_noted(const std::string& path, int line) {
  if (line != 7) return Error{path + ": no such line"};
  return std::unique_ptr<GpioLine>(new NotedLine);
}

std::unique_ptr<Triggers> opened(const TriggerOutput& settings) {
  auto triggers = Triggers::open({&settings, 1}, open_noted);
  if (!triggers) FAIL(triggers.error());
  return std::move(triggers).value();
}

void see(Triggers& triggers, const char* object, double score) {
  const SeenName seen[] = {{"another", 1e9}, {object, score}};
  triggers.report_seen(seen);
}

}  // namespace

TEST_CASE("a sight is believed after so many frames that agree, and no longer after as many") {
  SteadySight sight(3);
  std::string believed;
  for (const char frame : std::string("0110111001000111011"))
    believed += sight.update(frame == '1') ? '1' : '0';
  CHECK(believed == "0000001111110001111");
}

TEST_CASE("a line is high while the object is seen well enough") {
  chip.done.clear();
  {
    const auto triggers = opened({.object = "cube",
                                  .score_min = 5,
                                  .frames = 2,
                                  .command = {},
                                  .gpio_chip = "/dev/gpiochip0",
                                  .gpio_line = 7});
    see(*triggers, "cube", 4.9);
    see(*triggers, "cube", 4.9);
    see(*triggers, "cubes", 9);
    see(*triggers, "cube", 5);
    CHECK(noted().empty());
    see(*triggers, "cube", 5);
    CHECK(comes_true([] { return noted() == "h"; }));
    triggers->report_seen({});
    see(*triggers, "cube", 5);
    triggers->report_seen({});
    triggers->report_seen({});
    CHECK(comes_true([] { return noted() == "hl"; }));
  }
  CHECK(noted() == "hle");
  const TriggerOutput wrong{.object = "cube", .command = {}, .gpio_chip = "chip", .gpio_line = 8};
  CHECK_THAT(Triggers::open({&wrong, 1}, open_noted).error(), Contains("no such line"));
}

TEST_CASE("a command is told what is seen, one at a time, without a shell") {
  const TemporaryFolder folder;
  const std::string log = (folder.path() / "log").string();
  const auto program = folder.write("program",
                                    "#!/bin/sh\necho \"begin $1 $ASPECT_OBJECT $ASPECT_SEEN\" "
                                    ">>\"$2\"\nsleep 0.2\necho end >>\"$2\"\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const TriggerOutput settings{
      .object = "L $HOME", .command = {program, "a b; c", log}, .gpio_chip = ""};
  REQUIRE_FALSE(Triggers::check(settings));
  const auto triggers = opened(settings);
  const auto logged = [&] { return std::filesystem::exists(log) ? read_file(log) : ""; };
  const std::string first = "begin a b; c L $HOME 1\n", second = "begin a b; c L $HOME 0\n";
  see(*triggers, "L $HOME", 1);
  REQUIRE(comes_true([&] { return logged() == first; }));
  triggers->report_seen({});
  CHECK(comes_true([&] { return logged() == first + "end\n" + second + "end\n"; }));
  // Came and went while a command ran: nothing to be told.
  see(*triggers, "L $HOME", 1);
  REQUIRE(comes_true([&] { return logged().size() == 2 * first.size() + second.size() + 8; }));
  triggers->report_seen({});
  see(*triggers, "L $HOME", 1);
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  CHECK(logged() == first + "end\n" + second + "end\n" + first + "end\n");
}

TEST_CASE("the daemon's outputs run their triggers") {
  const TemporaryFolder folder;
  const std::string made = (folder.path() / "made").string();
  const auto outputs =
      Outputs::open({.triggers = {{.object = "cube", .command = {"/usr/bin/touch", made}}}});
  REQUIRE(outputs.ok());
  const SeenName seen[] = {{"cube", 1}};
  outputs.value()->report_seen(seen);
  CHECK(comes_true([&] { return std::filesystem::exists(made); }));
}

TEST_CASE("a trigger that cannot work is refused with a reason") {
  const auto reason = [](const TriggerOutput& settings) {
    const auto error = Triggers::check(settings);
    return error ? error->message : "";
  };
  CHECK_THAT(reason({.object = "cube", .command = {}, .gpio_chip = ""}), Contains("does nothing"));
  CHECK_THAT(reason({.object = "cube", .command = {"true"}, .gpio_chip = ""}),
             Contains("whole path"));
  CHECK_THAT(reason({.object = "cube", .command = {"/no/such"}, .gpio_chip = ""}),
             Contains("No such file"));
  CHECK_THAT(reason({.object = "cube", .command = {"/etc/passwd"}, .gpio_chip = ""}),
             Contains("Permission denied"));
}

}  // namespace aspect
