#include "runtime/recognition/region_parts.h"

#include <algorithm>
#include <cmath>

#include "runtime/recognition/seen_colours.h"
#include "runtime/vision/contour_trace.h"

namespace aspect {
namespace {

constexpr float kLeastArea_px = 60;

struct Place {
  double x = 0, y = 0;
};

// Integrals over a polygon, edge by edge; of a closed one those of its inside (Green's theorem).
void add_edge(PixelSums& sums, const Place& a, const Place& b) {
  const double c = a.x * b.y - b.x * a.y;
  sums.area += c / 2;
  sums.x += c * (a.x + b.x) / 6;
  sums.y += c * (a.y + b.y) / 6;
  sums.xx += c * (a.x * a.x + a.x * b.x + b.x * b.x) / 12;
  sums.xy += c * (2 * a.x * a.y + a.x * b.y + b.x * a.y + 2 * b.x * b.y) / 24;
  sums.yy += c * (a.y * a.y + a.y * b.y + b.y * b.y) / 12;
  sums.xxx += c * (a.x * a.x + b.x * b.x) * (a.x + b.x) / 20;
  sums.yyy += c * (a.y * a.y + b.y * b.y) * (a.y + b.y) / 20;
  sums.xxy += c *
              (a.y * (3 * a.x * a.x + 2 * a.x * b.x + b.x * b.x) +
               b.y * (a.x * a.x + 2 * a.x * b.x + 3 * b.x * b.x)) /
              60;
  sums.xyy += c *
              (a.x * (3 * a.y * a.y + 2 * a.y * b.y + b.y * b.y) +
               b.x * (a.y * a.y + 2 * a.y * b.y + 3 * b.y * b.y)) /
              60;
}

void add(PixelSums& sums, const PixelSums& other, double sign) {
  sums.area += sign * other.area;
  sums.x += sign * other.x;
  sums.y += sign * other.y;
  sums.xx += sign * other.xx;
  sums.xy += sign * other.xy;
  sums.yy += sign * other.yy;
  sums.xxx += sign * other.xxx;
  sums.xxy += sign * other.xxy;
  sums.xyy += sign * other.xyy;
  sums.yyy += sign * other.yyy;
}

// The same pixels, about a corner that lies `dx`, `dy` to the upper left.
PixelSums shifted(const PixelSums& s, double dx, double dy) {
  PixelSums t = s;
  t.x += dx * s.area;
  t.y += dy * s.area;
  t.xx += 2 * dx * s.x + dx * dx * s.area;
  t.yy += 2 * dy * s.y + dy * dy * s.area;
  t.xy += dx * s.y + dy * s.x + dx * dy * s.area;
  t.xxx += 3 * dx * s.xx + 3 * dx * dx * s.x + dx * dx * dx * s.area;
  t.yyy += 3 * dy * s.yy + 3 * dy * dy * s.y + dy * dy * dy * s.area;
  t.xxy += dy * s.xx + 2 * dx * s.xy + 2 * dx * dy * s.x + dx * dx * s.y + dx * dx * dy * s.area;
  t.xyy += dx * s.yy + 2 * dy * s.xy + 2 * dx * dy * s.y + dy * dy * s.x + dx * dy * dy * s.area;
  return t;
}

// A place where the border of a region turns inwards.
struct Concave {
  std::size_t at = 0;  // steps along the chain
  Place place;
  PixelSums before;  // integrals along the chain up to there
  double turn = 0;   // sine of the angle, below zero
};

constexpr std::size_t kMostConcave = 32, kReach = 6;

struct ConcaveCorners {
  std::array<Concave, kMostConcave> list;
  std::size_t count = 0, chain = 0;
  PixelSums all;

  // Of what lies to one side of the way from a corner to a later one and straight back.
  PixelSums side(std::size_t from, std::size_t to) const {
    PixelSums sums = list[to].before;
    add(sums, list[from].before, -1);
    add_edge(sums, list[to].place, list[from].place);
    return sums;
  }

