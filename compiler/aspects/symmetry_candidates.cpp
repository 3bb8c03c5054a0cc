// A view with several contours fixes the object's attitude by where its landmarks lie. If a view
// has an image under a symmetry, then one of the known views is near to that image and shows nearly
// the same landmarks. So the landmarks of a few telling views are mapped, colour by colour and
// distance by distance, on those of every other view; each mapping is a rotation.
//
// Weak side: landmarks of round surfaces move with the viewpoint, hence the generous reach; views
// of a single region have none to speak of.
#include "compiler/aspects/symmetry_candidates.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "compiler/aspects/rotation_group.h"

namespace aspect {
namespace {

constexpr std::size_t kSamples = 96;
constexpr double kSmallLandmark = 0.03;  // share of the outline's area
constexpr double kReach = 0.22;          // of the radius
constexpr float kSameShare = 0.05F;      // colour share
constexpr double kSameOutline = 0.2;     // relative difference of the outlines' areas
constexpr double kMostDirection_rad = 15 * std::numbers::pi / 180;
constexpr double kEnough = 0.8;  // likeness of a candidate
constexpr std::size_t kTellingViews = 4, kMostCandidates = 200, kMostMapped = 5;

bool same_colour(const Landmark& a, const Landmark& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (std::abs(a.share[k] - b.share[k]) > kSameShare) return false;
  return true;
}

// Points of a spiral from pole to pole, each the same share of the sphere; the odd start keeps them
// off the planes that models are symmetric to.
Eigen::Vector3d spiral_point(std::size_t k, std::size_t count) {
  const double z = 1 - 2 * (static_cast<double>(k) + 0.5) / static_cast<double>(count);
  const double angle =
      0.37 + static_cast<double>(k) * 2 * std::numbers::pi / (std::numbers::phi + 1);
  const double r = std::sqrt(std::max(0.0, 1 - z * z));
  return {r * std::cos(angle), r * std::sin(angle), z};
}

// Every mapping of `from` on as many of `to` that keeps colours, sizes and distances.
class Mappings {
 public:
  using Found = std::function<void(const std::vector<LandmarkPair>&)>;
  Mappings(std::vector<Landmark> from, const std::vector<Landmark>& to, double reach, Found found)
      : from_(std::move(from)),
        to_(to),
        used_(to.size(), false),
        reach_(reach),
        found_(std::move(found)) {
    if (from_.size() > kMostMapped) from_.resize(kMostMapped);
  }

  void extend() {
    const std::size_t place = pairs_.size();
    if (place == from_.size()) return found_(pairs_);
    for (std::size_t k = 0; k < to_.size(); ++k) {
      if (used_[k] || !fits(from_[place], to_[k])) continue;
      used_[k] = true;
      pairs_.push_back({from_[place].place, to_[k].place, from_[place].area});
      extend();
      pairs_.pop_back();
      used_[k] = false;
    }
  }

 private:
  bool fits(const Landmark& a, const Landmark& b) const {
    if (!same_colour(a, b) || std::abs(a.place.norm() - b.place.norm()) > reach_) return false;
    return std::all_of(pairs_.begin(), pairs_.end(), [&](const LandmarkPair& pair) {
      return std::abs((a.place - pair.from).norm() - (b.place - pair.to).norm()) <= reach_;
    });
  }

  std::vector<Landmark> from_;
  const std::vector<Landmark>& to_;
  std::vector<bool> used_;
  std::vector<LandmarkPair> pairs_;
  double reach_;
  Found found_;
};

}  // namespace

std::vector<Landmark> landmarks_of(const ObservedView& view, const Eigen::Vector3d& at) {
  std::vector<Landmark> landmarks;
  for (std::size_t k = 0; k < view.external_count; ++k) {
    const ObservedContour& contour = view.contours[k];
    const auto area = static_cast<double>(contour.feature.area);
    if (area < kSmallLandmark) continue;
    const Eigen::Vector3f centre(contour.centre_object.data());
    landmarks.push_back({centre.cast<double>() - at, contour.feature.share, area});
  }
  std::stable_sort(landmarks.begin(), landmarks.end(),
                   [](const Landmark& a, const Landmark& b) { return a.area > b.area; });
  return landmarks;
}

Eigen::Quaterniond rotation_of(const std::vector<LandmarkPair>& pairs) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const LandmarkPair& pair : pairs) sum += pair.weight * pair.to * pair.from.transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  const Eigen::Matrix3d rotation =
      svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
  return Eigen::Quaterniond(rotation).normalized();
}

double pair_landmarks(const std::vector<Landmark>& from, const std::vector<Landmark>& to,
                      const Eigen::Quaterniond& rotation, double reach,
                      std::vector<LandmarkPair>& pairs) {
  double lost = 0;
  for (const Landmark& landmark : from) {
    const Eigen::Vector3d wanted = rotation * landmark.place;
    const Landmark* best = nullptr;
    for (const Landmark& other : to) {
      if (!same_colour(landmark, other)) continue;
      if (best == nullptr || (other.place - wanted).norm() < (best->place - wanted).norm())
        best = &other;
    }
    if (best == nullptr || (best->place - wanted).norm() > reach)
      lost += landmark.area;
    else
      pairs.push_back({landmark.place, best->place, landmark.area});
  }
  return lost;
}

