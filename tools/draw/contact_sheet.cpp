#include "tools/draw/contact_sheet.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "runtime/base/check.h"
#include "tools/draw/picture_text.h"

namespace aspect {
namespace {

const cv::Scalar kDarkDesk(48, 48, 48);

cv::Size cell_size(std::span<const SheetPicture> pictures) {
  cv::Size cell(1, 1);
  for (const SheetPicture& entry : pictures) {
    cell.width = std::max(cell.width, entry.picture.cols);
    cell.height = std::max(cell.height, entry.picture.rows);
  }
  return cell;
}

cv::Mat in_colour(const cv::Mat& picture) {
  cv::Mat coloured = picture;
  if (picture.channels() == 1) cv::cvtColor(picture, coloured, cv::COLOR_GRAY2BGR);
  if (picture.channels() == 4) cv::cvtColor(picture, coloured, cv::COLOR_BGRA2BGR);
  ASPECT_CHECK(coloured.type() == CV_8UC3);
  return coloured;
}

std::string cut_to(std::string caption, const TextStyle& style, int width_px) {
  if (text_size(caption, style).width <= width_px) return caption;
  while (!caption.empty() && text_size(caption + "..", style).width > width_px) caption.pop_back();
  return caption + "..";
}

void draw_caption(cv::Mat strip, const std::string& caption, const TextStyle& cell_style) {
  const TextStyle style = fitted(cell_style, caption, strip.cols);
  const std::string text = cut_to(caption, style, strip.cols);
  const cv::Size size = text_size(text, style);
  draw_text(strip, text, {(strip.cols - size.width) / 2, (strip.rows - size.height) / 2}, style);
}

}  // namespace

int caption_height_px(cv::Size cell) {
  return text_style_for(cell).line_px;
}

cv::Mat contact_sheet(std::span<const SheetPicture> pictures, int columns) {
  ASPECT_CHECK(columns >= 1);
  if (pictures.empty()) return {};
  const cv::Size cell = cell_size(pictures);
  const int caption_px = caption_height_px(cell);
  const cv::Size step(cell.width + kSheetMargin_px, cell.height + caption_px + kSheetMargin_px);
  const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
  cv::Mat sheet(rows * step.height + kSheetMargin_px, columns * step.width + kSheetMargin_px,
                CV_8UC3, kDarkDesk);
  for (int k = 0; k < static_cast<int>(pictures.size()); ++k) {
    const SheetPicture& entry = pictures[static_cast<std::size_t>(k)];
    const cv::Point corner(kSheetMargin_px + k % columns * step.width,
                           kSheetMargin_px + k / columns * step.height);
    const cv::Point centred((cell.width - entry.picture.cols) / 2,
                            (cell.height - entry.picture.rows) / 2);
    if (!entry.picture.empty())
      in_colour(entry.picture).copyTo(sheet(cv::Rect(corner + centred, entry.picture.size())));
    const cv::Point below(corner.x, corner.y + cell.height);
    draw_caption(sheet(cv::Rect(below, cv::Size(cell.width, caption_px))), entry.caption,
                 text_style_for(cell));
  }
  return sheet;
}

}  // namespace aspect
