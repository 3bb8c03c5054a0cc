// From a camera position to a view graph: render, see, and look up where every contour lies.
#pragma once

#include <Eigen/Core>
#include <chrono>
#include <memory>

#include "compiler/matching/observed_view.h"
#include "compiler/render/renderer.h"
#include "compiler/render/sensor.h"
#include "runtime/base/planned_memory.h"
#include "runtime/vision/vision.h"

namespace aspect {

// One a thread: owns the picture and the memory of the vision pipeline.
class Observer {
 public:
  // Renderer and studio must outlive the observer.
  Observer(const Renderer& renderer, const Studio& studio, const VisionParameters& parameters);

  ObservedView observe(const Eigen::Vector3d& direction);
  // From any camera, rolled as it may be.
  ObservedView observe(const Camera& camera);

  // Of the last view, for drawing and for evaluation.
  const Picture& picture() const { return picture_; }
  const Frame& frame() const { return frame_; }
  const ViewGraph& graph() const { return graph_; }
  const RegionMap& regions() const { return vision_.regions(); }
  const VisionTimes& vision_times() const { return vision_.times(); }

  std::chrono::nanoseconds render_time() const { return render_time_; }  // of all views so far
  std::chrono::nanoseconds feature_time() const { return feature_time_; }

 private:
  void locate_contours(const Camera& camera, ObservedView& view);

  const Renderer* renderer_;
  Studio studio_;
  VisionParameters parameters_;
  Picture picture_;
  std::unique_ptr<Sensor> sensor_;
  Frame frame_;
  PlannedMemory memory_;
  Vision vision_;
  ViewGraph graph_;
  std::chrono::nanoseconds render_time_{}, feature_time_{};
};

}  // namespace aspect
