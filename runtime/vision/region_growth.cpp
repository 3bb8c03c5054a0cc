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

int difference(const std::array<std::uint8_t, 3>& a, const std::array<std::uint8_t, 3>& b) {
  return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

}  // namespace

// One run's inputs, so that the steps below need not hand them on.
struct RegionGrowth::Growing {
  const Shares& shares;
  std::span<const CoreColour> cores;
  const VisionParameters& parameters;
  LabelPicture picture;
  std::span<std::uint16_t> parent;

  std::size_t place(Pixel p) const {
    return static_cast<std::size_t>(p.y * picture.stride_px + p.x);
  }

  // Calls visit(label) for the labels of the four neighbours.
  template <typename Visit>
  void each_neighbour(Pixel p, Visit&& visit) const {
    const Box& box = picture.active;
    const std::uint16_t* at = picture.labels.data() + place(p);
    if (p.x > box.x) visit(at[-1]);
    if (p.x + 1 < box.x + box.width) visit(at[1]);
    if (p.y > box.y) visit(at[-picture.stride_px]);
    if (p.y + 1 < box.y + box.height) visit(at[picture.stride_px]);
  }

  Neighbour most_alike(Pixel p) const {
    const std::size_t i = place(p);
    const std::array<std::uint8_t, 3> own{shares.red[i], shares.green[i], shares.blue[i]};
    Neighbour best;
    each_neighbour(p, [&](std::uint16_t label) {
      if (label == 0 || label == best.label) return;
      const CoreColour& core = cores[label - 1U];
      const bool level = same_intensity(shares.intensity[i], core.intensity);
      const int distance = difference(own, core.share) + (level ? 0 : kOtherIntensity);
      if (distance < best.difference || (distance == best.difference && label < best.label))
        best = {label, distance};
    });
    return best;
  }

  bool same_intensity(int a, int b) const {
    return 3 * std::abs(a - b) <= parameters.intensity_step;
  }

  bool has_colour_of(Pixel p, const Neighbour& region) const {
    const std::size_t i = place(p);
    return region.label != 0 && region.difference <= shares.tolerance[i] &&
           same_intensity(shares.intensity[i], cores[region.label - 1U].intensity);
  }

  std::uint16_t root_of(std::uint16_t label) const {
    while (parent[label] != label) label = parent[label] = parent[parent[label]];
    return label;
  }

  void join_alike_neighbours(Pixel p, std::uint16_t label) const {
    each_neighbour(p, [&](std::uint16_t other) {
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
    if (label != 0) return;
    const Neighbour region = most_alike(p);
    if (!has_colour_of(p, region)) return;
    label = region.label;
    join_alike_neighbours(p, label);
  }
};

void RegionGrowth::take(Arena& arena, int width_px, int height_px) {
  const std::size_t pixels =
      static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
  pending_ = arena.take<Pixel>(pixels / kWaitingPixelDivisor);
  pending_label_ = arena.take<std::uint16_t>(pixels / kWaitingPixelDivisor);
  parent_ = arena.take<std::uint16_t>(kMaxRegions + 1);
}

void RegionGrowth::wait(int y, int begin, int end) {
  for (int x = begin; x < end && pending_count_ < pending_.size(); ++x)
    pending_[pending_count_++] = {static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)};
}

void RegionGrowth::run(const Shares& shares, std::span<const CoreColour> cores,
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
    for (std::size_t k = 0; k < rest.size(); ++k)
      pending_label_[k] = growing.most_alike(rest[k]).label;
    for (std::size_t k = 0; k < rest.size(); ++k)
      picture.labels[growing.place(rest[k])] = pending_label_[k];
    end = std::remove_if(rest.begin(), rest.end(), labelled);
  }
}

std::uint16_t RegionGrowth::joined(std::uint16_t label) const {
  while (parent_[label] != label) label = parent_[label];
  return label;
}

}  // namespace aspect
