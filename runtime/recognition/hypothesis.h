// What an object seen may be: which class of which index, from where, and how it stands.
#pragma once

#include <cstdint>
#include <span>

#include "runtime/recognition/pose_finder.h"

namespace aspect {

struct ContourMatch {
  std::uint16_t contour = 0;  // of the frame: index into ViewGraph::contours
  std::uint16_t name = 0;     // of the class
};

struct Hypothesis {
  std::uint16_t index = 0;  // which of the loaded indexes
  std::uint16_t class_id = 0;
  double score = 0;                // what the list is ordered by, higher is better
  double class_score = 0;          // the thesis's, equation 4.2
  int matched = 0, unmatched = 0;  // of the frame's contours
  Vector3 view{};                  // unit vector from the object's centre to the camera
  float least_cost = 0;            // no key view of its class fits better; views only
  float roll_rad = 0;              // the frame is turned by this against the key view; views only
  ViewStart start;                 // views only
  bool is_joined = false;       // found by what light has parted taken together (blob_features.h)
  bool is_second_view = false;  // its class is there already, with a better key view elsewhere
  const VerifiedPose* pose = nullptr;  // null: none was looked for
  std::span<const ContourMatch> contours;
};

inline bool better(const Hypothesis& a, const Hypothesis& b) {
  if (a.score != b.score) return a.score > b.score;
  if (a.class_score != b.class_score) return a.class_score > b.class_score;
  if (a.index != b.index) return a.index < b.index;
  if (a.class_id != b.class_id) return a.class_id < b.class_id;
  return a.is_second_view < b.is_second_view;
}

}  // namespace aspect
