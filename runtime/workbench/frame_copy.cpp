#include "runtime/workbench/frame_copy.h"

#include <algorithm>
#include <cstring>

namespace aspect {
namespace {

struct Plane {
  std::size_t row_bytes = 0, rows = 0;
};

Plane first_plane(const Frame& frame) {
  return {static_cast<std::size_t>(bytes_per_pixel(frame.format)) *
              static_cast<std::size_t>(frame.width_px),
          static_cast<std::size_t>(frame.height_px)};
}

// Of pairs for every two columns and rows.
Plane chroma_plane(const Frame& frame) {
  if (!has_chroma_plane(frame.format)) return {};
  return {static_cast<std::size_t>(frame.width_px), static_cast<std::size_t>(frame.height_px) / 2};
}

std::uint8_t* copy_rows(const std::uint8_t* from, std::ptrdiff_t stride, const Plane& plane,
                        std::uint8_t* to) {
  for (std::size_t y = 0; y < plane.rows; ++y, from += stride, to += plane.row_bytes)
    std::memcpy(to, from, plane.row_bytes);
  return to;
}

}  // namespace

std::size_t FrameCopy::bytes_of(const Frame& frame) noexcept {
  const Plane first = first_plane(frame), second = chroma_plane(frame);
  return first.row_bytes * first.rows + second.row_bytes * second.rows;
}

bool FrameCopy::copy(const Frame& frame) noexcept {
  const std::size_t bytes = bytes_of(frame);
  if (frame.data == nullptr || bytes == 0 || bytes > bytes_.size()) return false;
  const Plane first = first_plane(frame), second = chroma_plane(frame);
  std::uint8_t* const chroma = copy_rows(frame.data, frame.stride_bytes, first, bytes_.data());
  frame_ = frame;
  frame_.data = bytes_.data();
  frame_.stride_bytes = static_cast<std::ptrdiff_t>(first.row_bytes);
  if (second.rows > 0 && frame.chroma != nullptr) {
    copy_rows(frame.chroma, frame.chroma_stride_bytes, second, chroma);
    frame_.chroma = chroma;
    frame_.chroma_stride_bytes = static_cast<std::ptrdiff_t>(second.row_bytes);
  }
  used_ = bytes;
  count_ = 0;
  return true;
}

void FrameCopy::copy_poses(const Recognition& recognition,
                           std::span<const CameraModel> cameras) noexcept {
  count_ = 0;
  for (const SeenObject& object : recognition.objects) {
    const Verdict verdict = object.judgement.verdict;
    if ((verdict != Verdict::match && verdict != Verdict::ambiguous) || object.hypotheses.empty() ||
        count_ == objects_.size())
      continue;
    const Hypothesis& best = object.hypotheses.front();
    if (best.pose == nullptr || best.index >= cameras.size()) continue;
    objects_[count_++] = {best.index, best.pose->refined.pose, cameras[best.index]};
  }
}

}  // namespace aspect
