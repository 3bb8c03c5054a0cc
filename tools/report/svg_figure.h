// Drawings as SVG: the same in the page, where a style sheet colours them, and in a file to print.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace aspect {

// What is in a drawing's own words (class="ink", "faint", "line") has its colours as attributes,
// too.
struct SvgFigure {
  double width = 0, height = 0;
  std::string title;  // plain text
  std::string body;   // SVG elements
};

// For an HTML page.
std::string inline_svg(const SvgFigure& figure);

// A file of its own, on white.
std::string svg_file(const SvgFigure& figure);

// As a part of another figure.
std::string placed(const SvgFigure& figure, double x, double y, double width, double height);

struct TextLook {
  double size = 12;
  std::string_view anchor = "start";  // middle, end
  bool faint = false, bold = false;
};
std::string svg_text(double x, double y, std::string_view text, const TextLook& look = {});

std::string svg_line(double x1, double y1, double x2, double y2, std::string_view css = "line",
                     std::string_view colour = "#c6cbd2", double width = 1);

std::string svg_picture(double x, double y, double width, double height,
                        std::span<const std::uint8_t> png);

// Text that names may be made of, for XML and for HTML: control characters and what is no UTF-8
// become question marks.
std::string escaped(std::string_view text);

std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace aspect