  // The sharpest are kept, in the order of the chain.
  void keep(const Concave& corner) {
    if (count == kMostConcave) {
      const auto flattest =
          std::max_element(list.begin(), list.end(),
                           [](const Concave& a, const Concave& b) { return a.turn < b.turn; });
      if (flattest->turn <= corner.turn) return;
      std::move(flattest + 1, list.end(), flattest);
      --count;
    }
    list[count++] = corner;
  }
};

// Walks once round with a window of kReach steps to either side.
ConcaveCorners concave_corners(const Contour& contour) {
  constexpr double kLeastTurn = 0.5;
  constexpr std::size_t kWindow = 2 * kReach + 1;
  const auto chain = contour.chain;
  ConcaveCorners corners;
  corners.chain = chain.size();
  std::array<Place, kWindow> places{};
  std::array<PixelSums, kWindow> sums{};
  Place here;
  PixelSums so_far;
  Concave sharpest;
  std::size_t since = 0;
  for (std::size_t k = 0; k < chain.size() + kWindow - 1; ++k) {
    places[k % kWindow] = here;
    sums[k % kWindow] = so_far;
    if (k + 1 >= kWindow) {
      const std::size_t middle = k - kReach;
      const Place &a = places[(k + 1) % kWindow], &b = places[middle % kWindow], &c = here;
      const double ux = b.x - a.x, uy = b.y - a.y, vx = c.x - b.x, vy = c.y - b.y;
      const double lengths = std::sqrt((ux * ux + uy * uy) * (vx * vx + vy * vy));
      const double turn = lengths > 0 ? (ux * vy - uy * vx) / lengths : 0;
      if (turn < -kLeastTurn && turn < sharpest.turn) {
        sharpest = {middle % chain.size(), b, sums[middle % kWindow], turn};
        // Once round already.
        if (middle >= chain.size()) add(sharpest.before, corners.all, -1);
        since = 0;
      }
      // Of one turn, the sharpest place.
      if (sharpest.turn < 0 && ++since > kReach) {
        corners.keep(sharpest);
        sharpest = {};
      }
    }
    const std::uint8_t step = chain[k % chain.size()];
    const Place next{here.x + kStepX[step], here.y + kStepY[step]};
    if (k < chain.size()) {
      add_edge(so_far, here, next);
      if (k + 1 == chain.size()) corners.all = so_far;
    }
    here = next;
  }
  return corners;
}

// Of a part of a region, a few pixels about its middle; the region's own where it is not there.
std::array<float, 3> colour_around(const RegionMap& regions, const Planes& colours,
                                   const Point2& centre, float area_px, std::uint16_t label) {
  constexpr int kSteps = 2;
  constexpr float kStep = 0.1F;
  const float step_px = kStep * std::sqrt(area_px);
  std::array<float, 3> sum{};
  int count = 0;
  for (int j = -kSteps; j <= kSteps; ++j)
    for (int i = -kSteps; i <= kSteps; ++i) {
      const int x = static_cast<int>(centre.x + static_cast<float>(i) * step_px),
                y = static_cast<int>(centre.y + static_cast<float>(j) * step_px);
      const Box& box = regions.active;
      if (x < box.x || y < box.y || x >= box.x + box.width || y >= box.y + box.height ||
          regions.labels[static_cast<std::size_t>(y * regions.stride_px + x)] != label)
        continue;
      const std::size_t at = colours.place(x, y);
      sum[0] += static_cast<float>(colours.red[at]);
      sum[1] += static_cast<float>(colours.green[at]);
      sum[2] += static_cast<float>(colours.blue[at]);
      ++count;
    }
  if (count == 0) return regions.regions[label - 1U].mean_rgb;
  for (float& channel : sum) channel /= static_cast<float>(count);
  return sum;
}

}  // namespace

void RegionParts::add(const RegionPart& part) {
  if (part.area_px >= kLeastArea_px && count_ < kMost) parts_[count_++] = part;
}

void RegionParts::add_region(const RegionPart& part) {
  if (count_ < kMostRegions || part.area_px < kLeastArea_px) return add(part);
  RegionPart& smallest = *std::min_element(
      parts_.begin(), parts_.begin() + kMostRegions,
      [](const RegionPart& a, const RegionPart& b) { return a.area_px < b.area_px; });
  if (part.area_px > smallest.area_px) smallest = part;
}

void RegionParts::add_whole(const RegionMap& regions) {
  for (std::size_t r = 0; r < regions.regions.size(); ++r) {
    const Region& region = regions.regions[r];
    const PixelSums& s = region.sums;
    add_region({{static_cast<float>(region.box.x + s.x / s.area),
                 static_cast<float>(region.box.y + s.y / s.area)},
                static_cast<float>(s.area),
                moments_of(s),
                region.mean_rgb,
                static_cast<std::uint16_t>(r + 1),
                true});
  }
}

// Between each two concave corners whose distance is short against the way along the border.
void RegionParts::add_cut(const RegionMap& regions, const Planes& colours, const Contour& contour) {
  constexpr double kNeck = 0.4, kLeastShare = 0.04;
  constexpr std::size_t kLeastChain = 40;
  if (!contour.external || contour.chain.size() < kLeastChain) return;
  // The narrowest against what they cut off are kept.
  struct Cut {
    double narrowness = 0;
    std::size_t from = 0, to = 0;
  };
  constexpr std::size_t kMostCuts = 6;
  std::array<Cut, kMostCuts> cuts;
  std::size_t count = 0;
  const ConcaveCorners corners = concave_corners(contour);
  for (std::size_t i = 0; i < corners.count; ++i)
    for (std::size_t j = 0; j < corners.count; ++j) {
      const Concave &from = corners.list[i], &to = corners.list[j];
      if (from.at >= to.at) continue;
      const std::size_t way = to.at - from.at;
      const double dx = to.place.x - from.place.x, dy = to.place.y - from.place.y;
      const double neck = std::sqrt(dx * dx + dy * dy);
      const double narrowness = neck / static_cast<double>(std::min(way, corners.chain - way));
      if (narrowness > kNeck) continue;
      const PixelSums one = corners.side(i, j);
      const double smaller = std::min(one.area, corners.all.area - one.area);
      if (smaller < std::max(kLeastShare * corners.all.area, static_cast<double>(kLeastArea_px)))
        continue;
      if (count < kMostCuts) {
        cuts[count++] = {narrowness, i, j};
        continue;
      }
      Cut& widest = *std::max_element(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) {
        return a.narrowness < b.narrowness;
      });
      if (narrowness < widest.narrowness) widest = {narrowness, i, j};
    }
  for (const Cut& cut : std::span(cuts).first(count)) {
    const PixelSums one = corners.side(cut.from, cut.to);
    PixelSums other = corners.all;
    aspect::add(other, one, -1);
    const std::size_t way = corners.list[cut.to].at - corners.list[cut.from].at;
    for (const auto& [sums, length] :
         {std::pair{one, static_cast<double>(way)},
          std::pair{other, static_cast<double>(corners.chain - way)}}) {
      const Point2 centre{static_cast<float>(contour.start_x + sums.x / sums.area),
                          static_cast<float>(contour.start_y + sums.y / sums.area)};
      // The chain runs through the middles of pixels.
      const auto area_px = static_cast<float>(sums.area + length / 2);
      add({centre, area_px, moments_of(sums),
           colour_around(regions, colours, centre, area_px, contour.region), contour.region,
           false});
    }
  }
}

