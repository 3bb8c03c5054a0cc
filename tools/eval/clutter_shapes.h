// What stands behind and before an object in a frame that is made: shapes in random colours, or cut
// out of pictures.
#pragma once

#include <opencv2/core.hpp>
#include <span>

#include "compiler/render/dice.h"

namespace aspect {

// Around the origin, its farthest corner at a distance of 1. Every ray from the origin leaves it
// once, so that a larger one at the same place covers a smaller one.
struct ClutterShape {
  std::vector<cv::Point2d> outline;
};

// An ellipse, a bar, a polygon or a blob.
ClutterShape random_shape(Dice& dice);

// Adds the shape's pixels, 255, to a mask of 8 bits.
void draw_shape(const ClutterShape& shape, const cv::Point2d& centre_px, double size_px,
                cv::Mat& mask);

// A surface of that size: a colour, lighter on one side, or a piece of one of the pictures where
// there are any. Red first.
cv::Mat random_surface(const cv::Size& size, std::span<const cv::Mat> pictures, Dice& dice);

// A piece of a picture of any size, from half of it on, perhaps mirrored.
cv::Mat random_piece(const cv::Mat& picture, const cv::Size& size, Dice& dice);

// Fills the pixels of the mask with such a surface.
void paint_shape(const cv::Mat& mask, std::span<const cv::Mat> pictures, Dice& dice, cv::Mat& rgb);

}  // namespace aspect