KnownViews::KnownViews(const Subdivision& subdivision, const Eigen::Vector3d& at)
    : subdivision_(subdivision) {
  for (const ObservedView& view : subdivision.views) landmarks_.push_back(landmarks_of(view, at));
  for (const auto& landmarks : landmarks_)
    for (const Landmark& landmark : landmarks) radius_ = std::max(radius_, landmark.place.norm());
  // Steps of a number coprime to the count spread any first few.
  constexpr std::size_t kStep = 37;
  for (std::size_t k = 0; k < kSamples; ++k) {
    const VertexId vertex = nearest(spiral_point(k * kStep % kSamples, kSamples));
    if (view(vertex).external_count > 0 &&
        std::find(samples_.begin(), samples_.end(), vertex) == samples_.end())
      samples_.push_back(vertex);
  }
}

VertexId KnownViews::nearest(const Eigen::Vector3d& direction) const {
  const ViewSphere& sphere = subdivision_.sphere;
  const auto& corners = sphere.patch(sphere.locate(direction)).corners;
  return *std::max_element(corners.begin(), corners.end(), [&](VertexId a, VertexId b) {
    return sphere.position(a).dot(direction) < sphere.position(b).dot(direction);
  });
}

double KnownViews::likeness(const Eigen::Quaterniond& rotation, double enough,
                            std::vector<LandmarkPair>* pairs) const {
  std::vector<LandmarkPair> unwanted;
  std::vector<LandmarkPair>& kept = pairs == nullptr ? unwanted : *pairs;
  const auto total = static_cast<double>(samples_.size());
  double lost = 0;
  for (const VertexId from : samples_) {
    const VertexId to = nearest(rotation * view(from).direction);
    const double a = static_cast<double>(view(from).area_px);
    const double b = static_cast<double>(view(to).area_px);
    if (std::abs(a - b) > kSameOutline * std::max(a, b))
      lost += 1;
    else
      lost += std::min(
          1.0, pair_landmarks(landmarks(from), landmarks(to), rotation, kReach * radius_, kept));
    if (total - lost < enough * total) return 0;
  }
  return total > 0 ? 1 - lost / total : 0;
}

// Those with the most landmarks, the smallest of them as large as possible.
std::vector<VertexId> KnownViews::telling_views() const {
  const auto rank = [&](VertexId vertex) {
    const auto& all = landmarks(vertex);
    return std::pair(std::min(all.size(), kMostMapped), all.empty() ? 0.0 : all.back().area);
  };
  std::vector<VertexId> sorted = samples_;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](VertexId a, VertexId b) { return rank(a) > rank(b); });
  sorted.resize(std::min(sorted.size(), kTellingViews));
  std::erase_if(sorted, [&](VertexId vertex) { return landmarks(vertex).size() < 2; });
  return sorted;
}

void KnownViews::add_candidates(VertexId from, VertexId to,
                                std::vector<std::pair<double, Eigen::Quaterniond>>& found) const {
  if (landmarks(from).size() != landmarks(to).size()) return;
  const Eigen::Vector3d &a = view(from).direction, &b = view(to).direction;
  const auto add = [&](const std::vector<LandmarkPair>& pairs) {
    std::vector<LandmarkPair> all = pairs;
    all.push_back({radius_ * a, radius_ * b, 0.1});
    const Eigen::Quaterniond rotation = rotation_of(all);
    const double off = std::acos(std::clamp((rotation * a).dot(b), -1.0, 1.0));
    if (off > kMostDirection_rad) return;
    double residual = 0;
    for (const LandmarkPair& pair : pairs)
      residual = std::max(residual, (rotation * pair.from - pair.to).norm());
    if (residual <= kReach * radius_) found.emplace_back(residual / radius_ + off, rotation);
  };
  Mappings(landmarks(from), landmarks(to), kReach * radius_, add).extend();
}

std::vector<Eigen::Quaterniond> KnownViews::candidates() const {
  constexpr double kApart_rad = 8 * std::numbers::pi / 180;
  std::vector<std::pair<double, Eigen::Quaterniond>> found;
  for (const VertexId from : telling_views())
    for (std::size_t to = 0; to < landmarks_.size(); ++to)
      add_candidates(from, static_cast<VertexId>(to), found);
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Eigen::Quaterniond> tried{Eigen::Quaterniond::Identity()}, kept = tried;
  const auto is_near = [&](const std::vector<Eigen::Quaterniond>& all, const auto& rotation) {
    return std::any_of(all.begin(), all.end(), [&](const Eigen::Quaterniond& other) {
      return angle_between_rad(other, rotation) < kApart_rad;
    });
  };
  for (const auto& [cost, rotation] : found) {
    if (tried.size() > kMostCandidates) break;
    if (is_near(tried, rotation)) continue;
    tried.push_back(rotation);
    std::vector<LandmarkPair> pairs;
    if (likeness(rotation, kEnough, &pairs) <= 0) continue;
    const Eigen::Quaterniond better = rotation_of(pairs);
    if (!is_near(kept, better)) kept.push_back(better);
  }
  kept.erase(kept.begin());
  return kept;
}

}  // namespace aspect
