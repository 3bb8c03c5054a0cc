#include "tools/plot/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace aspect {
namespace {

constexpr std::array kColours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                 "#e69f00", "#56b4e9", "#000000"};
constexpr std::array kDashes = {"", "7 3", "2 3", "9 3 2 3"};
constexpr double kTitle_px = 16, kTick_px = 12, kMark_px = 4.5, kLegendMark_px = 30;
constexpr std::size_t kLegendLetters = 32;

// How many bytes from there on are one character; 0: no UTF-8.
std::size_t character_bytes(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char first = byte(at);
  const std::size_t count = first < 0x80                     ? 1
                            : first >= 0xC2 && first <= 0xDF ? 2
                            : (first & 0xF0) == 0xE0         ? 3
                            : first >= 0xF0 && first <= 0xF4 ? 4
                                                             : 0;
  if (count == 0 || at + count > text.size()) return 0;
  for (std::size_t k = 1; k < count; ++k)
    if ((byte(at + k) & 0xC0) != 0x80) return 0;
  // Overlong forms, halves of UTF-16, and what XML has no place for.
  const unsigned char second = count > 1 ? byte(at + 1) : 0;
  if (first == 0xE0 && second < 0xA0) return 0;
  if (first == 0xED && second > 0x9F) return 0;
  if (first == 0xEF && second == 0xBF && byte(at + 2) >= 0xBE) return 0;
  if (first == 0xF0 && second < 0x90) return 0;
  if (first == 0xF4 && second > 0x8F) return 0;
  return count;
}

std::string entity_or(std::string_view character) {
  switch (character.front()) {
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '&':
      return "&amp;";
    case '"':
      return "&quot;";
    default:
      return std::string(character);
  }
}

const char* anchor_name(PlotAnchor anchor) {
  constexpr std::array kNames = {"start", "middle", "end"};
  return kNames.at(static_cast<std::size_t>(anchor));
}

std::string stroke_words(const PlotStroke& stroke) {
  std::string words =
      fmt::format("stroke=\"{}\" stroke-width=\"{:g}\"", stroke.colour, stroke.width_px);
  if (!stroke.dashes.empty()) words += fmt::format(" stroke-dasharray=\"{}\"", stroke.dashes);
  return words;
}

std::string hover_word(std::string_view word) {
  return word.empty() ? std::string() : fmt::format("<title>{}</title>", svg_text(word));
}

// A circle, square, triangle or diamond, the next one for each round of colours or so.
std::string mark_shape(PlotPoint at, std::size_t series, std::string_view word) {
  const std::string fill =
      fmt::format("fill=\"{}\" stroke=\"#ffffff\" stroke-width=\"0.8\"", series_colour(series));
  const std::string title = hover_word(word);
  const double r = kMark_px;
  switch (series % 4) {
    case 0:
      return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}>{}</circle>\n", at.x,
                         at.y, r, fill, title);
    case 1:
      return fmt::format("<path d=\"M{:.1f} {:.1f}h{}v{}h-{}z\" {} class=\"mark\">{}</path>\n",
                         at.x - 0.9 * r, at.y - 0.9 * r, 1.8 * r, 1.8 * r, 1.8 * r, fill, title);
    case 2:
      return fmt::format("<path d=\"M{:.1f} {:.1f}l{} {}h-{}z\" {} class=\"mark\">{}</path>\n",
                         at.x, at.y - 1.2 * r, 1.15 * r, 2 * r, 2.3 * r, fill, title);
    default:
      return fmt::format(
          "<path d=\"M{:.1f} {:.1f}l{} {}l-{} {}l-{} -{}z\" {} class=\"mark\">{}</path>\n", at.x,
          at.y - 1.25 * r, 1.25 * r, 1.25 * r, 1.25 * r, 1.25 * r, 1.25 * r, 1.25 * r, fill, title);
  }
}

