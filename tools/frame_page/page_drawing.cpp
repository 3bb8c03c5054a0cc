#include "tools/frame_page/page_drawing.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "runtime/vision/contour_trace.h"
#include "tools/draw/frame_canvas.h"

namespace aspect {
namespace {

// Steps between points need no space before a minus sign.
void append_number(std::string& path, const std::string& number, bool first) {
  if (!first && number.front() != '-') path += ' ';
  path += number;
}

std::string tenths(int number) {
  return number % 10 == 0 ? fmt::to_string(number / 10) : fmt::format("{:.1f}", number / 10.0);
}

// Points in tenths of a pixel.
void append_line(std::string& path, const std::vector<cv::Point>& points, bool closed) {
  cv::Point last;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const cv::Point step = points[k] - last;
    path += k == 0 ? "M" : k == 1 ? "l" : "";
    append_number(path, tenths(step.x), k < 2);
    append_number(path, tenths(step.y), false);
    last = points[k];
  }
  if (closed) path += "z";
}

std::vector<cv::Point> border_of(const Contour& contour, double tolerance_px) {
  std::vector<cv::Point> border, simple;
  border.reserve(contour.chain.size() + 1);
  cv::Point at(contour.start_x, contour.start_y);
  border.push_back(10 * at);
  for (const std::uint8_t code : contour.chain) {
    at += cv::Point(kStepX[code], kStepY[code]);
    border.push_back(10 * at);
  }
  cv::approxPolyDP(border, simple, 10 * tolerance_px, true);
  return simple;
}

// A contour with the holes of its region.
struct Outline {
  std::size_t place = 0;
  std::vector<const Contour*> borders;
};

std::vector<Outline> outlines_of(const ViewGraph& graph) {
  std::vector<Outline> outlines;
  std::map<std::uint16_t, std::size_t> of_region;
  for (std::size_t k = 0; k < graph.contours.size(); ++k)
    if (graph.contours[k].external) {
      of_region[graph.contours[k].region] = outlines.size();
      outlines.push_back({k, {&graph.contours[k]}});
    }
  for (const Contour& contour : graph.contours)
    if (const auto own = of_region.find(contour.region);
        !contour.external && own != of_region.end())
      outlines[own->second].borders.push_back(&contour);
  std::stable_sort(outlines.begin(), outlines.end(), [](const Outline& a, const Outline& b) {
    return a.borders.front()->area_px > b.borders.front()->area_px;
  });
  return outlines;
}

std::vector<std::string> paths_of(const std::vector<Outline>& outlines, double tolerance_px) {
  std::vector<std::string> paths;
  for (const Outline& outline : outlines) {
    std::string& path = paths.emplace_back();
    for (const Contour* border : outline.borders)
      append_line(path, border_of(*border, tolerance_px), true);
  }
  return paths;
}

std::size_t bytes_of(const std::vector<std::string>& paths) {
  constexpr std::size_t kAround = 60;  // an outline's other members
  std::size_t bytes = 0;
  for (const std::string& path : paths) bytes += path.size() + kAround;
  return bytes;
}

}  // namespace

std::string path_of(std::span<const PictureLine> lines) {
  std::string path;
  for (const PictureLine& line : lines) {
    std::vector<cv::Point> points, simple;
    points.reserve(line.size());
    for (const Point2d& p : line) points.emplace_back(cvRound(10 * p.x), cvRound(10 * p.y));
    cv::approxPolyDP(points, simple, 5, false);
    append_line(path, simple, false);
  }
  return path;
}

nlohmann::json contours_json(const ViewGraph& graph, const RegionMap& regions) {
  const std::vector<Outline> outlines = outlines_of(graph);
  std::vector<std::string> paths;
  constexpr double kFinest_px = 1.2, kCoarsest_px = 4;
  for (double tolerance_px = kFinest_px; tolerance_px <= kCoarsest_px; tolerance_px *= 1.6) {
    paths = paths_of(outlines, tolerance_px);
    if (bytes_of(paths) <= kMostContourBytes) break;
  }
  while (bytes_of(paths) > kMostContourBytes) paths.pop_back();
  nlohmann::json shown = nlohmann::json::array();
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const Contour& contour = *outlines[k].borders.front();
    const Point2 label = label_point(contour, regions);
    const auto level = [&](std::size_t channel) {
      return std::clamp(cvRound(contour.mean_rgb[channel]), 0, 255);
    };
    shown.push_back({{"n", outlines[k].place},
                     {"colour", fmt::format("#{:02x}{:02x}{:02x}", level(0), level(1), level(2))},
                     {"at", {cvRound(label.x), cvRound(label.y)}},
                     {"path", paths[k]}});
  }
  return {{"shown", shown}, {"left_out", outlines.size() - paths.size()}};
}

}  // namespace aspect
