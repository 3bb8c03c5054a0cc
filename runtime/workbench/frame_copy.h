// A frame of the loop with what was recognised in it, copied for those who look at it later.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/recognition/recogniser.h"
#include "runtime/vision/vision_limits.h"

namespace aspect {

// Of a match, or one of several.
struct PosedObject {
  std::uint16_t index = 0;
  RigidPose pose;
  CameraModel camera;
};

class FrameCopy {
 public:
  // Without gaps between rows and planes.
  static std::size_t bytes_of(const Frame& frame) noexcept;

  // Of so many bytes.
  void make_room(std::size_t bytes) { bytes_.resize(std::max(bytes, bytes_.size())); }
  // False, and nothing is copied, where there is no room. Allocates nothing.
  bool copy(const Frame& frame) noexcept;
  void copy_poses(const Recognition& recognition, std::span<const CameraModel> cameras) noexcept;

  // Lives as long as the copy and is not copied itself.
  const Frame& frame() const { return frame_; }
  std::span<const std::uint8_t> bytes() const { return std::span(bytes_).first(used_); }
  std::span<const PosedObject> objects() const { return std::span(objects_).first(count_); }

 private:
  std::vector<std::uint8_t> bytes_;
  std::size_t used_ = 0;
  Frame frame_;
  std::array<PosedObject, kMaxBlobs> objects_{};
  std::size_t count_ = 0;
};

}  // namespace aspect
