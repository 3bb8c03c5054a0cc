#include "tools/doctor/finding_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>

#include "tools/doctor/finding_marks.h"
#include "tools/doctor/finding_views.h"
#include "tools/draw/paper.h"
#include "tools/draw/picture_text.h"

namespace aspect {
namespace {

constexpr int kMargin_px = 16, kGap_px = 12, kHead_px = 44, kCaption_px = 26, kLine_px = 21;
constexpr int kBadge_px = 13;  // radius
constexpr std::size_t kMostLegend = 30;

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

void draw_badge(cv::Mat& picture, cv::Point centre, const std::string& label,
                const cv::Scalar& colour) {
  const TextStyle style = text_style_for({450, 450});
  const int half = std::max(kBadge_px, text_size(label, style).width / 2 + 1);
  const auto pill = [&](int grow, const cv::Scalar& ink) {
    const int r = kBadge_px + grow;
    cv::line(picture, centre - cv::Point(half - kBadge_px, 0),
             centre + cv::Point(half - kBadge_px, 0), ink, 2 * r, cv::LINE_AA);
  };
  pill(2, {255, 255, 255});
  pill(0, colour);
  const cv::Size size = text_size(label, style);
  draw_dark_text(picture, label, centre - cv::Point(size.width / 2, size.height / 2 - 1), style,
                 {255, 255, 255});
}

// Beside what it points at, outwards from the middle, where no other one is.
class Badges {
 public:
  explicit Badges(cv::Mat& picture) : picture_(picture) {}

  void add(cv::Point at, const std::string& label, const cv::Scalar& colour) {
    const cv::Point centre = place(at);
    taken_.push_back({at, centre});
    cv::line(picture_, at, centre, {255, 255, 255}, 4, cv::LINE_AA);
    cv::line(picture_, at, centre, kInk, 2, cv::LINE_AA);
    cv::circle(picture_, at, 3, kInk, cv::FILLED, cv::LINE_AA);
    draw_badge(picture_, centre, label, colour);
  }

 private:
  cv::Point place(cv::Point at) const {
    const double outwards =
        std::atan2(at.y - picture_.rows / 2.0, at.x - picture_.cols / 2.0 + 1e-9);
    for (const double reach_px : {40.0, 64.0, 92.0, 124.0})
      for (const int turn : {0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5, 6}) {
        const double angle = outwards + turn * CV_PI / 6;
        const cv::Point centre = at + cv::Point(cvRound(reach_px * std::cos(angle)),
                                                cvRound(reach_px * std::sin(angle)));
        if (is_free(at, centre)) return centre;
      }
    return {std::clamp(at.x, 2 * kBadge_px, picture_.cols - 2 * kBadge_px),
            std::clamp(at.y, 2 * kBadge_px, picture_.rows - 2 * kBadge_px)};
  }
  // How far a point is from the way to a badge.
  static double distance(cv::Point2d p, cv::Point2d from, cv::Point2d to) {
    const cv::Point2d way = to - from;
    const double share = std::clamp((p - from).dot(way) / std::max(1.0, way.dot(way)), 0.0, 1.0);
    return cv::norm(p - from - share * way);
  }

  bool is_free(cv::Point at, cv::Point centre) const {
    constexpr int kApart_px = 2 * kBadge_px + 6;
    const cv::Rect inside(2 * kBadge_px, 2 * kBadge_px, picture_.cols - 4 * kBadge_px,
                          picture_.rows - 4 * kBadge_px);
    return inside.contains(centre) &&
           std::none_of(taken_.begin(), taken_.end(), [&](const Taken& other) {
             return cv::norm(other.centre - centre) < kApart_px ||
                    distance(centre, other.at, other.centre) < kBadge_px + 4 ||
                    distance(other.centre, at, centre) < kBadge_px + 4;
           });
  }

  struct Taken {
    cv::Point at, centre;
  };

