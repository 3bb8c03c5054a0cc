// Poses as the BOP benchmark's toolkit reads them: CSV with the columns scene_id, im_id, obj_id,
// score, R (row by row), t (millimetres) and time (seconds that the whole image took), a row for
// each estimate. Its poses are ours: they take object coordinates to OpenCV's camera coordinates.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/recognition/recogniser.h"

namespace aspect {

struct BopIds {
  std::uint32_t scene = 0;
  std::vector<std::uint32_t> objects;  // of the objects loaded, in their order
  double unit_mm = 1;                  // of the scenes that they were compiled from
};

// BOP's images have a number for a name: that which the file's name ends with, or behind the # of a
// frame of a video.
std::optional<std::uint64_t> bop_image_id(std::string_view frame_name);

class BopRows {
 public:
  explicit BopRows(BopIds ids) : ids_(std::move(ids)) {}

  static std::string_view head() { return "scene_id,im_id,obj_id,score,R,t,time\n"; }

  // A row for each object that is a match or ambiguous and has a pose, of its best hypothesis, with
  // its probability for a score. An error where the name has no number, or that of another frame.
  Result<std::string> rows(std::string_view frame_name, const Recognition& recognition);

 private:
  BopIds ids_;
  std::set<std::uint64_t> images_;
};

}  // namespace aspect
