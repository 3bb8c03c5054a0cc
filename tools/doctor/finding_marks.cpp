#include "tools/doctor/finding_marks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <set>

#include "compiler/render/scene_outline.h"
#include "compiler/scene/ear_clipping.h"

namespace aspect {
namespace {

using Eigen::Vector3d;
using Pair = std::pair<std::size_t, std::size_t>;

const cv::Scalar kRim(255, 255, 255);
constexpr std::size_t kMostHidden = 400;  // lines behind surfaces; more hide what is before them
constexpr double kStep_px = 2;

cv::Point pixel(const Vector3d& projected) {
  const auto within = [](double px) { return cvRound(std::clamp(px, -4e3, 4e3)); };
  return {within(projected.x()), within(projected.y())};
}

// What a finding is on a picture, before it is drawn.
struct Strokes {
  std::vector<std::vector<cv::Point>> seen, hidden;
  std::vector<cv::Point> rings;
  cv::Mat area;    // 8 bits: hatched
  cv::Mat border;  // 8 bits: drawn as a line

  explicit Strokes(int side_px)
      : area(cv::Mat::zeros(side_px, side_px, CV_8UC1)), border(area.clone()) {}
};

// In runs of what is shown and what is not. `as_hidden`: all of it lies within.
void add_line(const ObjectView& view, const Vector3d& from, const Vector3d& to, bool as_hidden,
              Strokes& strokes) {
  const auto a = view.project(from), b = view.project(to);
  if (!a || !b) return;
  const double length_px = (*b - *a).head<2>().norm();
  const int steps = static_cast<int>(std::clamp(length_px / kStep_px, 1.0, 800.0));
  std::vector<cv::Point> run;
  bool was_seen = false;
  const auto finish = [&] {
    if (run.size() > 1) (was_seen ? strokes.seen : strokes.hidden).push_back(run);
  };
  for (int k = 0; k <= steps; ++k) {
    const auto p = view.project(from + (static_cast<double>(k) / steps) * (to - from));
    if (!p) continue;
    const bool seen = !as_hidden && view.shows(*p);
    if (!run.empty() && seen != was_seen) {
      run.push_back(pixel(*p));
      finish();
      run.clear();
    }
    was_seen = seen;
    run.push_back(pixel(*p));
  }
  finish();
}

// Those pixels of a flat face that no surface lies before.
void add_face(const ObjectView& view, const std::vector<Vector3d>& corners, Strokes& strokes) {
  std::vector<cv::Point> outline;
  double nearest = 1e300, farthest = 0;
  for (const Vector3d& corner : corners) {
    const auto p = view.project(corner);
    if (!p) return;
    outline.push_back(pixel(*p));
    nearest = std::min(nearest, p->z());
    farthest = std::max(farthest, p->z());
  }
  const cv::Rect box = cv::boundingRect(outline) & cv::Rect({0, 0}, strokes.area.size());
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& corner : corners) middle += corner / static_cast<double>(corners.size());
  const auto at = view.project(middle);
  constexpr int kLeast_px = 8;  // smaller ones are pointed at
  if (at && view.shows(*at) && std::max(box.width, box.height) < kLeast_px && !box.empty())
    strokes.rings.push_back(pixel(*at));
  const Vector3d normal = polygon_normal(corners);
  if (normal.norm() < 0.5 || box.empty()) {  // without area: its edges are all of it
    for (std::size_t k = 0; k < corners.size(); ++k)
      add_line(view, corners[k], corners[(k + 1) % corners.size()], false, strokes);
    return;
  }
  cv::Mat inside = cv::Mat::zeros(box.size(), CV_8UC1);
  for (cv::Point& p : outline) p -= box.tl();
  cv::fillPoly(inside, std::vector{outline}, 255);
  for (int y = 0; y < box.height; ++y)
    for (int x = 0; x < box.width; ++x) {
      if (inside.at<std::uint8_t>(y, x) == 0) continue;
      const Vector3d there(box.x + x, box.y + y,
                           view.depth_on_plane(box.x + x, box.y + y, middle, normal));
      // Seen at a slant the plane runs far away between two pixels.
      const double depth = std::clamp(there.z(), nearest, farthest);
      if (view.shows({there.x(), there.y(), depth}))
        strokes.area.at<std::uint8_t>(box.y + y, box.x + x) = 255;
    }
}

void add_surfaces(const ObjectView& view, const std::vector<std::size_t>& primitives,
                  Strokes& strokes) {
  const std::set<std::size_t> wanted(primitives.begin(), primitives.end());
  const auto& surface = view.picture().surface;
  for (std::size_t k = 0; k < surface.size(); ++k)
    if (surface[k] != 0 && wanted.contains(surface[k] - 1U)) strokes.area.data[k] = 255;
}

void add_borders(const ObjectView& view, const FindingMarks& marks, const ColourGroups& groups,
                 Strokes& strokes) {
  const std::set<Pair> borders(marks.borders.begin(), marks.borders.end()),
      of_colours(marks.of_colours.begin(), marks.of_colours.end());
  const auto& surface = view.picture().surface;
  const auto width = static_cast<std::size_t>(view.side_px());
  for (std::size_t k = 0; k < surface.size(); ++k)
    for (const std::size_t next : {k + 1, k + width}) {
      if (next >= surface.size() || (next == k + 1 && next % width == 0)) continue;
      if (surface[k] == 0 || surface[next] == 0 || surface[next] == surface[k]) continue;
      const std::size_t a = surface[k] - 1U, b = surface[next] - 1U;
      if (!view.touch(k, next)) continue;
      if (borders.contains(std::minmax(a, b)) ||
          of_colours.contains(std::minmax(groups.group_of[a], groups.group_of[b])))
        strokes.border.data[k] = strokes.border.data[next] = 255;
    }
}

// Of surfaces that this view does not show and that no other does.
void add_hidden(const ObjectView& view, const Scene& scene,
                const std::vector<std::size_t>& primitives, Strokes& strokes) {
  constexpr std::size_t kMostOutlined = 60;
  Scene part;
  for (const std::size_t primitive : primitives)
    if (part.primitives.size() < kMostOutlined)
      part.primitives.push_back(scene.primitives[primitive]);
  std::vector<std::vector<Triangle>> triangles(part.primitives.size());
  for (std::size_t k = 0; k < triangles.size(); ++k)
    if (const auto* polygon = std::get_if<Polygon>(&part.primitives[k].shape))
      triangles[k] = triangulate(polygon->vertices);
  const SceneOutline outline = outline_of(part, triangles);
  for (const SceneOutline::Edge& edge : outline.edges)
    add_line(view, outline.points[edge.from], outline.points[edge.to], true, strokes);
}

// Closely where the area is small; a large one would be nothing but lines.
void hatch(cv::Mat& picture, const cv::Mat& area, const cv::Scalar& colour) {
  const int every_px = 20 * cv::countNonZero(area) > picture.rows * picture.cols ? 24 : 11;
  const cv::Vec3b ink(cv::saturate_cast<std::uint8_t>(colour[0]),
                      cv::saturate_cast<std::uint8_t>(colour[1]),
                      cv::saturate_cast<std::uint8_t>(colour[2]));
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x) {
      if (area.at<std::uint8_t>(y, x) == 0) continue;
      const int phase = (x + y) % every_px;
      if (phase < 2) picture.at<cv::Vec3b>(y, x) = ink;
      if (phase == 2 || phase == every_px - 1)
        picture.at<cv::Vec3b>(y, x) = cv::Vec3b(255, 255, 255);
    }
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(area, outlines, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  cv::drawContours(picture, outlines, -1, kRim, 4, cv::LINE_AA);
  cv::drawContours(picture, outlines, -1, colour, 2, cv::LINE_AA);
}

void draw_dots(cv::Mat& picture, const std::vector<cv::Point>& run, const cv::Scalar& colour) {
  for (std::size_t k = 0; k < run.size(); k += 3) {
    cv::circle(picture, run[k], 2, kRim, cv::FILLED, cv::LINE_AA);
    cv::circle(picture, run[k], 1, colour, cv::FILLED, cv::LINE_AA);
  }
}

void draw(cv::Mat& picture, const Strokes& strokes, const cv::Scalar& colour) {
  hatch(picture, strokes.area, colour);
  for (const int width : {5, 3}) {
    const cv::Scalar ink = width == 5 ? kRim : colour;
    cv::Mat wide;
    cv::dilate(strokes.border, wide, cv::Mat::ones(width - 1, width - 1, CV_8UC1));
    picture.setTo(ink, wide);
  }
  if (strokes.hidden.size() <= kMostHidden)
    for (const auto& run : strokes.hidden) draw_dots(picture, run, colour);
  for (const auto& run : strokes.seen) cv::polylines(picture, run, false, kRim, 5, cv::LINE_AA);
  for (const auto& run : strokes.seen) cv::polylines(picture, run, false, colour, 3, cv::LINE_AA);
  for (const cv::Point ring : strokes.rings) {
    cv::circle(picture, ring, 7, kRim, 4, cv::LINE_AA);
    cv::circle(picture, ring, 7, colour, 2, cv::LINE_AA);
  }
}

std::vector<cv::Point> marked_pixels(const Strokes& strokes) {
  std::vector<cv::Point> all, some;
  for (const cv::Mat& mask : {strokes.area, strokes.border}) {
    cv::findNonZero(mask, some);
    all.insert(all.end(), some.begin(), some.end());
    some.clear();
  }
  for (const auto& run : strokes.seen) all.insert(all.end(), run.begin(), run.end());
  all.insert(all.end(), strokes.rings.begin(), strokes.rings.end());
  if (all.empty() && strokes.hidden.size() <= kMostHidden)
    for (const auto& run : strokes.hidden) all.insert(all.end(), run.begin(), run.end());
  std::erase_if(all, [&](cv::Point p) {
    return p.x < 0 || p.y < 0 || p.x >= strokes.area.cols || p.y >= strokes.area.rows;
  });
  return all;
}

}  // namespace

