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

// Cube and l_shape, each at level 3; made once in a program.
const std::vector<ClassIndex>& cube_and_l_shape();

OwnedFrame beside(const OwnedFrame& left, const OwnedFrame& right);

// Stripes of colours that neither cube nor l_shape has, nor any that is near one of theirs,
// brighter and darker by turns: no background.
OwnedFrame striped(int width_px, int height_px);

// Puts what is not black in a frame into another, shifted, as far as it lies within that.
void paste(const OwnedFrame& object, int right_px, int down_px, OwnedFrame& onto);

Eigen::Vector3d random_direction(std::mt19937& random);

double angle_deg(const Vector3& a, const Eigen::Vector3d& b);

}  // namespace aspect
