#include "compiler/scene/ply_numbers.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace aspect {
namespace {

template <typename Value>
double as(const std::array<char, 8>& bytes) {
  Value value{};
  std::memcpy(&value, bytes.data(), sizeof value);
  return static_cast<double>(value);
}

}  // namespace

double PlyNumbers::next_word() {
  if (word_ == words_.size()) words_ = text_.take_words("a number"), word_ = 0;
  return text_.number(words_[word_++]);
}

double PlyNumbers::next_bytes(PlyType type) {
  const std::size_t count = bytes_of(type);
  if (position_ > file_.size() || file_.size() - position_ < count)
    throw MeshError("ends before its data do; export it again");
  std::array<char, 8> bytes{};
  std::copy_n(file_.data() + position_, count, bytes.data());
  position_ += count;
  const bool big = format_ == PlyHeader::Format::big_endian;
  if (big != (std::endian::native == std::endian::big))
    std::reverse(bytes.data(), bytes.data() + count);
  switch (type) {
    case PlyType::int8:
      return as<std::int8_t>(bytes);
    case PlyType::uint8:
      return as<std::uint8_t>(bytes);
    case PlyType::int16:
      return as<std::int16_t>(bytes);
    case PlyType::uint16:
      return as<std::uint16_t>(bytes);
    case PlyType::int32:
      return as<std::int32_t>(bytes);
    case PlyType::uint32:
      return as<std::uint32_t>(bytes);
    case PlyType::float32:
      return as<float>(bytes);
    default:
      return as<double>(bytes);
  }
}

}  // namespace aspect
