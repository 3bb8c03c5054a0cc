// What the tests of scenes share.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "compiler/scene/scene.h"

namespace aspect {

// The scene of a text that must be right; the test fails with the reader's message where it is not.
Scene scene_of(std::string_view text);

// The message of a text that is wrong, "no error" where it is not. Texts are called s.b.
std::string error_of(std::string_view text);
std::string error_of_file(const std::filesystem::path& file);

// The only vertex, centre and so on of tests: where `sphere { center TEXT radius 1 }` stands.
Eigen::Vector3d vector_of(std::string_view text);

template <typename Shape>
const Shape& shape_of(const Scene& scene, std::size_t index = 0) {
  return std::get<Shape>(scene.primitives.at(index).shape);
}

}  // namespace aspect
