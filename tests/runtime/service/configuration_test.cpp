#include "runtime/service/configuration.h"

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "runtime/service/segmentation_table.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

std::string error_of(const std::string& text) {
  const auto configuration = parse_configuration(text, "c.toml");
  REQUIRE_FALSE(configuration.ok());
  CHECK(configuration.error().find('\n') == std::string::npos);
  return configuration.error();
}

constexpr const char* kCamera =
    "[camera]\nwidth = 640\nheight = 480\nfx = 686.2\nfy = 686\ncx = 319.5\ncy = -1\n";

TEST_CASE("A configuration without tables changes nothing") {
  const auto configuration = parse_configuration("# nothing\n", "c.toml");
  REQUIRE(configuration.ok());
  CHECK_FALSE(configuration.value().camera);
  RecogniserParameters parameters;
  parameters.top = 7;
  parameters.vision.chroma_step = 17;
  configuration.value().apply(parameters);
  CHECK(parameters.top == 7);
  CHECK(parameters.vision.chroma_step == 17);
}

TEST_CASE("A camera is read") {
  const auto configuration = parse_configuration(kCamera, "c.toml");
  REQUIRE(configuration.ok());
  REQUIRE(configuration.value().camera);
  const CameraConfiguration& camera = *configuration.value().camera;
  CHECK(camera.width_px == 640);
  CHECK(camera.height_px == 480);
  CHECK(camera.model.fx_px == 686.2);
  CHECK(camera.model.fy_px == 686);
  CHECK(camera.model.cx_px == 319.5);
  CHECK(camera.model.cy_px == -1);
}

TEST_CASE("All of segmentation and recognition is applied") {
  const auto configuration = parse_configuration(
      "segmentation = {intensity_min = 150, chroma_step = 12, noise_steps = 0,\n"
      "intensity_step = 40, area_min_px = 99, thickness_min_px = 2.5, smooth = false,\n"
      "region_of_interest = [1, 2, 30, 40]}\n"
      "[recognition]\nmatching = \"simple\"\nranking = 'classes'\ntop = 3\nshortlist_slack = 0\n",
      "c.toml");
  // Inline tables must stay on one line in TOML.
  CHECK_FALSE(configuration.ok());
  const auto mended = parse_configuration(
      "[segmentation]\nintensity_min = 150\nchroma_step = 12\nnoise_steps = 0\n"
      "intensity_step = 40\narea_min_px = 99\nthickness_min_px = 2.5\nsmooth = false\n"
      "region_of_interest = [1, 2, 30, 40]\n"
      "[recognition]\nmatching = \"simple\"\nranking = 'classes'\ntop = 3\nshortlist_slack = 0\n",
      "c.toml");
  REQUIRE(mended.ok());
  RecogniserParameters parameters;
  mended.value().apply(parameters);
  CHECK(parameters.vision.intensity_min == 150);
  CHECK(parameters.vision.chroma_step == 12);
  CHECK(parameters.vision.noise_steps == 0);
  CHECK(parameters.vision.intensity_step == 40);
  CHECK(parameters.vision.area_min_px == 99);
  CHECK(parameters.vision.thickness_min_px == 2.5F);
  CHECK_FALSE(parameters.vision.smooth);
  CHECK(parameters.vision.region_of_interest == Box{1, 2, 30, 40});
  CHECK(parameters.matching == Matching::simple);
  CHECK(parameters.ranking == RecogniserParameters::Ranking::classes);
  CHECK(parameters.top == 3);
  CHECK(parameters.shortlist_slack == 0);
}

TEST_CASE(
    "Tracking is off until it is asked for, and new objects are looked for as often as said") {
  const auto parameters_of = [](const char* text) {
    const auto configuration = parse_configuration(text, "c.toml");
    REQUIRE(configuration.ok());
    RecogniserParameters parameters;
    configuration.value().apply(parameters);
    return parameters.tracking;
  };
  CHECK_FALSE(parameters_of("").on);
  CHECK(parameters_of("").search_every == 10);
  CHECK(parameters_of("[recognition]\ntrack = true\n").on);
  CHECK(parameters_of("[recognition]\nsearch_every = 1\n").search_every == 1);
}

TEST_CASE("A frame's time limit is read in milliseconds, and there is none by itself") {
  const auto limit_of = [](const std::string& text) {
    const auto configuration = parse_configuration(text, "c.toml");
    REQUIRE(configuration);
    RecogniserParameters parameters;
    configuration.value().apply(parameters);
    return parameters.time_limit;
  };
  CHECK(limit_of("").count() == 0);
  CHECK(limit_of("[recognition]\ntime_limit_ms = 12.5\n") == std::chrono::microseconds(12500));
  CHECK(limit_of("[recognition]\ntime_limit_ms = 40\n") == std::chrono::milliseconds(40));
}

