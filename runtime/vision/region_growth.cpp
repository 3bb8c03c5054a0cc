#include "runtime/vision/region_growth.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

// Pixels of no region's colour, the mixed ones of a blurred edge, are taken up to this many steps
// from a region; wider blur stays without a label.
constexpr int kBlurLayers = 3;

// Passes over the waiting pixels in alternating order: a thread of one colour is followed to its
// end unless it turns back on itself more often.
constexpr int kThreadPasses = 3;

// More than shares can differ by: of two regions, the one of the pixel's own intensity is taken.
constexpr int kOtherIntensity = 256;

constexpr std::uint8_t kNoSide = 0, kLeft = 1, kRight = 2, kUp = 3, kDown = 4;

int difference(const std::array<std::uint8_t, 3>& a, const std::array<std::uint8_t, 3>& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

}  // namespace

// One run's inputs, so that the steps below need not hand them on.
struct RegionGrowth::Growing {
  const ShareRows& shares;
  std::span<const CoreColour> cores;
  const VisionParameters& parameters;
  LabelPicture picture;
  std::span<std::uint16_t> parent;

  std::size_t place(Pixel p) const {
    return static_cast<std::size_t>(p.y * picture.stride_px + p.x);
  }

  // Calls visit(label, side) for the labels of the four neighbours.
  template <typename Visit>
  void each_neighbour(Pixel p, Visit&& visit) const {
    const Box& box = picture.active;
    const std::uint16_t* at = picture.labels.data() + place(p);
    if (p.x > box.x) visit(at[-1], kLeft);
    if (p.x + 1 < box.x + box.width) visit(at[1], kRight);
    if (p.y > box.y) visit(at[-picture.stride_px], kUp);
    if (p.y + 1 < box.y + box.height) visit(at[picture.stride_px], kDown);
  }

  // Its own, none, where it has no side.
  std::uint16_t label_beside(Pixel p) const {
    const std::uint16_t* at = picture.labels.data() + place(p);
    const std::array<int, 5> step = {0, -1, 1, -picture.stride_px, picture.stride_px};
    return at[step[p.side]];
  }

  // Without a neighbour that has a label, its shares are not looked up.
  bool is_beside_a_region(Pixel p) const {
    unsigned labels = 0;
    each_neighbour(p, [&](std::uint16_t label, std::uint8_t) { labels |= label; });
    return labels != 0;
  }

  Neighbour most_alike(Pixel p, const PixelShares& own) const {
    Neighbour best;
    each_neighbour(p, [&](std::uint16_t label, std::uint8_t side) {
      if (label == 0 || label == best.label) return;
      const CoreColour& core = cores[label - 1U];
      const bool level = same_intensity(own.intensity, core.intensity);
      const int distance = difference(own.share, core.share) + (level ? 0 : kOtherIntensity);
      if (distance < best.difference || (distance == best.difference && label < best.label))
        best = {label, side, distance};
    });
    return best;
  }

  bool same_intensity(int a, int b) const {
    return 3 * std::abs(a - b) <= parameters.intensity_step;
  }

  bool has_colour_of(const PixelShares& own, const Neighbour& region) const {
    return region.label != 0 && region.difference <= own.tolerance &&
           same_intensity(own.intensity, cores[region.label - 1U].intensity);
  }

  std::uint16_t root_of(std::uint16_t label) const {
    while (parent[label] != label) label = parent[label] = parent[parent[label]];
    return label;
  }

  void join_alike_neighbours(Pixel p, std::uint16_t label) const {
    each_neighbour(p, [&](std::uint16_t other, std::uint8_t) {
      if (other == 0 || other == label) return;
      const CoreColour &a = cores[label - 1U], &b = cores[other - 1U];
      if (difference(a.share, b.share) > parameters.chroma_step ||
          !same_intensity(a.intensity, b.intensity))
        return;
      const std::uint16_t p_root = root_of(label), q_root = root_of(other);
      parent[std::max(p_root, q_root)] = std::min(p_root, q_root);
    });
  }

  void follow(Pixel p) const {
    std::uint16_t& label = picture.labels[place(p)];
    if (label != 0 || !is_beside_a_region(p)) return;
    const PixelShares own = shares.pixel(place(p));
    const Neighbour region = most_alike(p, own);
    if (!has_colour_of(own, region)) return;
    label = region.label;
    join_alike_neighbours(p, label);
  }

  std::uint8_t side_to_follow(Pixel p) const {
    return is_beside_a_region(p) ? most_alike(p, shares.pixel(place(p))).side : kNoSide;
  }
};

void RegionGrowth::take(Arena& arena, int width_px, int height_px) {
  // What borrows the idle memory needs a little even in the smallest frames.
  constexpr std::size_t kSpare = 256;
  const std::size_t pixels =
      static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
  room_ = pixels / kWaitingPixelDivisor;
  pending_ = arena.take<Pixel>(room_ + kSpare);
  parent_ = arena.take<std::uint16_t>(kMaxRegions + 1);
}

void RegionGrowth::wait(int y, int begin, int end) {
  for (int x = begin; x < end && pending_count_ < room_; ++x) {
    Pixel& pixel = pending_[pending_count_++];
    pixel.x = static_cast<std::uint16_t>(x);
    pixel.y = static_cast<std::uint16_t>(y) & 0x1FFFU;
  }
}

void RegionGrowth::run(const ShareRows& shares, std::span<const CoreColour> cores,
                       const VisionParameters& parameters, LabelPicture picture) {
  const Growing growing{shares, cores, parameters, picture, parent_};
  std::iota(parent_.begin(), parent_.end(), std::uint16_t{0});
  const auto waiting = pending_.first(pending_count_);
  for (int pass = 0; pass < kThreadPasses; ++pass) {
    if (pass % 2 == 0)
      std::for_each(waiting.begin(), waiting.end(), [&](Pixel p) { growing.follow(p); });
    else
      std::for_each(waiting.rbegin(), waiting.rend(), [&](Pixel p) { growing.follow(p); });
  }
  const auto labelled = [&](Pixel p) { return picture.labels[growing.place(p)] != 0; };
  auto end = std::remove_if(waiting.begin(), waiting.end(), labelled);
  for (int layer = 0; layer < kBlurLayers; ++layer) {
    const auto rest = std::span(waiting.begin(), end);
    for (Pixel& p : rest) p.side = growing.side_to_follow(p) & 7U;
    // Neighbours that had a label have it still: only pixels without one get one.
    for (const Pixel& p : rest) picture.labels[growing.place(p)] = growing.label_beside(p);
    end = std::remove_if(rest.begin(), rest.end(), labelled);
  }
}

std::uint16_t RegionGrowth::joined(std::uint16_t label) const {
  while (parent_[label] != label) label = parent_[label];
  return label;
}

}  // namespace aspect
