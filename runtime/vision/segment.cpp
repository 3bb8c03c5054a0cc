// Cores first, borders second. A pixel is core where colour shares hardly change across it; cores
// are joined to their neighbours under the same tolerance, so a blurred edge, which has no core
// pixels, parts two regions although the colour runs through all the steps between them. Small
// components are then forgotten, and every foreground pixel left takes the most alike region next
// to it, layer by layer, which puts the border where a blurred edge is half one colour and half
// the other. In a picture without blur each border pixel falls back to its own side.
// Where pixels of one colour lead from core to core, the regions are one: that is what the thesis's
// 4-connectedness says, and threads too thin to have a core still count.
// Weak side: a region that is nowhere three pixels thick has no core and is not seen.
#include "runtime/vision/segment.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <numeric>
#include <utility>

#include "runtime/vision/alike_rows.h"
#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

using Byte = std::uint8_t;

// Of a region that starts in a row for which the runs of the foreground found no room.
constexpr std::int32_t kNoRoot = -1;

// A core has fewer pixels than its region; smaller ones than this share of the least area are
// noise.
constexpr int kCoreAreaDivisor = 4;

// core[i] &= solid[i].
void keep_solid(const Byte* solid, std::size_t count, Byte* __restrict core) {
  for (std::size_t i = 0; i < count; ++i) core[i] = static_cast<Byte>(core[i] & solid[i]);
}

// First index in [from, end) whose label differs from `label`, marks aside, four at a time.
int end_of_labels(const std::uint16_t* labels, int from, int end, std::uint16_t label) {
  constexpr std::uint64_t kEach = 0x0001000100010001;
  const std::uint64_t pattern = label * kEach;
  for (; from + 4 <= end; from += 4) {
    std::uint64_t word = 0;
    std::memcpy(&word, labels + from, sizeof word);
    if ((word & (kLabelMask * kEach)) != pattern) break;
  }
  while (from < end && (labels[from] & kLabelMask) == label) ++from;
  return from;
}

// Runs come row by row, so the last one is the lowest.
void grow_box(Box& box, const Run& run) {
  const bool first = box.empty();
  const int left = first ? run.begin : std::min<int>(box.x, run.begin);
  const int right = first ? run.end : std::max<int>(box.x + box.width, run.end);
  const int top = first ? run.row : box.y;
  box = {left, top, right - left, run.row + 1 - top};
}

}  // namespace

struct Segmenter::Core {
  std::array<std::uint64_t, 3> rgb{};
  std::uint64_t area = 0;

  std::uint64_t sum() const { return std::max<std::uint64_t>(rgb[0] + rgb[1] + rgb[2], 1); }
};

void Segmenter::take(Arena& arena, int width_px, int height_px) {
  const auto width = static_cast<std::size_t>(width_px);
  const std::size_t pixels = width * static_cast<std::size_t>(height_px);
  stride_px_ = width_px;
  components_.take(arena, width_px, height_px);
  shares_.take(arena, width_px);
  core_ = arena.take<Byte>(2 * width);
  left_ = arena.take<Byte>(width);
  up_ = arena.take<Byte>(width);
  roots_ = arena.take<std::int32_t>(kMaxRegions);
  cores_ = arena.take<Core>(kMaxRegions);
  colours_ = arena.take<CoreColour>(kMaxRegions);
  growth_.take(arena, width_px, height_px);
  runs_ = arena.take<Run>(pixels / kRegionRunsPerPixelDivisor + width);
  regions_ = arena.take<Region>(kMaxRegions);
  blobs_ = arena.take<Blob>(kMaxBlobs);
  labels_ = arena.take<std::uint16_t>(pixels);
}

RowLinks Segmenter::link_core_row(const EnhancedFrame& frame, int y, int intensity_step) {
  const auto width = static_cast<std::size_t>(active_.width);
  const auto step = static_cast<Byte>(std::clamp(intensity_step / 3, 0, 255));
  const bool first = y == active_.y, last = y + 1 == active_.y + active_.height;
  const ShareRow here = shares_.row(y);
  const ShareRow above = first ? here : shares_.row(y - 1);
  const auto core_row = [&](int row) {
    return core_.data() + (row % 2 == 0 ? 0 : stride_px_) + active_.x;
  };
  Byte* core = core_row(y);
  std::copy_n(here.foreground, width, core);
  if (frame.codes != nullptr)
    keep_solid(frame.codes->solid.data() + frame.planes.place(active_.x, y), width, core);
  if (width > 2) require_alike(here, here.from(2), width - 2, step, core + 1);
  if (!first && !last) require_alike(above, shares_.row(y + 1), width, step, core);
  Byte* left = left_.data() + active_.x;
  left[0] = 0;
  link_alike(here, here.from(1), core, core + 1, width - 1, step, left + 1);
  if (!first) link_alike(here, above, core, core_row(y - 1), width, step, up_.data() + active_.x);
  return {core - active_.x, left_.data(), up_.data()};
}

