// Frames of models from anywhere, and the indexes that recognise them.
#pragma once

#include <Eigen/Core>
#include <random>
#include <string>
#include <vector>

#include "runtime/recognition/class_index.h"
#include "tests/runtime/recognition/model_samples.h"

namespace aspect {

// Compiled at that level, as aspectc would.
ClassIndex model_index(const std::string& name, int level);

OwnedFrame beside(const OwnedFrame& left, const OwnedFrame& right);

Eigen::Vector3d random_direction(std::mt19937& random);

double angle_deg(const Vector3& a, const Eigen::Vector3d& b);

}  // namespace aspect
