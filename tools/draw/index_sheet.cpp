#include "tools/draw/index_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "tools/draw/class_tile.h"
#include "tools/draw/paper.h"
#include "tools/draw/picture_text.h"

namespace aspect {
namespace {

constexpr int kMargin_px = 16, kGap_px = 10, kCaption_px = 24, kHead_px = 62;
constexpr int kLeastColumns = 4, kMostColumns = 20;
const cv::Scalar kFrame(196, 190, 184);

// So many classes of each that all together are no more than there may be.
std::size_t quota_of(std::span<const ClassIndex> indexes) {
  std::size_t quota = 1;
  const auto tiles = [&](std::size_t most) {
    return std::accumulate(indexes.begin(), indexes.end(), std::size_t{0},
                           [most](std::size_t sum, const ClassIndex& index) {
                             return sum + std::min(most, index.classes.size());
                           });
  };
  while (quota < kMostTiles && tiles(quota + 1) <= kMostTiles) ++quota;
  return quota;
}

double percent_of(const ClassIndex& index, std::span<const std::size_t> classes) {
  double share = 0;
  for (const std::size_t k : classes) share += static_cast<double>(index.classes[k].area_fraction);
  return 100 * share;
}

std::string figures_of(const ClassIndex& index, std::span<const std::size_t> shown) {
  const std::string sizes =
      fmt::format("level {}, {:.1f} KiB, seen in {}", index.level,
                  static_cast<double>(index.file_bytes) / 1024, name_of(index.vision.sensor));
  if (shown.size() == index.classes.size())
    return fmt::format("{} classes, the largest first; {}", index.classes.size(), sizes);
  return fmt::format("the {} largest of {} classes, with {:.1f} % of the viewing sphere; {}",
                     shown.size(), index.classes.size(), percent_of(index, shown), sizes);
}

void draw_section(cv::Mat& sheet, int top, const ClassIndex& index,
                  std::span<const std::size_t> shown, int columns, std::vector<cv::Rect>& tiles) {
  const TextStyle large = text_style_for({900, 900}), small = text_style_for({500, 500});
  const int width = sheet.cols - 2 * kMargin_px;
  draw_dark_text(sheet, index.object, {kMargin_px, top}, fitted(large, index.object, width));
  const std::string figures = figures_of(index, shown);
  draw_dark_text(sheet, figures, {kMargin_px, top + 34}, fitted(small, figures, width), kQuietInk);
  for (std::size_t k = 0; k < shown.size(); ++k) {
    const AspectClass& aspect = index.classes[shown[k]];
    const int column = static_cast<int>(k) % columns, row = static_cast<int>(k) / columns;
    const cv::Rect place(kMargin_px + column * (kTile_px + kGap_px),
                         top + kHead_px + row * (kTile_px + kCaption_px + kGap_px), kTile_px,
                         kTile_px);
    class_tile(index, aspect, kTile_px).copyTo(sheet(place));
    cv::rectangle(sheet, place + cv::Point(-1, -1) + cv::Size(2, 2), kFrame);
    const std::string caption =
        fmt::format("{}: {:.2f} %", shown[k], 100 * static_cast<double>(aspect.area_fraction));
    draw_dark_text(sheet, caption, {place.x, place.y + kTile_px + 2}, small);
    tiles.push_back(place);
  }
}

}  // namespace

std::vector<std::size_t> largest_first(const ClassIndex& index) {
  std::vector<std::size_t> order(index.classes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return index.classes[a].area_fraction > index.classes[b].area_fraction;
  });
  return order;
}

IndexSheet index_sheet(std::span<const ClassIndex> indexes) {
  const std::size_t quota = quota_of(indexes);
  std::vector<std::vector<std::size_t>> shown;
  std::size_t most = 1;
  IndexSheet sheet;
  for (const ClassIndex& index : indexes) {
    shown.push_back(largest_first(index));
    sheet.classes += shown.back().size();
    shown.back().resize(std::min(quota, shown.back().size()));
    sheet.shown += shown.back().size();
    most = std::max(most, shown.back().size());
  }
  const int columns =
      std::clamp(static_cast<int>(std::lround(std::sqrt(1.6 * static_cast<double>(most)))),
                 kLeastColumns, kMostColumns);
  const auto height_of = [&](std::size_t tiles) {
    const int rows = (static_cast<int>(tiles) + columns - 1) / columns;
    return kHead_px + rows * (kTile_px + kCaption_px + kGap_px) + kMargin_px;
  };
  int height = kMargin_px;
  for (const auto& classes : shown) height += height_of(classes.size());
  sheet.picture =
      cv::Mat(height, 2 * kMargin_px + columns * (kTile_px + kGap_px) - kGap_px, CV_8UC3, kDesk);
  int top = kMargin_px;
  for (std::size_t k = 0; k < indexes.size(); ++k) {
    draw_section(sheet.picture, top, indexes[k], shown[k], columns, sheet.tiles);
    top += height_of(shown[k].size());
  }
  return sheet;
}

}  // namespace aspect
