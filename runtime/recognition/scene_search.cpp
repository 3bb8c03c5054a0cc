#include "runtime/recognition/scene_search.h"

#include <algorithm>
#include <cmath>

#include "runtime/base/portable_math.h"

namespace aspect {
namespace {

constexpr int kStartCells = 20, kFinalCells = 40, kRoundCells = 64, kRounds = 7;
constexpr std::size_t kMostInPlace = 5;
// A drawing that shows less than this of what it should is not worth refining.
constexpr float kHopeful = 0.35F;
// A start of this margin that is worse when refined is refined once more.
constexpr float kPromising = -0.2F, kAlmostAll = 0.95F;

Box box_around(const PictureDisc& place) {
  const int side = static_cast<int>(2 * place.radius_px) + 8;
  return {static_cast<int>(place.x) - side / 2, static_cast<int>(place.y) - side / 2, side, side};
}

}  // namespace

void SceneSearch::prepare(Arena& arena, std::span<const ClassIndex> indexes, bool in_time) {
  indexes_ = indexes;
  finder_.prepare(arena, indexes);
  starts_.prepare(arena, indexes);
  std::size_t vertices = 0;
  for (const ClassIndex& index : indexes)
    vertices = std::max(vertices, index.model.vertices.size());
  scratch_.drawing.prepare(arena, vertices);
  if (!in_time) return;
  waiting_ = arena.take<Waiting>(SceneStarts::kMostStarts * indexes.size());
  waiting_order_ = arena.take<std::uint32_t>(SceneStarts::kMostStarts * indexes.size());
  early_ = arena.take<SceneObject>(kMostObjects);
}

// Among the best of all indexes.
void SceneSearch::keep(const Drawn& drawn) {
  if (drawn_count_ < kMostDrawn) {
    drawn_[drawn_count_++] = drawn;
    return;
  }
  Drawn& worst =
      *std::min_element(drawn_.begin(), drawn_.end(),
                        [](const Drawn& a, const Drawn& b) { return a.margin < b.margin; });
  if (drawn.margin > worst.margin) worst = drawn;
}

// The pose that a start says.
SceneSearch::Drawn SceneSearch::laid(const SeenScene& scene, std::size_t index_place,
                                     const SceneStart& start, int corrections) {
  const ClassIndex& index = indexes_[index_place];
  const KeyView& view = index.key_views[start.key_view];
  Blob blob;
  blob.centre_px = start.centre_px;
  blob.area_px = start.scale_px * start.scale_px;
  const int side = static_cast<int>(2 * start.scale_px);
  blob.box = {static_cast<int>(start.centre_px.x) - side / 2,
              static_cast<int>(start.centre_px.y) - side / 2, side, side};
  Drawn drawn;
  drawn.roll_rad = static_cast<float>(
      portable_atan2(static_cast<double>(start.sin), static_cast<double>(start.cos)));
  drawn.index = static_cast<std::uint16_t>(index_place);
  drawn.key_view = start.key_view;
  drawn.pose =
      finder_.start(index, {view.direction, view.direction, drawn.roll_rad, {}},
                    scene.cameras[index_place], blob, PoseFinder::kEverything, corrections);
  return drawn;
}

// False: it is not worth refining.
bool SceneSearch::draw(const SeenScene& scene, Drawn& drawn) {
  const CameraModel& camera = scene.cameras[drawn.index];
  if (!scratch_.drawing.draw_alone(indexes_[drawn.index].model, drawn.pose, camera, scene.width_px,
                                   scene.height_px, kStartCells))
    return false;
  const SceneAgreement agreement = scene_agreement(scratch_.drawing, camera, seen_colours_,
                                                   scene.width_px, scene.height_px, 1, of_others_);
  drawn.margin = agreement.margin;
  return agreement.score >= kHopeful;
}

void SceneSearch::look_for(const SeenScene& scene, std::size_t index_place) {
  seen_colours_.look(*scene.regions, *scene.colours, SeenColours::kAllBlobs,
                     indexes_[index_place].model, {});
}

void SceneSearch::draw_starts(const SeenScene& scene, std::size_t index_place) {
  look_for(scene, index_place);
  for (const SceneStart& start : starts_.run(scene, index_place)) {
    if (start.explained < kWorth) continue;
    Drawn drawn = laid(scene, index_place, start, kCorrections);
    if (draw(scene, drawn)) keep(drawn);
  }
}

PictureDisc SceneSearch::place_of(const SeenScene& scene, const SceneObject& object) const {
  return disc_of(indexes_[object.index].model, object.refined.pose, scene.cameras[object.index]);
}

PictureDisc SceneSearch::place_of(const SeenScene& scene, const Drawn& drawn) const {
  return disc_of(indexes_[drawn.index].model, drawn.pose, scene.cameras[drawn.index]);
}

// By an object that is there beyond doubt, or by several that were tried.
bool SceneSearch::is_taken(const SeenScene& scene, const Drawn& drawn) const {
  const PictureDisc place = place_of(scene, drawn);
  std::size_t tried = 0;
  for (const SceneObject& other : std::span<const SceneObject>(found_).first(found_count_)) {
    if (!share_place(place, place_of(scene, other))) continue;
    if (other.agreement.margin >= kSureMargin || ++tried >= kMostInPlace) return true;
  }
  return false;
}

void SceneSearch::refine(const SeenScene& scene, const Drawn& drawn) {
  const ClassIndex& index = indexes_[drawn.index];
  const CameraModel& camera = scene.cameras[drawn.index];
  look_for(scene, drawn.index);
  const PictureDisc place = place_of(scene, drawn);
  const auto radius_px = static_cast<float>(place.radius_px);
  constexpr float kLeastReach_px = 5;
  // Where the object shows many borders side by side, the nearer ones are the right ones.
  constexpr std::array<float, 2> kReach{0.2F, 0.06F};
  SceneObject& best = found_[found_count_];
  bool is_drawn = false;
  for (const float reach : kReach) {
    SceneObject object;
    object.index = drawn.index;
    object.key_view = drawn.key_view;
    object.roll_rad = drawn.roll_rad;
    const RigidPose& from = is_drawn && best.agreement.margin >= 0 ? best.refined.pose : drawn.pose;
    object.refined = refine_pose(index.model, camera, seen_colours_, box_around(place), from,
                                 kRounds, std::max(kLeastReach_px, reach * radius_px), scratch_,
                                 Behind::anything, {kRoundCells});
    if (!compare(scene, object)) continue;
    if (!is_drawn || object.agreement.margin > best.agreement.margin) best = object;
    is_drawn = true;
    const bool is_there = best.agreement.margin >= 0;
    if (is_there ? best.refined.borders_met > kAlmostAll : drawn.margin < kPromising) break;
  }
  if (is_drawn) ++found_count_;
}

// Where it was refined to, with the colours that were looked for; false: nothing of it is drawn.
bool SceneSearch::compare(const SeenScene& scene, SceneObject& object) {
  const CameraModel& camera = scene.cameras[object.index];
  if (!scratch_.drawing.draw_alone(indexes_[object.index].model, object.refined.pose, camera,
                                   scene.width_px, scene.height_px, kFinalCells))
    return false;
  object.agreement = scene_agreement(scratch_.drawing, camera, seen_colours_, scene.width_px,
                                     scene.height_px, object.refined.borders_met, of_others_);
  return true;
}

// Without what stronger objects have explained; false where too little is left.
bool SceneSearch::score_again(const SeenScene& scene, SceneObject& object) {
  if (of_others_.none()) return true;
  look_for(scene, object.index);
  return compare(scene, object) && object.agreement.margin >= 0;
}

std::span<const SceneObject> SceneSearch::run(const SeenScene& scene) {
  drawn_count_ = found_count_ = 0;
  of_others_.reset();
  left_undone_ = {};
  if (scene.deadline.is_set()) {
    draw_in_time(scene);
  } else {
    starts_.see(scene);
    for (std::size_t i = 0; i < indexes_.size(); ++i)
      if (!indexes_[i].model.empty() && scene.wants(i)) draw_starts(scene, i);
  }
  const auto drawn = std::span(drawn_).first(drawn_count_);
  std::sort(drawn.begin(), drawn.end(), [](const Drawn& a, const Drawn& b) {
    if (a.margin != b.margin) return a.margin > b.margin;
    if (a.index != b.index) return a.index < b.index;
    return a.key_view < b.key_view;
  });
  for (Drawn& d : drawn) {
    if (found_count_ == kMostObjects) break;
    if (!is_taken(scene, d)) refine_in_time(scene, d);
  }
  if (left_undone_.any()) drop_unsettled(scene);
  const auto found = std::span(found_).first(found_count_);
  std::sort(found.begin(), found.end(), [](const SceneObject& a, const SceneObject& b) {
    if (a.agreement.margin != b.agreement.margin) return a.agreement.margin > b.agreement.margin;
    if (a.index != b.index) return a.index < b.index;
    return a.key_view < b.key_view;
  });
  std::size_t kept = 0;
  for (const SceneObject& object : found) {
    const PictureDisc place = place_of(scene, object);
    const auto is_there = [&](const SceneObject& other) {
      return share_place(place, place_of(scene, other),
                         other.index == object.index ? kSameObjectShare : kPlaceShare);
    };
    if (std::any_of(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(kept), is_there))
      continue;
    SceneObject& next = found_[kept];
    next = object;
    // Regions are explained once.
    if (next.agreement.margin < 0 || !score_again(scene, next)) continue;
    of_others_ |= next.agreement.explained;
    ++kept;
  }
  return found.first(kept);
}

}  // namespace aspect
