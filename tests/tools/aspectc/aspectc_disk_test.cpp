// aspectc where it cannot write, or must not: one line that names the file, and nothing lost.
#include <sys/resource.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/temporary_folder.h"
#include "tests/tools/aspectc/run_aspectc.h"
#include "tests/tools/aspectc/small_disk.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Catch::StartsWith;
using nlohmann::json;

// Small pictures: the work is in the files.
std::string small_scene() {
  std::string text = read_file(ASPECT_SOURCE_DIR "/tests/data/rendered/l_shape.b");
  const std::string large = "resolution 512 512";
  return text.replace(text.find(large), large.size(), "resolution 192 192");
}

using Words = std::vector<std::string>;

Words compile_to(int level, const Words& more = {}) {
  Words words = {"part.b",     "--level", std::to_string(level), "--border-views", "0",
                 "--progress", "never"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

void check_fails(const Outcome& outcome, const Words& expected) {
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err, StartsWith("aspectc: "));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  for (const std::string& word : expected) CHECK_THAT(outcome.err, Contains(word));
}

bool has_part(const fs::path& folder) {
  return std::any_of(fs::directory_iterator(folder), fs::directory_iterator(),
                     [](const auto& entry) { return entry.path().extension() == ".part"; });
}

json statistics(const TemporaryFolder& folder) {
  return json::parse(read_file(folder.path() / "s.json"));
}

// The index of an undisturbed run.
const std::string& undisturbed(int level) {
  static std::map<int, std::string> known;
  std::string& bytes = known[level];
  if (!bytes.empty()) return bytes;
  const TemporaryFolder folder;
  folder.write("part.b", small_scene());
  REQUIRE(run_aspectc(folder.path(), compile_to(level, {"--no-store"})).exit_code == 0);
  bytes = read_file(folder.path() / "part.aspect");
  return bytes;
}

class Workplace : public TemporaryFolder {
 public:
  Workplace() { write("part.b", small_scene()); }
  Outcome run(const Words& words) const { return run_aspectc(path(), words); }
  std::string read(const std::string& name) const { return read_file(path() / name); }
};

}  // namespace

TEST_CASE("a deeper level renders what is missing, and a shallower one nothing") {
  const Workplace here, fresh;
  REQUIRE(here.run(compile_to(4, {"--stats", "s.json"})).exit_code == 0);
  const json first = statistics(here);
  REQUIRE(fresh.run(compile_to(5, {"--stats", "s.json"})).exit_code == 0);
  const json whole = statistics(fresh);
  REQUIRE(whole["views"] > first["views"]);

  REQUIRE(here.run(compile_to(5, {"--stats", "s.json"})).exit_code == 0);
  const json deepened = statistics(here);
  CHECK(deepened["views"] == whole["views"]);
  CHECK(deepened["views_rendered"].get<int>() ==
        whole["views_rendered"].get<int>() - first["views_rendered"].get<int>());
  CHECK(deepened["matches_executed"].get<int>() ==
        whole["matches_executed"].get<int>() - first["matches_executed"].get<int>());
  CHECK(here.read("part.aspect") == fresh.read("part.aspect"));

  REQUIRE(here.run(compile_to(4, {"--stats", "s.json"})).exit_code == 0);
  CHECK(statistics(here)["views_rendered"] == 0);
  CHECK(statistics(here)["matches_executed"] == 0);
  CHECK(here.read("part.aspect") == undisturbed(4));
}

TEST_CASE("inspect tells what a store belongs to and holds, and refuses what is none") {
  const Workplace here;
  REQUIRE(here.run(compile_to(4, {"--stats", "s.json"})).exit_code == 0);
  REQUIRE(here.run(compile_to(3)).exit_code == 0);
  const json store = json::parse(here.run({"inspect", "part.store", "--json"}).out);
  CHECK(store["object"] == "part");
  CHECK_THAT(store["options"].get<std::string>(), Contains("segmentation"));
  CHECK(here.run({"--version"}).out == store["compiler"].get<std::string>() + "\n");
  CHECK(store["views"] == statistics(here)["views"]);
  CHECK(store["matches"] == statistics(here)["matches_executed"]);
  CHECK(store["bytes"] == fs::file_size(here.path() / "part.store"));
  REQUIRE(store["runs"].size() == 2);
  CHECK(store["runs"][0] ==
        json({{"level", 3}, {"min_level", 3}, {"threshold", 10000.0}, {"views", 642}}));
  CHECK(store["runs"][1]["views"] == statistics(here)["views"]);
  CHECK_THAT(here.run({"inspect", "part.store"}).out,
             StartsWith("object part, ") && Contains("complete: --level 4 "));
  check_fails(here.run({"inspect", "none.store"}), {"none.store", "no such file"});
  CHECK_FALSE(fs::exists(here.path() / "none.store"));
  here.write("text.store", "no store at all");
  check_fails(here.run({"inspect", "text.store"}), {"text.store", "not a store"});
}

TEST_CASE("a store that is none, damaged, of another version or nowhere is refused in one line") {
  const Workplace here;
  REQUIRE(here.run(compile_to(3)).exit_code == 0);
  const std::string good = here.read("part.store");
  const auto refused = [&](const std::string& bytes, const std::string& why) {
    here.write("x.store", bytes);
    check_fails(here.run(compile_to(3, {"--store", "x.store", "-o", "x.aspect"})),
                {"x.store: ", why});
    CHECK(here.read("x.store") == bytes);
    CHECK_FALSE(fs::exists(here.path() / "x.aspect"));
  };
  refused("this is a text", "not a store of aspectc");
  refused(good.substr(0, good.size() - 4096), "damaged");
  std::string torn = good;
  std::fill(torn.begin() + 8192, torn.begin() + 40960, '\x5a');
  refused(torn, "damaged");
  std::string newer = good;
  newer[63] = 9;  // SQLite's user version, big-endian, at 60
  refused(newer, "another version of aspectc (store version 9");
  check_fails(here.run(compile_to(3, {"--store", "none/x.store"})), {"none/x.store: its folder"});
  fs::create_directory(here.path() / "folder");
  check_fails(here.run(compile_to(3, {"--store", "folder"})), {"folder: not a regular file"});
}

