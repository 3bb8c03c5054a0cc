// aspectc inspect --sheet as its users start it.
#include <algorithm>
#include <catch2/catch.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/temporary_folder.h"
#include "tests/tools/aspectc/run_aspectc.h"
#include "tests/tools/tiny_index.h"

namespace aspect {
namespace {

void check_refused(const Outcome& outcome, const std::string& part) {
  CAPTURE(outcome.err);
  CHECK(outcome.exit_code == 1);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err, Catch::StartsWith("aspectc: ") && Catch::Contains(part));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
}

}  // namespace

TEST_CASE("An index becomes a picture, and what is none is refused in one line") {
  const TemporaryFolder folder;
  cv::Mat seen(64, 64, CV_8UC3, cv::Scalar(0, 0, 0));
  seen(cv::Rect(16, 16, 32, 32)).setTo(cv::Scalar(20, 20, 200));
  write_tiny_index(folder / "tiny.aspect", "tiny", seen);
  const auto inspect = [&](const std::vector<std::string>& words) {
    std::vector<std::string> all = {"inspect"};
    all.insert(all.end(), words.begin(), words.end());
    return run_aspectc(folder.path(), all);
  };
  const Outcome outcome = inspect({"tiny.aspect", "--sheet", "sheet.png"});
  INFO(outcome.err);
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out == "sheet.png: 1 class\n");
  CHECK(cv::imread((folder / "sheet.png").string()).cols > 200);
  const std::string bytes = read_file(folder / "tiny.aspect");
  folder.write("cut.aspect", bytes.substr(0, bytes.size() / 2));
  folder.write("part.store", "");
  check_refused(inspect({"cut.aspect", "--sheet", "none.png"}), "cut.aspect: ");
  check_refused(inspect({"part.store", "--sheet", "none.png"}), "part.store: is a store");
  check_refused(inspect({"tiny.aspect", "--sheet", "none/sheet.png"}), "none/sheet.png: ");
  CHECK_FALSE(std::filesystem::exists(folder / "none.png"));
}

}  // namespace aspect