cv::Scalar mark_colour(Severity severity, std::size_t place) {
  static const std::array<cv::Scalar, 7> kColours = {{{190, 0, 225},
                                                      {205, 150, 0},
                                                      {0, 110, 245},
                                                      {240, 50, 110},
                                                      {110, 140, 0},
                                                      {170, 90, 20},
                                                      {0, 130, 130}}};
  if (severity == Severity::error) return {50, 0, 215};
  return kColours.at(place % kColours.size());
}

std::vector<cv::Point> MarkPainter::draw(cv::Mat& picture, const ObjectView& view,
                                         const FindingMarks& marks,
                                         const cv::Scalar& colour) const {
  Strokes strokes(view.side_px());
  add_surfaces(view, marks.primitives, strokes);
  if (!marks.primitives.empty() && cv::countNonZero(strokes.area) == 0)
    add_hidden(view, scene_, marks.primitives, strokes);
  add_borders(view, marks, groups_, strokes);
  for (const auto& face : marks.faces) add_face(view, face, strokes);
  for (const auto& [from, to] : marks.lines) add_line(view, from, to, false, strokes);
  for (const Vector3d& point : marks.points)
    if (const auto p = view.project(point)) {
      if (view.shows(*p))
        strokes.rings.push_back(pixel(*p));
      else
        strokes.hidden.push_back({pixel(*p)});
    }
  aspect::draw(picture, strokes, colour);
  return marked_pixels(strokes);
}

}  // namespace aspect
