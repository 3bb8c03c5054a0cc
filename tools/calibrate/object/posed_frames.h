// Frames in which an object is found, with its pose: what is known of a picture before anything is
// measured in it.
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "compiler/scene/scene.h"
#include "runtime/base/result.h"
#include "runtime/recognition/camera_model.h"
#include "runtime/recognition/class_index.h"
#include "runtime/recognition/recogniser.h"
#include "runtime/recognition/rigid_pose.h"

namespace aspect {

struct PosedFrame {
  std::string name;
  std::size_t number = 0;  // among all frames
  cv::Mat picture;         // colours, blue first
  RigidPose camera_from_object;
  CameraModel camera;
  double probability = 0, reprojection_px = 0;
};

// What objects are looked for with.
struct KnownObject {
  std::vector<ClassIndex> indexes;  // one
  RecogniserParameters parameters;  // the index's and the configuration's
};

// The index of the scene's object, checked against the scene: a box of another size is another
// object. `configuration` may be empty.
Result<KnownObject> known_object(const std::filesystem::path& index,
                                 const std::filesystem::path& configuration, const Scene& scene);

struct FoundFrames {
  std::vector<PosedFrame> posed;
  std::vector<cv::Mat> pictures;       // all, smaller: for what compares frames as a whole
  std::vector<std::string> names;      // of all
  std::vector<std::string> not_found;  // where the object is not seen, or its pose is in doubt
};

// Of every frame the object that is surest. Those are left out that other poses explain as well,
// and those that are none too sure. Stops at a frame that cannot be read.
Result<FoundFrames> find_object(const KnownObject& object,
                                const std::vector<std::filesystem::path>& frames);

// The same of a picture that was read.
std::optional<PosedFrame> find_in_picture(const KnownObject& object, const std::string& name,
                                          const cv::Mat& picture);

}  // namespace aspect
