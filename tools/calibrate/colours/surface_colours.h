// The colours of an object's surfaces as a camera and a light show them: shares of r, g, b, which
// the thesis measured, too.
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tools/calibrate/object/posed_frames.h"
#include "tools/calibrate/object/surface_map.h"

namespace aspect {

struct SamplingParameters {
  // Pixels from a surface's border that are not looked at: blur, and a pose that is not exact.
  double rim_px = 3;
  // Sums of r, g and b, and single channels, outside of which shares are not the surface's.
  int darkest_sum = 60, lightest = 250;
  // A surface must show so many pixels in a frame.
  std::size_t least_pixels = 40;
};

// A paint in one frame.
struct PaintSample {
  int paint = 0;
  std::size_t frame = 0;  // place among the frames
  std::vector<cv::Point> pixels;
  Eigen::Vector3d share{0, 0, 0};  // of r, g, b: medians, which highlights do not move
  double brightness = 0;           // mean of r, g, b, 0 to 255: the median
  double cut_off_share = 0;        // of its pixels, that are too light
};

// Of all paints that are seen well enough. `paints` is SurfaceMapper's map.
std::vector<PaintSample> sample_paints(const cv::Mat& picture, const cv::Mat& paints,
                                       std::size_t paint_count, std::size_t frame,
                                       const SamplingParameters& parameters);

// Around a place that somebody points at: the pixels there that have one colour, without their rim.
// Nothing where that is no picture of a surface: outside, cut off, too dark.
std::optional<PaintSample> sample_at(const cv::Mat& picture, cv::Point place, int paint,
                                     std::size_t frame, const SamplingParameters& parameters);

struct PaintColour {
  std::size_t frames = 0, pixels = 0;  // 0: not seen
  Eigen::Vector3d share{0, 0, 0};
  double spread = 0;  // between frames: median of the largest channel's distances
  double brightness = 0;
  double cut_off_share = 0;
  bool is_estimate = false;  // of one that is not seen, by the light on the others
};

// One of each paint, over the frames: medians, so that a wrong pose does no harm, in which frames
// that show it lighter and larger weigh more.
std::vector<PaintColour> paint_colours(const std::vector<PaintSample>& samples,
                                       std::size_t paint_count);

// Gives those that are not seen the scene's colour under the light that the others show, where
// these are enough to say it: half the object in new colours and half in old ones has none that
// fit.
void add_unseen(const std::vector<Paint>& paints, std::vector<PaintColour>& colours);

// How much the light's colour of each frame differs from all frames' by what surfaces show: the
// largest ratio of two channels' gains; 1: not at all, or not known.
std::vector<double> light_changes(const std::vector<PaintSample>& samples,
                                  const std::vector<PaintColour>& colours, std::size_t frames);

}  // namespace aspect
