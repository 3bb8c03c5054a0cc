// OpenCV's LINEMOD on a set of frames: what recognition in clutter is measured beside. Writes lines
// like aspect-replay's, OUT/linemod-THRESHOLD.ndjson and, with a test of colours after it,
// OUT/linemod-colours-THRESHOLD.ndjson, and on standard error how many templates
// there are and what they take.
#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "compiler/scene/scene_reader.h"
#include "tools/bench/camera_table.h"
#include "tools/bench/linemod_templates.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

struct Options {
  std::vector<std::string> scenes;
  std::string set, out;
  std::vector<int> thresholds = {80};
  int shrink = 1;
  int first_frames = 0;
  bool write_templates = false;
  LinemodSampling sampling;
};

Intrinsics read_lens(const fs::path& file) {
  const std::map<std::string, double> values = camera_table(file.native());
  Intrinsics lens;
  lens.width_px = static_cast<int>(values.at("width"));
  lens.height_px = static_cast<int>(values.at("height"));
  lens.fx_px = values.at("fx"), lens.fy_px = values.at("fy");
  lens.cx_px = values.at("cx"), lens.cy_px = values.at("cy");
  return lens;
}

// Pixel centres are at whole numbers, the picture's border at -0.5.
Intrinsics shrunk(Intrinsics lens, int by) {
  lens.width_px /= by, lens.height_px /= by;
  lens.fx_px /= by, lens.fy_px /= by;
  lens.cx_px = (lens.cx_px + 0.5) / by - 0.5;
  lens.cy_px = (lens.cy_px + 0.5) / by - 0.5;
  return lens;
}

std::string json(const LinemodObject& object, int enlarge) {
  const Eigen::Quaterniond q(object.camera_from_object);
  const Eigen::Vector3d& t = object.translation_camera;
  const Eigen::Vector3d view = (-object.camera_from_object.transpose() * t).normalized();
  const cv::Rect& box = object.box_px;
  char text[512];
  std::snprintf(
      text, sizeof(text),
      R"({"box":[%d,%d,%d,%d],"verdict":"match","hypotheses":[{"object":"%s",)"
      R"("score":%.3f,"view":[%.6f,%.6f,%.6f],"pose":{"quaternion":[%.9f,%.9f,%.9f,%.9f],)"
      R"("translation":[%.9f,%.9f,%.9f]}}]})",
      enlarge * box.x, enlarge * box.y, enlarge * box.width, enlarge * box.height,
      object.name.c_str(), object.similarity, view.x(), view.y(), view.z(), q.w(), q.x(), q.y(),
      q.z(), t.x(), t.y(), t.z());
  return text;
}

std::vector<fs::path> frames_of(const Options& options) {
  std::vector<fs::path> frames;
  for (const auto& entry : fs::directory_iterator(fs::path(options.set) / "frames"))
    frames.push_back(entry.path());
  std::sort(frames.begin(), frames.end());
  if (options.first_frames > 0 && frames.size() > static_cast<std::size_t>(options.first_frames))
    frames.resize(static_cast<std::size_t>(options.first_frames));
  return frames;
}

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Matched once for both ways to choose; each is told with the time that it would take alone.
void recognise_all(const LinemodModel& model, const Intrinsics& lens, const Options& options,
                   int threshold) {
  std::array<std::ofstream, 2> out;
  for (const bool test_colours : {false, true})
    out[test_colours].open(
        fs::path(options.out) /
        ((test_colours ? "linemod-colours-" : "linemod-") + std::to_string(threshold) + ".ndjson"));
  for (const fs::path& frame : frames_of(options)) {
    const cv::Mat read = cv::imread(frame.string());
    const auto start = Clock::now();
    cv::Mat picture;
    cv::resize(read, picture, cv::Size(lens.width_px, lens.height_px), 0, 0, cv::INTER_AREA);
    picture = linemod_padded(picture, options.sampling.spread_px);
    std::vector<cv::linemod::Match> matches;
    model.detector->match({picture}, static_cast<float>(threshold), matches);
    const double match_ms = ms_since(start);
    for (const bool test_colours : {false, true}) {
      const auto choice = Clock::now();
      std::string seen;
      for (const LinemodObject& object :
           linemod_objects(model, matches, picture, lens, test_colours))
        seen += (seen.empty() ? "" : ",") + json(object, options.shrink);
      out[test_colours] << R"({"frame":")" << frame.string() << R"(","elapsed_ms":)"
                        << match_ms + ms_since(choice) << R"(,"objects":[)" << seen << "]}"
                        << std::endl;
    }
  }
}

int run(const Options& options) {
  fs::create_directories(options.out);
  const Intrinsics lens = shrunk(read_lens(fs::path(options.set) / "camera.toml"), options.shrink);
  std::vector<Scene> scenes;
  for (const std::string& file : options.scenes) {
    Result<Scene> scene = read_scene(file);
    if (!scene) return std::fprintf(stderr, "linemod-clutter: %s\n", scene.error().c_str()), 1;
    scenes.push_back(std::move(scene).value());
  }
  // Measured as ours, on one core; and threads of its own only slow the making of templates.
  cv::setNumThreads(1);
  const auto start = Clock::now();
  const LinemodModel model = linemod_model(scenes, lens, options.sampling);
  const std::chrono::duration<double> elapsed = Clock::now() - start;
  std::fprintf(stderr, "templates: %d, made in %.0f s\n", model.detector->numTemplates(),
               elapsed.count());
  for (const int threshold : options.thresholds) recognise_all(model, lens, options, threshold);
  if (options.write_templates)
    model.detector->writeClasses((fs::path(options.out) / "templates_%s.yml.gz").string());
  return 0;
}

}  // namespace
}  // namespace aspect

int main(int argc, char** argv) {
  aspect::Options options;
  CLI::App app("OpenCV's LINEMOD on the frames of SET (frames/, camera.toml)");
  app.add_option("SET", options.set)->required();
  app.add_option("OUT", options.out, "folder for linemod-THRESHOLD.ndjson")->required();
  app.add_option("--scene", options.scenes, "an object; once each")->required();
  app.add_option("--threshold", options.thresholds, "of similarity, in percent; once each");
  app.add_option("--shrink", options.shrink, "frames are made smaller by it first")
      ->check(CLI::PositiveNumber);
  app.add_option("--first-frames", options.first_frames, "only so many; 0: all");
  app.add_flag("--write-templates", options.write_templates, "OUT/templates_NAME.yml.gz");
  app.add_option("--sphere-level", options.sampling.sphere_level)->check(CLI::Range(0, 5));
  app.add_option("--turn-deg", options.sampling.turn_deg)->check(CLI::PositiveNumber);
  app.add_option("--nearest", options.sampling.nearest)->check(CLI::PositiveNumber);
  app.add_option("--farthest", options.sampling.farthest)->check(CLI::PositiveNumber);
  app.add_option("--distances", options.sampling.distances)->check(CLI::PositiveNumber);
  app.add_option("--features", options.sampling.features, "a template")->check(CLI::PositiveNumber);
  app.add_option("--spread-px", options.sampling.spread_px, "a level of the pyramid, finest first");
  CLI11_PARSE(app, argc, argv);
  return aspect::run(options);
}
