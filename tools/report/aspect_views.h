// What the compiler saw of an aspect: pictures with their named contours.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "compiler/compile.h"

namespace aspect {

using PixelLine = std::vector<std::array<int, 2>>;  // pixels of a picture

struct SeenContour {
  std::string name;              // of the aspect's contour
  PixelLine outline;             // closed
  std::array<float, 2> label{};  // a point inside
};

// A picture cut to what it shows of the object.
struct SeenView {
  Eigen::Vector3d direction{0, 0, 1};
  int left_px = 0, top_px = 0;  // of the cut in the whole picture
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> png;
  std::vector<SeenContour> contours;
  bool is_in_index = false;  // a key view that the device has, too
};

// Of every aspect the typical view first, then those farthest from the ones before: the key views
// that an index without a budget would hold, at most `most` of each. Rendered again, on all
// threads; the result does not depend on how many.
std::vector<std::vector<SeenView>> aspect_views(const LearntModel& model, const Scene& scene,
                                                const Renderer& renderer,
                                                const CompileOptions& options, std::size_t most);

// The whole object from there, cut to what is seen, without contours.
SeenView picture_from(const Eigen::Vector3d& direction, const Studio& studio,
                      const Renderer& renderer, const VisionParameters& vision);

// Fewer points, none farther than `most_px` from the line through those kept (Douglas and Peucker,
// 1973). Closed lines.
PixelLine simplified(const PixelLine& line, double most_px);

}  // namespace aspect