TEST_CASE("Unknown names are refused with their line and the nearest known name") {
  CHECK_THAT(error_of("\n[segmentation]\nchroma_stp = 3\n"),
             StartsWith("c.toml:3: ") && Contains("did you mean chroma_step?"));
  CHECK_THAT(error_of("[cammera]\n"), StartsWith("c.toml:1: ") && Contains("did you mean camera?"));
  CHECK_THAT(error_of("top = 3\n"), StartsWith("c.toml:1: top is not known"));
  CHECK_THAT(error_of(std::string(kCamera) + "fov = 50\n"), StartsWith("c.toml:8: "));
}

TEST_CASE("Wrong types and numbers out of range are refused with their line") {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"[segmentation]\nchroma_step = 0\n",
       "c.toml:2: [segmentation] chroma_step is 0; it must be "
       "a whole number from 1 to 255"},
      {"[segmentation]\nchroma_step = 256\n", "c.toml:2: [segmentation] chroma_step is 256"},
      {"[segmentation]\nchroma_step = 8.0\n", "c.toml:2: [segmentation] chroma_step is 8"},
      {"[segmentation]\nchroma_step = '8'\n", "c.toml:2: [segmentation] chroma_step is \"8\""},
      {"[segmentation]\nintensity_min = -1\n", "c.toml:2: [segmentation] intensity_min is -1"},
      {"[segmentation]\narea_min_px = 99999999999\n", "c.toml:2: [segmentation] area_min_px is 9"},
      {"[segmentation]\nthickness_min_px = nan\n", "c.toml:2: [segmentation] thickness_min_px is"},
      {"[segmentation]\nthickness_min_px = inf\n", "c.toml:2: [segmentation] thickness_min_px is"},
      {"[segmentation]\nsmooth = 1\n", "c.toml:2: [segmentation] smooth is 1; it must be true or"},
      {"[segmentation]\nregion_of_interest = [1, 2, 3]\n", "c.toml:2: [segmentation] region_of"},
      {"[segmentation]\nregion_of_interest = [1,\n2, -3, 4]\n", "c.toml:3: [segmentation] region"},
      {"[segmentation]\nregion_of_interest = [1, 2, 0, 4]\n", "c.toml:2: [segmentation] region_of"},
      {"segmentation = 3\n", "c.toml:1: segmentation is 3; it must be a table"},
      {"[[camera]]\nwidth = 3\n", "c.toml:1: camera is an array; it must be a table"},
      {"[recognition]\ntop = 65\n", "c.toml:2: [recognition] top is 65"},
      {"[recognition]\ntrack = 1\n", "c.toml:2: [recognition] track is 1"},
      {"[recognition]\nsearch_every = 0\n", "c.toml:2: [recognition] search_every is 0"},
      {"[recognition]\nsearch_every = 1001\n", "c.toml:2: [recognition] search_every is 1001"},
      {"[recognition]\ntime_limit_ms = 0\n",
       "c.toml:2: [recognition] time_limit_ms is 0; it must be a number from 0.001 to 60000"},
      {"[recognition]\ntime_limit_ms = -5\n", "c.toml:2: [recognition] time_limit_ms is -5"},
      {"[recognition]\ntime_limit_ms = nan\n", "c.toml:2: [recognition] time_limit_ms is nan"},
      {"[recognition]\ntime_limit_ms = '5'\n", "c.toml:2: [recognition] time_limit_ms is \"5\""},
      {"[recognition]\ntop = 1979-05-27\n", "c.toml:2: [recognition] top is a date or time"},
      {"[recognition]\nmatching = 'best'\n",
       "c.toml:2: [recognition] matching is \"best\"; it "
       "must be \"simple\" or \"weighted\""},
      {"[recognition]\nranking = true\n", "c.toml:2: [recognition] ranking is true"},
      {"[camera]\nwidth = 9000\n", "c.toml:2: [camera] width is 9000"},
  };
  for (const auto& [text, expected] : cases) CHECK_THAT(error_of(text), StartsWith(expected));
}

TEST_CASE("A camera must be complete") {
  const std::string camera = kCamera;
  CHECK_THAT(error_of(camera.substr(0, camera.find("cy"))),
             StartsWith("c.toml:1: [camera] cy is missing"));
}