struct RegionParts::Touch {
  std::uint16_t one = 0, other = 0, rows = 0;
};

// Neighbours in rows, with a blurred border of a few pixels at most between them.
void RegionParts::add_joined(const RegionMap& regions) {
  constexpr int kWidestBorder_px = 3, kLeastRows = 4;
  constexpr float kSameShare = 0.03F;
  constexpr std::size_t kPlaces = 1024;
  std::array<Touch, kPlaces> touches{};
  for (std::size_t k = 1; k < regions.runs.size(); ++k) {
    const Run &a = regions.runs[k - 1], &b = regions.runs[k];
    if (a.row != b.row || a.label == b.label || a.label == 0 || b.label == 0 ||
        b.begin - a.end > kWidestBorder_px)
      continue;
    const std::uint16_t one = std::min(a.label, b.label), other = std::max(a.label, b.label);
    std::size_t place = (one * 31U + other) % kPlaces;
    for (std::size_t tries = 0; tries < 8; ++tries, place = (place + 1) % kPlaces) {
      Touch& touch = touches[place];
      if (touch.rows > 0 && (touch.one != one || touch.other != other)) continue;
      touch = {one, other, static_cast<std::uint16_t>(touch.rows + 1)};
      break;
    }
  }
  const auto share_of = [](const Region& region) {
    const auto& c = region.mean_rgb;
    const float sum = std::max(1.0F, c[0] + c[1] + c[2]);
    return std::array<float, 3>{c[0] / sum, c[1] / sum, c[2] / sum};
  };
  for (const Touch& touch : touches) {
    if (touch.rows < kLeastRows) continue;
    const Region &a = regions.regions[touch.one - 1U], &b = regions.regions[touch.other - 1U];
    if (squared_distance(share_of(a), share_of(b)) > kSameShare * kSameShare) continue;
    PixelSums sums = a.sums;
    aspect::add(sums, shifted(b.sums, b.box.x - a.box.x, b.box.y - a.box.y), 1);
    add({{static_cast<float>(a.box.x + sums.x / sums.area),
          static_cast<float>(a.box.y + sums.y / sums.area)},
         static_cast<float>(sums.area),
         moments_of(sums),
         a.mean_rgb,
         touch.one,
         false});
  }
}

void RegionParts::find(const RegionMap& regions, const Planes& colours,
                       std::span<const Contour> contours) {
  count_ = 0;
  add_whole(regions);
  for (const Contour& contour : contours) add_cut(regions, colours, contour);
  add_joined(regions);
}

}  // namespace aspect
