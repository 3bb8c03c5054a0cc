#include "tools/doctor/finding_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>

#include "tools/doctor/finding_badges.h"
#include "tools/doctor/finding_legend.h"
#include "tools/doctor/finding_marks.h"
#include "tools/doctor/finding_views.h"
#include "tools/draw/paper.h"
#include "tools/draw/picture_text.h"

namespace aspect {
namespace {

constexpr int kMargin_px = 16, kGap_px = 12, kHead_px = 44, kCaption_px = 26;

FindingMarks marks_of(const Diagnosis& diagnosis, const FindingLine& line) {
  FindingMarks all;
  const auto append = [](auto& to, const auto& more) {
    to.insert(to.end(), more.begin(), more.end());
  };
  for (const std::size_t finding : line.findings) {
    const FindingMarks& marks = diagnosis.findings[finding].marks;
    append(all.lines, marks.lines);
    append(all.faces, marks.faces);
    append(all.points, marks.points);
    append(all.primitives, marks.primitives);
    append(all.borders, marks.borders);
    append(all.of_colours, marks.of_colours);
  }
  return all;
}

// A pixel in each of the places that have most of them, three at most, apart from each other.
std::vector<cv::Point> anchors_of(const std::vector<cv::Point>& pixels) {
  constexpr int kCell_px = 90;
  constexpr std::size_t kMost = 3;
  std::map<std::pair<int, int>, std::vector<cv::Point>> cells;
  for (const cv::Point p : pixels) cells[{p.x / kCell_px, p.y / kCell_px}].push_back(p);
  std::vector<std::pair<std::pair<int, int>, const std::vector<cv::Point>*>> by_size;
  for (const auto& [cell, points] : cells) by_size.emplace_back(cell, &points);
  std::stable_sort(by_size.begin(), by_size.end(), [](const auto& a, const auto& b) {
    return a.second->size() > b.second->size();
  });
  std::vector<std::pair<int, int>> taken;
  std::vector<cv::Point> anchors;
  for (const auto& [cell, points] : by_size) {
    const auto is_near = [&, c = cell](const auto& other) {
      return std::abs(c.first - other.first) <= 1 && std::abs(c.second - other.second) <= 1;
    };
    if (anchors.size() == kMost) break;
    if (std::any_of(taken.begin(), taken.end(), is_near)) continue;
    taken.push_back(cell);
    cv::Point2d sum;
    for (const cv::Point p : *points) sum += cv::Point2d(p);
    const cv::Point2d mean = sum * (1.0 / static_cast<double>(points->size()));
    anchors.push_back(*std::min_element(points->begin(), points->end(), [&](auto a, auto b) {
      return cv::norm(cv::Point2d(a) - mean) < cv::norm(cv::Point2d(b) - mean);
    }));
  }
  return anchors;
}

// One of the views with its marks, which are added to the others'.
cv::Mat marked_view(const ObjectView& view, const cv::Mat& drawn, const MarkPainter& painter,
                    const Diagnosis& diagnosis, std::span<const FindingLine> lines,
                    std::size_t number, std::vector<MarkedPlace>& marks) {
  cv::Mat picture = drawn.clone();
  std::vector<MarkedPlace> here;
  std::vector<cv::Scalar> colours;
  // Notes first: what is worse lies over them.
  std::vector<const FindingLine*> order;
  for (const FindingLine& line : lines) order.push_back(&line);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto* a, const auto* b) { return a->severity < b->severity; });
  for (const FindingLine* line : order) {
    const FindingMarks of_line = marks_of(diagnosis, *line);
    if (of_line.empty()) continue;
    const cv::Scalar colour =
        mark_colour(line->severity, static_cast<std::size_t>(line - lines.data()));
    for (const cv::Point at : anchors_of(painter.draw(picture, view, of_line, colour))) {
      here.push_back({line->label, number, at});
      colours.push_back(colour);
    }
  }
  Badges badges(picture);
  for (std::size_t k = 0; k < here.size(); ++k) badges.add(here[k].at, here[k].label, colours[k]);
  marks.insert(marks.end(), here.begin(), here.end());
  return picture;
}

