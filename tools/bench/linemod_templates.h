// Templates of OpenCV's LINEMOD from rendered views, and poses from what they match.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/rgbd/linemod.hpp>
#include <string>
#include <vector>

#include "compiler/render/camera.h"
#include "compiler/scene/scene.h"

namespace aspect {

struct LinemodSampling {
  int sphere_level = 3;    // directions: the corners of a sphere of that level, 10 * 4^level + 2
  double turn_deg = 15;    // from template to template in the picture's plane
  double nearest = 1.1;    // distances, in the scene's units
  double farthest = 2.2;   //
  int distances = 6;       // so many between them, in equal ratios
  unsigned features = 63;  // a template; OpenCV's default
  double weak_gradient = 10, strong_gradient = 55;  // OpenCV's defaults
  std::vector<int> spread_px = {5, 8};              // by level of the pyramid; OpenCV's default
};

// A point of the object's colour.
struct LinemodHue {
  std::int16_t x_px = 0, y_px = 0;
  std::uint8_t hue = 0;  // OpenCV's: half degrees
};

// What a template was made of.
struct LinemodView {
  Eigen::Matrix3d camera_from_object;  // rotation
  double distance = 0;
  cv::Point2d centre_px;  // where the object's origin is; as all here, from the match's place on
  cv::Rect silhouette_px;
  std::vector<LinemodHue> hues;
};

struct LinemodModel {
  cv::Ptr<cv::linemod::Detector> detector;
  std::map<std::string, std::vector<LinemodView>> views;  // by object, then by template
};

struct LinemodObject {
  std::string name;
  cv::Rect box_px;
  double similarity = 0;
  Eigen::Matrix3d camera_from_object;  // rotation
  Eigen::Vector3d translation_camera;
};

// As a camera of that lens sees the objects, colour gradients only; objects are made on two
// threads.
LinemodModel linemod_model(const std::vector<Scene>& scenes, const Intrinsics& lens,
                           const LinemodSampling& sampling);

// Of the matches in a picture, best first and, if so asked, of those whose colours are right: of
// two that overlap by more than half of the smaller box the better one stays.
std::vector<LinemodObject> linemod_objects(const LinemodModel& model,
                                           const std::vector<cv::linemod::Match>& matches,
                                           const cv::Mat& picture, const Intrinsics& lens,
                                           bool test_colours);

// The picture with rows and columns repeated to sides that LINEMOD can divide, as it has to.
cv::Mat linemod_padded(const cv::Mat& picture, const std::vector<int>& spread_px);

}  // namespace aspect
