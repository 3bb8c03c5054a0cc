// The command line of aspect-replay.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "runtime/service/configuration.h"
#include "tools/replay/bop_rows.h"

namespace aspect {

struct ReplayOptions {
  std::vector<std::filesystem::path> indexes;
  std::vector<std::filesystem::path> frames;
  std::optional<std::filesystem::path> configuration;
  std::optional<std::filesystem::path> overlay_folder, dump_folder, page_folder;
  std::optional<std::filesystem::path> truth, symmetries;  // of the page
  std::optional<double> pace_fps;
  std::optional<std::string> explain;  // empty: only what was chosen
  std::optional<BopIds> bop;           // rows in place of lines
  bool self_test = false;              // instead of frames
  bool thesis_index = false;           // instead of lines of JSON
  bool serve = false;                  // frames over and over on a page
  std::optional<std::string> address;  // of the page
  std::optional<int> port;
  std::optional<std::filesystem::path> record_folder;
  RecognitionOverrides recognition;
};

// The options, or the exit code after help, version or a complaint have been printed.
std::variant<ReplayOptions, int> parse_replay_options(int argc, const char* const* argv);

}  // namespace aspect
