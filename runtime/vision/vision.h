// The half of Aspect that sees: a frame in, an attributed relational graph of its coloured regions
// out (thesis 3.2.2). Rendered and captured frames go through this same code.
#pragma once

#include <chrono>
#include <span>

#include "runtime/base/arena.h"
#include "runtime/vision/code_planes.h"
#include "runtime/vision/colour_bands.h"
#include "runtime/vision/contour_trace.h"
#include "runtime/vision/frame.h"
#include "runtime/vision/planes.h"
#include "runtime/vision/range_codes.h"
#include "runtime/vision/segment.h"
#include "runtime/vision/view_graph.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

struct VisionTimes {
  std::chrono::nanoseconds convert{}, enhance{}, segment{}, features{};
};

class Vision {
 public:
  // Takes all memory for frames of up to width x height from the arena; never allocates later.
  // An arena without storage only counts the bytes.
  void prepare(Arena& arena, int width_px, int height_px, SensorKind sensor = SensorKind::colour);

  // The graph, and everything it points to, lives until the next run. A frame larger than was
  // prepared for, without all its planes, or of another sensor than prepared for, gives an empty
  // graph. parameters.sensor must be what was prepared for, too. O(pixels).
  ViewGraph run(const Frame& frame, const VisionParameters& parameters) noexcept;

  // Only the colours of parameters.region_of_interest, smoothed: no regions, and a fraction of the
  // time. False where there is nothing to see.
  bool look(const Frame& frame, const VisionParameters& parameters) noexcept;

  // Of the last run: for drawing and for the compiler's surface ids.
  const RegionMap& regions() const { return regions_; }
  const Planes& colours() const { return colours_; }  // smoothed, within their active part
  const VisionTimes& times() const { return times_; }
  int max_width_px() const { return width_px_; }
  int max_height_px() const { return height_px_; }

 private:
  bool can_see(const Frame& frame, const VisionParameters& parameters) const;
  bool see_colours(const Frame& frame, const VisionParameters& parameters);
  bool see_codes(const Frame& frame, const VisionParameters& parameters);
  ViewGraph build_graph(const VisionParameters& parameters);

  SensorKind sensor_ = SensorKind::colour;
  int width_px_ = 0, height_px_ = 0;
  ColourBands bands_;
  Planes colours_;
  // Of sensors that measure something else.
  Planes codes_;
  CodeMasks masks_;
  std::span<std::uint8_t> scratch_;
  RangeCodes range_codes_;
  EnhancedFrame enhanced_;
  Segmenter segmenter_;
  ContourTracer tracer_;
  std::span<Contour> contours_;
  std::span<Relation> relations_;
  std::span<Blob> blobs_;
  RegionMap regions_;
  VisionTimes times_;
};

}  // namespace aspect