// Where the views are on the page: two in a row, a single one in the middle.
std::vector<cv::Rect> places_of(std::size_t views, int width_px) {
  std::vector<cv::Rect> places;
  for (int k = 0; k < static_cast<int>(views); ++k) {
    const int left =
        views == 1 ? (width_px - kView_px) / 2 : kMargin_px + k % 2 * (kView_px + kGap_px);
    places.emplace_back(left, kHead_px + k / 2 * (kView_px + kCaption_px + kGap_px), kView_px,
                        kView_px);
  }
  return places;
}

// The page without its views.
cv::Mat page_of(const Diagnosis& diagnosis, const FindingPicture& made,
                std::span<const FindingLine> lines, int width_px) {
  std::vector<FindingLegend::Shown> shown;
  for (const FindingLine& line : lines)
    shown.push_back({std::any_of(made.marks.begin(), made.marks.end(),
                                 [&](const MarkedPlace& mark) { return mark.label == line.label; }),
                     !marks_of(diagnosis, line).empty()});
  const FindingLegend legend(lines, shown, width_px - 2 * kMargin_px);
  const int top = made.places.back().br().y + kCaption_px + kGap_px;
  cv::Mat page(top + legend.height_px() + kMargin_px, width_px, CV_8UC3, kDesk);
  const TextStyle large = text_style_for({800, 800}), small = text_style_for({540, 540});
  draw_dark_text(page, diagnosis.object, {kMargin_px, kMargin_px - 4},
                 fitted(large, diagnosis.object, width_px - 2 * kMargin_px));
  for (std::size_t k = 0; k < made.views.size(); ++k) {
    const Eigen::Vector3d from = made.views[k].array() + 0.0;  // without the sign of zero
    draw_dark_text(page, fmt::format("from {:.2f},{:.2f},{:.2f}", from.x(), from.y(), from.z()),
                   {made.places[k].x, made.places[k].br().y + 2}, small, kQuietInk);
  }
  legend.draw(page, {kMargin_px, top});
  return page;
}

}  // namespace

Result<FindingPicture> finding_picture(const PreparedObject& object, const Diagnosis& diagnosis,
                                       std::span<const FindingLine> lines) {
  const Scene shown = scene_for_views(object.scene);
  const Result<Renderer> renderer = Renderer::create(shown);
  if (!renderer) return Error{object.scene_file.native() + ": " + renderer.error()};
  const ColourGroups groups = colour_groups(object.scene);
  const MarkPainter painter(object.scene, groups);
  constexpr int kWidth_px = 2 * kMargin_px + 2 * kView_px + kGap_px;
  FindingPicture made;
  made.views = best_views(diagnosis, groups, renderer.value(), shown.studio);
  made.places = places_of(made.views.size(), kWidth_px);
  std::vector<cv::Mat> views;
  for (std::size_t k = 0; k < made.views.size(); ++k) {
    const ObjectView sharp(renderer.value(), shown.studio, made.views[k], kView_px);
    const ObjectView fine(renderer.value(), shown.studio, made.views[k], 2 * kView_px);
    cv::Mat drawn;
    cv::resize(fine.drawn(), drawn, {kView_px, kView_px}, 0, 0, cv::INTER_AREA);
    views.push_back(marked_view(sharp, drawn, painter, diagnosis, lines, k, made.marks));
  }
  made.picture = page_of(diagnosis, made, lines, kWidth_px);
  for (std::size_t k = 0; k < views.size(); ++k) views[k].copyTo(made.picture(made.places[k]));
  for (MarkedPlace& mark : made.marks) mark.at += made.places[mark.view].tl();
  return made;
}

}  // namespace aspect
