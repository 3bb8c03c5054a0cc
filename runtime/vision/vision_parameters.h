// How a picture is cut into regions. The same values must be used when an index is compiled and
// when frames are recognised, but for those that say otherwise.
#pragma once

#include <cstdint>

#include "runtime/vision/frame.h"
#include "runtime/vision/sensor_kind.h"

namespace aspect {

// How a range picture is cut into surfaces.
struct RangeParameters {
  // Length of one step of a depth, in the scene's units. 0.0001: tenths of a millimetre where the
  // object is seen from a metre.
  float step_length = 1e-4F;

  // Depths outside of [steps_min, steps_max] are background: cuts away what stands behind.
  int steps_min = 1;
  int steps_max = 65534;

  // A gap between neighbouring pixels parts two surfaces where it is more than this share of their
  // distance, slant taken into account. Typical 0.01; lower sees shallower steps, until noise does.
  float depth_step = 0.01F;

  // Normals of neighbouring pixels of one surface differ by at most this, in degrees. Typical 12;
  // surfaces that meet at less are one, and so are round ones of a radius above 10 pixels.
  float normal_step_deg = 12;

  // Full horizontal field of view of the camera that takes the frames; the index's where no camera
  // is configured.
  float field_of_view_deg = 50;
};
// Which arcs of the graph come first (thesis 3.2.2): the shortest; those between large contours, as
// area over squared length; or those of the minimal spanning tree, and then the shortest.
enum class RelationChoice : std::uint8_t { nearest, important, tree };

struct VisionParameters {
  // What frames are of; a frame from another sensor is seen as empty.
  SensorKind sensor = SensorKind::colour;
  RangeParameters range;  // of a range sensor only

  // Pixels whose r + g + b is less are background, 0..765; in grey pictures all three are the grey
  // value, in those of other sensors it is not used. Typical 48 for a black background,
  // 150 and more to cut away dark clutter; dark parts of the object vanish as it rises.
  int intensity_min = 48;

  // Largest step of a colour share (255 r / (r + g + b), likewise g and b) between neighbouring
  // pixels of one region, 1..255. Typical 6 to 16; higher joins alike colours, lower breaks up
  // noisy surfaces.
  int chroma_step = 8;

  // Added to chroma_step where the pixel is dark: the error of a colour share of a pixel with one
  // grey value of noise in each channel is about 255 / (r + g + b). In multiples of that error;
  // 0 for noise-free pictures, typical 3 for cameras.
  int noise_steps = 3;

  // Largest step of three times the brightness, 0.6 (r + g + b + 2 max(r, g, b)), between pixels
  // of one region that are two apart; of grey it is r + g + b. 0: as the picture's noise allows,
  // 15 to 90; 765: any, so that only colours part regions. Higher joins what shading parts.
  int intensity_step = 0;

  // Smaller regions are discarded. Typical 40 at 512 x 512.
  int area_min_px = 40;

  // Filaments thinner than this are discarded. Typical 5: the pixel grid breaks thinner slivers
  // into pieces, and aspects with them; lower sees finer detail.
  float thickness_min_px = 5.0F;

  // 1. step, a 3 x 3 median: removes noise, keeps edges. Costs a third of the time.
  bool smooth = true;

  // All foreground is one blob, however many pieces it is in: one object fills the picture. Always
  // so when compiling.
  bool one_blob = false;

  // Arcs kept for each blob, in the order that relation_choice says; 0 keeps all, and of a tree
  // its own.
  int relations_max = 0;
  RelationChoice relation_choice = RelationChoice::nearest;

  // The part of the frame that is looked at; empty: all of it. May differ from frame to frame.
  Box region_of_interest;
};

// What a sensor's pictures are best cut with as long as nobody says otherwise.
constexpr VisionParameters default_parameters(SensorKind sensor) {
  // Of r + g + b: surfaces that differ by fewer than eight grey levels are one.
  constexpr int kGreyStep = 24;
  VisionParameters parameters;
  parameters.sensor = sensor;
  if (sensor == SensorKind::grey) parameters.intensity_step = kGreyStep;
  return parameters;
}

}  // namespace aspect
