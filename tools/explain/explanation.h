// What to expect of a compiled model before it ships: how often it is recognised, which aspects are
// mistaken for which, where it cannot be recognised, and which surface colour would cure it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "compiler/recipe.h"
#include "runtime/recognition/class_index.h"
#include "tools/eval/wilson_interval.h"
#include "tools/explain/colour_presence.h"

namespace aspect {

struct ExplainSettings {
  int views = 500;  // fresh random ones
  std::uint64_t seed = 1;
  int cure_level = 3;  // of the model compiled with changed colours; less than the store's is quick
  int jobs = 0;
  std::filesystem::path backgrounds;  // folder of pictures; empty: none
};

struct Accuracy {
  Share rank_1, rank_5, rank_10;  // the right aspect among the first, modulo symmetry
  Share within_20_deg;            // of the best answer's view from the true one, modulo symmetry
};

// A part of the sphere, about a direction.
struct Spot {
  Eigen::Vector3d centre{0, 0, 1};
  double share = 0;  // of the sphere, or of the views
  double radius_deg = 0;
  std::string reason;
};

// One or more primitives in a plane, of one colour: what people would call a face.
struct Face {
  std::vector<std::uint16_t> primitives;  // from 1, as in pictures
  Eigen::Vector3d colour{0, 0, 0};        // as it is seen, linear 0..1
  std::string name = {};                  // of the first that has one in the file
};

// Views of one aspect answered with a far view (more than 20 degrees off) of another.
struct AspectConfusion {
  std::int32_t aspect = 0, taken_for = 0;
  std::size_t views = 0;
  Eigen::Vector3d seen_from{0, 0, 1}, believed_from{0, 0, 1};  // means
  std::vector<Face> faces, faces_believed;                     // of the contours that were matched
};

// Two faces of which one was matched with a contour of the other.
struct FaceConfusion {
  std::size_t face = 0, taken_for = 0;  // into Explanation::faces
  std::size_t views = 0;
  double separation = 0;  // of the colours; the segmentation separates above 1
};

// A colour that a surface can be painted in.
struct PaletteColour {
  std::string name;
  Eigen::Vector3d colour{0, 0, 0};
  // In the backgrounds, where there are any.
  ColourPresence presence;
  Commonness commonness = Commonness::rare;
};

struct BetterPaint {
  PaletteColour paint;
  double separation = 0;  // least, from all other colours
};

// A colour of the object, with all its surfaces, in the backgrounds.
struct BackgroundColour {
  Face face;
  ColourPresence presence;
  Commonness commonness = Commonness::rare;
  std::optional<BetterPaint> better;  // where it is common, and another would be less so
};

inline constexpr std::size_t kMostBetterPaints = 3;  // that are proposed

struct BackgroundColours {
  std::string folder;
  std::size_t pictures = 0;               // that were looked at
  std::vector<BackgroundColour> colours;  // most common first
};

struct ColourChange {
  std::size_t face = 0;
  Eigen::Vector3d colour{0, 0, 0};
  std::string colour_name;
  double separation = 0;  // least, from all other faces; it was that of the confusion
};

struct Cure {
  std::vector<ColourChange> changes;
  int level = 0;                 // of the model compiled to try them
  std::size_t wrong_before = 0;  // views answered by a far view; with the store's model
  std::size_t wrong_after = 0;
  std::size_t cured = 0;  // of those wrong before, the ones that are right after
  Accuracy after;
};

// Of a mesh with so many colours that touch others like them that painting one cures nothing.
struct CrowdedColours {
  std::size_t colours = 0;
  double share = 0;        // of the surface that is seen, in such colours
  std::size_t enough = 0;  // so many show nearly all of the surface as it is
};

// One of the views that the model was tried on.
struct TriedView {
  Eigen::Vector3d direction{0, 0, 1};
  std::int32_t aspect = 0;
  std::optional<std::int32_t> taken_for;  // nothing: not found
  double error_deg = 180;                 // of the answer's view, modulo symmetry
  bool is_right = false;                  // the right aspect, modulo symmetry
  bool is_wrong = false;                  // neither that nor a view within 20 degrees
};

struct Explanation {
  std::string object, store, scene_file;
  int views = 0;
  std::size_t aspects = 0;
  std::vector<std::array<float, 4>> symmetries;
  std::vector<std::array<float, 3>> symmetry_axes;
  Accuracy accuracy;
  std::vector<TriedView> tried_views;
  std::size_t neighbour_views = 0;  // another aspect, but a view at most 20 degrees off
  std::size_t wrong_views = 0;      // farther off, or nothing found
  double blind_share = 0;           // of the sphere: no aspect covers it
  std::vector<Spot> blind_spots;    // largest first
  std::vector<Spot> failing_spots;  // where wrong answers come from
  std::vector<Face> faces;
  std::vector<AspectConfusion> confusions;  // most views first
  std::vector<FaceConfusion> face_confusions;
  std::optional<CrowdedColours> crowded;      // then no changes are looked for
  std::optional<std::size_t> merged_colours;  // of a mesh whose colours were merged: into so many
  std::optional<BackgroundColours> backgrounds;  // where some were given
  Cure cure;                                     // without changes where none would help
};

// Puts the index that a recipe gave to the test.
Result<Explanation> explain(ClassIndex index, const std::filesystem::path& store,
                            const Recipe& recipe, const ExplainSettings& settings);

// Makes the model of a store again, which renders nothing new, and puts it to the test.
Result<Explanation> explain(const std::filesystem::path& store, const Recipe& recipe,
                            const ExplainSettings& settings);

// Wrong views and cures in colour for a terminal.
std::string explanation_text(const Explanation& explanation, bool colours = false);
std::string explanation_json(const Explanation& explanation);

}  // namespace aspect
