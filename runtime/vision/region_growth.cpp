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

// Of two regions of one colour the one of the pixel's own brightness is taken; of others, colour
// says more, since shading changes brightness within a region.
constexpr int kBrightnessDivisor = 2;
constexpr int kAnyIntensityStep = 765;

// Marks labels that pixels have been given by following: what has looked at the others once need
// not again.
constexpr std::uint16_t kFollowed = kLabelMask + 1;

// Marks labels that a layer gives: the layers after it build on them, it does not.
constexpr std::uint16_t mark_of_layer(int layer) {
  return static_cast<std::uint16_t>((2 * kFollowed) << layer);
}
static_assert(mark_of_layer(kBlurLayers - 1) != 0);

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
  bool parts_by_brightness = true;

  std::size_t place(Pixel p) const {
    return static_cast<std::size_t>(p.y * picture.stride_px + p.x);
  }

  // Calls visit(label) for those of the four neighbours that have one, without one of `ignored`.
  template <typename Visit>
  void each_neighbour(Pixel p, unsigned ignored, Visit&& visit) const {
    const Box& box = picture.active;
    const std::uint16_t* at = picture.labels.data() + place(p);
    const auto see = [&](std::uint16_t label) {
      if (label != 0 && (label & ignored) == 0)
        visit(static_cast<std::uint16_t>(label & kLabelMask));
    };
    if (p.x > box.x) see(at[-1]);
    if (p.x + 1 < box.x + box.width) see(at[1]);
    if (p.y > box.y) see(at[-picture.stride_px]);
    if (p.y + 1 < box.y + box.height) see(at[picture.stride_px]);
  }

  // The labels of the four neighbours together.
  unsigned labels_beside(Pixel p) const {
    const Box& box = picture.active;
    const std::uint16_t* at = picture.labels.data() + place(p);
    unsigned labels = 0;
    if (p.x > box.x) labels |= at[-1];
    if (p.x + 1 < box.x + box.width) labels |= at[1];
    if (p.y > box.y) labels |= at[-picture.stride_px];
    if (p.y + 1 < box.y + box.height) labels |= at[picture.stride_px];
    return labels;
  }

  Neighbour most_alike(Pixel p, const PixelShares& own, unsigned ignored) const {
    Neighbour best;
    each_neighbour(p, ignored, [&](std::uint16_t label) {
      if (label == best.label) return;
      const CoreColour& core = cores[label - 1U];
      const int brightness = parts_by_brightness ? std::abs(own.intensity - core.intensity) : 0;
      const int distance = difference(own.share, core.share) + brightness / kBrightnessDivisor;
      if (distance < best.difference || (distance == best.difference && label < best.label))
        best = {label, distance};
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
    each_neighbour(p, 0, [&](std::uint16_t other) {
      if (other == label) return;
      const CoreColour &a = cores[label - 1U], &b = cores[other - 1U];
      if (difference(a.share, b.share) > parameters.chroma_step ||
          !same_intensity(a.intensity, b.intensity))
        return;
      const std::uint16_t p_root = root_of(label), q_root = root_of(other);
      parent[std::max(p_root, q_root)] = std::min(p_root, q_root);
    });
  }

  // Pixels without a neighbour whose label is of `interest` are not looked at.
  void follow(Pixel p, unsigned interest) const {
    std::uint16_t& label = picture.labels[place(p)];
    if (label != 0 || (labels_beside(p) & interest) == 0) return;
    const PixelShares own = shares.pixel(place(p));
    const Neighbour region = most_alike(p, own, 0);
    if (!has_colour_of(own, region)) return;
    label = region.label | kFollowed;
    join_alike_neighbours(p, region.label);
  }

  void take_most_alike(Pixel p, std::uint16_t mark) const {
    std::uint16_t& label = picture.labels[place(p)];
    if (label != 0 || labels_beside(p) == 0) return;
    const Neighbour region = most_alike(p, shares.pixel(place(p)), mark);
    if (region.label != 0) label = region.label | mark;
  }

  // Pixels of a row, in their order.
  template <typename Step>
  void forwards(const WaitingRun& run, Step&& step) const {
    for (int x = run.begin; x < run.end; ++x) step(Pixel{x, run.row});
  }

  template <typename Step>
  void backwards(const WaitingRun& run, Step&& step) const {
    for (int x = run.end; x-- > run.begin;) step(Pixel{x, run.row});
  }

  // Takes the pixels with a label off both ends; false where none without one is left.
  bool shorten(WaitingRun& run) const {
    const std::uint16_t* row = picture.labels.data() + run.row * picture.stride_px;
    while (run.begin < run.end && row[run.begin] != 0) ++run.begin;
    while (run.begin < run.end && row[run.end - 1] != 0) --run.end;
    return run.begin < run.end;
  }
};

void RegionGrowth::take(Arena& arena, int width_px, int height_px) {
  // What borrows the idle memory needs a little even in the smallest frames.
  constexpr std::size_t kSpare = 256;
  const std::size_t pixels =
      static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
  room_ = pixels / kWaitingRunsDivisor;
  waiting_ = arena.take<WaitingRun>(room_ + kSpare);
  parent_ = arena.take<std::uint16_t>(kMaxRegions + 1);
}

void RegionGrowth::wait(int y, int begin, int end, bool is_flat) {
  if (waiting_count_ < room_)
    waiting_[waiting_count_++] = {
        static_cast<std::uint16_t>(y & 0x7FFF), static_cast<std::uint16_t>(is_flat),
        static_cast<std::uint16_t>(begin), static_cast<std::uint16_t>(end)};
}

void RegionGrowth::run(const ShareRows& shares, std::span<const CoreColour> cores,
                       const VisionParameters& parameters, LabelPicture picture) {
  const Growing growing{shares,  cores,   parameters,
                        picture, parent_, parameters.intensity_step < kAnyIntensityStep};
  std::iota(parent_.begin(), parent_.end(), std::uint16_t{0});
  auto waiting = waiting_.first(waiting_count_);
  const auto forget_labelled = [&] {
    const auto end = std::remove_if(waiting.begin(), waiting.end(),
                                    [&](WaitingRun& run) { return !growing.shorten(run); });
    waiting = waiting.first(static_cast<std::size_t>(end - waiting.begin()));
  };
  for (int pass = 0; pass < kThreadPasses; ++pass) {
    const unsigned interest = pass == 0 ? kLabelMask : kFollowed;
    const auto follow = [&](Pixel p) { growing.follow(p, interest); };
    if (pass % 2 == 0)
      for (const WaitingRun& run : waiting) growing.forwards(run, follow);
    else
      for (std::size_t k = waiting.size(); k-- > 0;) growing.backwards(waiting[k], follow);
  }
  for (int layer = 0; layer < kBlurLayers; ++layer) {
    forget_labelled();
    const std::uint16_t mark = mark_of_layer(layer);
    // What is flat is no mixture of the colours beside it.
    for (const WaitingRun& run : waiting)
      if (run.is_flat == 0)
        growing.forwards(run, [&](Pixel p) { growing.take_most_alike(p, mark); });
  }
}

std::uint16_t RegionGrowth::joined(std::uint16_t label) const {
  while (parent_[label] != label) label = parent_[label];
  return label;
}

}  // namespace aspect
