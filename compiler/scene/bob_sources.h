// The texts a scene is read from: the scene file and what it includes, and how a place in them
// is written in a message.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/result.h"

namespace aspect {

// Thrown inside compiler/scene only; parse_bob() turns it into a Result. what() is the whole line.
class BobError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct Place {
  std::uint32_t file = 0;  // index into BobSources
  std::uint32_t line = 0;  // from 1
};

class BobSources {
 public:
  // All texts of one scene together; far above any real scene, low enough to be safe.
  static constexpr std::size_t kMaxBytes = std::size_t{64} << 20;

  // The text stays where it is for this object's life: words are views of it.
  std::uint32_t add(std::filesystem::path path, std::string text,
                    std::optional<Place> included_at = std::nullopt);

  // A file that is read or looked for, beside the first.
  void note(const std::filesystem::path& path) { noted_.push_back(path.string()); }
  const std::vector<std::string>& noted() const { return noted_; }

  std::string_view text(std::uint32_t file) const { return sources_[file].text; }
  const std::filesystem::path& path(std::uint32_t file) const { return sources_[file].path; }
  std::size_t bytes_left() const { return kMaxBytes - bytes_; }

  // "file:line"
  std::string locate(Place place) const;

  // "file:line: message (included from file:line, ...)", on one line whatever the names hold.
  std::string line_of(Place place, std::string_view message) const;

  [[noreturn]] void fail(Place place, std::string_view message) const;

 private:
  struct Source {
    std::filesystem::path path;
    std::string text;
    std::optional<Place> included_at;
  };

  std::deque<Source> sources_;
  std::vector<std::string> noted_;
  std::size_t bytes_ = 0;
};

// The bytes of a regular file of at most `max_bytes`; the error has no file name in front.
// Anything else, such as a device or a pipe, is refused, so that reading always ends.
Result<std::string> load_text(const std::filesystem::path& path, std::size_t max_bytes);

}  // namespace aspect
