// Why an object seen is taken for what it is: which contour is which surface, what should be there
// and is not, and what is there and should not be.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/recognition/recogniser.h"

namespace aspect {

using ColourShare = std::array<float, 3>;  // r g b of 1

struct ExplainedContour {
  std::uint16_t contour = 0, name = 0;      // of the frame, of the class
  std::span<const std::uint16_t> surfaces;  // the scene's primitives, from 1
  ColourShare colour{};                     // as seen
};

// A piece of one colour that the drawn model shows, little of which is seen. Without a pose: a
// contour of the class that none of the frame's stands for, and nothing is said of its area.
struct MissingPart {
  std::optional<std::uint16_t> name;        // of the class's contour there, if one is known
  std::span<const std::uint16_t> surfaces;  // that contour's
  ColourShare colour{};                     // in white light
  std::optional<float> area_px, covered;    // share of it that has the right colour
};

// Where a contour shows another colour than the drawn model. Without a pose: a contour that the
// class has nothing for.
struct Contradiction {
  std::uint16_t contour = 0;
  ColourShare colour{};              // as seen
  std::optional<ColourShare> drawn;  // nothing: the model is not there, or there is no pose
  float area_px = 0;
};

struct SeenExplanation {
  std::vector<ExplainedContour> contours;
  std::vector<MissingPart> missing;          // largest first
  std::vector<Contradiction> contradicting;  // largest first
};

// What a recogniser has of its last frame, and lives as long.
struct SeenFrame {
  ViewGraph graph;
  const RegionMap* regions = nullptr;
  const Planes* colours = nullptr;
  std::span<const ClassIndex> indexes;
  std::span<const CameraModel> cameras;
};

// Where an object is in the frame.
struct SeenPlace {
  std::size_t blob = 0;
  // Of one that is only a part of its blob, before a background or touching others: what is beside
  // its model does not speak against it.
  std::optional<Box> part;
};
SeenPlace place_of(const SeenObject& object, const ViewGraph& graph);

// `pose` is the hypothesis's own or one that was found for it since; null: none.
SeenExplanation explain_seen(const Hypothesis& hypothesis, const VerifiedPose* pose,
                             const SeenPlace& place, const SeenFrame& frame);

}  // namespace aspect
