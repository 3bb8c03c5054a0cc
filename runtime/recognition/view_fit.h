// How well a key view explains what is seen: colour, size, shape and place of every contour
// compared at the best roll. Answers which view, where classes alone say which aspect.
#pragma once

#include <array>
#include <span>

#include "runtime/recognition/assignment.h"
#include "runtime/recognition/class_index.h"

namespace aspect {

// Differences that count as one; squares of them are added up. Tuned on random views rendered by
// the compiler.
struct ViewFitScales {
  float share = 0.06F;      // colour share
  float position = 0.06F;   // square roots of the blob's area
  float area = 0.04F;       // shares of the blob's area
  float second = 0.012F;    // second moments, in the blob's area
  float third = 0.004F;     // third moments, in the blob's area to 1.5
  float missing = 6.0F;     // cost of a contour without partner, and
  float missing_area = 40;  // on top of it for all of the blob's area
  float roll = 0.15F;       // cost of standing on the head: cameras are seldom rolled by chance

  float alone(float contour_area) const { return missing + missing_area * contour_area; }
};

struct ViewFit {
  float cost = 0;         // 0: perfect
  float roll_rad = 0;     // the frame is turned by this against the key view
  Assignment assignment;  // frame contour -> key contour
};

class ViewFitter {
 public:
  // What is seen; at most kMaxSide contours.
  void set_contours(std::span<const ContourFeature> seen);

  // The best fit, or one with a cost of at least `give_up`, whichever is found first.
  ViewFit fit(std::span<const KeyContour> key, float give_up);

 private:
  struct Turn {
    float cos = 1, sin = 0;
  };
  float least_cost(std::span<const KeyContour> key);
  std::size_t candidate_turns(std::span<const KeyContour> key);
  float evaluate(std::span<const KeyContour> key, Turn turn, float give_up, Assignment& assignment);
  float add_shape(float cost, const Moments& a, const Moments& b) const;
  double most_weight(std::size_t columns) const;
  Turn aligned(std::span<const KeyContour> key, const Assignment& assignment, Turn otherwise) const;

  static constexpr std::size_t kMaxTurns = 24;
  ViewFitScales scales_;
  // What is needed again and again of a seen contour.
  struct Seen {
    float alone = 0, radius = 0;
    Moments shape;  // in units of the blob
  };
  std::span<const ContourFeature> seen_;
  std::array<Seen, kMaxSide> of_seen_{};
  std::array<std::size_t, 2> anchors_{};
  std::size_t anchor_count_ = 0;
  std::array<float, kMaxSide * kMaxSide> roll_free_{};  // cost of what does not change with roll,
  std::array<float, kMaxSide * kMaxSide> placeless_{};  // and without that of the distance
  std::array<double, kMaxSide * kMaxSide> weights_{};
  std::array<Turn, kMaxTurns> turns_{};
};

}  // namespace aspect
