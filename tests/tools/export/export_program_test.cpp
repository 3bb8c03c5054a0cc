// aspect-export as its users start it, and where it cannot write.
#include <sys/resource.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/tools/aspectc/small_disk.h"
#include "tests/tools/export/exported_store.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Catch::StartsWith;
using Words = std::vector<std::string>;

const std::string& store() {
  static const std::string name = sample_store().string();
  return name;
}

// A file of each kind that is quickly made.
Words quick(const std::string& folder) {
  return {store(), folder, "--format", "vert", "--format", "part", "--format", "class"};
}

void check_fails(const Outcome& outcome, const Words& expected) {
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err, StartsWith("aspect-export: "));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  for (const std::string& word : expected) CHECK_THAT(outcome.err, Contains(word));
}

Words files_in(const fs::path& folder) {
  Words names;
  for (const auto& entry : fs::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

const Words kQuickFiles = {"l_shape.2.part", "l_shape.2.vert", "l_shape.class"};

}  // namespace

TEST_CASE("the same bytes for any number of threads, and other files stay") {
  const TemporaryFolder here;
  here.write("b/other.txt", "mine");
  here.write("b/l_shape.means", "an old file");
  const Words details = {"--format", "det", "--format", "means"};
  const auto run = [&](const std::string& folder, const std::string& jobs) {
    Words words = {store(), folder, "--jobs", jobs};
    words.insert(words.end(), details.begin(), details.end());
    return run_export(here.path(), words);
  };
  const Outcome first = run("a/new", "1"), second = run("b", "3");
  REQUIRE(first.err == "");
  REQUIRE(first.exit_code == 0);
  REQUIRE(second.exit_code == 0);
  CHECK_THAT(first.out, StartsWith("l_shape level 2: "));
  CHECK_THAT(first.out, Contains("; 2 files, ") && Contains(" MiB in a/new\n"));
  CHECK(files_in(here / "a/new") == Words{"l_shape.2.det", "l_shape.means"});
  CHECK(files_in(here / "b") == Words{"l_shape.2.det", "l_shape.means", "other.txt"});
  for (const char* name : {"l_shape.2.det", "l_shape.means"})
    CHECK(read_file(here / "a/new" / name) == read_file(here / "b" / name));
  CHECK(read_file(here / "b/other.txt") == "mine");
}

TEST_CASE("a level below the store's is the thesis's model, without views on borders") {
  const TemporaryFolder here;
  Words words = quick("files");
  words.insert(words.end(), {"--level", "1"});
  REQUIRE(run_export(here.path(), words).exit_code == 0);
  CHECK(files_in(here / "files") == Words{"l_shape.1.part", "l_shape.1.vert", "l_shape.class"});
  CHECK_THAT(read_file(here / "files/l_shape.1.vert"), StartsWith("42\n3 -1.0000000000 "));
  words = quick("thesis");
  words.emplace_back("--without-borders");
  REQUIRE(run_export(here.path(), words).exit_code == 0);
  CHECK_THAT(read_file(here / "thesis/l_shape.2.vert"), StartsWith("162\n"));
  words.insert(words.end(), {"--level", "3"});
  check_fails(run_export(here.path(), words), {"l_shape.store: its model goes to level 2, not 3"});
}

TEST_CASE("what is no store, or no folder, is one line") {
  const TemporaryFolder here;
  here.write("text.store", "no store");
  here.write("file", "mine");
  check_fails(run_export(here.path(), {"none.store", "files"}), {"none.store: no such file"});
  check_fails(run_export(here.path(), {"text.store", "files"}), {"text.store: ", "not a store"});
  check_fails(run_export(here.path(), {store(), "file"}), {"file: cannot be written (Not a dir"});
  check_fails(run_export(here.path(), {store(), "file/files"}),
              {"file/files: cannot be written (Not"});
  check_fails(run_export(here.path(), {store(), "/proc/files"}),
              {"/proc/files: cannot be written ("});
  CHECK(read_file(here / "file") == "mine");
  for (const Words& wrong : {Words{store()},
                             {store(), "files", "more"},
                             {store(), "files", "--format", "img"},
                             {store(), "files", "--level", "x"}}) {
    const Outcome outcome = run_export(here.path(), wrong);
    CHECK(outcome.exit_code == 2);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
}

TEST_CASE("files that may not grow are one line, and the old ones stay") {
  const TemporaryFolder here;
  for (const std::string& name : kQuickFiles) here.write("files/" + name, "old");
  here.write("files/.aspect-export.1/l_shape.class", "of a killed program");
  rlimit usual{};
  getrlimit(RLIMIT_FSIZE, &usual);
  const rlimit tight{4 * 1024, usual.rlim_max};
  setrlimit(RLIMIT_FSIZE, &tight);
  const Outcome outcome = run_export(here.path(), quick("files"));
  setrlimit(RLIMIT_FSIZE, &usual);
  check_fails(outcome,
              {"files/l_shape.2.vert: cannot be written (File too large); check the folder"});
  CHECK(files_in(here / "files") == kQuickFiles);
  for (const std::string& name : kQuickFiles) CHECK(read_file(here / "files" / name) == "old");
}

TEST_CASE("a full disk is one line, and the old files stay") {
  const TemporaryFolder here;
  fs::create_directory(here / "disk");
  const auto disk = SmallDisk::mount_at(here / "disk", 64);
  if (!disk) {
    WARN("may not mount: not tested");
    return;
  }
  here.write("disk/l_shape.class", "old");
  check_fails(run_export(here.path(), quick("disk")),
              {"disk/l_shape.2.", ": cannot be written (No space left on device); check"});
  CHECK(files_in(here / "disk") == Words{"l_shape.class"});
  CHECK(read_file(here / "disk/l_shape.class") == "old");
  REQUIRE(disk->resize(4096));
  REQUIRE(run_export(here.path(), quick("disk")).exit_code == 0);
  CHECK(files_in(here / "disk") == kQuickFiles);
  REQUIRE(disk->make_read_only());
  check_fails(run_export(here.path(), quick("disk")),
              {"disk: cannot be written (Read-only file system)"});
}

}  // namespace aspect
