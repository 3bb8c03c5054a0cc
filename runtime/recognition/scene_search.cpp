#include "runtime/recognition/scene_search.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "runtime/base/portable_math.h"

namespace aspect {
namespace {

// Regions that take part.
constexpr float kLeastArea_px = 60, kMostAreaShare = 0.3F;
// Shares farther from a colour of the model than this are not it.
constexpr float kFarthestShare = 0.1F;
// Two regions are neighbours where their centres are no farther apart than this, in square roots of
// the sum of their areas.
constexpr float kFarthest = 3;
// Factor between sizes that a step between key views and a rough outline make.
constexpr float kSizeReach = 1.57F;
// A region alone: its axis must be clear, and its moments the key contour's.
constexpr std::size_t kMostAlone = 12;
constexpr float kLeastAlone = 0.6F, kLeastLength = 0.15F, kSpreadReach = 0.08F, kLeastCos = 1e-3F,
                kThirdReach = 0.008F;
// Two starts are one where they differ by less.
constexpr float kSamePlace = 0.2F, kSameTurn_cos = 0.96F, kSameView_cos = 0.97F;
// Of the picture, so large that it says something.
constexpr float kEnoughArea_px = 1500;
constexpr int kStartCells = 20, kFinalCells = 40, kRounds = 7, kCorrections = 2;
constexpr std::size_t kMostInPlace = 3;
constexpr float kSureMargin = 0.27F;
// A start that explains less of its key view is not drawn.
constexpr float kWorth = 0.25F;
// A drawing that shows less than this of what it should is not worth refining.
constexpr float kHopeful = 0.35F;
constexpr float kPlaceShare = 0.4F;

std::uint64_t colours_near(const ObjectModel& model, const std::array<float, 3>& rgb) {
  const float sum = std::max(1.0F, rgb[0] + rgb[1] + rgb[2]);
  const std::array<float, 3> share{rgb[0] / sum, rgb[1] / sum, rgb[2] / sum};
  std::uint64_t near = 0;
  for (std::size_t k = 0; k < std::min<std::size_t>(model.shares.size(), 64); ++k)
    if (squared_distance(share, model.shares[k]) < kFarthestShare * kFarthestShare)
      near |= std::uint64_t{1} << k;
  return near;
}

bool is_of(std::uint64_t colours, ColourClass colour) {
  return colour != kBackgroundClass && (colours >> (colour - 1U) & 1U) != 0;
}

bool shows(const Planes& colours, int x, int y, const std::array<float, 3>& share) {
  constexpr float kLeastSum = 40;
  const std::size_t place = colours.place(x, y);
  const auto red = static_cast<float>(colours.red[place]),
             green = static_cast<float>(colours.green[place]),
             blue = static_cast<float>(colours.blue[place]);
  const float sum = red + green + blue;
  return sum >= kLeastSum && squared_distance({red / sum, green / sum, blue / sum}, share) <
                                 kFarthestShare * kFarthestShare;
}

bool is_near(float size, float other) {
  return size < kSizeReach * other && other < kSizeReach * size;
}

// Where the object's middle is in the picture, and how far it reaches from there.
struct Place {
  float x = 0, y = 0, radius_px = 0;
};

Place place_of(const ObjectModel& model, const RigidPose& pose, const CameraModel& camera) {
  const Vector3d centre = pose(model.centre);
  const double near = 1 / std::max(centre[2], 1e-9);
  return {static_cast<float>(camera.cx_px + camera.fx_px * centre[0] * near),
          static_cast<float>(camera.cy_px + camera.fy_px * centre[1] * near),
          static_cast<float>(model.radius * camera.fx_px * near)};
}

bool share_place(const Place& a, const Place& b) {
  const float dx = a.x - b.x, dy = a.y - b.y;
  const float reach = kPlaceShare * std::max(a.radius_px, b.radius_px);
  return dx * dx + dy * dy < reach * reach;
}

Box box_around(const Place& place) {
  const int side = static_cast<int>(2 * place.radius_px) + 8;
  return {static_cast<int>(place.x) - side / 2, static_cast<int>(place.y) - side / 2, side, side};
}

}  // namespace

void SceneSearch::prepare(Arena& arena, std::span<const ClassIndex> indexes) {
  indexes_ = indexes;
  finder_.prepare(arena, indexes);
  pairs_ = arena.take<RegionPairs>(indexes.size());
  std::size_t vertices = 0;
  for (std::size_t i = 0; i < indexes.size(); ++i) {
    vertices = std::max(vertices, indexes[i].model.vertices.size());
    if (!pairs_.empty())
      pairs_[i].prepare(arena, indexes[i]);
    else
      RegionPairs().prepare(arena, indexes[i]);
  }
  scratch_.drawing.prepare(arena, vertices);
}

void SceneSearch::see_regions(const SeenScene& scene, const ClassIndex& index) {
  const auto regions = scene.regions->regions;
  const float most_px =
      kMostAreaShare * static_cast<float>(scene.width_px) * static_cast<float>(scene.height_px);
  const auto is_smaller = [](const SeenRegion& a, const SeenRegion& b) {
    return a.area_px < b.area_px;
  };
  region_count_ = 0;
  colours_of_label_[0] = 0;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const Region& region = regions[r];
    std::uint64_t& colours = colours_of_label_[r + 1];
    const auto blob = static_cast<std::size_t>(region.blob);
    colours = blob < scene.taken.size() && scene.taken[blob]
                  ? 0
                  : colours_near(index.model, region.mean_rgb);
    const auto area = static_cast<float>(region.sums.area);
    if (colours == 0 || area < kLeastArea_px || area > most_px) continue;
    const bool is_full = region_count_ == kMostRegions;
    SeenRegion& place =
        is_full ? *std::min_element(seen_regions_.begin(), seen_regions_.end(), is_smaller)
                : seen_regions_[region_count_++];
    if (is_full && area <= place.area_px) continue;
    place = {{static_cast<float>(region.box.x + region.sums.x / region.sums.area),
              static_cast<float>(region.box.y + region.sums.y / region.sums.area)},
             area,
             moments_of(region.sums),
             colours};
  }
}