TEST_CASE("an output that is a folder or a device is refused and stays") {
  const Workplace here;
  fs::create_directory(here.path() / "folder");
  check_fails(here.run(compile_to(3, {"-o", "folder", "--no-store"})), {"folder: cannot be"});
  check_fails(here.run(compile_to(3, {"-o", "/dev/null", "--no-store"})), {"/dev/null: not a"});
  check_fails(here.run(compile_to(3, {"--stats", "/dev/null", "--no-store"})), {"/dev/null"});
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("a second compiler on one store gets one line, and the first comes to its end") {
  const Workplace here;
  ChildProgram first(ASPECTC, here.path(), compile_to(4));
  const TemporaryFolder elsewhere;
  elsewhere.write("part.b", small_scene());
  while (!fs::exists(here.path() / "part.store")) REQUIRE_FALSE(first.has_ended());
  const std::string store = (here.path() / "part.store").string();
  const Outcome second = run_aspectc(elsewhere.path(), compile_to(4, {"--store", store}));
  CHECK_FALSE(first.has_ended());
  check_fails(second, {store, "in use by another aspectc"});
  CHECK(first.wait().exit_code == 0);
  CHECK(here.read("part.aspect") == undisturbed(4));
}

TEST_CASE(
    "a store that may not grow is one line, the old index stays, and the work goes on later") {
  const Workplace here;
  here.write("part.aspect", "an old index");
  rlimit usual{};
  getrlimit(RLIMIT_FSIZE, &usual);
  const rlimit tight{200 * 1024, usual.rlim_max};
  setrlimit(RLIMIT_FSIZE, &tight);
  const Outcome outcome = here.run(compile_to(4));
  setrlimit(RLIMIT_FSIZE, &usual);
  check_fails(outcome, {"part.store: cannot be read or written (disk I/O error"});
  CHECK(here.read("part.aspect") == "an old index");
  REQUIRE(here.run(compile_to(4)).exit_code == 0);
  CHECK(here.read("part.aspect") == undisturbed(4));
}

TEST_CASE("an index that may not grow is one line, and the old one stays") {
  const Workplace here;
  REQUIRE(here.run(compile_to(4)).exit_code == 0);
  here.write("part.aspect", "an old index");
  rlimit usual{};
  getrlimit(RLIMIT_FSIZE, &usual);
  const rlimit tight{8 * 1024, usual.rlim_max};
  setrlimit(RLIMIT_FSIZE, &tight);
  const Outcome outcome = here.run(compile_to(4, {"--no-store"}));
  setrlimit(RLIMIT_FSIZE, &usual);
  check_fails(outcome, {"part.aspect: cannot be written (File too large)"});
  CHECK(here.read("part.aspect") == "an old index");
  CHECK_FALSE(has_part(here.path()));
}

TEST_CASE("a full disk is one line, the old files stay, and with room again the work goes on") {
  const Workplace here;
  const fs::path disk_folder = here.path() / "disk";
  const std::optional<SmallDisk> disk = SmallDisk::mount_at(disk_folder, 200);
  if (!disk) {
    WARN("skipped: this process may not mount a small disk");
    return;
  }
  SECTION("with the store") {
    here.write("part.aspect", "an old index");
    const Words words = compile_to(4, {"--store", "disk/x.store", "--stats", "s.json"});
    check_fails(here.run(words), {"disk/x.store: the disk is full; make room and start again"});
    CHECK(here.read("part.aspect") == "an old index");
    check_fails(here.run(words), {"disk/x.store: the disk is full"});
    REQUIRE(disk->resize(8192));
    REQUIRE(here.run(words).exit_code == 0);
    CHECK(here.read("part.aspect") == undisturbed(4));
  }
  SECTION("with the index") {
    here.write("disk/x.aspect", "an old index");
    here.write("disk/filler", std::string(190 * 1024, 'x'));
    check_fails(here.run(compile_to(4, {"-o", "disk/x.aspect", "--store", "x.store"})),
                {"disk/x.aspect: cannot be written (No space left on device)"});
    CHECK(here.read("disk/x.aspect") == "an old index");
    CHECK_FALSE(has_part(disk_folder));
  }
  SECTION("with the statistics") {
    here.write("disk/filler", std::string(1 << 20, 'x'));
    check_fails(here.run(compile_to(3, {"--no-store", "--stats", "disk/s.json"})),
                {"disk/s.json: cannot be written (No space left on device)"});
    CHECK_FALSE(has_part(disk_folder));
  }
  SECTION("read-only") {
    here.write("disk/x.aspect", "an old index");
    REQUIRE(disk->make_read_only());
    check_fails(here.run(compile_to(3, {"-o", "disk/x.aspect", "--no-store"})),
                {"disk/x.aspect: cannot be written (Read-only file system)"});
    check_fails(here.run(compile_to(3, {"--stats", "disk/s.json", "--no-store"})),
                {"disk/s.json: cannot be written (Read-only file system)"});
    check_fails(here.run(compile_to(3, {"--store", "disk/x.store"})),
                {"disk/x.store: its folder cannot be written (Read-only file system)"});
    CHECK(here.read("disk/x.aspect") == "an old index");
  }
}

}  // namespace aspect
