// From hypotheses to poses: the models of the best are laid over the blob, the poses that explain
// it best are refined, and rank what they came from.
#pragma once

#include <span>

#include "runtime/base/arena.h"
#include "runtime/base/deadline.h"
#include "runtime/recognition/class_index.h"
#include "runtime/recognition/hypothesis.h"
#include "runtime/recognition/pose_finder.h"
#include "runtime/vision/vision.h"

namespace aspect {

// A camera for each index, whose objects it is assumed to have been compiled for.
struct SeenBlob {
  const Planes* colours = nullptr;
  const RegionMap* regions = nullptr;
  std::size_t place = 0;  // of the blob in regions
  std::span<const CameraModel> cameras;
  Deadline deadline{};  // when it is over, no further pose is tried
};

class PoseSearch {
 public:
  static constexpr std::size_t kMostPoses = 4;  // of a blob

  void prepare(Arena& arena, std::span<const ClassIndex> indexes);

  // `poses` is where the poses go that hypotheses point to, at most kMostPoses are taken; returns
  // how many. A hypothesis with a pose gets the pose's view, the class that is seen from there, and
  // as score the share of object and picture that agree; the others come after, in the order that
  // they are in.
  std::size_t run(std::span<Hypothesis> list, const SeenBlob& blob, std::span<VerifiedPose> poses);

  // A pose found elsewhere: the canonical one of those that look alike, and from it the
  // hypothesis's view and class.
  void settle(Hypothesis& hypothesis, VerifiedPose& pose) const;

  // The view and the class of a pose that stays as it is.
  void name(Hypothesis& hypothesis, const VerifiedPose& pose) const;

 private:
  VerifiedPose verify(const Hypothesis& hypothesis, const RigidPose& pose, const SeenBlob& blob,
                      int rounds);
  void name_class(Hypothesis& hypothesis, std::span<Hypothesis> list) const;

  std::span<const ClassIndex> indexes_;
  PoseFinder finder_;
};

}  // namespace aspect
