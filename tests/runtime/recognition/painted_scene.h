// Models painted into one frame at poses that are known then, nearer ones before others.
#pragma once

#include <span>

#include "runtime/recognition/camera_model.h"
#include "runtime/recognition/object_model.h"
#include "tests/runtime/recognition/model_samples.h"

namespace aspect {

struct PlacedModel {
  const ObjectModel* model = nullptr;
  RigidPose pose;
};

// Without light: each surface in its colour. All of each model must lie before the camera.
void paint(std::span<const PlacedModel> placed, const CameraModel& camera, OwnedFrame& onto);

// A pinhole that sees so much over the picture's width.
CameraModel centred_camera(double field_of_view_deg, int width_px, int height_px);

}  // namespace aspect
