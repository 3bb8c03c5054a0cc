// ViSP's model-based tracker, edges only, on a clip of make_clip.py: what ours is measured beside.
// It is started with the true pose, and again wherever it has lost an object that is in sight; ours
// never is. Writes lines like aspect-replay's, for score_clip.py, and on standard error how often
// each object was started.
//
// usage: visp-clip CLIP    with the models that visp_models.py has written there
#include <visp3/core/vpImageConvert.h>
#include <visp3/mbt/vpMbGenericTracker.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "tools/bench/camera_table.h"

namespace {

using Clock = std::chrono::steady_clock;

struct TrueObject {
  vpHomogeneousMatrix camera_from_object;
  double visible = 0;
};

// By frame, then by object.
using Truth = std::map<std::string, std::map<std::string, TrueObject>>;

Truth read_truth(const std::string& file) {
  Truth truth;
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::vector<std::string> cells;
    std::stringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    TrueObject& object = truth[cells.at(0)][cells.at(1)];
    for (unsigned i = 0; i < 3; ++i) {
      for (unsigned k = 0; k < 3; ++k)
        object.camera_from_object[i][k] = std::stod(cells.at(2 + 3 * i + k));
      object.camera_from_object[i][3] = std::stod(cells.at(11 + i));
    }
    object.visible = std::stod(cells.at(21));
  }
  return truth;
}

vpCameraParameters read_camera(const std::string& file) {
  std::map<std::string, double> values = aspect::camera_table(file);
  vpCameraParameters camera;
  camera.initPersProjWithoutDistortion(values["fx"], values["fy"], values["cx"], values["cy"]);
  return camera;
}

class Object {
 public:
  Object(std::string name, const std::string& folder, const vpCameraParameters& camera)
      : name_(std::move(name)), tracker_(1, vpMbGenericTracker::EDGE_TRACKER) {
    // As its tutorials do; a range that reaches as far as objects move in a frame.
    vpMe edges;
    edges.setMaskSize(5);
    edges.setMaskNumber(180);
    edges.setRange(10);
    edges.setThreshold(10000);
    edges.setMu1(0.5);
    edges.setMu2(0.5);
    edges.setSampleStep(4);
    tracker_.setMovingEdge(edges);
    tracker_.setCameraParameters(camera);
    tracker_.setAngleAppear(vpMath::rad(70));
    tracker_.setAngleDisappear(vpMath::rad(80));
    tracker_.setNearClippingDistance(0.1);
    tracker_.setFarClippingDistance(100);
    tracker_.setScanLineVisibilityTest(true);
    tracker_.setClipping(tracker_.getClipping() | vpMbtPolygon::FOV_CLIPPING);
    tracker_.loadModel(folder + "/" + name_ + ".cao");
  }

  // True: seen, to its own belief.
  bool track(const vpImage<unsigned char>& picture, const TrueObject* truth) {
    constexpr double kInSight = 0.95, kFarOff = 0.15;
    if (!runs_) {
      if (truth == nullptr || truth->visible < kInSight) return false;
      tracker_.initFromPose(picture, truth->camera_from_object);
      ++starts_;
      runs_ = true;
      return false;
    }
    try {
      tracker_.track(picture);
    } catch (const vpException&) {
      runs_ = false;
      return false;
    }
    // It does not know that it follows something else; score_clip.py goes by the same distance.
    const vpHomogeneousMatrix pose = tracker_.getPose();
    if (truth == nullptr) {
      runs_ = false;
      return false;
    }
    const vpTranslationVector is = pose.getTranslationVector(),
                              should = truth->camera_from_object.getTranslationVector();
    runs_ = (is - should).frobeniusNorm() < kFarOff * should.frobeniusNorm();
    return true;
  }

  std::string json() const {
    const vpHomogeneousMatrix pose = tracker_.getPose();
    const vpQuaternionVector q(pose.getRotationMatrix());
    const vpTranslationVector t = pose.getTranslationVector();
    char text[512];
    std::snprintf(text, sizeof(text),
                  R"({"verdict":"match","track":%d,"hypotheses":[{"object":"%s","pose":)"
                  R"({"quaternion":[%.9f,%.9f,%.9f,%.9f],"translation":[%.9f,%.9f,%.9f]}}]})",
                  starts_, name_.c_str(), q.w(), q.x(), q.y(), q.z(), t[0], t[1], t[2]);
    return text;
  }

  const std::string& name() const { return name_; }
  int starts() const { return starts_; }

 private:
  std::string name_;
  vpMbGenericTracker tracker_;
  int starts_ = 0;
  bool runs_ = false;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fputs("usage: visp-clip CLIP\n", stderr), 2;
  // What it tells of models while it reads them.
  std::cout.setstate(std::ios::failbit);
  const std::string folder = argv[1];
  const Truth truth = read_truth(folder + "/truth.csv");
  const vpCameraParameters camera = read_camera(folder + "/camera.toml");
  std::vector<std::unique_ptr<Object>> objects;
  for (const char* name : {"blockcyl2", "pegblock", "l_shape"})
    objects.push_back(std::make_unique<Object>(name, folder, camera));
  for (const auto& [file, rows] : truth) {
    const cv::Mat read = cv::imread(folder + "/" + file, cv::IMREAD_GRAYSCALE);
    const vpImage<unsigned char> picture(read.data, static_cast<unsigned>(read.rows),
                                         static_cast<unsigned>(read.cols), true);
    std::string seen;
    const auto start = Clock::now();
    for (const auto& object : objects) {
      const auto row = rows.find(object->name());
      if (object->track(picture, row == rows.end() ? nullptr : &row->second))
        seen += (seen.empty() ? "" : ",") + object->json();
    }
    const std::chrono::duration<double, std::milli> elapsed = Clock::now() - start;
    std::printf(R"({"frame":"%s","elapsed_ms":%.4f,"stages_ms":{"segment":0},"objects":[%s]})"
                "\n",
                file.c_str(), elapsed.count(), seen.c_str());
  }
  for (const auto& object : objects)
    std::fprintf(stderr, "%s: started %d times with the true pose\n", object->name().c_str(),
                 object->starts());
  return 0;
}
