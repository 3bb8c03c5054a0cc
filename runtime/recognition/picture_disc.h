// Where an object is in the picture, roughly: the disc of the ball that holds it.
#pragma once

#include "runtime/recognition/camera_model.h"
#include "runtime/recognition/object_model.h"

namespace aspect {

struct PictureDisc {
  double x = 0, y = 0, radius_px = 0;  // of the straight picture
};

PictureDisc disc_of(const ObjectModel& model, const RigidPose& pose, const CameraModel& camera);

double distance_px(const PictureDisc& a, const PictureDisc& b);

// Two objects cannot both be where their discs are so near to each other, but one behind the other;
// twice the same one cannot from farther apart. Shares of the larger disc's radius.
inline constexpr double kPlaceShare = 0.4, kSameObjectShare = 0.7;
bool share_place(const PictureDisc& a, const PictureDisc& b, double share = kPlaceShare);

}  // namespace aspect
