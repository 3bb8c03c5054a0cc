#include "compiler/scene/bob_sources.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <system_error>
#include <utility>

namespace aspect {
namespace {

// A file's name may hold any byte; a message is one line.
std::string on_one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '\x7f'; }, '?');
  return text;
}

}  // namespace

std::uint32_t BobSources::add(std::filesystem::path path, std::string text,
                              std::optional<Place> included_at) {
  ASPECT_CHECK(text.size() <= bytes_left());
  bytes_ += text.size();
  sources_.push_back({std::move(path), std::move(text), included_at});
  return static_cast<std::uint32_t>(sources_.size() - 1);
}

std::string BobSources::locate(Place place) const {
  return fmt::format("{}:{}", sources_[place.file].path.string(), place.line);
}

std::string BobSources::line_of(Place place, std::string_view message) const {
  std::string line = fmt::format("{}: {}", locate(place), message);
  std::optional<Place> from = sources_[place.file].included_at;
  for (const char* lead = " (included from "; from; lead = ", ") {
    line += lead + locate(*from);
    from = sources_[from->file].included_at;
    if (!from) line += ")";
  }
  return on_one_line(std::move(line));
}

void BobSources::fail(Place place, std::string_view message) const {
  throw BobError(line_of(place, message));
}

Result<std::string> load_text(const std::filesystem::path& path, std::size_t max_bytes) {
  std::error_code code;
  const std::filesystem::file_status status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status)) return Error{"no such file; check the path"};
  if (!std::filesystem::is_regular_file(status)) {
    return Error{"not a regular file; give a plain one"};
  }
  const std::uintmax_t size = std::filesystem::file_size(path, code);
  if (code) return Error{"its size cannot be read; check its permissions"};
  if (size > max_bytes) {
    return Error{fmt::format("too large; a scene with all its includes has at most {} MiB",
                             BobSources::kMaxBytes >> 20)};
  }
  std::string text(static_cast<std::size_t>(size), '\0');
  std::ifstream stream(path, std::ios::binary);
  if (!stream.read(text.data(), static_cast<std::streamsize>(size))) {
    return Error{"cannot be read; check its permissions"};
  }
  return text;
}

}  // namespace aspect
