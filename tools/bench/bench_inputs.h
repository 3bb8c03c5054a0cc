// What several benchmarks start from.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "runtime/base/result.h"

namespace aspect {

template <typename Value>
Value checked(Result<Value> result) {
  if (!result) {
    std::fprintf(stderr, "aspect-bench: %s\n", result.error().c_str());
    std::exit(1);
  }
  return std::move(result).value();
}

// Of this thread: what other programs take of a shared machine does not count.
inline double cpu_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// The first that is there, beside the program: as in the tree, where it is built/PRESET/bin, or as
// it is installed, in bin with share/ beside it.
inline std::filesystem::path beside_program(std::initializer_list<const char*> places) {
  std::error_code unknown;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", unknown);
  for (const char* place : places) {
    const std::filesystem::path path = (program.parent_path() / place).lexically_normal();
    if (std::filesystem::exists(path, unknown)) return path;
  }
  std::fprintf(stderr, "aspect-bench: %s is not there; install it again, or run build/release's\n",
               *(places.end() - 1));
  std::exit(1);
}

// Bob scenes.
inline std::filesystem::path model_file(const std::string& name) {
  return beside_program({"../../../compiler/models", "../share/aspect/models"}) / (name + ".b");
}

// Frames that POV-Ray rendered, with the scenes they show.
inline std::filesystem::path rendered_folder() {
  return beside_program({"../../../tests/data/rendered", "../share/aspect/rendered"});
}

// A hundred directions, evenly spread by the golden angle.
inline std::vector<Eigen::Vector3d> directions() {
  std::vector<Eigen::Vector3d> spread;
  for (int i = 0; i < 100; ++i) {
    const double z = (2 * i + 1) / 100.0 - 1, angle = 2.399963229728653 * i;
    const double radius = std::sqrt(1 - z * z);
    spread.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
  }
  return spread;
}

}  // namespace aspect