PlotStroke series_stroke(std::size_t series) {
  return {series_colour(series), 2, kDashes.at(series / kColours.size() % kDashes.size())};
}

}  // namespace

double PlotAxis::share(double value) const {
  const auto scaled = [this](double v) { return logarithmic ? std::log10(v) : v; };
  if (!(value > least)) return 0;
  if (!(value < most)) return 1;
  return (scaled(value) - scaled(least)) / (scaled(most) - scaled(least));
}

std::vector<PlotTick> round_ticks(const PlotAxis& axis) {
  std::vector<PlotTick> ticks;
  if (axis.logarithmic) {
    const int first = static_cast<int>(std::ceil(std::log10(axis.least) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(axis.most) + 1e-9));
    for (int power = first; power <= last; ++power)
      ticks.push_back({std::pow(10, power), fmt::format("{:g}", std::pow(10, power))});
    return ticks;
  }
  const double step = round_end((axis.most - axis.least) / 6);
  const int first = static_cast<int>(std::ceil(axis.least / step - 1e-9));
  for (int k = first; k * step <= axis.most + 1e-9 * step; ++k)
    ticks.push_back({k * step, fmt::format("{:g}", k * step)});
  return ticks;
}

double round_end(double most) {
  if (!(most > 0) || !std::isfinite(most)) return 1;
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= most * (1 - 1e-9)) return factor * power;
  return 10 * power;
}

double text_width_px(std::string_view text, double size_px) {
  constexpr double kMeanWidth = 0.58;  // of the size: sans serif of several kinds
  const auto letters = std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
  });
  return kMeanWidth * size_px * static_cast<double>(letters);
}

std::string svg_text(std::string_view text) {
  std::string safe;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t count = character_bytes(text, at);
    const auto first = static_cast<unsigned char>(text[at]);
    if (count == 0 || first < 0x20 || first == 0x7F)
      safe += '?';
    else
      safe += entity_or(text.substr(at, count));
    at += std::max<std::size_t>(1, count);
  }
  return safe;
}

std::string cut_text(std::string_view text, std::size_t most) {
  std::size_t at = 0;
  for (std::size_t k = 0; k < most && at < text.size(); ++k)
    at += std::max<std::size_t>(1, character_bytes(text, at));
  return at < text.size() ? std::string(text.substr(0, at)) + "…" : std::string(text);
}

std::string series_colour(std::size_t series) {
  return kColours.at(series % kColours.size());
}

SvgPage::SvgPage(double width_px, double height_px, std::string_view title)
    : width_px_(width_px),
      body_(
          fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" "
                      "viewBox=\"0 0 {0:g} {1:g}\" font-family=\"system-ui, 'DejaVu Sans', Arial, "
                      "sans-serif\">\n<title>{2}</title>\n<rect width=\"{0:g}\" height=\"{1:g}\" "
                      "fill=\"#ffffff\"/>\n",
                      width_px, height_px, svg_text(title))) {
  text({width_px / 2, 26}, title, {PlotAnchor::middle, kTitle_px, "#111111", true});
}

void SvgPage::line(PlotPoint from, PlotPoint to, const PlotStroke& stroke) {
  fmt::format_to(std::back_inserter(body_),
                 "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", from.x,
                 from.y, to.x, to.y, stroke_words(stroke));
}

void SvgPage::curve(std::span<const PlotPoint> points, const PlotStroke& stroke) {
  body_ += "<polyline points=\"";
  for (const PlotPoint& p : points)
    fmt::format_to(std::back_inserter(body_), "{:.1f},{:.1f} ", p.x, p.y);
  body_ += fmt::format("\" fill=\"none\" stroke-linejoin=\"round\" {}/>\n", stroke_words(stroke));
}

void SvgPage::bar(const PlotBox& box, std::string_view fill, std::string_view word) {
  fmt::format_to(std::back_inserter(body_),
                 "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" "
                 "fill=\"{}\" class=\"bar\">{}</rect>\n",
                 box.left, box.top, std::max(0.0, box.width), std::max(0.0, box.height), fill,
                 hover_word(word));
}