void Segmenter::choose_cores(std::span<ComponentRun> runs, int area_min_px) {
  std::size_t count = 0;
  const int least = std::max(area_min_px / kCoreAreaDivisor, 1);
  const auto larger = [&](std::int32_t a, std::int32_t b) {
    const auto area = [&](std::int32_t i) { return runs[static_cast<std::size_t>(i)].area_px; };
    return area(a) != area(b) ? area(a) > area(b) : a < b;
  };
  // Once there are too many, a heap with the smallest on top.
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto root = static_cast<std::int32_t>(i);
    if (runs[i].root != root || runs[i].area_px < least) continue;
    if (count < kMaxRegions) {
      roots_[count++] = root;
      if (count == kMaxRegions) std::make_heap(roots_.begin(), roots_.end(), larger);
      continue;
    }
    ++dropped_;
    if (!larger(root, roots_[0])) continue;
    std::pop_heap(roots_.begin(), roots_.end(), larger);
    roots_[count - 1] = root;
    std::push_heap(roots_.begin(), roots_.end(), larger);
  }
  std::sort(roots_.begin(), roots_.begin() + static_cast<std::ptrdiff_t>(count));
  for (std::size_t k = 0; k < count; ++k)
    runs[static_cast<std::size_t>(roots_[k])].label = static_cast<std::uint16_t>(k + 1);
  for (ComponentRun& run : runs) run.label = runs[static_cast<std::size_t>(run.root)].label;
  core_count_ = count;
}

void Segmenter::measure_cores(std::span<const ComponentRun> runs, const EnhancedFrame& frame) {
  const Planes& colours = frame.planes;
  std::fill_n(cores_.begin(), core_count_, Core{});
  for (const Run& run : runs) {
    if (run.label == 0) continue;
    Core& core = cores_[run.label - 1U];
    const auto begin = colours.place(run.begin, run.row);
    const std::size_t length = static_cast<std::size_t>(run.end - run.begin);
    std::uint32_t red = 0, green = 0, blue = 0;
    for (std::size_t i = begin; i < begin + length; ++i) {
      red += colours.red[i];
      green += colours.green[i];
      blue += colours.blue[i];
    }
    core.rgb[0] += red;
    core.rgb[1] += green;
    core.rgb[2] += blue;
    core.area += length;
  }
  for (std::size_t k = 0; k < core_count_; ++k) {
    const Core& core = cores_[k];
    if (frame.codes != nullptr) {
      for (std::size_t channel = 0; channel < 3; ++channel)
        colours_[k].share[channel] =
            static_cast<Byte>((core.rgb[channel] + core.area / 2) / core.area);
      colours_[k].intensity = 0;
      continue;
    }
    for (std::size_t channel = 0; channel < 3; ++channel)
      colours_[k].share[channel] = static_cast<Byte>(255 * core.rgb[channel] / core.sum());
    colours_[k].intensity = static_cast<Byte>(
        (core.sum() + 2 * std::max({core.rgb[0], core.rgb[1], core.rgb[2]})) / (5 * core.area));
  }
}

// Runs of `border`, a row of bytes.
void Segmenter::wait_in_row(int y, const Byte* border) {
  const int end = active_.x + active_.width;
  for (int x = end_of_bytes(border, active_.x, end, 0); x < end;) {
    const int stop = end_of_bytes(border, x, end, 255);
    growth_.wait(y, x, stop, false);
    x = end_of_bytes(border, stop, end, 0);
  }
}

// What is foreground and in no run waits first, then the runs too small for a core.
void Segmenter::paint_cores(std::span<const ComponentRun> runs) {
  growth_.begin();
  std::size_t next = 0;
  Byte* border = left_.data();
  for (int y = active_.y; y < active_.y + active_.height; ++y) {
    std::uint16_t* labels = labels_.data() + y * stride_px_;
    std::fill_n(labels + active_.x, active_.width, std::uint16_t{0});
    std::copy_n(shares_.foreground(y), active_.width, border + active_.x);
    for (; next < runs.size() && runs[next].row == y; ++next) {
      const Run& run = runs[next];
      std::fill_n(border + run.begin, run.end - run.begin, Byte{0});
      std::fill_n(labels + run.begin, run.end - run.begin, run.label);
    }
    wait_in_row(y, border);
  }
  for (const Run& run : runs)
    if (run.label == 0) growth_.wait(run.row, run.begin, run.end, true);
}

