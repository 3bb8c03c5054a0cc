#include "tools/frame_page/page_block.h"

#include <fmt/format.h>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

namespace aspect {

std::string json_block(std::string_view css_class, const nlohmann::json& json) {
  const std::string text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size() + 64);
  // Only within strings there is a <, and "</script" or "<!--" must not be in an element.
  for (const char c : text)
    if (c == '<')
      safe += "\\u003c";
    else
      safe += c;
  return fmt::format("<script type=\"application/json\" class=\"{}\">{}</script>\n", css_class,
                     safe);
}

std::string text_block(std::string_view css_class, std::string_view text) {
  return fmt::format("<script type=\"text/plain\" class=\"{}\">{}</script>\n", css_class, text);
}

double with_digits(double number, int digits) {
  if (!std::isfinite(number)) return 0;
  return std::strtod(fmt::format("{:.{}g}", number, digits).c_str(), nullptr);
}

}  // namespace aspect
