#include "tests/compiler/scene/scene_samples.h"

#include <catch2/catch.hpp>

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

}  // namespace aspect
