// The command line of aspect-export.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>

namespace aspect {

inline constexpr std::array<std::string_view, 8> kExportFormats = {"sgm", "chn8", "vert",  "part",
                                                                   "det", "attr", "means", "class"};

struct ExportOptions {
  std::filesystem::path store, folder;
  std::optional<int> level;
  bool without_borders = false;
  std::set<std::string, std::less<>> formats;  // of the above; empty: all
  std::string scene;                           // or a project; empty: the store's
  int jobs = 0;

  bool wants(std::string_view format) const { return formats.empty() || formats.contains(format); }
};

// The options, or the exit code after help, version or a complaint have been printed.
std::variant<ExportOptions, int> parse_export_options(int argc, const char* const* argv);

}  // namespace aspect
