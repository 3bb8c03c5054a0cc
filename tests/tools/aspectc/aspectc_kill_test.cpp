// aspectc killed twenty times or more: what it had shown to be done a moment before is still there,
// and the index has the bytes of a run that nobody disturbed.
#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <regex>

#include "tests/temporary_folder.h"
#include "tests/tools/aspectc/run_aspectc.h"
#include "tests/tools/aspectc/terminal_program.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using nlohmann::json;
using std::chrono::milliseconds;

constexpr int kKills = 20;
// Of these so many must come late enough to tell: on a busy machine that takes more of them.
constexpr std::size_t kLateKills = 5;
constexpr int kMostKills = 3 * kKills;
constexpr unsigned kSeed = 20;
// A second of work may be lost; the rest is for a machine that does other things besides.
constexpr milliseconds kMayBeLost{1200};

const std::vector<std::string> kCompile = {ASPECT_SOURCE_DIR "/compiler/models/l_shape.b",
                                           "--level",
                                           "6",
                                           "--border-views",
                                           "0",
                                           "-o",
                                           "l.aspect",
                                           "--stats",
                                           "s.json",
                                           "--progress",
                                           "always"};

// What the last line of progress in a text says: views of a level.
struct ShownViews {
  int level = 0;
  std::size_t done = 0, wanted = 0;
};
std::vector<ShownViews> shown_views(const std::string& text) {
  static const std::regex pattern(R"(level (\d+)/\d+, (\d+) of (\d+) views)");
  std::vector<ShownViews> all;
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at)
    all.push_back({std::stoi((*at)[1]), std::stoul((*at)[2]), std::stoul((*at)[3])});
  return all;
}

struct Undisturbed {
  std::string bytes;
  std::size_t views = 0;
  std::map<int, std::size_t> views_below;  // in all levels before this one
};

Undisturbed run_undisturbed() {
  const TemporaryFolder folder;
  const Outcome outcome = run_aspectc(folder.path(), kCompile);
  REQUIRE(outcome.exit_code == 0);
  Undisturbed run;
  run.bytes = read_file(folder.path() / "l.aspect");
  run.views = json::parse(read_file(folder.path() / "s.json"))["views"];
  std::map<int, std::size_t> of_level;
  for (const ShownViews& shown : shown_views(outcome.err)) of_level[shown.level] = shown.wanted;
  std::size_t below = 0;
  for (const auto& [level, views] : of_level) {
    run.views_below[level] = below;
    below += views;
  }
  REQUIRE(below == run.views);
  return run;
}

// How many views a terminal had told to be done at that time.
std::size_t told_before(const TerminalProgram& program, Clock::time_point time,
                        const Undisturbed& calm) {
  std::string text;
  for (const TerminalProgram::Shown& part : program.shown())
    if (part.at < time) text += part.text;
  const std::vector<ShownViews> views = shown_views(text);
  return views.empty() ? 0 : calm.views_below.at(views.back().level) + views.back().done;
}

std::size_t kept_views(const fs::path& folder) {
  if (!fs::exists(folder / "l.store")) return 0;
  const Outcome outcome = run_aspectc(folder, {"inspect", "l.store", "--json"});
  // Killed before there was anything in it.
  if (outcome.exit_code == 1 && fs::file_size(folder / "l.store") == 0) return 0;
  REQUIRE(outcome.exit_code == 0);
  return json::parse(outcome.out)["views"];
}

struct Kill {
  bool hit = false;  // else it was done before
  std::size_t kept = 0, told_long_before = 0, told = 0;
};

Kill kill_after(milliseconds moment, const fs::path& folder, const Undisturbed& calm) {
  TerminalProgram program(folder, kCompile);
  Kill kill;
  kill.hit = program.watch_until(Clock::now() + moment);
  const auto killed_at = Clock::now();
  program.send(SIGKILL);
  program.wait();
  kill.kept = kept_views(folder);
  kill.told_long_before = told_before(program, killed_at - kMayBeLost, calm);
  kill.told = told_before(program, killed_at, calm);
  return kill;
}

}  // namespace

TEST_CASE("twenty kills at random moments lose a second of work each, and not a bit of the index") {
  const Undisturbed calm = run_undisturbed();
  std::mt19937 random(kSeed);
  std::optional<TemporaryFolder> folder(std::in_place);
  int kills = 0;
  std::size_t kept = 0, lost = 0, long_kept = 0;
  while (kills < kKills || (long_kept < kLateKills && kills < kMostKills)) {
    const milliseconds moment(100 + random() % 2300);
    const Kill kill = kill_after(moment, folder->path(), calm);
    INFO("seed " << kSeed << ", kill " << kills << " after " << moment.count() << " ms: kept "
                 << kill.kept << " views, told " << kill.told << ", long before "
                 << kill.told_long_before);
    const fs::path index = folder->path() / "l.aspect";
    if (fs::exists(index)) CHECK(read_file(index) == calm.bytes);
    CHECK(kill.kept >= std::max(kept, kill.told_long_before));
    CHECK(kill.kept <= calm.views);
    long_kept += kill.told_long_before > kept ? 1U : 0U;
    lost += kill.told - std::min(kill.told, kill.kept);
    kept = kill.kept;
    kills += kill.hit ? 1 : 0;
    if (kill.hit) continue;
    CHECK(fs::exists(index));
    folder.emplace();
    kept = 0;
  }
  std::cout << "seed " << kSeed << ": " << kills << " kills lost " << lost << " views of "
            << calm.views << "\n";
  CHECK(long_kept >= kLateKills);
  REQUIRE(run_aspectc(folder->path(), kCompile).exit_code == 0);
  CHECK(read_file(folder->path() / "l.aspect") == calm.bytes);
  const json stats = json::parse(read_file(folder->path() / "s.json"));
  CHECK(stats["views_rendered"] == calm.views - kept);
}

}  // namespace aspect
