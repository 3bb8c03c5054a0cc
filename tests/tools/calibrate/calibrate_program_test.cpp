// aspect-calibrate as its users start it: rendered frames of a cube in a light whose colour is
// known.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/child_program.h"
#include "tests/runtime/recognition/rendered_views.h"
#include "tests/temporary_folder.h"
#include "tests/tools/calibrate/board_picture.h"
#include "tools/aspectc/project/prepared_object.h"
#include "tools/calibrate/object/surface_map.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using nlohmann::json;

const Eigen::Vector3d kTint(1.1, 0.95, 0.75);

// A camera's picture of what was rendered: under a tinted light, blurred, with noise.
cv::Mat photographed(const OwnedFrame& frame, const Eigen::Vector3d& tint, unsigned seed) {
  cv::Mat rgb(frame.height_px, frame.width_px, CV_8UC3,
              const_cast<std::uint8_t*>(frame.rgb.data()));
  cv::Mat picture, noise(rgb.size(), CV_32FC3), seen;
  cv::cvtColor(rgb, picture, cv::COLOR_RGB2BGR);
  picture.convertTo(picture, CV_32FC3);
  cv::multiply(picture, cv::Scalar(0.85 * tint[2], 0.85 * tint[1], 0.85 * tint[0]), picture);
  cv::GaussianBlur(picture, picture, {3, 3}, 0.7);
  cv::RNG dice(seed);
  dice.fill(noise, cv::RNG::NORMAL, 0, 1.5);
  cv::Mat(picture + noise).convertTo(seen, CV_8UC3);
  return seen;
}

class Workshop {
 public:
  Workshop() {
    const auto bytes = model_index_bytes("cube", 3);
    folder_.write("cube.aspect", std::string(bytes.begin(), bytes.end()));
    for (const char* file : {"cube.b", "cube.bo", "studio.bo", "palette.bc", "rl.bc", "rl.bo"})
      folder_.write(file, read_file(std::string(ASPECT_SOURCE_DIR "/compiler/models/") + file));
  }

  void take_frames(const std::string& folder, const Eigen::Vector3d& tint, int count) const {
    ModelCamera camera("cube");
    const std::array<Eigen::Vector3d, 4> views = {
        Eigen::Vector3d(0.48, 0.6, 0.64), Eigen::Vector3d(-0.48, -0.6, 0.64),
        Eigen::Vector3d(0.6, -0.64, -0.48), Eigen::Vector3d(-0.64, 0.48, -0.6)};
    folder_.write(folder + "/none", "");
    for (int k = 0; k < count; ++k) {
      const OwnedFrame frame = camera.view(views[static_cast<std::size_t>(k % 4)], 0.3 * k);
      cv::imwrite((folder_ / (folder + "/" + std::to_string(k) + ".png")).native(),
                  photographed(frame, tint, static_cast<unsigned>(k)));
    }
  }

  Outcome run(const std::string& arguments) const {
    return run_shell(folder_.path(), "'" ASPECT_CALIBRATE "' " + arguments);
  }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

Eigen::Vector3d vector_of(const json& numbers) {
  return {numbers[0].get<double>(), numbers[1].get<double>(), numbers[2].get<double>()};
}

TEST_CASE("Colours under a tinted light are measured to 0.01, and a project shows them") {
  const Workshop workshop;
  workshop.take_frames("frames", kTint, 4);
  const Outcome outcome = workshop.run(
      "colours --scene cube.b --index cube.aspect frames -o seen.toml --json --dump drawn");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const json result = json::parse(outcome.out);
  REQUIRE(result["colours"].size() == 6);
  const auto prepared = read_prepared_object(workshop.folder() / "seen.toml");
  INFO((prepared ? "" : prepared.error()));
  REQUIRE(prepared);
  const Scene& scene = prepared.value().scene;
  for (const json& colour : result["colours"]) {
    const Eigen::Vector3d truth = shares_of(vector_of(colour["before"]).cwiseProduct(kTint));
    INFO(colour.dump());
    CHECK_FALSE(colour["estimated"]);
    CHECK((vector_of(colour["share"]) - truth).cwiseAbs().maxCoeff() < 0.01);
    for (const int index : colour["surfaces"].get<std::vector<int>>()) {
      const Surface& surface = scene.surfaces[static_cast<std::size_t>(index)];
      const Eigen::Vector3d shown = surface.ambient.cwiseProduct(scene.studio.ambient);
      CHECK((shares_of(shown) - truth).cwiseAbs().maxCoeff() < 0.01);
    }
  }
  for (const json& frame : result["frames"]) CHECK(frame["light_change"].get<double>() < 1.05);
  // The sampled pixels, with a bar of swatches below.
  const cv::Mat drawn = cv::imread((workshop.folder() / "drawn/000002_samples.png").native());
  CHECK(drawn.rows > 512);

  // Once more, from its own project: the same tables in place of the old ones.
  const Outcome again =
      workshop.run("colours --scene seen.toml --index cube.aspect frames -o seen.toml");
  INFO(again.err);
  CHECK(again.exit_code == 0);
  const std::string text = read_file(workshop.folder() / "seen.toml");
  CHECK(text.find("---- measured by") == text.rfind("---- measured by"));
  CHECK(read_prepared_object(workshop.folder() / "seen.toml"));
}

TEST_CASE("A light that changes from frame to frame is told with its control") {
  const Workshop workshop;
  workshop.take_frames("frames", kTint, 2);
  workshop.take_frames("other", {0.8, 0.95, 1.15}, 2);
  const Outcome outcome = workshop.run("colours --scene cube.b --index cube.aspect frames other");
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.err, Contains("white_balance_automatic"));
  CHECK_THAT(outcome.out, StartsWith("# cube in the colours") && Contains("[[surface]]"));
}

