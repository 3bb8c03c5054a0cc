#include "tools/aspectc/commands/whole_file.h"

#include <catch2/catch.hpp>
#include <vector>

#include "tests/temporary_folder.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;
using Catch::StartsWith;

const std::vector<std::uint8_t> kBytes = {0, 10, 13, 255, 7};

std::size_t file_count(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(folder)) count += entry.exists() ? 1U : 0U;
  return count;
}

void check_refused(const Result<Done>& outcome, const fs::path& file) {
  REQUIRE_FALSE(outcome.ok());
  CHECK_THAT(outcome.error(), StartsWith(file.string() + ": cannot be written ("));
  CHECK(outcome.error().find('\n') == std::string::npos);
}

}  // namespace

TEST_CASE("a file is written whole, over an older and larger one too") {
  const TemporaryFolder folder;
  const fs::path file = folder.write("x.aspect", std::string(1000, 'x'));
  REQUIRE(check_writable(file).ok());
  REQUIRE(write_whole_file(file, kBytes).ok());
  CHECK(read_file(file) == std::string(kBytes.begin(), kBytes.end()));
  REQUIRE(write_whole_file(file, {}).ok());
  CHECK(fs::file_size(file) == 0);
  CHECK(file_count(folder.path()) == 1);
}

TEST_CASE("what cannot be written is refused in one line, before and after, and leaves nothing") {
  const TemporaryFolder folder;
  const fs::path text = folder.write("text", "text");
  fs::create_directory(folder.path() / "folder");
  for (const fs::path& file :
       {folder.path() / "none" / "x", text / "x", folder.path() / "folder"}) {
    check_refused(check_writable(file), file);
    check_refused(write_whole_file(file, kBytes), file);
  }
  CHECK(file_count(folder.path()) == 2);
  CHECK(file_count(folder.path() / "folder") == 0);
}

}  // namespace aspect
