#include "runtime/output/rotated_file.h"

#include <sys/resource.h>
#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>

#include "tests/runtime/output/made_lines.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
namespace fs = std::filesystem;

constexpr std::size_t kLongest = 200;

LineTally tally_of(const fs::path& file) {
  LineTally tally;
  tally.take(read_file(file), kLongest);
  return tally;
}

// No file of this process may become longer while it lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    handler_ = std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

}  // namespace

TEST_CASE("rotation splits no line, loses none of those kept and keeps so many files") {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "lines";
  auto file = RotatedFile::open({path, 5000, 3});
  REQUIRE(file.ok());
  constexpr std::uint64_t kLines = 500;
  for (std::uint64_t number = 0; number < kLines; ++number)
    REQUIRE_FALSE(file.value().append(made_line(number, kLongest)));
  std::uint64_t newer = kLines;
  for (const char* ending : {"", ".1", ".2", ".3"}) {
    const fs::path one = path.string() + ending;
    INFO(one.filename());
    const LineTally tally = tally_of(one);
    CHECK(tally.broken + tally.gaps + tally.disordered == 0);
    CHECK(tally.rest.empty());
    CHECK(tally.last == newer - 1);
    CHECK(fs::file_size(one) <= 5000);
    if (*ending != '\0') CHECK(fs::file_size(one) > 5000 - kLongest);
    newer -= tally.whole;
  }
  CHECK_FALSE(fs::exists(path.string() + ".4"));
  CHECK(newer < kLines);
}

TEST_CASE("a file that is there is gone on with, and a torn last line ended") {
  const TemporaryFolder folder;
  const fs::path path = folder.write("lines", made_line(0, kLongest) + "1 tor");
  auto file = RotatedFile::open({path, 1U << 20U, 1});
  REQUIRE(file.ok());
  REQUIRE_FALSE(file.value().append(made_line(2, kLongest)));
  CHECK(read_file(path) == made_line(0, kLongest) + "1 tor\n" + made_line(2, kLongest));
}

TEST_CASE("none kept means that the file begins anew") {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "lines";
  auto file = RotatedFile::open({path, 300, 0});
  REQUIRE(file.ok());
  for (std::uint64_t number = 0; number < 50; ++number)
    REQUIRE_FALSE(file.value().append(made_line(number, kLongest)));
  const LineTally tally = tally_of(path);
  CHECK(tally.broken == 0);
  CHECK(tally.last == 49);
  CHECK_FALSE(fs::exists(path.string() + ".1"));
  CHECK(fs::file_size(path) <= 300);
}

TEST_CASE("a disk that fills up in the middle of a line leaves no piece of it") {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / "lines";
  auto file = RotatedFile::open({path, 1U << 20U, 1});
  REQUIRE(file.ok());
  std::uint64_t written = 0, refused = 0;
  {
    const FileSizeLimit full(1000);
    for (std::uint64_t number = 0; number < 40; ++number) {
      const auto error = file.value().append(made_line(number, kLongest));
      ++(error ? refused : written);
      if (error) CHECK_THAT(error->message, Contains("lines: cannot be written: "));
    }
  }
  CHECK(written > 3);
  CHECK(refused > 3);
  REQUIRE_FALSE(file.value().append(made_line(40, kLongest)));
  const LineTally tally = tally_of(path);
  CHECK(tally.broken == 0);
  CHECK(tally.rest.empty());
  CHECK(tally.whole == written + 1);
  CHECK(tally.last == 40);
}

TEST_CASE("what cannot be written to is refused with a reason") {
  const TemporaryFolder folder;
  CHECK_THAT(RotatedFile::open({folder.path(), 1000, 1}).error(), Contains("cannot be opened"));
  CHECK_THAT(RotatedFile::open({folder.path() / "no" / "such", 1000, 1}).error(),
             Contains("No such file or directory"));
  CHECK_THAT(RotatedFile::open({"/dev/null", 1000, 1}).error(), Contains("is no plain file"));
}

}  // namespace aspect
