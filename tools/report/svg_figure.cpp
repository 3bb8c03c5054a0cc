#include "tools/report/svg_figure.h"

#include <fmt/format.h>

namespace aspect {
namespace {

// Of the UTF-8 sequence at the beginning; 0: none that XML takes.
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return first >= 0x20 && first != 0x7f ? 1 : 0;
  const std::size_t length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < length) return 0;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(k) & 0xc0U) != 0x80U) return 0;
  // Too long for what they are, surrogates, beyond Unicode, and two that XML leaves out.
  if (first == 0xe0 && byte(1) < 0xa0) return 0;
  if (first == 0xed && byte(1) > 0x9f) return 0;
  if (first == 0xf0 && byte(1) < 0x90) return 0;
  if (first == 0xf4 && byte(1) > 0x8f) return 0;
  if (text.starts_with("\xef\xbf\xbe") || text.starts_with("\xef\xbf\xbf")) return 0;
  return length;
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string safe;
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    const std::string_view letter = text.substr(0, length);
    if (length == 0)
      safe += '?';
    else if (letter == "<")
      safe += "&lt;";
    else if (letter == ">")
      safe += "&gt;";
    else if (letter == "&")
      safe += "&amp;";
    else if (letter == "\"")
      safe += "&quot;";
    else
      safe += letter;
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return safe;
}

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t three = 0;
    for (std::size_t i = 0; i < 3; ++i)
      three = three << 8U | (k + i < bytes.size() ? bytes[k + i] : 0U);
    for (std::size_t i = 0; i < 4; ++i)
      text += k + i > bytes.size() ? '=' : kLetters[three >> (18 - 6 * i) & 63U];
  }
  return text;
}

std::string inline_svg(const SvgFigure& figure) {
  return fmt::format("<svg viewBox=\"0 0 {:.7g} {:.7g}\" role=\"img\" aria-label=\"{}\">{}</svg>",
                     figure.width, figure.height, escaped(figure.title), figure.body);
}

std::string svg_file(const SvgFigure& figure) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.7g}\" height=\"{1:.7g}\" viewBox=\"0 "
      "0 "
      "{0:.7g} {1:.7g}\" font-family=\"system-ui, Helvetica, Arial, "
      "sans-serif\">\n<title>{2}</title>"
      "\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n{3}\n</svg>\n",
      figure.width, figure.height, escaped(figure.title), figure.body);
}

std::string placed(const SvgFigure& figure, double x, double y, double width, double height) {
  return fmt::format(
      "<svg x=\"{:.7g}\" y=\"{:.7g}\" width=\"{:.7g}\" height=\"{:.7g}\" viewBox=\"0 0 {:.7g} "
      "{:.7g}\">"
      "{}</svg>",
      x, y, width, height, figure.width, figure.height, figure.body);
}

std::string svg_text(double x, double y, std::string_view text, const TextLook& look) {
  return fmt::format(
      "<text x=\"{:.7g}\" y=\"{:.7g}\" font-size=\"{:.7g}\" text-anchor=\"{}\" {}{}>{}</text>", x,
      y, look.size, look.anchor,
      look.faint ? "class=\"faint\" fill=\"#69707a\"" : "class=\"ink\" fill=\"#1b1f24\"",
      look.bold ? " font-weight=\"600\"" : "", escaped(text));
}

std::string svg_line(double x1, double y1, double x2, double y2, std::string_view css,
                     std::string_view colour, double width) {
  return fmt::format(
      "<line x1=\"{:.7g}\" y1=\"{:.7g}\" x2=\"{:.7g}\" y2=\"{:.7g}\" class=\"{}\" stroke=\"{}\" "
      "stroke-width=\"{:.7g}\"/>",
      x1, y1, x2, y2, css, colour, width);
}

std::string svg_picture(double x, double y, double width, double height,
                        std::span<const std::uint8_t> png) {
  return fmt::format(
      "<image x=\"{:.7g}\" y=\"{:.7g}\" width=\"{:.7g}\" height=\"{:.7g}\" "
      "href=\"data:image/png;base64,{}\"/>",
      x, y, width, height, base64(png));
}

}  // namespace aspect