// The share of the key view's area whose contours find their colour where they should be.
float SceneSearch::explained(const SeenScene& scene, std::size_t index_place,
                             const Start& start) const {
  const ClassIndex& index = indexes_[index_place];
  const IndexRange range = index.key_views[start.key_view].contours;
  float seen = 0, all = 0;
  for (std::uint32_t k = 0; k < range.count; ++k) {
    const ContourFeature& contour = index.key_contours[range.first + k].feature;
    all += contour.area;
    const Point2 p = start.laid(contour.position);
    const int x = static_cast<int>(start.centre_px.x + p.x + 0.5F),
              y = static_cast<int>(start.centre_px.y + p.y + 0.5F);
    const Box& active = scene.regions->active;
    if (x < active.x || y < active.y || x >= active.x + active.width ||
        y >= active.y + active.height)
      continue;
    const std::uint16_t label =
        scene.regions->labels[static_cast<std::size_t>(y * scene.regions->stride_px + x)];
    const ColourClass colour = pairs_[index_place].colour_of(range.first + k);
    // A region may hold a surface and what stands behind it.
    if (is_of(colours_of_label_[label], colour) ||
        (colour != kBackgroundClass &&
         shows(*scene.colours, x, y, index.model.shares[colour - 1U])))
      seen += contour.area;
  }
  return seen / all * std::min(1.0F, all * start.scale_px * start.scale_px / kEnoughArea_px);
}

// Among the best, each once.
void SceneSearch::keep(const ClassIndex& index, const Start& start, Starts& starts) {
  std::size_t worst = 0;
  for (std::size_t k = 0; k < starts.count; ++k) {
    Start& other = starts.list[k];
    const float dx = other.centre_px.x - start.centre_px.x,
                dy = other.centre_px.y - start.centre_px.y;
    const float reach = kSamePlace * start.scale_px;
    if (dx * dx + dy * dy < reach * reach &&
        other.cos * start.cos + other.sin * start.sin > kSameTurn_cos) {
      const Vector3 &a = index.key_views[other.key_view].direction,
                    &b = index.key_views[start.key_view].direction;
      if (a[0] * b[0] + a[1] * b[1] + a[2] * b[2] > kSameView_cos) {
        if (start.score > other.score) other = start;
        return;
      }
    }
    if (other.score < starts.list[worst].score) worst = k;
  }
  if (starts.count < starts.most)
    starts.list[starts.count++] = start;
  else if (start.score > starts.list[worst].score)
    starts.list[worst] = start;
}

