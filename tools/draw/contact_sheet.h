// Many pictures on one sheet.
#pragma once

#include <opencv2/core.hpp>
#include <span>
#include <string>

namespace aspect {

struct SheetPicture {
  cv::Mat picture;      // 8 bits a channel; grey, BGR or BGRA; may be empty
  std::string caption;  // one line below it, made smaller or cut where it is too wide
};

// Row by row in a grid of `columns` (at least 1), every cell as large as the largest picture and
// the caption, with kSheetMargin_px between and around. Without pictures an empty one.
cv::Mat contact_sheet(std::span<const SheetPicture> pictures, int columns);

inline constexpr int kSheetMargin_px = 8;

// Of the caption under cells of this size.
int caption_height_px(cv::Size cell);

}  // namespace aspect
