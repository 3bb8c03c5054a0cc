#include "runtime/workbench/view_drawing.h"

#include <fmt/format.h>
#include <bit>
#include <chrono>
#include <cstring>
#include <iterator>

#include "runtime/recognition/model_lines.h"
#include "runtime/workbench/frame_picture.h"

namespace aspect {
namespace {

static_assert(std::endian::native == std::endian::little && sizeof(Run) == 8,
              "runs are sent as they are");

void add_edges(const PosedObject& object, const ObjectModel& model, const Frame& frame,
               std::string& json) {
  json += '[';
  const char* between = "";
  for (const PictureLine& line :
       edges_seen(model, object.pose, object.camera, frame.width_px, frame.height_px)) {
    json += between;
    json += '[';
    const char* comma = "";
    for (const Point2d& point : line) {
      fmt::format_to(std::back_inserter(json), "{}{:.1f},{:.1f}", comma, point.x, point.y);
      comma = ",";
    }
    json += ']';
    between = ",";
  }
  json += ']';
}

}  // namespace

// Null where the frame cannot be seen; one larger than before takes memory.
const RegionMap* ViewDrawing::cut(const Frame& frame, const VisionParameters& vision) {
  if (frame.width_px > width_px_ || frame.height_px > height_px_ || vision.sensor != sensor_) {
    const int width = std::max(frame.width_px, width_px_);
    const int height = std::max(frame.height_px, height_px_);
    width_px_ = height_px_ = 0;
    memory_ = {};
    vision_ = {};
    memory_.plan([&](Arena& arena) { vision_.prepare(arena, width, height, vision.sensor); });
    sensor_ = vision.sensor;
    width_px_ = width;
    height_px_ = height;
  }
  vision_.run(frame, vision);
  return &vision_.regions();
}

std::string ViewDrawing::draw(const FrameCopy& copy, const VisionParameters& vision,
                              const std::vector<ObjectModel>& models, const ViewLabel& label) {
  const auto started = std::chrono::steady_clock::now();
  const Frame& frame = copy.frame();
  const RegionMap& regions = *cut(frame, vision);
  const std::chrono::duration<double, std::milli> cutting =
      std::chrono::steady_clock::now() - started;
  const PictureSize size = size_within({frame.width_px, frame.height_px}, {kWidth_px, kHeight_px});
  const std::string picture = bitmap_of(frame, size);
  std::string json = fmt::format(
      R"({{"view": {}, "line": {}, "settings": {}, "width": {}, "height": {}, "regions": {}, )"
      R"("dropped": {}, "cut_ms": {:.2f}, "picture": {}, "runs": {}, "edges": [)",
      label.view, label.line, label.settings, frame.width_px, frame.height_px,
      regions.regions.size(), regions.dropped_regions, cutting.count(), picture.size(),
      regions.runs.size());
  const char* between = "";
  for (const PosedObject& object : copy.objects()) {
    if (object.index >= models.size()) continue;
    json += between;
    add_edges(object, models[object.index], frame, json);
    between = ",";
  }
  json += "]}";

  const auto length = static_cast<std::uint32_t>(json.size());
  const std::size_t run_bytes = regions.runs.size_bytes();
  std::string bundle(sizeof length + json.size() + picture.size() + run_bytes, '\0');
  char* to = bundle.data();
  const auto put = [&to](const void* from, std::size_t bytes) {
    if (bytes > 0) std::memcpy(to, from, bytes);
    to += bytes;
  };
  put(&length, sizeof length);
  put(json.data(), json.size());
  put(picture.data(), picture.size());
  put(regions.runs.data(), run_bytes);
  return bundle;
}

}  // namespace aspect
