// STEP files (AP203, AP214, AP242), through a module of its own: compiler/step.
//
// The module needs OpenCASCADE and is built where that is found. It is loaded for the first STEP
// file and lies beside the program or in ../lib/aspect, so that nothing else needs it, or waits for
// it to load: measured, 40 ms.
#pragma once

#include <filesystem>

#include "compiler/scene/coloured_mesh.h"

namespace aspect {

// Of the diagonal of the box around the object. A third of what the index's model may be off.
inline constexpr double kDefaultChordError = 0.001;

struct StepReading {
  Eigen::Vector3d stand_in = kUncoloured;  // has the faces without colour
  // Largest distance of the triangles from the surface, as a share of the diagonal of the box
  // around the object; half of it has twice the triangles.
  double chord_error = kDefaultChordError;
};

// Millimetres, whatever the file's unit. Every face of every placed body is a part, in the file's
// order: its name is the face's own or "BODY.face N", N from 1 within the body; its material is the
// body's, so that a colour by name can be given to one face or to all of a body. A face's colour is
// its own, or that of the shell, solid or set of bodies it is in, of the instance (as the assembly
// around it overrides it), of the product, of the assembly: the first of these that has one. A face
// without any is a missing colour. Left out, with a warning: what is invisible; faces that cannot
// be cut into triangles. Throws MeshError, also where the module is not there.
ColouredMesh read_step(const std::filesystem::path& file, const StepReading& reading = {});

// What the module has, by this name.
using ReadStepFile = void (*)(const char* file, const StepReading& reading, ColouredMesh& mesh);
inline constexpr const char* kReadStepFile = "aspect_read_step_file";
inline constexpr const char* kStepModule = "aspect_step.so";

}  // namespace aspect
