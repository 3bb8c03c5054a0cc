#include "tools/command_line/value_words.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace aspect {
namespace {

// What compiler/scene reads, and the projects that name it.
constexpr std::array<std::string_view, 9> kSceneEndings = {"b",   "obj", "ply", "stl", "gltf",
                                                           "glb", "dxf", "off", "3ds"};

bool begins_with_capital(std::string_view word) {
  return !word.empty() && std::isupper(static_cast<unsigned char>(word.front())) != 0;
}

std::vector<std::string_view> split(std::string_view value) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t bar = value.find('|');
    parts.push_back(value.substr(0, bar));
    if (bar == std::string_view::npos) return parts;
    value.remove_prefix(bar + 1);
  }
}

void add_part(std::string_view part, ValueWords& words) {
  const std::size_t dot = part.find('.');
  if (!begins_with_capital(part)) {
    words.choices.emplace_back(part);
  } else if (dot != std::string_view::npos) {
    words.is_file = true;
    words.endings.emplace_back(part.substr(dot + 1));
  } else if (part == "SCENE") {
    words.is_file = true;
    words.endings.insert(words.endings.end(), kSceneEndings.begin(), kSceneEndings.end());
  } else if (part == "FILE" || part == "FRAME") {
    words.is_file = true;
  } else if (part == "FOLDER") {
    words.is_folder = true;
  }
}

}  // namespace

ValueWords value_words(std::string_view value) {
  ValueWords words;
  if (value.empty() || value.front() == '[') return words;
  const std::vector<std::string_view> parts = split(value);
  // "auto" alone would be a name for a value, not a choice.
  if (parts.size() == 1 && !begins_with_capital(value)) return words;
  for (const std::string_view part : parts) add_part(part, words);
  return words;
}

}  // namespace aspect
