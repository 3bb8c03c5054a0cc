// Which colour a STEP file gives to a face.
#pragma once

#include <TDF_Label.hxx>
#include <TDF_LabelSequence.hxx>
#include <XCAFDoc_ColorTool.hxx>

#include <Eigen/Core>
#include <optional>

namespace aspect {

using StepColour = std::optional<Eigen::Vector3d>;

// As displayed, 0..1: of the surface, otherwise of everything.
StepColour colour_of(const TDF_Label& label);

// Of an instance, the last of `path` (from the outermost assembly inwards): what an assembly around
// it says of it (SPECIFIED_HIGHER_USAGE_OCCURRENCE, the outermost first), otherwise its own.
StepColour instance_colour(const TDF_LabelSequence& path);

}  // namespace aspect
