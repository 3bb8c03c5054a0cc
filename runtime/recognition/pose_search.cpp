#include "runtime/recognition/pose_search.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/recognition/alike_poses.h"

namespace aspect {
namespace {

constexpr std::size_t kMostStarted = 8;
constexpr int kRounds = 7;
// Of two that start, or end, so near to each other one is enough.
constexpr double kSameStart_rad = 0.2, kSamePose_rad = 0.05;
// A start that explains this much less than the best one is not refined: before a pose is found
// that leaves next to nothing unexplained, and after.
constexpr float kHopeful = 0.7F, kRival = 0.85F, kExplained = 0.06F;

// Of what the picture's border cuts off, centre and size say less.
constexpr int kCorrections = 2, kCutCorrections = 4;

bool is_cut(const Box& box, const Box& looked_at) {
  return box.x <= looked_at.x || box.y <= looked_at.y ||
         box.x + box.width >= looked_at.x + looked_at.width ||
         box.y + box.height >= looked_at.y + looked_at.height;
}

struct Start {
  Hypothesis* hypothesis = nullptr;
  RigidPose pose;
  float agreement = 0;
};

// Rims tell poses apart, and count half since blur does as well.
double score_of(const Agreement& agreement) {
  return (static_cast<double>(agreement.all) + static_cast<double>(agreement.all_but_rims)) / 2;
}

float least_unexplained(std::span<const VerifiedPose> poses) {
  float least = 1;
  for (const VerifiedPose& pose : poses) least = std::min(least, 1 - pose.agreement.all);
  return least;
}

// Where the camera is, seen from the object.
Vector3 view_of(const RigidPose& pose, const Vector3d& centre) {
  const Vector3d towards = inverse(pose.rotation)(-1 * pose(centre));
  const double length = norm(towards);
  return {static_cast<float>(towards[0] / length), static_cast<float>(towards[1] / length),
          static_cast<float>(towards[2] / length)};
}

// The class that is seen from there, or where the map knows none, the one seen from nearest to it:
// of 1000 random views of TRUCK, half of whose sphere is of no class, 91 % are named rightly so,
// 77 % by the nearest key view or by keeping the class that was matched.
std::size_t class_seen(const ClassIndex& index, const Vector3& view, std::size_t otherwise) {
  const Vector3d direction{static_cast<double>(view[0]), static_cast<double>(view[1]),
                           static_cast<double>(view[2])};
  std::int32_t seen = index.sphere_map.class_at(direction);
  if (seen == SphereMap::kNone) seen = index.sphere_map.nearest_class(direction);
  return seen == SphereMap::kNone ? otherwise : static_cast<std::size_t>(seen);
}

}  // namespace

void PoseSearch::prepare(Arena& arena, std::span<const ClassIndex> indexes) {
  indexes_ = indexes;
  finder_.prepare(arena, indexes);
}

VerifiedPose PoseSearch::verify(const Hypothesis& hypothesis, const RigidPose& pose,
                                const SeenBlob& blob, int rounds) {
  return finder_.verify(indexes_[hypothesis.index], pose, hypothesis.start.light,
                        blob.cameras[hypothesis.index], *blob.regions, *blob.colours,
                        static_cast<int>(blob.place), rounds);
}

// Refined, a pose may lie in the aspect beside the one that it started from. Who stood for that one
// stands for the other then.
void PoseSearch::name_class(Hypothesis& hypothesis, std::span<Hypothesis> list) const {
  const auto named = static_cast<std::uint16_t>(
      class_seen(indexes_[hypothesis.index], hypothesis.view, hypothesis.class_id));
  if (named == hypothesis.class_id) return;
  for (Hypothesis& other : list)
    if (other.index == hypothesis.index && other.class_id == named && other.pose == nullptr)
      other.class_id = hypothesis.class_id;
  hypothesis.class_id = named;
}

void PoseSearch::settle(Hypothesis& hypothesis, VerifiedPose& pose) const {
  const ClassIndex& index = indexes_[hypothesis.index];
  pose.refined.pose = canonical_pose(pose.refined.pose, index);
  name(hypothesis, pose);
}

void PoseSearch::name(Hypothesis& hypothesis, const VerifiedPose& pose) const {
  const ClassIndex& index = indexes_[hypothesis.index];
  hypothesis.view = view_of(pose.refined.pose, index.model.centre);
  hypothesis.class_id = static_cast<std::uint16_t>(class_seen(index, hypothesis.view, 0));
}

std::size_t PoseSearch::run(std::span<Hypothesis> list, const SeenBlob& blob,
                            std::span<VerifiedPose> poses) {
  std::array<Start, kMostStarted> starts;
  std::size_t count = 0;
  const Blob& seen = blob.regions->blobs[blob.place];
  const int corrections =
      is_cut(seen.box, blob.regions->looked_at) ? kCutCorrections : kCorrections;
  std::sort(list.begin(), list.end(), better);
  for (Hypothesis& hypothesis : list) {
    if (count == starts.size() || blob.deadline.is_over()) break;
    const ClassIndex& index = indexes_[hypothesis.index];
    if (index.model.empty() || !(hypothesis.score > 0)) continue;
    Start start{&hypothesis, finder_.start(index, hypothesis.start, blob.cameras[hypothesis.index],
                                           seen, blob.regions->looked_at, corrections)};
    const auto is_near = [&](const Start& other) {
      return other.hypothesis->index == hypothesis.index &&
             angle_between_rad(other.pose.rotation, start.pose.rotation) < kSameStart_rad;
    };
    const auto known = std::span(starts).first(count);
    if (std::any_of(known.begin(), known.end(), is_near)) continue;
    start.agreement = verify(hypothesis, start.pose, blob, 0).agreement.all;
    starts[count++] = start;
  }
  const std::size_t most = std::min({count, kMostPoses, poses.size()});
  std::partial_sort(starts.begin(), starts.begin() + static_cast<std::ptrdiff_t>(most),
                    starts.begin() + static_cast<std::ptrdiff_t>(count),
                    [](const Start& a, const Start& b) {
                      if (a.agreement != b.agreement) return a.agreement > b.agreement;
                      return better(*a.hypothesis, *b.hypothesis);
                    });

  std::size_t found = 0;
  double least = 1;
  for (const Start& start : std::span(starts).first(most)) {
    const bool explained = found > 0 && least_unexplained(poses.first(found)) < kExplained;
    if (start.agreement < (explained ? kRival : kHopeful) * starts[0].agreement ||
        blob.deadline.is_over())
      break;
    VerifiedPose& pose = poses[found];
    pose = verify(*start.hypothesis, start.pose, blob, kRounds);
    pose.refined.pose = canonical_pose(pose.refined.pose, indexes_[start.hypothesis->index]);
    const auto is_same = [&](const Hypothesis& other) {
      return other.pose != nullptr && other.index == start.hypothesis->index &&
             angle_between_rad(other.pose->refined.pose.rotation, pose.refined.pose.rotation) <
                 kSamePose_rad;
    };
    if (std::any_of(list.begin(), list.end(), is_same)) continue;
    ++found;
    start.hypothesis->pose = &pose;
    least = std::min(least, score_of(pose.agreement));
  }
  for (Hypothesis& hypothesis : list) {
    if (hypothesis.pose == nullptr) {
      hypothesis.score *= least;
      continue;
    }
    hypothesis.score = score_of(hypothesis.pose->agreement);
    hypothesis.view =
        view_of(hypothesis.pose->refined.pose, indexes_[hypothesis.index].model.centre);
    name_class(hypothesis, list);
  }
  return found;
}

}  // namespace aspect
