#include "compiler/scene/dxf_names.h"

#include <cstdint>

namespace aspect {
namespace {

// Of two bytes in UTF-8 before and after.
std::uint32_t lower(std::uint32_t letter) {
  if (letter >= 0xC0 && letter <= 0xDE && letter != 0xD7) return letter + 0x20;     // Latin-1
  if (letter >= 0x391 && letter <= 0x3AB && letter != 0x3A2) return letter + 0x20;  // Greek
  if (letter >= 0x410 && letter <= 0x42F) return letter + 0x20;                     // Cyrillic
  if (letter >= 0x400 && letter <= 0x40F) return letter + 0x50;
  return letter;
}

std::uint32_t byte(char letter) {
  return static_cast<std::uint8_t>(letter);
}

}  // namespace

std::string dxf_key(std::string_view name) {
  std::string key(name);
  for (std::size_t k = 0; k < key.size(); ++k) {
    if (key[k] >= 'A' && key[k] <= 'Z') key[k] = static_cast<char>(key[k] - 'A' + 'a');
    const bool pair = (byte(key[k]) & 0xE0U) == 0xC0U && k + 1 < key.size() &&
                      (byte(key[k + 1]) & 0xC0U) == 0x80U;
    if (!pair) continue;
    const std::uint32_t letter = lower((byte(key[k]) & 0x1FU) << 6U | (byte(key[k + 1]) & 0x3FU));
    key[k] = static_cast<char>(0xC0U | letter >> 6U);
    key[++k] = static_cast<char>(0x80U | (letter & 0x3FU));
  }
  return key;
}

}  // namespace aspect