void SceneSearch::try_pair(const SeenScene& scene, std::size_t index_place, const SeenRegion& first,
                           const SeenRegion& second, ColourClass first_colour,
                           ColourClass second_colour) {
  const ClassIndex& index = indexes_[index_place];
  const float dx = second.centre_px.x - first.centre_px.x,
              dy = second.centre_px.y - first.centre_px.y;
  const float squared = dx * dx + dy * dy;
  const float first_size = first.area_px / squared, second_size = second.area_px / squared;
  for (const RegionPair& pair : pairs_[index_place].of(first_colour, second_colour)) {
    if (!is_near(pair.first_size, first_size) || !is_near(pair.second_size, second_size)) continue;
    const IndexRange range = index.key_views[pair.key_view].contours;
    const ContourFeature &a = index.key_contours[range.first + pair.first].feature,
                         &b = index.key_contours[range.first + pair.second].feature;
    const float kx = b.position.x - a.position.x, ky = b.position.y - a.position.y;
    const float key_squared = kx * kx + ky * ky;
    Start start;
    start.key_view = pair.key_view;
    start.scale_px = std::sqrt(squared / key_squared);
    const float length = std::sqrt(squared * key_squared);
    start.cos = (dx * kx + dy * ky) / length;
    start.sin = (dy * kx - dx * ky) / length;
    const Point2 p = start.laid(a.position);
    start.centre_px = {first.centre_px.x - p.x, first.centre_px.y - p.y};
    start.score = explained(scene, index_place, start);
    keep(index, start, of_pairs_);
  }
}

// One region alone says where the object is by its area, its middle and its main axis; which way
// round, by its third moments.
void SceneSearch::try_alone(const SeenScene& scene, std::size_t index_place,
                            const SeenRegion& region, ColourClass colour) {
  const ClassIndex& index = indexes_[index_place];
  const Moments& m = region.moments;
  const float spread = m.xx + m.yy, along = m.xx - m.yy, across = 2 * m.xy;
  const float length = std::sqrt(along * along + across * across);
  if (length < kLeastLength * spread) return;
  for (const KeyRegion& key : pairs_[index_place].of(colour)) {
    const ContourFeature& feature = index.key_contours[key.contour].feature;
    const Moments& k = feature.moments;
    const float key_spread = k.xx + k.yy, key_along = k.xx - k.yy, key_across = 2 * k.xy;
    if (std::abs(key_spread - spread) > kSpreadReach * spread) continue;
    const float key_length = std::sqrt(key_along * key_along + key_across * key_across);
    if (std::abs(key_length - length) > kSpreadReach * spread || key_length <= 0) continue;
    // Of twice the turn, then of the turn.
    const float double_cos = (along * key_along + across * key_across) / (length * key_length),
                double_sin = (across * key_along - along * key_across) / (length * key_length);
    const float cos = std::sqrt(std::max(0.0F, (1 + double_cos) / 2));
    const float sin = cos > kLeastCos ? double_sin / (2 * cos) : 1;
    for (const float way : {1.0F, -1.0F}) {
      Start start;
      start.key_view = key.key_view;
      start.cos = way * cos;
      start.sin = way * sin;
      const Moments turned_key = turned(k, start.cos, start.sin);
      const float xxx = turned_key.xxx - m.xxx, xxy = turned_key.xxy - m.xxy,
                  xyy = turned_key.xyy - m.xyy, yyy = turned_key.yyy - m.yyy;
      if (xxx * xxx + 3 * xxy * xxy + 3 * xyy * xyy + yyy * yyy > kThirdReach * kThirdReach)
        continue;
      start.scale_px = std::sqrt(region.area_px / feature.area);
      const Point2 p = start.laid(feature.position);
      start.centre_px = {region.centre_px.x - p.x, region.centre_px.y - p.y};
      start.score = explained(scene, index_place, start);
      if (start.score >= kLeastAlone) keep(index, start, of_regions_);
    }
  }
}

