#include "scene_samples.h"

#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <fstream>
#include <system_error>

#include "compiler/scene/bob_reader.h"

namespace aspect {

Scene scene_of(std::string_view text) {
  Result<Scene> scene = parse_bob(text, "s.b");
  if (!scene.ok()) FAIL(scene.error());
  return std::move(scene).value();
}

std::string error_of(std::string_view text) {
  const Result<Scene> scene = parse_bob(text, "s.b");
  return scene.ok() ? "no error" : scene.error();
}

std::string error_of_file(const std::filesystem::path& file) {
  const Result<Scene> scene = read_bob(file);
  return scene.ok() ? "no error" : scene.error();
}

Eigen::Vector3d vector_of(std::string_view text) {
  const Scene scene = scene_of("sphere { center " + std::string(text) + " radius 1 }");
  return shape_of<Sphere>(scene).center;
}

ScratchFolder::ScratchFolder() {
  static std::atomic<int> made = 0;
  path_ = std::filesystem::temp_directory_path() /
          ("aspect_scene_test_" + std::to_string(::getpid()) + "_" + std::to_string(made++));
  std::filesystem::create_directories(path_);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::filesystem::path ScratchFolder::write(const std::string& name, std::string_view text) const {
  const std::filesystem::path file = path_ / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

}  // namespace aspect