  cv::Mat& picture_;
  std::vector<Taken> taken_;
};

// Words that fit in a width; what does not fit in so many lines is cut.
std::vector<std::string> wrapped(const std::string& text, const TextStyle& style, int width_px,
                                 std::size_t most) {
  std::vector<std::string> lines(1);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t space = std::min(text.find(' ', at), text.size());
    const std::string word = text.substr(at, space - at);
    const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
    at = space + 1;
    if (lines.back().empty() || text_size(longer, style).width <= width_px) {
      lines.back() = longer;
    } else if (lines.size() == most) {
      lines.back() += " ..";
      return lines;
    } else {
      lines.push_back(word);
    }
  }
  return lines;
}

struct LegendEntry {
  const FindingLine* line = nullptr;
  bool marked = false;
  cv::Scalar colour;
  std::vector<std::string> words;
};

std::vector<LegendEntry> legend_of(std::span<const FindingLine> lines,
                                   const std::vector<MarkedPlace>& marks, int width_px) {
  const TextStyle style = text_style_for({540, 540});
  std::vector<LegendEntry> entries;
  for (const FindingLine& line : lines.first(std::min(lines.size(), kMostLegend))) {
    LegendEntry& entry = entries.emplace_back();
    entry.line = &line;
    entry.marked = std::any_of(marks.begin(), marks.end(),
                               [&](const MarkedPlace& mark) { return mark.label == line.label; });
    const auto place = static_cast<std::size_t>(&line - lines.data());
    entry.colour = entry.marked ? mark_colour(line.severity, place) : kQuietInk;
    const std::string text = fmt::format("{} {}: {}{}", severity_name(line.severity), line.code,
                                         line.text, entry.marked ? "" : " (not seen here)");
    entry.words = wrapped(text, style, width_px, 3);
    for (std::string& cure : wrapped("cure: " + line.cure, style, width_px, 2))
      entry.words.push_back(std::move(cure));
  }
  return entries;
}

int height_of(const std::vector<LegendEntry>& legend, std::size_t lines) {
  std::size_t rows = lines > legend.size() || legend.empty() ? 1 : 0;
  for (const LegendEntry& entry : legend) rows += entry.words.size();
  return kGap_px * (1 + static_cast<int>(legend.size())) + kLine_px * static_cast<int>(rows);
}

void draw_legend(cv::Mat& page, int top, const std::vector<LegendEntry>& legend,
                 std::size_t lines) {
  const TextStyle style = text_style_for({540, 540});
  const int left = kMargin_px + 64;
  for (const LegendEntry& entry : legend) {
    draw_badge(page, {kMargin_px + 26, top + kLine_px / 2}, entry.line->label, entry.colour);
    for (const std::string& words : entry.words) {
      draw_dark_text(page, words, {left, top}, style,
                     words.starts_with("cure: ") ? kQuietInk : kInk);
      top += kLine_px;
    }
    top += kGap_px;
  }
  if (legend.empty()) draw_dark_text(page, "nothing is wrong with it", {left, top}, style);
  if (lines > legend.size())
    draw_dark_text(page, fmt::format("and {} more, in the text", lines - legend.size()),
                   {left, top}, style, kQuietInk);
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

}  // namespace

Result<FindingPicture> finding_picture(const PreparedObject& object, const Diagnosis& diagnosis,
                                       std::span<const FindingLine> lines) {
  const Scene shown = scene_for_views(object.scene);
  const Result<Renderer> renderer = Renderer::create(shown);
  if (!renderer) return Error{object.scene_file.native() + ": " + renderer.error()};
  const ColourGroups groups = colour_groups(object.scene);
  const MarkPainter painter(object.scene, groups);
  FindingPicture out;
  out.views = best_views(diagnosis, groups, renderer.value(), shown.studio);
  const int columns = out.views.size() == 1 ? 1 : 2;
  const int rows = (static_cast<int>(out.views.size()) + columns - 1) / columns;
  // A single view leaves room beside it, which its text needs.
  const int width = 2 * kMargin_px + 2 * kView_px + kGap_px;
  std::vector<cv::Mat> views;
  for (std::size_t k = 0; k < out.views.size(); ++k) {
    const ObjectView sharp(renderer.value(), shown.studio, out.views[k], kView_px);
    cv::Mat drawn;
    cv::resize(ObjectView(renderer.value(), shown.studio, out.views[k], 2 * kView_px).drawn(),
               drawn, {kView_px, kView_px}, 0, 0, cv::INTER_AREA);
    views.push_back(marked_view(sharp, drawn, painter, diagnosis, lines, k, out.marks));
  }
  const auto legend = legend_of(lines, out.marks, width - 2 * kMargin_px - 70);
  const int legend_top = kHead_px + rows * (kView_px + kCaption_px + kGap_px);
  out.picture =
      cv::Mat(legend_top + height_of(legend, lines.size()) + kMargin_px, width, CV_8UC3, kDesk);
  const TextStyle large = text_style_for({800, 800}), small = text_style_for({540, 540});
  draw_dark_text(out.picture, diagnosis.object, {kMargin_px, kMargin_px - 4},
                 fitted(large, diagnosis.object, width - 2 * kMargin_px));
  for (std::size_t k = 0; k < views.size(); ++k) {
    const int column = static_cast<int>(k) % columns, row = static_cast<int>(k) / columns;
    const int left =
        columns == 1 ? (width - kView_px) / 2 : kMargin_px + column * (kView_px + kGap_px);
    const cv::Rect place(left, kHead_px + row * (kView_px + kCaption_px + kGap_px), kView_px,
                         kView_px);
    views[k].copyTo(out.picture(place));
    const Eigen::Vector3d from = out.views[k].array() + 0.0;
    draw_dark_text(out.picture,
                   fmt::format("from {:.2f},{:.2f},{:.2f}", from.x(), from.y(), from.z()),
                   {place.x, place.br().y + 2}, small, kQuietInk);
    out.places.push_back(place);
  }
  for (MarkedPlace& mark : out.marks) mark.at += out.places[mark.view].tl();
  draw_legend(out.picture, legend_top, legend, lines.size());
  return out;
}

}  // namespace aspect
