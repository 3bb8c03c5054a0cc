// Frames of an object in clutter, made: somewhere in the picture before coloured shapes or pieces
// of pictures, partly hidden, lit from a side, blurred and noisy.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <vector>

#include "compiler/render/camera.h"
#include "runtime/vision/frame.h"
#include "tools/eval/lit_object.h"

namespace aspect {

struct ClutterSettings {
  double hidden_max = 0.7;  // share of the object, at most; a third of the frames hide nothing
  std::span<const cv::Mat> backgrounds;  // red first; none: shapes alone
};

struct ClutteredFrame {
  int width_px = 0, height_px = 0;
  std::vector<std::uint8_t> rgb;

  // Of the object, where there is one.
  bool has_object = false;
  Camera camera;
  Box box;             // of what is seen of it; empty where nothing is
  double visible = 0;  // share of its pixels that nothing hides
  enum class Pixel : std::uint8_t { other, hidden, visible };
  std::vector<Pixel> pixels;

  Frame view() const {
    return {rgb.data(), width_px, height_px, std::ptrdiff_t{3} * width_px, PixelFormat::rgb8};
  }
};

// Every fourth frame, from the fourth on, shows no object.
constexpr bool is_empty_frame(std::size_t number) {
  return number % 4 == 3;
}

// The same dice give the same frame. Of an object with a studio in perspective; it is within the
// picture, at once to 2.2 times the studio's distance. Takes some milliseconds; may be called by
// several threads at once.
ClutteredFrame make_cluttered_frame(const Scene& scene, const LitObject& object, bool with_object,
                                    const ClutterSettings& settings, Dice dice);

// Those of a frame: other ones for every seed, object and number.
Dice dice_of_frame(std::uint64_t seed, std::size_t object, std::size_t number);

}  // namespace aspect
