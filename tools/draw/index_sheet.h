// All that an index knows of its objects as one picture: a tile a class.
#pragma once

#include <opencv2/core.hpp>
#include <span>

#include "runtime/recognition/class_index.h"

namespace aspect {

// Of all objects; more classes are left out, the smallest of those objects that have the most.
inline constexpr std::size_t kMostTiles = 400;
inline constexpr int kTile_px = 200;

struct IndexSheet {
  cv::Mat picture;
  std::size_t shown = 0, classes = 0;
  std::vector<cv::Rect> tiles;  // where they are in the picture, object by object
};

// A section an object with its name and figures, its classes by their share of the viewing sphere,
// the largest first; under a tile the class's number and its share.
IndexSheet index_sheet(std::span<const ClassIndex> indexes);

// The classes of an object in that order.
std::vector<std::size_t> largest_first(const ClassIndex& index);

}  // namespace aspect
