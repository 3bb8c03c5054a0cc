// Which rotations may be symmetries, judged by the views that a subdivision holds: no rendering.
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <vector>

#include "compiler/aspects/subdivision.h"

namespace aspect {

// Contours of a view and where they lie, large ones only.
struct Landmark {
  Eigen::Vector3d place;  // from studio.at, object coordinates
  std::array<float, 3> share{};
  double area = 0;  // share of the outline's area
};
std::vector<Landmark> landmarks_of(const ObservedView& view, const Eigen::Vector3d& at);

struct LandmarkPair {
  Eigen::Vector3d from, to;
  double weight = 1;
};
// The rotation that takes `from` to `to` with the least weighted squares (Kabsch).
Eigen::Quaterniond rotation_of(const std::vector<LandmarkPair>& pairs);

// Adds, for every landmark of `from`, the one of `to` that is of its colour and nearest to where
// the rotation takes it; returns the area of those that have none within `reach`.
double pair_landmarks(const std::vector<Landmark>& from, const std::vector<Landmark>& to,
                      const Eigen::Quaterniond& rotation, double reach,
                      std::vector<LandmarkPair>& pairs);

class KnownViews {
 public:
  KnownViews(const Subdivision& subdivision, const Eigen::Vector3d& at);

  // Views spread evenly over the sphere, in an order in which any first few are spread too.
  const std::vector<VertexId>& samples() const { return samples_; }
  const ObservedView& view(VertexId vertex) const {
    return subdivision_.views[static_cast<std::size_t>(vertex)];
  }
  const std::vector<Landmark>& landmarks(VertexId vertex) const {
    return landmarks_[static_cast<std::size_t>(vertex)];
  }
  double radius() const { return radius_; }  // of the farthest landmark

  // The share of what the samples show that is there again, turned, in the known views nearest to
  // the turned directions; 0 as soon as it must be below `enough`. Adds pairs where asked for.
  double likeness(const Eigen::Quaterniond& rotation, double enough,
                  std::vector<LandmarkPair>* pairs = nullptr) const;

  // Rotations that take the landmarks of a telling view to those of another one; improved by the
  // landmarks of all samples, and alike in all of them. None is nearer than 8 degrees to another.
  std::vector<Eigen::Quaterniond> candidates() const;

 private:
  VertexId nearest(const Eigen::Vector3d& direction) const;
  std::vector<VertexId> telling_views() const;
  void add_candidates(VertexId from, VertexId to,
                      std::vector<std::pair<double, Eigen::Quaterniond>>& found) const;

  const Subdivision& subdivision_;
  std::vector<VertexId> samples_;
  std::vector<std::vector<Landmark>> landmarks_;  // by vertex
  double radius_ = 0;
};

}  // namespace aspect
