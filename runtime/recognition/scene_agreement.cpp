#include "runtime/recognition/scene_agreement.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/base/portable_math.h"

namespace aspect {
namespace {

// Cells of a colour that is seen, and what a leak costs.
constexpr int kLeastCells = 8;
constexpr float kLeastColour_px = 60;
// Nothing dark hides an object.
constexpr float kLeakCost = 0.5F, kEmptyCost = 0.5F, kWithin = 0.6F, kHiddenShare = 0.3F,
                kExplainedShare = 0.8F;

ColourClass colour_beside(const ModelDrawing& drawing, int column, int row) {
  constexpr int kRim = 2;
  for (int d = 1; d <= kRim; ++d)
    for (const auto& [right, down] : {std::pair{-d, 0}, {d, 0}, {0, -d}, {0, d}}) {
      const int x = column + right, y = row + down;
      if (x < 0 || y < 0 || x >= drawing.width() || y >= drawing.height()) continue;
      const ModelDrawing::Cell cell = drawing.cell(x, y);
      if (cell.covered) return cell.colour;
    }
  return kBackgroundClass;
}

// A logistic regression over 12,000 refined hypotheses in rendered frames: of objects that touch,
// of clutter, and of others of the same colours and almost the same shapes.
float margin_of(const SceneAgreement& agreement, float borders_met, float seen_px) {
  constexpr float kOfBorders = 3.02F, kOfThreeColours = 1.93F, kOfArea = 0.858F, kOfRegions = 3.14F,
                  kEven = 26.1F;
  // More than the fit knows says no more.
  constexpr float kMostArea_px = 30000;
  constexpr std::size_t kMostRegions = 24;
  // Half of the object must be in the picture, and of its borders; one colour is found on many
  // things.
  constexpr float kLeastInside = 0.45F, kLeastBorders = 0.25F;
  constexpr int kLeastColours = 2;
  if (agreement.colours < kLeastColours || agreement.inside < kLeastInside ||
      borders_met < kLeastBorders)
    return -1;
  const auto regions = static_cast<double>(std::min(agreement.explained.count(), kMostRegions));
  const double area_px = static_cast<double>(std::clamp(seen_px, 1.0F, kMostArea_px));
  return agreement.score +
         (kOfBorders * borders_met + (agreement.colours > 2 ? kOfThreeColours : 0) +
          kOfArea * static_cast<float>(portable_log(area_px)) +
          kOfRegions * static_cast<float>(portable_log(1 + regions)) - kEven) /
             static_cast<float>(kLogOddsOfMargin);
}

}  // namespace

SceneAgreement scene_agreement(const ModelDrawing& drawing, const CameraModel& camera,
                               const SeenColours& seen, int width_px, int height_px,
                               float borders_met, const Labels& of_others) {
  int drawn = 0, inside = 0, right = 0, empty = 0, rim = 0, leak = 0;
  std::array<int, kMaxModelColours + 1> cells_of_colour{};
  std::array<std::uint16_t, kMaxRegions + 1> wrong_cells{}, right_cells{}, of_black{};
  float left_px = 1e9F, right_px = -1e9F, top_px = 1e9F, bottom_px = -1e9F;
  for (int row = 0; row < drawing.height(); ++row)
    for (int column = 0; column < drawing.width(); ++column) {
      const ModelDrawing::Cell cell = drawing.cell(column, row);
      const bool is_black = cell.covered && cell.colour == kBackgroundClass;
      const ColourClass beside =
          cell.covered ? kBackgroundClass : colour_beside(drawing, column, row);
      if (!cell.covered && beside == kBackgroundClass) continue;
      const Point2d p = camera.bent(
          {static_cast<double>(drawing.x_px(column)), static_cast<double>(drawing.y_px(row))});
      const auto x = static_cast<float>(p.x), y = static_cast<float>(p.y);
      drawn += cell.covered && !is_black ? 1 : 0;
      if (!(x >= 0 && y >= 0 && x <= static_cast<float>(width_px - 1) &&
            y <= static_cast<float>(height_px - 1)) ||
          seen.is_hidden(x, y))
        continue;
      const std::uint16_t label = seen.label_at(x, y);
      if (is_black) {
        ++of_black[label];
        continue;
      }
      const ColourClass wanted = cell.covered ? cell.colour : beside;
      const ColourClass of_region = seen.of_label(label);
      const ColourClass of_pixel = of_region == wanted ? wanted : seen.at_pixel(x, y);
      const bool is_seen = of_pixel == wanted && !of_others[label];
      if (!cell.covered) {
        ++rim;
        leak += is_seen ? 1 : 0;
        continue;
      }
      ++inside;
      right += is_seen ? 1 : 0;
      if (label > 0) ++(is_seen ? right_cells : wrong_cells)[label];
      empty += of_region == kBackgroundClass && of_pixel == kBackgroundClass ? 1 : 0;
      cells_of_colour[wanted] += is_seen ? 1 : 0;
      left_px = std::min(left_px, x);
      right_px = std::max(right_px, x);
      top_px = std::min(top_px, y);
      bottom_px = std::max(bottom_px, y);
    }
  SceneAgreement agreement;
  if (inside == 0) return agreement;
  agreement.inside = static_cast<float>(inside) / static_cast<float>(drawn);
  // What goes on beyond the outline may stand before the object; what ends within it may not.
  int contradicting = 0, hidden = 0;
  const float cell_px = drawing.cell_px() * drawing.cell_px();
  for (std::size_t label = 1; label < wrong_cells.size(); ++label) {
    const int cells = wrong_cells[label] + of_black[label], rights = right_cells[label];
    if (cells + rights == 0) continue;
    const float area_px = seen.area_px(static_cast<std::uint16_t>(label));
    agreement.explained[label] = static_cast<float>(rights) * cell_px > kExplainedShare * area_px;
    const bool ends_within =
        static_cast<float>(cells) * cell_px > kWithin * area_px && !of_others[label];
    if (ends_within)
      contradicting += cells;
    else
      hidden += wrong_cells[label];
  }
  agreement.score =
      (static_cast<float>(right) - kEmptyCost * static_cast<float>(empty + contradicting)) /
          (static_cast<float>(inside) - kHiddenShare * static_cast<float>(hidden)) -
      kLeakCost * static_cast<float>(leak) / static_cast<float>(std::max(1, rim));
  agreement.colours = static_cast<int>(
      std::count_if(cells_of_colour.begin(), cells_of_colour.end(), [&](int cells) {
        return cells >= kLeastCells && static_cast<float>(cells) * cell_px > kLeastColour_px;
      }));
  agreement.margin = margin_of(agreement, borders_met, static_cast<float>(right) * cell_px);
  const int x = static_cast<int>(left_px), y = static_cast<int>(top_px);
  agreement.box = {x, y, static_cast<int>(right_px) + 1 - x, static_cast<int>(bottom_px) + 1 - y};
  return agreement;
}

}  // namespace aspect
