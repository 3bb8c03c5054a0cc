// What a frame showed, kept for as long as somebody looks at it: aspect.h's own structs are good
// until the next frame only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "runtime/c_interface/aspect.h"

namespace aspect {

struct KeptRecognition {
  // `owner` has the names of objects. Two allocations a list; O(what was seen).
  KeptRecognition(const aspect_recognition& seen, std::shared_ptr<const void> owner);
  KeptRecognition(const KeptRecognition&) = delete;
  KeptRecognition& operator=(const KeptRecognition&) = delete;

  std::shared_ptr<const void> owner;
  std::vector<aspect_object> objects;
  std::vector<aspect_hypothesis> hypotheses;
  std::vector<aspect_pose> poses;
  std::vector<aspect_contour_match> matches;
  std::vector<std::uint8_t> rivals, chains;
  std::vector<aspect_contour> contours;
  std::vector<aspect_camera> cameras;
  int dropped_regions = 0;
  double elapsed_ms = 0;
  aspect_left_undone left_undone{};
};

}  // namespace aspect
