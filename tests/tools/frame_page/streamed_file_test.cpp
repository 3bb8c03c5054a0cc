// A file that others see whole or not at all.
#include "tools/frame_page/streamed_file.h"

#include <catch2/catch.hpp>

#include "tests/temporary_folder.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

}  // namespace

TEST_CASE("A file is there when it is finished, in place of what was there") {
  const TemporaryFolder folder;
  const fs::path file = folder.write("page.html", "old");
  auto streamed = StreamedFile::create(file);
  REQUIRE(streamed);
  for (const char* text : {"one ", "two ", "three"}) CHECK_FALSE(streamed.value().write(text));
  CHECK(read_file(file) == "old");
  CHECK_FALSE(streamed.value().finish());
  CHECK(read_file(file) == "one two three");
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("Of a file that is not finished nothing is left") {
  const TemporaryFolder folder;
  {
    auto streamed = StreamedFile::create(folder / "page.html");
    REQUIRE(streamed);
    const StreamedFile moved = std::move(streamed).value();
    CHECK(!fs::exists(folder / "page.html"));
  }
  CHECK(files_in(folder.path()) == 0);
}

TEST_CASE("Where no file can be, one line says so") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "taken");
  for (const char* name : {"taken", "none/page.html"}) {
    const auto streamed = StreamedFile::create(folder / name);
    REQUIRE_FALSE(streamed);
    CHECK_THAT(streamed.error(), Catch::Matchers::StartsWith((folder / name).native() + ": "));
  }
  CHECK_THAT(StreamedFile::create("/dev/null").error(), Catch::Matchers::Contains("not a regular"));
}

}  // namespace aspect