// Labels without a run would keep the number of a core.
void Segmenter::clear_labels_from(int x, int y) {
  const int end = active_.x + active_.width;
  std::fill_n(labels_.begin() + y * stride_px_ + x, end - x, std::uint16_t{0});
  for (int row = y + 1; row < active_.y + active_.height; ++row)
    std::fill_n(labels_.begin() + row * stride_px_ + active_.x, active_.width, std::uint16_t{0});
}

// What growth has joined is one region from here on, under the lowest label.
void Segmenter::merge_joined_cores() {
  for (std::size_t k = 0; k < core_count_; ++k) {
    const std::size_t joined = growth_.joined(static_cast<std::uint16_t>(k + 1)) - 1U;
    if (joined == k) continue;
    cores_[joined].area += cores_[k].area;
    for (std::size_t channel = 0; channel < 3; ++channel)
      cores_[joined].rgb[channel] += cores_[k].rgb[channel];
  }
}

void Segmenter::find_region_runs() {
  run_count_ = 0;
  const int end = active_.x + active_.width;
  for (int y = active_.y; y < active_.y + active_.height; ++y) {
    std::uint16_t* row = labels_.data() + y * stride_px_;
    for (int x = active_.x; x < end;) {
      const auto grown = static_cast<std::uint16_t>(row[x] & kLabelMask);
      const int stop = end_of_labels(row, x + 1, end, grown);
      const std::uint16_t label = growth_.joined(grown);
      std::fill(row + x, row + stop, label);
      if (label != 0) {
        if (run_count_ == runs_.size()) {
          ++dropped_;
          clear_labels_from(x, y);
          return;
        }
        runs_[run_count_++] = {static_cast<std::uint16_t>(y), static_cast<std::uint16_t>(x),
                               static_cast<std::uint16_t>(stop), label};
      }
      x = stop;
    }
  }
}

void Segmenter::measure_regions() {
  std::fill_n(regions_.begin(), core_count_, Region{});
  const auto runs = runs_.first(run_count_);
  for (const Run& run : runs) grow_box(regions_[run.label - 1U].box, run);
  for (const Run& run : runs) {
    Region& region = regions_[run.label - 1U];
    add_run(region.sums, run, region.box);
  }
}

std::array<float, 3> Segmenter::mean_rgb(const Core& core) {
  std::array<float, 3> mean{};
  for (std::size_t channel = 0; channel < 3; ++channel)
    mean[channel] =
        static_cast<float>(static_cast<double>(core.rgb[channel]) / static_cast<double>(core.area));
  return mean;
}

// Regions that are chosen, by their places, to the front in that order; the others' are lost.
void Segmenter::move_to_front(std::span<const std::uint16_t> chosen) {
  std::array<std::uint16_t, kMaxRegions> place_of, region_at;
  std::iota(place_of.begin(), place_of.end(), std::uint16_t{0});
  std::iota(region_at.begin(), region_at.end(), std::uint16_t{0});
  for (std::size_t to = 0; to < chosen.size(); ++to) {
    const std::size_t from = place_of[chosen[to]];
    std::swap(regions_[to], regions_[from]);
    std::swap(region_at[to], region_at[from]);
    place_of[region_at[from]] = static_cast<std::uint16_t>(from);
  }
}

// Forgets small regions and filaments and numbers the rest in the order of their first pixels.
void Segmenter::drop_small(const VisionParameters& parameters) {
  enum : std::uint16_t { kUndecided = 0xFFFF };
  std::array<std::uint16_t, kMaxRegions + 1> relabel;
  std::array<std::uint16_t, kMaxRegions> kept_regions;
  relabel.fill(kUndecided);
  region_count_ = 0;
  for (Run& run : runs_.first(run_count_)) {
    std::uint16_t& label = relabel[run.label];
    if (label == kUndecided) {
      const auto place = static_cast<std::uint16_t>(run.label - 1U);
      Region& region = regions_[place];
      const bool kept = region.sums.area >= parameters.area_min_px &&
                        thickness_px_of(region.sums) >= parameters.thickness_min_px;
      label = 0;
      if (kept) {
        region.mean_rgb = mean_rgb(cores_[place]);
        kept_regions[region_count_] = place;
        label = static_cast<std::uint16_t>(++region_count_);
      }
    }
    if (run.label == label) continue;
    run.label = label;
    std::fill_n(labels_.begin() + run.row * stride_px_ + run.begin, run.end - run.begin, label);
  }
  move_to_front(std::span(kept_regions).first(region_count_));
}