TEST_CASE(
    "A surface that is pointed at needs no index, and the others get its light only with company") {
  const Workshop workshop;
  workshop.folder().write("frames/none", "");
  cv::Mat picture(100, 200, CV_8UC3, cv::Scalar(0, 0, 0));
  picture(cv::Rect(10, 10, 60, 60)) = cv::Scalar(40, 80, 120);
  picture(cv::Rect(70, 10, 60, 60)) = cv::Scalar(150, 60, 30);
  cv::imwrite((workshop.folder() / "frames/a.png").native(), picture);
  const Outcome outcome =
      workshop.run("colours --scene cube.b --click 0,40,40 --click 1,100,40,0 frames --json");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  const json result = json::parse(outcome.out);
  CHECK((vector_of(result["colours"][0]["share"]) - Eigen::Vector3d(0.5, 1.0 / 3, 1.0 / 6)).norm() <
        0.002);
  CHECK((vector_of(result["colours"][1]["share"]) - Eigen::Vector3d(30, 60, 150) / 240).norm() <
        0.002);
  CHECK(result["colours"][2]["estimated"]);
  for (const char* click : {"0,300,40", "99,40,40", "0,40,40,3"}) {
    const Outcome bad = workshop.run(std::string("colours --scene cube.b frames --click ") + click);
    INFO(click << bad.err);
    CHECK(bad.exit_code == 1);
    CHECK(std::count(bad.err.begin(), bad.err.end(), '\n') == 1);
  }
}

TEST_CASE(
    "A board is printed, photographed and measured, into a configuration that keeps the rest") {
  const Workshop workshop;
  Board board;
  board.columns = 7;
  board.rows = 5;
  const TakingCamera camera = wide_camera(320, 240);
  const BoardStudio studio(board, camera);
  workshop.folder().write("shots/none", "");
  int number = 0;
  for (const RigidPose& pose : studio.poses(6, 9, true))
    cv::imwrite((workshop.folder() / ("shots/" + std::to_string(number++) + ".png")).native(),
                studio.take(pose, 1));
  const auto file =
      workshop.folder().write("camera.toml", "# mine\n[segmentation]\nchroma_step = 9\n");
  const Outcome outcome =
      workshop.run("camera --squares 7x5 shots -o camera.toml --json --dump drawn");
  INFO(outcome.err);
  REQUIRE(outcome.exit_code == 0);
  CHECK_THAT(outcome.err, Contains("6 pictures are few"));
  const json result = json::parse(outcome.out);
  CHECK(result["camera"]["fx"].get<double>() == Approx(camera.model.fx_px).epsilon(0.02));
  CHECK_THAT(read_file(file),
             StartsWith("# mine\n[segmentation]\nchroma_step = 9\n\n[camera]\nwidth = 320\n"));
  CHECK(cv::imread((workshop.folder() / "drawn/000000_coverage.png").native()).cols == 320);

  const Outcome none = workshop.run("camera --squares 9x6 shots");
  CHECK(none.exit_code == 1);
  CHECK_THAT(none.err, Contains("found in 0 pictures") && Contains("--squares 9x6"));
  CHECK(workshop.run("board -o board.pdf").exit_code == 0);
  CHECK_THAT(read_file(workshop.folder() / "board.pdf"), StartsWith("%PDF"));
}

TEST_CASE("Wrong usage ends with 2 and bad files with 1, both in one line") {
  const Workshop workshop;
  workshop.take_frames("frames", kTint, 1);
  workshop.folder().write("broken.png", "no picture");
  workshop.folder().write("broken.aspect", "no index");
  for (const char* arguments :
       {"", "board -o board.png", "board --squares 9 -o b.pdf", "colours --scene cube.b frames",
        "colours --scene cube.b --click nowhere frames"}) {
    const Outcome outcome = workshop.run(arguments);
    INFO(arguments << outcome.err);
    CHECK(outcome.exit_code == 2);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
  for (const char* arguments :
       {"camera broken.png", "noise frames --config nowhere.toml", "board -o nowhere/b.pdf",
        "colours --scene cube.b --index broken.aspect frames",
        "segmentation --scene cube.b --index cube.aspect frames"}) {
    const Outcome outcome = workshop.run(arguments);
    INFO(arguments << outcome.err);
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.out == "");
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
  // Another object's index.
  workshop.folder().write("other.toml", "scene = \"ball.b\"\n");
  workshop.folder().write("ball.b",
                          "studio { at 0 0 0 ambient 1 1 1 }\nsurface { diffuse 1 0 0 }\n"
                          "sphere { center 0 0 0 radius 0.2 }\n");
  CHECK_THAT(workshop.run("colours --scene other.toml --index cube.aspect frames").err,
             Contains("another size"));
  CHECK(workshop.run("--help").exit_code == 0);
  CHECK_THAT(workshop.run("--version").out, StartsWith("aspect-calibrate "));
}

}  // namespace
}  // namespace aspect
