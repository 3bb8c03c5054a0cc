// A picture to draw on in a frame's coordinates. Small frames are blown up by a whole factor, so
// that lines and text have room.
#pragma once

#include <opencv2/core.hpp>
#include <span>

#include "runtime/vision/segment.h"
#include "runtime/vision/view_graph.h"
#include "tools/draw/picture_text.h"

namespace aspect {

// The frame in colours of 8 bits, in OpenCV's order: what a camera gave as it was meant, depths as
// greys, the nearer the lighter, and surface ids in colours of their own.
cv::Mat picture_of(const Frame& frame);

// The frame with its own pixels, as a file keeps them: colours in OpenCV's order, or one channel of
// 8 or 16 bits.
cv::Mat recorded_picture(const Frame& frame);

class FrameCanvas {
 public:
  explicit FrameCanvas(const cv::Mat& frame_picture);

  cv::Mat& picture() { return picture_; }
  // Where the centre of a frame's pixel is in the picture.
  cv::Point at(float x, float y) const;
  cv::Rect at(const Box& box) const;
  int scale() const { return scale_; }
  int line_px() const;
  TextStyle text_style() const { return text_style_for(picture_.size()); }

  void draw_outline(const Contour& contour, const cv::Scalar& colour);

 private:
  int scale_;
  cv::Mat picture_;
};

// A point to write a contour's label at: its centre or, where that lies beside the region, the
// region's nearest pixel.
Point2 label_point(const Contour& contour, const RegionMap& map);

}  // namespace aspect
