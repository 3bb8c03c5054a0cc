#include "tests/runtime/recognition/kept_sample.h"

#include <unistd.h>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "runtime/base/check.h"

namespace aspect {
namespace {

std::optional<std::filesystem::path> file_of(const std::string& name) {
  const char* folder = std::getenv("ASPECT_SAMPLES");
  if (folder == nullptr) return std::nullopt;
  return std::filesystem::path(folder) / name;
}

}  // namespace

std::string view_name(const std::string& model, const Eigen::Vector3d& direction, double roll_rad) {
  std::array<char, 160> text;
  std::snprintf(text.data(), text.size(), "%s_%a_%a_%a_%a", model.c_str(), direction.x(),
                direction.y(), direction.z(), roll_rad);
  return text.data();
}

void keep_sample(const std::string& name, const std::vector<std::uint8_t>& bytes) {
  const auto file = file_of(name);
  if (!file) return;
  // Another program may be reading it.
  const std::filesystem::path part = file->string() + "." + std::to_string(::getpid());
  std::ofstream stream(part, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  ASPECT_CHECK(stream.flush().good());
  std::filesystem::rename(part, *file);
}

bool is_sample_fresh(const std::string& name, const std::filesystem::path& input) {
  const auto file = file_of(name);
  if (!file || !std::filesystem::exists(*file)) return false;
  const auto made = std::filesystem::last_write_time(*file);
  return made > std::filesystem::last_write_time(input) &&
         made > std::filesystem::last_write_time("/proc/self/exe");
}

std::vector<std::uint8_t> kept_sample(const std::string& name) {
  const auto file = file_of(name);
  ASPECT_CHECK(file.has_value());
  std::ifstream stream(*file, std::ios::binary);
  if (!stream)
    std::fprintf(stderr, "no sample %s: run the same test of the release build first\n",
                 file->c_str());
  ASPECT_CHECK(stream.good());
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Its size, then its pixels.
void keep_view(const std::string& name, const OwnedFrame& frame) {
  const std::array<std::int32_t, 2> size = {frame.width_px, frame.height_px};
  std::vector<std::uint8_t> bytes(sizeof size + frame.rgb.size());
  std::memcpy(bytes.data(), size.data(), sizeof size);
  std::memcpy(bytes.data() + sizeof size, frame.rgb.data(), frame.rgb.size());
  keep_sample(name, bytes);
}

OwnedFrame kept_view(const std::string& name) {
  const std::vector<std::uint8_t> bytes = kept_sample(name);
  std::array<std::int32_t, 2> size{};
  ASPECT_CHECK(bytes.size() > sizeof size);
  std::memcpy(size.data(), bytes.data(), sizeof size);
  return {size[0], size[1], {bytes.begin() + sizeof size, bytes.end()}};
}

}  // namespace aspect