void SvgPage::mark(PlotPoint at, std::size_t series, std::string_view word) {
  body_ += mark_shape(at, series, word);
}

void SvgPage::text(PlotPoint at, std::string_view text, const PlotText& style) {
  body_ += fmt::format("<text x=\"{0:.1f}\" y=\"{1:.1f}\" font-size=\"{2:g}\" text-anchor=\"{3}\"",
                       at.x, at.y, style.size_px, anchor_name(style.anchor));
  if (style.bold) body_ += " font-weight=\"600\"";
  if (style.upwards) body_ += fmt::format(" transform=\"rotate(-90 {:.1f} {:.1f})\"", at.x, at.y);
  body_ += fmt::format(" fill=\"{}\">{}</text>\n", style.colour, svg_text(text));
}

void SvgPage::legend(PlotPoint corner, std::span<const std::string> names) {
  for (std::size_t k = 0; k < names.size(); ++k) {
    const double y = corner.y + (static_cast<double>(k) + 0.5) * kLegendLine_px;
    line({corner.x, y}, {corner.x + 22, y}, series_stroke(k));
    mark({corner.x + 11, y}, k);
    text({corner.x + kLegendMark_px, y + 4.5}, cut_text(names[k], kLegendLetters));
  }
}

double legend_width_px(std::span<const std::string> names) {
  double width = 0;
  for (const std::string& name : names)
    width = std::max(width, text_width_px(cut_text(name, kLegendLetters), 13));
  return kLegendMark_px + width;
}

PlotPanel::PlotPanel(SvgPage& page, const PlotBox& box, PlotAxis x, PlotAxis y)
    : page_(page), box_(box), x_(std::move(x)), y_(std::move(y)) {
  if (x_.ticks.empty()) x_.ticks = round_ticks(x_);
  if (y_.ticks.empty()) y_.ticks = round_ticks(y_);
  const PlotStroke grid{"#dddddd", 1}, frame{"#444444", 1.2};
  for (const PlotTick& tick : x_.ticks) {
    const double at_x = box_.left + box_.width * x_.share(tick.at);
    page_.line({at_x, box_.top}, {at_x, box_.bottom()}, grid);
    page_.text({at_x, box_.bottom() + 18}, tick.text, {PlotAnchor::middle, kTick_px});
  }
  for (const PlotTick& tick : y_.ticks) {
    const double at_y = box_.bottom() - box_.height * y_.share(tick.at);
    page_.line({box_.left, at_y}, {box_.right(), at_y}, grid);
    page_.text({box_.left - 8, at_y + 4}, tick.text, {PlotAnchor::end, kTick_px});
  }
  page_.line({box_.left, box_.top}, {box_.left, box_.bottom()}, frame);
  page_.line({box_.left, box_.bottom()}, {box_.right(), box_.bottom()}, frame);
  page_.text({box_.left + box_.width / 2, box_.bottom() + 42}, x_.title, {PlotAnchor::middle});
  page_.text({box_.left - 50, box_.top + box_.height / 2}, y_.title,
             {PlotAnchor::middle, 13, "#222222", false, true});
}

PlotPoint PlotPanel::at(double x, double y) const {
  return {box_.left + box_.width * x_.share(x), box_.bottom() - box_.height * y_.share(y)};
}

void PlotPanel::curve(std::span<const PlotPoint> data, std::size_t series, bool marks) {
  std::vector<PlotPoint> points;
  for (const PlotPoint& p : data) points.push_back(at(p.x, p.y));
  page_.curve(points, series_stroke(series));
  if (!marks) return;
  for (std::size_t k = 0; k < points.size(); ++k)
    page_.mark(points[k], series, fmt::format("{:g}: {:g}", data[k].x, data[k].y));
}

}  // namespace aspect
