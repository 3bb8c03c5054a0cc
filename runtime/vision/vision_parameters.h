// How a picture is cut into regions. The same values must be used when an index is compiled and
// when frames are recognised, but for those that say otherwise.
#pragma once

#include <cstdint>

#include "runtime/vision/frame.h"

namespace aspect {

// Which arcs of the graph come first (thesis 3.2.2): the shortest; those between large contours, as
// area over squared length; or those of the minimal spanning tree, and then the shortest.
enum class RelationChoice : std::uint8_t { nearest, important, tree };

struct VisionParameters {
  // Pixels whose r + g + b is less are background, 0..765. Typical 48 for a black background,
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

  // Largest step of r + g + b between neighbouring pixels of one region, 765: any. Needed only
  // where surfaces differ in grey alone; shading then breaks up.
  int intensity_step = 765;

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

}  // namespace aspect