TEST_CASE("A camera to capture from needs no lens") {
  const auto configuration = parse_configuration(
      "indexes = [\"a.aspect\", \"/b/c.aspect\"]\n"
      "[camera]\ndevice = \"bus:usb-1.2\"\nformat = \"NV12\"\nwidth = 320\nheight = 240\n"
      "rate = 12.5\nstall_ms = 300\n"
      "[camera.controls]\nwhite_balance_automatic = 0\nauto_exposure = 1\ngain = -3\n"
      "[recognition]\nscore_min = 0.25\n"
      "[process]\nlock_memory = true\nrealtime_priority = 20\ncpus = [1, 3]\n",
      "etc/c.toml");
  REQUIRE(configuration.ok());
  const Configuration& read = configuration.value();
  CHECK(read.indexes == std::vector<std::filesystem::path>{"etc/a.aspect", "/b/c.aspect"});
  CHECK_FALSE(read.camera);
  CHECK(read.capture.device == "bus:usb-1.2");
  CHECK(read.capture.format == "NV12");
  CHECK(read.capture.width_px == 320);
  CHECK(read.capture.height_px == 240);
  CHECK(read.capture.rate_hz == 12.5);
  CHECK(read.capture.stall == std::chrono::milliseconds(300));
  // Set in the order of the file: automatics must be off before what they hold can be set.
  CHECK(read.capture.controls == std::vector<CameraControl>{{"white_balance_automatic", 0},
                                                            {"auto_exposure", 1},
                                                            {"gain", -3}});
  CHECK(read.process == ProcessSettings{true, 20, {1, 3}});
  RecogniserParameters parameters;
  read.apply(parameters);
  CHECK(parameters.score_min == 0.25);
}

TEST_CASE("What a live camera cannot be told is refused with its line") {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"indexes = \"a\"\n", "c.toml:1: indexes is \"a\"; it must be an array of texts"},
      {"indexes = [\"a\",\n\"\"]\n", "c.toml:1: indexes holds an empty name"},
      {"[camera]\nwidth = 9000\n", "c.toml:2: [camera] width is 9000"},
      {"[camera]\nformat = \"MJPEG\"\n", "c.toml:2: [camera] format must have four characters"},
      {"[camera]\ndevice = \"\"\n", "c.toml:2: [camera] device is empty"},
      {"[camera]\nrate = 0\n", "c.toml:2: [camera] rate is 0"},
      {"[camera]\nstall_ms = 99\n", "c.toml:2: [camera] stall_ms is 99"},
      {"[camera]\ncontrols = 3\n", "c.toml:2: [camera] controls is 3; it must be a table"},
      {"[camera.controls]\ngain = \"high\"\n", "c.toml:2: [camera] gain is \"high\""},
      {"[process]\ncpus = [0, -1]\n", "c.toml:2: [process] cpus is -1"},
      {"[process]\nrealtime_priority = 100\n", "c.toml:2: [process] realtime_priority is 100"},
      {"[process]\nlock_memory = 1\n", "c.toml:2: [process] lock_memory is 1"},
  };
  for (const auto& [text, expected] : cases) CHECK_THAT(error_of(text), StartsWith(expected));
}

TEST_CASE("What is not TOML is refused with its line") {
  CHECK_THAT(error_of("[camera]\nwidth = \n"), StartsWith("c.toml:2: not TOML"));
  CHECK_THAT(error_of("[camera]\n[camera]\n"), StartsWith("c.toml:2: not TOML"));
  CHECK_THAT(error_of(std::string("a\0b", 3)), StartsWith("c.toml:1: not TOML"));
  CHECK_THAT(error_of("\xFF\xFE"), StartsWith("c.toml:1: not TOML"));
  CHECK_THAT(error_of("a = " + std::string(5000, '[')), StartsWith("c.toml:1: not TOML"));
}

TEST_CASE("Files that are no configuration are refused by name") {
  const auto missing = read_configuration("no/such.toml");
  REQUIRE_FALSE(missing.ok());
  CHECK_THAT(missing.error(), StartsWith("no/such.toml: no such file"));
  const auto folder = read_configuration("/");
  REQUIRE_FALSE(folder.ok());
  CHECK_THAT(folder.error(), StartsWith("/: not a file"));
}

TEST_CASE("A project can read its segmentation table by itself") {
  const toml::table project = toml::parse("[segmentation]\nchroma_step = 20\n");
  VisionParameters parameters;
  CHECK_FALSE(read_segmentation(*project["segmentation"].as_table(), "p.toml", parameters));
  CHECK(parameters.chroma_step == 20);

  const toml::table wrong = toml::parse("[segmentation]\nchroma_step = 20\nsmoth = true\n");
  VisionParameters untouched;
  const auto error = read_segmentation(*wrong["segmentation"].as_table(), "p.toml", untouched);
  REQUIRE(error);
  CHECK_THAT(error->message, StartsWith("p.toml:3: ") && Contains("did you mean smooth?"));
  CHECK(untouched.chroma_step == VisionParameters().chroma_step);
}

}  // namespace
}  // namespace aspect
