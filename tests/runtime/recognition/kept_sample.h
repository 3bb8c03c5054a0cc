// Samples as files in the folder that the environment variable ASPECT_SAMPLES names.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/runtime/recognition/model_samples.h"

namespace aspect {

// The name of a frame's sample: every bit of the direction is in it.
std::string view_name(const std::string& model, const Eigen::Vector3d& direction, double roll_rad);

// Does nothing without a folder. Fails the program where the file cannot be written.
void keep_sample(const std::string& name, const std::vector<std::uint8_t>& bytes);
void keep_view(const std::string& name, const OwnedFrame& frame);

// Whether there is one that is newer than `input` and than this program, and so than the compiler
// in it.
bool is_sample_fresh(const std::string& name, const std::filesystem::path& input);

// Fails the program where there is none.
std::vector<std::uint8_t> kept_sample(const std::string& name);
OwnedFrame kept_view(const std::string& name);

}  // namespace aspect
