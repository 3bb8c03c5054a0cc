// Stage "convert" of a range frame: at every pixel the plane that its surface has there, as a code
// of the plane's normal and place. Planes that differ, and depths that jump, part surfaces.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "runtime/vision/code_planes.h"

namespace aspect {

// A camera whose principal point is the picture's centre and whose pixels are square.
struct RangeCamera {
  float focal_px = 0, centre_x_px = 0, centre_y_px = 0;
};
RangeCamera range_camera(int width_px, int height_px, float field_of_view_deg);

// Largest difference of the codes of two normals that are an angle apart.
std::uint8_t code_step(float normal_step_deg);

class RangeCodes {
 public:
  void take(Arena& arena, int width_px, int height_px);

  // Fills codes, foreground and solid. False where the frame shows nothing. O(pixels).
  bool run(const Frame& frame, const VisionParameters& parameters, Planes& codes,
           CodeMasks& masks) noexcept;

 private:
  // Where the places of planes are counted from, and in what unit.
  struct Reference {
    std::array<float, 3> centre{};
    float size = 1;
  };
  struct RowSums;

  void read_disparities(const Frame& frame, const RangeParameters& range, CodeMasks& masks);
  void find_reference();
  void fit_row(int y, float most_misfit);
  void add_window_rows(int y, const RowSums& sums) const;
  void encode(int x, int y, const RowSums& sums, std::size_t column, float mean);
  std::size_t best_window(int x, int y) const;
  void choose_windows(Planes& codes, CodeMasks& masks) const;
  void mark_jumps(float depth_step, CodeMasks& masks) const;
  bool jumps(std::ptrdiff_t i, std::ptrdiff_t step, bool has_before, bool has_after,
             float depth_step) const;
  void spread_codes(float depth_step, Planes& codes, const CodeMasks& masks) const;
  std::size_t place(int x, int y) const { return static_cast<std::size_t>(y * stride_px_ + x); }

  std::span<float> disparity_;                    // 1 / depth, 0: nothing measured
  std::span<float> misfit_;                       // of the window about a pixel, infinite: none
  std::span<std::uint8_t> tilt_x_, tilt_y_, at_;  // code of the window about a pixel
  std::span<float> sums_;                         // five rows
  Box active_;
  int stride_px_ = 0;
  RangeCamera camera_;
  Reference reference_;
};

}  // namespace aspect
