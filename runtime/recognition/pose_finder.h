// From a key view that fits to a pose that was looked at: the model is laid over the blob, refined
// and compared with it.
#pragma once

#include <span>

#include "runtime/base/arena.h"
#include "runtime/recognition/class_index.h"
#include "runtime/recognition/pose_refinement.h"

namespace aspect {

// Where a key view has the object: seen from `direction`, turned in the picture by `roll_rad`.
struct ViewStart {
  Vector3 key_direction{};  // that the roll was measured against
  Vector3 direction{};      // the better estimate, near it
  float roll_rad = 0;
  LightGain light;
};

struct VerifiedPose {
  RefinedPose refined;
  Agreement agreement;
};

class PoseFinder {
 public:
  // What is larger than any picture.
  static constexpr Box kEverything{-(1 << 20), -(1 << 20), 1 << 21, 1 << 21};

  void prepare(Arena& arena, std::span<const ClassIndex> indexes);

  // Lays the model over the blob: the centre of what is seen of it on the blob's, as large as it;
  // corrected so often. `looked_at` is the part of the picture that something can be seen in.
  RigidPose start(const ClassIndex& index, const ViewStart& view, const CameraModel& camera,
                  const Blob& blob, const Box& looked_at, int corrections = 2);

  // The pose refined in `rounds`, 0: as it is, and how far it explains the blob.
  VerifiedPose verify(const ClassIndex& index, const RigidPose& start, const LightGain& light,
                      const CameraModel& camera, const RegionMap& regions, const Planes& colours,
                      int blob, int rounds);

 private:
  SeenColours seen_;
  RefinementScratch scratch_;
};

}  // namespace aspect
