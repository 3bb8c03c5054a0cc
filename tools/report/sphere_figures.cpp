#include "tools/report/sphere_figures.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>

#include "tools/aspectc/project/distance_check.h"
#include "tools/report/aspect_colours.h"

namespace aspect {
namespace {

constexpr double kWidth = 300, kHeight = 322, kRadius = 140, kMiddle = 150;
constexpr double kInset = 62;    // side of the picture in the corner
constexpr double kUnits = 1000;  // of a path to the sphere's radius

int unit(double coordinate) {
  return static_cast<int>(std::lround(kUnits * coordinate));
}

// Whole units, relative: a third of the size of anything else.
void append_path(const Outline& outline, std::string& path) {
  auto out = std::back_inserter(path);
  int x = unit(outline[0].x()), y = unit(outline[0].y());
  fmt::format_to(out, "M{} {}l", x, y);
  for (std::size_t k = 1; k < outline.size(); ++k) {
    const int next_x = unit(outline[k].x()), next_y = unit(outline[k].y());
    if (next_x == x && next_y == y) continue;
    fmt::format_to(out, "{} {} ", next_x - x, next_y - y);
    x = next_x;
    y = next_y;
  }
  path += 'z';
}

std::string aspects_drawn(const ReportContents& contents, const LookFrame& frame) {
  std::string drawn;
  for (const auto& [aspect, outlines] : class_outlines(contents.mesh, frame)) {
    std::string path;
    for (const Outline& outline : outlines)
      if (outline.size() > 2) append_path(outline, path);
    if (path.empty()) continue;
    if (aspect == kNoClass) {
      drawn += fmt::format("<path class=\"none\" fill=\"{}\" d=\"{}\"/>", kNoAspectColour, path);
      continue;
    }
    const auto k = static_cast<std::size_t>(aspect);
    drawn += fmt::format(
        "<path class=\"aspect{}\" data-aspect=\"{}\" fill=\"{}\"{} stroke=\"#4a515b\" "
        "stroke-width=\".6\" vector-effect=\"non-scaling-stroke\" d=\"{}\"><title>aspect {}: "
        "{:.2f} % "
        "of the sphere</title></path>",
        contents.is_in_index(k) ? "" : " out", k, kMapColours[contents.colours[k]],
        contents.is_in_index(k) ? "" : " fill-opacity=\".35\"", path, k, 100 * contents.areas[k]);
  }
  return drawn;
}

std::string patches_drawn(const ReportContents& contents, const LookFrame& frame) {
  std::string path;
  for (const auto& side : patch_sides(contents.mesh, frame)) {
    const int x = unit(side[0].x()), y = unit(side[0].y());
    fmt::format_to(std::back_inserter(path), "M{} {}l{} {}", x, y, unit(side[1].x()) - x,
                   unit(side[1].y()) - y);
  }
  return fmt::format(
      "<path class=\"patches\" fill=\"none\" stroke=\"#c0392b\" stroke-width=\".25\" "
      "vector-effect=\"non-scaling-stroke\" d=\"{}\"/>",
      path);
}

std::string tried_drawn(const ReportContents& contents, const LookFrame& frame) {
  std::string dots;
  for (const TriedView& view : contents.explanation.tried_views) {
    if (view.direction.dot(frame.towards) < 0) continue;
    const Eigen::Vector2d at = frame(view.direction);
    const char* kind = view.is_wrong ? "wrong" : view.is_right ? "right" : "near";
    const char* colour = view.is_wrong ? "#c0392b" : view.is_right ? "#1b5e9c" : "#b9770e";
    dots += fmt::format(
        "<circle class=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"{}\" stroke=\"white\" "
        "stroke-width=\".6\" vector-effect=\"non-scaling-stroke\"/>",
        kind, unit(at.x()), unit(at.y()), view.is_wrong ? 26 : 15, colour);
  }
  return "<g class=\"tried\">" + dots + "</g>";
}

// The part of a circle about a direction that is on this side.
std::string circle_path(const Eigen::Vector3d& centre, double radius_deg, const LookFrame& frame) {
  constexpr int kSteps = 72;
  const double radius = radius_deg * std::numbers::pi / 180;
  const Eigen::Vector3d x = centre.unitOrthogonal(), y = centre.cross(x);
  std::string path;
  bool is_drawing = false;
  for (int k = 0; k <= kSteps; ++k) {
    const double turn = 2 * std::numbers::pi * k / kSteps;
    const Eigen::Vector3d point =
        std::cos(radius) * centre + std::sin(radius) * (std::cos(turn) * x + std::sin(turn) * y);
    const bool is_seen = point.dot(frame.towards) >= 0;
    const Eigen::Vector2d at = frame(point);
    if (is_seen)
      fmt::format_to(std::back_inserter(path), "{}{} {}", is_drawing ? 'L' : 'M', unit(at.x()),
                     unit(at.y()));
    is_drawing = is_seen;
  }
  return path;
}

std::string spots_drawn(const ReportContents& contents, const LookFrame& frame) {
  std::string drawn;
  for (const Spot& spot : contents.explanation.blind_spots) {
    const std::string path = circle_path(spot.centre, std::max(spot.radius_deg, 1.0), frame);
    if (path.empty()) continue;
    drawn += fmt::format(
        "<path fill=\"none\" stroke=\"#1b1f24\" stroke-width=\"1.4\" stroke-dasharray=\"4 3\" "
        "vector-effect=\"non-scaling-stroke\" d=\"{}\"><title>{:.1f} % blind: {}</title></path>",
        path, 100 * spot.share, escaped(spot.reason));
  }
  return "<g class=\"blind\">" + drawn + "</g>";
}

std::string sphere_drawn(const ReportContents& contents, const LookFrame& frame,
                         const SphereMarks& marks, double scale) {
  std::string drawn = aspects_drawn(contents, frame);
  if (marks.patches) drawn += patches_drawn(contents, frame);
  drawn += fmt::format(
      "<circle class=\"rim\" r=\"{}\" fill=\"none\" stroke=\"#1b1f24\" stroke-width=\"1\" "
      "vector-effect=\"non-scaling-stroke\"/>",
      kUnits);
  if (marks.blind_spots) drawn += spots_drawn(contents, frame);
  if (marks.tried_views) drawn += tried_drawn(contents, frame);
  return fmt::format("<g transform=\"translate({0} {0}) scale({1:.6g} {2:.6g})\">{3}</g>", kMiddle,
                     scale, -scale, drawn);
}

// In the middle of a square, as large as it can be.
std::string inset(const SeenView& picture, double x, double y, double side) {
  if (picture.png.empty()) return {};
  const double scale = side / std::max(picture.width_px, picture.height_px);
  const double width = scale * picture.width_px, height = scale * picture.height_px;
  return svg_picture(x + (side - width) / 2, y + (side - height) / 2, width, height, picture.png);
}

// A point of the scene in a cut picture.
Eigen::Vector2d place_in(const SeenView& picture, const Camera& camera,
                         const Eigen::Vector3d& point) {
  const Eigen::Vector3d at = camera.camera_from_object * (point - camera.position_object);
  const Intrinsics& lens = camera.intrinsics;
  const double depth = lens.projection == Projection::kPerspective ? at.z() : 1;
  return {lens.fx_px * at.x() / depth + lens.cx_px + 0.5 - picture.left_px,
          lens.fy_px * at.y() / depth + lens.cy_px + 0.5 - picture.top_px};
}

// Round about a picture that stands in the middle of a square of side `within`, `side` large.
std::string axes_drawn(const ReportContents& contents, double within, double side) {
  const Studio& studio = contents.studio;
  const SeenView& picture = contents.overview.picture;
  const Camera camera = camera_at(studio, picture.direction);
  const double scale = side / std::max(picture.width_px, picture.height_px);
  const Eigen::Vector2d corner = (Eigen::Vector2d(within, within) -
                                  scale * Eigen::Vector2d(picture.width_px, picture.height_px)) /
                                 2;
  const double reach = 1.2 * radius_around(contents.recipe.scene, studio.at);
  std::string drawn;
  for (const ObjectAxis& axis : contents.axes) {
    const auto end = [&](double sign) {
      return Eigen::Vector2d(
          corner + scale * place_in(picture, camera, studio.at + sign * reach * axis.direction));
    };
    const Eigen::Vector2d a = end(-1), b = end(1);
    drawn += svg_line(a.x(), a.y(), b.x(), b.y(), "axis", "#c0392b", 1.6);
    drawn += svg_text(b.x() + 5, b.y() + 3,
                      axis.fold == 0 ? std::string("any angle") : fmt::format("{}-fold", axis.fold),
                      {11});
  }
  return drawn;
}

}  // namespace

SvgFigure half_figure(const ReportContents& contents, const HalfSphereView& half,
                      const SphereMarks& marks) {
  const Eigen::Vector3d& from = half.frame.towards;
  SvgFigure figure{kWidth, kHeight, "the half of the viewing sphere with " + half.name, {}};
  figure.body = sphere_drawn(contents, half.frame, marks, kRadius / kUnits);
  figure.body += inset(half.picture, 1, kHeight - 24 - kInset, kInset);
  figure.body += svg_text(kMiddle, kHeight - 8,
                          fmt::format("{}, from ({:.0f}, {:.0f}, {:.0f})", half.name, from.x() + 0,
                                      from.y() + 0, from.z() + 0),
                          {13, "middle"});
  return figure;
}

SvgFigure sphere_figure(const ReportContents& contents, const SphereMarks& marks) {
  const CompileStatistics& s = contents.model.index.statistics;
  const std::string title =
      fmt::format("The viewing sphere of {}: {} aspects, level {}, thresholds {:g}, {:g}", s.object,
                  contents.aspects(), s.level, s.threshold, s.cluster_threshold);
  SvgFigure figure{2 * kWidth + 20, 3 * kHeight + 30, title, {}};
  for (std::size_t k = 0; k < contents.halves.size(); ++k)
    figure.body += placed(half_figure(contents, contents.halves[k], marks),
                          static_cast<double>(k % 2) * (kWidth + 20),
                          static_cast<double>(k / 2) * kHeight, kWidth, kHeight);
  figure.body += svg_text(figure.width / 2, figure.height - 8, title, {12, "middle", false, true});
  return figure;
}

SvgFigure overview_figure(const ReportContents& contents) {
  constexpr double kSide = 300;
  SvgFigure figure{2 * kSide + 20,
                   kSide + 24,
                   contents.model.index.statistics.object + " and its viewing sphere",
                   {}};
  // Axes reach beyond the object.
  const double side = contents.axes.empty() ? kSide : 0.58 * kSide;
  figure.body = inset(contents.overview.picture, (kSide - side) / 2, (kSide - side) / 2, side);
  figure.body += axes_drawn(contents, kSide, side);
  SvgFigure sphere{kWidth, kWidth, {}, {}};
  sphere.body = sphere_drawn(contents, contents.overview.frame, {}, kRadius / kUnits);
  figure.body += placed(sphere, kSide + 20, 0, kSide, kSide);
  figure.body +=
      svg_text(figure.width / 2, figure.height - 6, figure.title, {12, "middle", false, true});
  return figure;
}

}  // namespace aspect