// Writes the root of each region's piece of foreground to its `blob`, and all of them to roots_;
// returns their number.
std::size_t Segmenter::find_roots(bool one_blob) {
  const int row_end = active_.y + active_.height - components_.dropped_rows();
  std::size_t count = 0, labels_met = 0;
  for (const Run& run : runs_.first(run_count_)) {
    if (run.label <= labels_met) continue;
    labels_met = run.label;
    std::int32_t root = kNoRoot;
    if (one_blob)
      root = 0;
    else if (run.row < row_end)
      root = components_.run_at(run.begin, run.row).root;
    regions_[labels_met - 1].blob = root;
    if (root != kNoRoot) roots_[count++] = root;
  }
  return count;
}

// Blobs that hold a region, largest first. Regions of a blob too many get blob = kMaxBlobs and are
// left out of the graph.
void Segmenter::find_blobs(bool one_blob) {
  const std::span<ComponentRun> runs = components_.run(active_, [&](int y) {
    const Byte* row = shares_.foreground(y) - active_.x;
    return RowLinks{row, row, row};
  });
  if (one_blob) {
    for (ComponentRun& run : runs.subspan(std::min<std::size_t>(1, runs.size()))) {
      if (run.root == static_cast<std::int32_t>(&run - runs.data())) runs[0].area_px += run.area_px;
      run.root = 0;
    }
  }
  const auto root = [&](std::int32_t i) -> ComponentRun& {
    return runs[static_cast<std::size_t>(i)];
  };
  const auto first = roots_.begin();
  auto last = first + static_cast<std::ptrdiff_t>(find_roots(one_blob));
  std::sort(first, last);
  last = std::unique(first, last);
  std::sort(first, last, [&](std::int32_t a, std::int32_t b) {
    return root(a).area_px != root(b).area_px ? root(a).area_px > root(b).area_px : a < b;
  });
  blob_count_ = std::min<std::size_t>(static_cast<std::size_t>(last - first), kMaxBlobs);
  for (std::size_t k = 0; k < blob_count_; ++k)
    root(roots_[k]).label = static_cast<std::uint16_t>(k + 1);
  for (Region& region : regions_.first(region_count_)) {
    const int label = region.blob == kNoRoot ? 0 : root(region.blob).label;
    region.blob = label == 0 ? kMaxBlobs : label - 1;
    if (label == 0) ++dropped_;
  }
  measure_blobs(runs);
}

void Segmenter::measure_blobs(std::span<const ComponentRun> runs) {
  std::fill_n(blobs_.begin(), blob_count_, Blob{});
  std::array<PixelSums, kMaxBlobs> sums{};
  for (const ComponentRun& run : runs) {
    const int label = runs[static_cast<std::size_t>(run.root)].label;
    if (label == 0) continue;
    const auto k = static_cast<std::size_t>(label - 1);
    grow_box(blobs_[k].box, run);
    const double length = run.end - run.begin;
    sums[k].area += length;
    sums[k].x += length * (run.begin + run.end - 1) / 2;
    sums[k].y += length * run.row;
  }
  for (std::size_t k = 0; k < blob_count_; ++k) {
    blobs_[k].area_px = static_cast<float>(sums[k].area);
    blobs_[k].centre_px = {static_cast<float>(sums[k].x / sums[k].area),
                           static_cast<float>(sums[k].y / sums[k].area)};
  }
}

RegionMap Segmenter::run(const EnhancedFrame& frame, const VisionParameters& parameters) noexcept {
  active_ = frame.planes.active;
  shares_.begin(frame, parameters);
  const std::span<ComponentRun> cores = components_.run(
      active_, [&](int y) { return link_core_row(frame, y, parameters.intensity_step); });
  dropped_ = components_.dropped_rows();
  choose_cores(cores, parameters.area_min_px);
  measure_cores(cores, frame);
  paint_cores(cores);
  growth_.run(shares_, colours_.first(core_count_), parameters, {labels_, stride_px_, active_});
  merge_joined_cores();
  find_region_runs();
  measure_regions();
  drop_small(parameters);
  find_blobs(parameters.one_blob);
  return {labels_,
          stride_px_,
          active_,
          runs_.first(run_count_),
          regions_.first(region_count_),
          blobs_.first(blob_count_),
          dropped_,
          {}};
}

}  // namespace aspect
