#include "runtime/workbench/kept_file.h"

#include <sys/stat.h>
#include <unistd.h>
#include <catch2/catch.hpp>

#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;

int files_in(const std::filesystem::path& folder) {
  int count = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++count;
  return count;
}

}  // namespace

TEST_CASE("a file is replaced, and those before it are kept, the newest as .1") {
  const TemporaryFolder folder;
  const auto file = folder.write("a.toml", "0");
  REQUIRE(::chmod(file.c_str(), 0640) == 0);
  for (int k = 1; k <= 12; ++k) {
    const auto kept = replace_and_keep(file, std::to_string(k));
    REQUIRE(kept.ok());
    CHECK(kept.value().filename() == "a.toml.1");
    CHECK(read_file(file) == std::to_string(k));
    for (int age = 1; age <= std::min(k, kMostKept); ++age)
      CHECK(read_file(folder / ("a.toml." + std::to_string(age))) == std::to_string(k - age));
  }
  CHECK(files_in(folder.path()) == 1 + kMostKept);
  struct stat status {};
  REQUIRE(::stat(file.c_str(), &status) == 0);
  CHECK((status.st_mode & 0777U) == 0640U);
}

TEST_CASE("where a kept one is missing, the older ones stay") {
  const TemporaryFolder folder;
  const auto file = folder.write("a.toml", "new");
  folder.write("a.toml.2", "older");
  REQUIRE(replace_and_keep(file, "newer").ok());
  CHECK(read_file(folder / "a.toml.1") == "new");
  CHECK(read_file(folder / "a.toml.2") == "older");
}

TEST_CASE("a link stays one, and what it names is replaced") {
  const TemporaryFolder folder;
  const auto file = folder.write("there/a.toml", "old");
  std::filesystem::create_symlink(file, folder / "link.toml");
  const auto kept = replace_and_keep(folder / "link.toml", "new");
  REQUIRE(kept.ok());
  CHECK(std::filesystem::is_symlink(folder / "link.toml"));
  CHECK(read_file(file) == "new");
  CHECK(read_file(folder / "there/a.toml.1") == "old");
}

TEST_CASE("what cannot be replaced is left as it is") {
  const TemporaryFolder folder;
  CHECK_THAT(replace_and_keep(folder / "none.toml", "new").error(), Contains("none.toml: cannot"));
  std::filesystem::create_directory(folder / "folder");
  CHECK_THAT(replace_and_keep(folder / "folder", "new").error(), Contains("no regular file"));
  // A folder in the place of the kept one.
  const auto file = folder.write("a.toml", "old");
  std::filesystem::create_directories(folder / "a.toml.9/full");
  for (int age = 1; age < kMostKept; ++age)
    folder.write("a.toml." + std::to_string(age), std::to_string(age));
  CHECK_FALSE(replace_and_keep(file, "new").ok());
  CHECK(read_file(file) == "old");
  CHECK_FALSE(
      std::filesystem::exists(folder.path() / ("a.toml." + std::to_string(::getpid()) + ".part")));
}

}  // namespace aspect
