#include "runtime/service/json_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace aspect {
namespace {

// Length of the UTF-8 character at the front of `text`, 0: there is none (Unicode 15, table 3-7).
std::size_t utf8_length(std::string_view text) {
  const auto at = [&](std::size_t k) {
    return k < text.size() ? static_cast<unsigned char>(text[k]) : 0U;
  };
  const unsigned first = at(0), second = at(1);
  if (first < 0x80) return 1;
  std::size_t length = 0;
  unsigned least = 0x80, most = 0xBF;
  if (first >= 0xC2 && first <= 0xDF) length = 2;
  if (first >= 0xE0 && first <= 0xEF) {
    length = 3;
    if (first == 0xE0) least = 0xA0;
    if (first == 0xED) most = 0x9F;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    length = 4;
    if (first == 0xF0) least = 0x90;
    if (first == 0xF4) most = 0x8F;
  }
  if (length == 0 || second < least || second > most) return 0;
  for (std::size_t k = 2; k < length; ++k)
    if (at(k) < 0x80 || at(k) > 0xBF) return 0;
  return length;
}

}  // namespace

void JsonText::begin_object() {
  separate();
  put('{');
}

void JsonText::end_object() {
  put('}');
}

void JsonText::begin_array() {
  separate();
  put('[');
}

void JsonText::end_array() {
  put(']');
}

void JsonText::key(std::string_view name) {
  separate();
  put_quoted(name);
  put(':');
}

void JsonText::end_line() {
  put('\n');
}

void JsonText::value(std::string_view text) {
  separate();
  put_quoted(text);
}

void JsonText::value(std::int64_t number) {
  separate();
  std::array<char, 24> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  put({digits.data(), static_cast<std::size_t>(end.ptr - digits.data())});
}

void JsonText::value(bool truth) {
  json_value(truth ? "true" : "false");
}

void JsonText::json_value(std::string_view json) {
  separate();
  put(json);
}

void JsonText::value(float number) {
  put_real(number);
}
void JsonText::value(double number) {
  put_real(number);
}

template <typename Real>
void JsonText::put_real(Real number) {
  separate();
  if (!fits_) return;
  if (!std::isfinite(number)) return put("null");
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  const std::string_view text(digits.data(), static_cast<std::size_t>(end.ptr - digits.data()));
  put(text);
  if (text.find_first_of(".e") == std::string_view::npos) put(".0");
}

// A value that follows another one needs a comma; a string cannot end like an opening bracket.
void JsonText::separate() {
  if (size_ == 0) return;
  const char last = out_[size_ - 1];
  if (last != '{' && last != '[' && last != ':') put(',');
}

void JsonText::put(char c) {
  fits_ = fits_ && size_ < out_.size();
  if (fits_) out_[size_++] = c;
}

void JsonText::put(std::string_view text) {
  if (!fits_ || text.size() > out_.size() - size_) {
    fits_ = false;
    return;
  }
  std::copy(text.begin(), text.end(), out_.begin() + static_cast<std::ptrdiff_t>(size_));
  size_ += text.size();
}

void JsonText::put_quoted(std::string_view text) {
  put('"');
  while (!text.empty() && fits_) {
    const std::size_t length = utf8_length(text);
    if (length == 1) put_escaped(static_cast<unsigned char>(text.front()));
    if (length != 1) put(length == 0 ? std::string_view("\\ufffd") : text.substr(0, length));
    text.remove_prefix(std::max(length, std::size_t{1}));
  }
  put('"');
}

void JsonText::put_escaped(unsigned char c) {
  constexpr std::string_view kHex = "0123456789abcdef";
  if (c == '"') return put("\\\"");
  if (c == '\\') return put("\\\\");
  if (c == '\n') return put("\\n");
  if (c == '\t') return put("\\t");
  if (c >= 0x20 && c != 0x7F) return put(static_cast<char>(c));
  const std::array<char, 6> escape = {'\\', 'u', '0', '0', kHex[c >> 4U], kHex[c & 15U]};
  put({escape.data(), escape.size()});
}

}  // namespace aspect