void SceneSearch::pair_up(const SeenScene& scene, std::size_t index_place) {
  of_pairs_.count = of_regions_.count = 0;
  of_regions_.most = kMostAlone;
  const auto regions = std::span<const SeenRegion>(seen_regions_).first(region_count_);
  for (const SeenRegion& region : regions)
    for (std::uint64_t c = region.colours; c != 0; c &= c - 1)
      try_alone(scene, index_place, region, static_cast<ColourClass>(std::countr_zero(c) + 1));
  for (std::size_t i = 0; i < regions.size(); ++i)
    for (std::size_t j = 0; j < regions.size(); ++j) {
      const SeenRegion &first = regions[i], &second = regions[j];
      const float dx = second.centre_px.x - first.centre_px.x,
                  dy = second.centre_px.y - first.centre_px.y;
      const float squared = dx * dx + dy * dy;
      if (i == j || squared > kFarthest * kFarthest * (first.area_px + second.area_px) ||
          squared < 4)
        continue;
      for (std::uint64_t a = first.colours; a != 0; a &= a - 1)
        for (std::uint64_t b = second.colours; b != 0; b &= b - 1) {
          const auto of_first = static_cast<ColourClass>(std::countr_zero(a) + 1),
                     of_second = static_cast<ColourClass>(std::countr_zero(b) + 1);
          if (of_first <= of_second)
            try_pair(scene, index_place, first, second, of_first, of_second);
        }
    }
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

void SceneSearch::draw_starts(const SeenScene& scene, std::size_t index_place) {
  const ClassIndex& index = indexes_[index_place];
  const CameraModel& camera = scene.cameras[index_place];
  seen_colours_.look(*scene.regions, *scene.colours, SeenColours::kAllBlobs, index.model, {});
  const auto draw = [&](const Start& start) {
    if (start.score < kWorth) return;
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
    drawn.pose = finder_.start(index, {view.direction, view.direction, drawn.roll_rad, {}}, camera,
                               blob, kCorrections);
    if (!scratch_.drawing.draw_alone(index.model, drawn.pose, camera, scene.width_px,
                                     scene.height_px, kStartCells))
      return;
    const SceneAgreement agreement =
        scene_agreement(scratch_.drawing, camera, seen_colours_, scene.width_px, scene.height_px);
    drawn.margin = agreement.margin;
    if (agreement.score >= kHopeful) keep(drawn);
  };
  for (const Start& start : of_pairs_.all()) draw(start);
  for (const Start& start : of_regions_.all()) draw(start);
}

// By an object that is there beyond doubt, or by several that were tried.
bool SceneSearch::is_taken(const SeenScene& scene, const Drawn& drawn) const {
  const Place place = place_of(indexes_[drawn.index].model, drawn.pose, scene.cameras[drawn.index]);
  std::size_t tried = 0;
  for (const SceneObject& other : std::span<const SceneObject>(found_).first(found_count_)) {
    if (!share_place(place, place_of(indexes_[other.index].model, other.refined.pose,
                                     scene.cameras[other.index])))
      continue;
    if (other.agreement.margin >= kSureMargin || ++tried >= kMostInPlace) return true;
  }
  return false;
}

void SceneSearch::refine(const SeenScene& scene, const Drawn& drawn) {
  const ClassIndex& index = indexes_[drawn.index];
  const CameraModel& camera = scene.cameras[drawn.index];
  seen_colours_.look(*scene.regions, *scene.colours, SeenColours::kAllBlobs, index.model, {});
  const Place place = place_of(index.model, drawn.pose, camera);
  constexpr float kLeastReach_px = 5, kReach = 0.2F;
  SceneObject& object = found_[found_count_];
  object = {};
  object.index = drawn.index;
  object.key_view = drawn.key_view;
  object.refined =
      refine_pose(index.model, camera, seen_colours_, box_around(place), drawn.pose, kRounds,
                  std::max(kLeastReach_px, kReach * place.radius_px), scratch_, Behind::anything);
  if (!scratch_.drawing.draw_alone(index.model, object.refined.pose, camera, scene.width_px,
                                   scene.height_px, kFinalCells))
    return;
  object.agreement =
      scene_agreement(scratch_.drawing, camera, seen_colours_, scene.width_px, scene.height_px);
  object.roll_rad = drawn.roll_rad;
  ++found_count_;
}

std::span<const SceneObject> SceneSearch::run(const SeenScene& scene) {
  drawn_count_ = found_count_ = 0;
  for (std::size_t i = 0; i < indexes_.size(); ++i) {
    if (indexes_[i].model.empty()) continue;
    see_regions(scene, indexes_[i]);
    pair_up(scene, i);
    draw_starts(scene, i);
  }
  const auto drawn = std::span(drawn_).first(drawn_count_);
  std::sort(drawn.begin(), drawn.end(), [](const Drawn& a, const Drawn& b) {
    if (a.margin != b.margin) return a.margin > b.margin;
    if (a.index != b.index) return a.index < b.index;
    return a.key_view < b.key_view;
  });
  for (const Drawn& d : drawn) {
    if (found_count_ == kMostObjects) break;
    if (!is_taken(scene, d)) refine(scene, d);
  }
  const auto found = std::span(found_).first(found_count_);
  std::sort(found.begin(), found.end(), [](const SceneObject& a, const SceneObject& b) {
    if (a.agreement.margin != b.agreement.margin) return a.agreement.margin > b.agreement.margin;
    if (a.index != b.index) return a.index < b.index;
    return a.key_view < b.key_view;
  });
  std::size_t kept = 0;
  for (const SceneObject& object : found) {
    const Place place =
        place_of(indexes_[object.index].model, object.refined.pose, scene.cameras[object.index]);
    const auto is_there = [&](const SceneObject& other) {
      return share_place(place, place_of(indexes_[other.index].model, other.refined.pose,
                                         scene.cameras[other.index]));
    };
    if (std::none_of(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(kept), is_there))
      found_[kept++] = object;
  }
  return found.first(kept);
}

}  // namespace aspect
