#include "tools/score/truth_table.h"

#include <catch2/catch.hpp>

namespace aspect {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

const std::string kHead = "file,object,vx,vy,vz,x,y,w,h,visible\n";

TEST_CASE("Rows of one file become one frame, in the order of the first rows") {
  const auto truth = parse_truth(kHead +
                                     "b.png,cube,1,0,0,1,2,3,4,1\n"
                                     "a.png,,,,,,,,,\n"
                                     "\r\n"
                                     "b.png,ball,0,0.6,-0.8,10,20,30,40,0.5\r\n",
                                 "t.csv");
  REQUIRE(truth.ok());
  REQUIRE(truth.value().size() == 2);
  const TrueFrame& frame = truth.value()[0];
  CHECK(frame.file == "b.png");
  REQUIRE(frame.objects.size() == 2);
  CHECK(frame.objects[0].object == "cube");
  CHECK(frame.objects[1].box == PixelBox{10, 20, 30, 40});
  CHECK(frame.objects[1].visible == 0.5);
  CHECK(frame.objects[1].view.isApprox(Eigen::Vector3d(0, 0.6, -0.8)));
  CHECK(truth.value()[1].file == "a.png");
  CHECK(truth.value()[1].objects.empty());
}

TEST_CASE("Columns are found by name, wherever they stand") {
  const auto truth = parse_truth(
      "visible,h,w,y,x,vz,vy,vx,more,object,file\n1,4,3,2,1,0,0,1,?,cube,a.png\n", "t.csv");
  REQUIRE(truth.ok());
  CHECK(truth.value()[0].objects[0].box == PixelBox{1, 2, 3, 4});
}

TEST_CASE("A truth that cannot be used is told with its line") {
  const auto error_of = [](const std::string& text) {
    const auto truth = parse_truth(text, "t.csv");
    REQUIRE_FALSE(truth.ok());
    CHECK(truth.error().find('\n') == std::string::npos);
    return truth.error();
  };
  CHECK_THAT(error_of(""), StartsWith("t.csv: holds no frames"));
  CHECK_THAT(error_of(kHead), StartsWith("t.csv: holds no frames"));
  CHECK_THAT(error_of("file,object,vx\na,b,1\n"), StartsWith("t.csv:1: no column vy"));
  CHECK_THAT(error_of(kHead + "a,cube,1,0,0\n"), StartsWith("t.csv:2: 5 fields; 10"));
  CHECK_THAT(error_of(kHead + "a,cube,1,0,0,1,2,x3,4,1\n"),
             StartsWith("t.csv:2: w is \"x3\"") && Contains("number"));
  CHECK_THAT(error_of(kHead + "a,cube,nan,0,0,1,2,3,4,1\n"), StartsWith("t.csv:2: vx"));
  CHECK_THAT(error_of(kHead + "\na,cube,1,1,0,1,2,3,4,1\n"),
             StartsWith("t.csv:3: ") && Contains("unit vector"));
  CHECK_THAT(read_truth("missing.csv").error(), StartsWith("missing.csv: no such file"));
  CHECK_THAT(read_truth(".").error(), StartsWith(".: a folder"));
}

}  // namespace
}  // namespace aspect
