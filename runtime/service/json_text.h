// JSON into a caller's buffer: no allocation, no exceptions, commas and escapes in the right
// places.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace aspect {

// What does not fit is left out together with all that follows; fits() then says no, and the text
// so far is not valid JSON. Opening and closing in the right order is the caller's part.
class JsonText {
 public:
  explicit JsonText(std::span<char> out) : out_(out) {}

  void begin_object();
  void end_object();
  void begin_array();
  void end_array();
  void key(std::string_view name);
  void end_line();

  // Bytes that are not UTF-8 become the replacement character U+FFFD, one each.
  void value(std::string_view text);
  void value(std::int64_t number);
  // The shortest decimals that read back as the same number, with a point or an exponent;
  // null where it is not finite, which JSON cannot say.
  void value(float number);
  void value(double number);

  void value(bool truth);
  // Text that is one JSON value already.
  void json_value(std::string_view json);

  bool fits() const { return fits_; }
  std::size_t size() const { return size_; }

 private:
  void separate();
  void put(char c);
  void put(std::string_view text);
  void put_quoted(std::string_view text);
  void put_escaped(unsigned char c);
  template <typename Real>
  void put_real(Real number);

  std::span<char> out_;
  std::size_t size_ = 0;
  bool fits_ = true;
};

}  // namespace aspect
