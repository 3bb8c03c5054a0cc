// Plots as SVG documents: light paper, axes with units, series that are told apart without colours
// too. Lengths are in px of a page at 96 a inch.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aspect {

struct PlotPoint {
  double x = 0, y = 0;
};

struct PlotBox {
  double left = 0, top = 0, width = 0, height = 0;

  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

struct PlotTick {
  double at = 0;
  std::string text;
};

struct PlotAxis {
  std::string title;  // what it is, and in which unit
  double least = 0, most = 1;
  bool logarithmic = false;          // both ends are then above 0
  std::vector<PlotTick> ticks = {};  // none: round numbers

  // 0 at its beginning, 1 at its end, and no less or more: values beyond are drawn at the border.
  double share(double value) const;
};

// Round numbers, about six or, where logarithmic, the powers of ten.
std::vector<PlotTick> round_ticks(const PlotAxis& axis);
// A round number that is no less, for the end of an axis that begins at 0.
double round_end(double most);

enum class PlotAnchor { start, middle, end };

struct PlotText {
  PlotAnchor anchor = PlotAnchor::start;
  double size_px = 13;
  std::string colour = "#222222";
  bool bold = false, upwards = false;  // upwards: turned left by a right angle
};

struct PlotStroke {
  std::string colour = "#222222";
  double width_px = 1;
  std::string dashes = {};  // "4 3"; none: a whole line
};

// Wide enough for a text, by the mean width of letters.
double text_width_px(std::string_view text, double size_px);
// As it can stand in XML: with entities, without control characters and broken UTF-8.
std::string svg_text(std::string_view text);
// Its first characters and an ellipsis where it has more than `most`.
std::string cut_text(std::string_view text, std::size_t most);

// Told apart by colour, in the order of Okabe and Ito's palette for all eyes, and by mark and
// dashes beyond its end.
std::string series_colour(std::size_t series);

class SvgPage {
 public:
  SvgPage(double width_px, double height_px, std::string_view title);

  void line(PlotPoint from, PlotPoint to, const PlotStroke& stroke);
  void curve(std::span<const PlotPoint> points, const PlotStroke& stroke);
  // With a word that viewers show where the pointer rests; none where it is empty.
  void bar(const PlotBox& box, std::string_view fill, std::string_view word = {});
  void mark(PlotPoint at, std::size_t series, std::string_view word = {});
  void text(PlotPoint at, std::string_view text, const PlotText& style = {});
  // One below the other from there on, each with its mark.
  void legend(PlotPoint corner, std::span<const std::string> names);

  double width_px() const { return width_px_; }
  std::string document() const { return body_ + "</svg>\n"; }

 private:
  double width_px_;
  std::string body_;
};

// How wide a legend is, and how far apart its lines are.
double legend_width_px(std::span<const std::string> names);
inline constexpr double kLegendLine_px = 20;

// A rectangle with a grid, ticks and the titles of its axes: these lie to its left and below, in
// kAxisLeft_px and kAxisBelow_px.
inline constexpr double kAxisLeft_px = 68, kAxisBelow_px = 52;
class PlotPanel {
 public:
  PlotPanel(SvgPage& page, const PlotBox& box, PlotAxis x, PlotAxis y);

  PlotPoint at(double x, double y) const;
  const PlotBox& box() const { return box_; }
  // In data's coordinates: a line in the series' look, with a mark at each point if asked.
  void curve(std::span<const PlotPoint> data, std::size_t series, bool marks);

 private:
  SvgPage& page_;
  PlotBox box_;
  PlotAxis x_, y_;
};

}  // namespace aspect
