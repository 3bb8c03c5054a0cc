#include "compiler/scene/named_file.h"

#include <algorithm>
#include <string>

#include "compiler/scene/mesh_text.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

constexpr int kMostEntries = 100'000;  // of a folder that are looked at
constexpr std::size_t kMostLetters = 4096;

bool is_file(const fs::path& path) {
  std::error_code unknown;
  return fs::is_regular_file(path, unknown);
}

// The only entry of the folder that has the name but for its case.
std::optional<fs::path> alike_in(const fs::path& folder, const fs::path& name) {
  std::optional<fs::path> found;
  std::error_code fault;
  fs::directory_iterator entry(folder.empty() ? fs::path(".") : folder, fault);
  const std::string wanted = lower_case(name.string());
  for (int k = 0; !fault && entry != fs::directory_iterator() && k < kMostEntries; ++k) {
    if (lower_case(entry->path().filename().string()) == wanted) {
      if (found) return std::nullopt;
      found = folder / entry->path().filename();
    }
    entry.increment(fault);
  }
  return found;
}

std::optional<fs::path> find_in_any_case(const fs::path& path) {
  fs::path found;
  for (const fs::path& step : path) {
    std::error_code unknown;
    if (fs::exists(found / step, unknown)) {
      found /= step;
      continue;
    }
    const std::optional<fs::path> alike = alike_in(found, step);
    if (!alike) return std::nullopt;
    found = *alike;
  }
  return is_file(found) ? std::optional(found) : std::nullopt;
}

}  // namespace

std::optional<NamedFile> find_named_file(const fs::path& folder, std::string_view name,
                                         std::vector<std::string>& asked) {
  if (name.empty() || name.size() > kMostLetters || name.find('\0') != std::string_view::npos)
    return std::nullopt;
  const auto noted = [&](const fs::path& path) {
    asked.push_back(path.string());
    return path;
  };
  if (const fs::path plain = noted(folder / name); is_file(plain)) return NamedFile{plain, false};
  std::string slashes(name);
  std::replace(slashes.begin(), slashes.end(), '\\', '/');
  const fs::path turned = noted(folder / slashes);
  if (is_file(turned)) return NamedFile{turned, false};
  const fs::path last_part = folder / fs::path(slashes).filename();
  for (const fs::path& path : {turned, last_part})
    if (const auto found = find_in_any_case(noted(path))) return NamedFile{noted(*found), true};
  return std::nullopt;
}

}  // namespace aspect
