#include "runtime/recognition/scene_starts.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "runtime/recognition/seen_colours.h"

namespace aspect {
namespace {

// Regions that take part.
constexpr float kMostAreaShare = 0.3F;
// Two regions are neighbours where their centres are no farther apart than this, in square roots of
// the sum of their areas.
constexpr float kFarthest = 3;
// Factor between sizes that a step between key views and a rough outline make.
constexpr float kSizeReach = 1.57F;
// A region alone: its axis must be clear, and its moments the key contour's.
constexpr float kLeastAlone = 0.6F, kLeastLength = 0.15F, kSpreadReach = 0.08F, kLeastCos = 1e-3F,
                kThirdReach = 0.008F;
// The more contours a view has, the more pairs of them look alike.
constexpr std::size_t kStartsPerContour = 4, kLeastOfPairs = 32;
// Two starts are one where they differ by less.
constexpr float kSamePlace = 0.2F, kSameTurn_cos = 0.96F, kSameView_cos = 0.97F;
// Of the picture, so large that it says something.
constexpr float kEnoughArea_px = 1500;

std::uint64_t colours_near(const ObjectModel& model, const std::array<float, 3>& rgb) {
  const float sum = std::max(1.0F, rgb[0] + rgb[1] + rgb[2]);
  const std::array<float, 3> share{rgb[0] / sum, rgb[1] / sum, rgb[2] / sum};
  std::uint64_t near = 0;
  for (std::size_t k = 0; k < std::min<std::size_t>(model.shares.size(), 64); ++k)
    if (squared_distance(share, model.shares[k]) < kColourReach * kColourReach)
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
                                 kColourReach * kColourReach;
}

bool is_near(float size, float other) {
  return size < kSizeReach * other && other < kSizeReach * size;
}

}  // namespace

void SceneStarts::prepare(Arena& arena, std::span<const ClassIndex> indexes) {
  indexes_ = indexes;
  pairs_ = arena.take<RegionPairs>(indexes.size());
  for (std::size_t i = 0; i < indexes.size(); ++i) {
    if (!pairs_.empty())
      pairs_[i].prepare(arena, indexes[i]);
    else
      RegionPairs().prepare(arena, indexes[i]);
  }
}

void SceneStarts::see(const SeenScene& scene) {
  parts_.find(*scene.regions, *scene.colours, scene.contours);
}

void SceneStarts::see_regions(const SeenScene& scene, const ClassIndex& index) {
  const auto regions = scene.regions->regions;
  const float most_px =
      kMostAreaShare * static_cast<float>(scene.width_px) * static_cast<float>(scene.height_px);
  const auto is_smaller = [](const SeenRegion& a, const SeenRegion& b) {
    return a.area_px < b.area_px;
  };
  region_count_ = 0;
  colours_of_label_[0] = 0;
  // Blobs that are taken have no colours.
  const auto colours_of = [&](std::size_t region, const std::array<float, 3>& rgb) {
    const auto blob = static_cast<std::size_t>(regions[region].blob);
    const bool is_taken = blob < scene.taken.size() && scene.taken[blob];
    return is_taken ? 0 : colours_near(index.model, rgb);
  };
  for (std::size_t r = 0; r < regions.size(); ++r)
    colours_of_label_[r + 1] = colours_of(r, regions[r].mean_rgb);
  for (const RegionPart& part : parts_.all()) {
    const std::uint64_t colours =
        part.is_region ? colours_of_label_[part.label] : colours_of(part.label - 1U, part.mean_rgb);
    if (colours == 0 || part.area_px > most_px) continue;
    // Regions come before what is cut of them or joined: the largest of them are kept.
    const bool is_full = region_count_ == kMostRegions;
    if (is_full && !part.is_region) break;
    SeenRegion& place =
        is_full ? *std::min_element(seen_regions_.begin(), seen_regions_.end(), is_smaller)
                : seen_regions_[region_count_++];
    if (is_full && part.area_px <= place.area_px) continue;
    place = {part, colours};
  }
}

// By the share of the key view's area whose contours find their colour where they should be.
void SceneStarts::explain(const SeenScene& scene, std::size_t index_place,
                          SceneStart& start) const {
  const ClassIndex& index = indexes_[index_place];
  const IndexRange range = index.key_views[start.key_view].contours;
  float seen = 0, all = 0, count = 0;
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
      seen += contour.area, ++count;
  }
  start.explained =
      seen / all * std::min(1.0F, all * start.scale_px * start.scale_px / kEnoughArea_px);
  start.score = start.explained * count / (count + 1);
}

// Among the best, each once.
void SceneStarts::keep(const ClassIndex& index, const SceneStart& start, List& list) {
  std::size_t worst = 0;
  for (std::size_t k = 0; k < list.count; ++k) {
    SceneStart& other = list.starts[k];
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
    if (other.score < list.starts[worst].score) worst = k;
  }
  if (list.count < list.most)
    list.starts[list.count++] = start;
  else if (start.score > list.starts[worst].score)
    list.starts[worst] = start;
}

void SceneStarts::try_pair(const SeenScene& scene, std::size_t index_place, const SeenRegion& first,
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
    SceneStart start;
    start.key_view = pair.key_view;
    start.scale_px = std::sqrt(squared / key_squared);
    const float length = std::sqrt(squared * key_squared);
    start.cos = (dx * kx + dy * ky) / length;
    start.sin = (dy * kx - dx * ky) / length;
    const Point2 p = start.laid(a.position);
    start.centre_px = {first.centre_px.x - p.x, first.centre_px.y - p.y};
    explain(scene, index_place, start);
    keep(index, start, of_pairs_);
  }
}

// One region alone says where the object is by its area, its middle and its main axis; which way
// round, by its third moments.
void SceneStarts::try_alone(const SeenScene& scene, std::size_t index_place,
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
      SceneStart start;
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
      explain(scene, index_place, start);
      if (start.explained >= kLeastAlone) keep(index, start, of_regions_);
    }
  }
}

void SceneStarts::pair_up(const SeenScene& scene, std::size_t index_place) {
  of_pairs_.count = of_regions_.count = 0;
  of_regions_.most = kMostAlone;
  of_pairs_.most = std::clamp(kStartsPerContour * indexes_[index_place].key_contours.size() /
                                  std::max<std::size_t>(1, indexes_[index_place].key_views.size()),
                              kLeastOfPairs, kMostOfPairs);
  const auto regions = std::span<const SeenRegion>(seen_regions_).first(region_count_);
  for (const SeenRegion& region : regions) {
    if (scene.deadline.is_over()) return;
    for (std::uint64_t c = region.colours; c != 0; c &= c - 1)
      try_alone(scene, index_place, region, static_cast<ColourClass>(std::countr_zero(c) + 1));
  }
  for (std::size_t i = 0; i < regions.size() && !scene.deadline.is_over(); ++i)
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

std::span<const SceneStart> SceneStarts::run(const SeenScene& scene, std::size_t index_place) {
  see_regions(scene, indexes_[index_place]);
  pair_up(scene, index_place);
  List& all = of_pairs_;
  for (std::size_t k = 0; k < of_regions_.count; ++k)
    all.starts[all.count++] = of_regions_.starts[k];
  return std::span(all.starts).first(all.count);
}

}  // namespace aspect
