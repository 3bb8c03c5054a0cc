// From triangles in a file's coordinates to a scene that fits in the picture.
#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <string>

#include "compiler/scene/coloured_mesh.h"
#include "compiler/scene/scene.h"
#include "runtime/base/result.h"

namespace aspect {

// Colours that replace a file's own, by the name of a part or of a material, or by the part's
// number in the file, from "0". A part's name wins over its material's, and that over its number.
struct MeshColours {
  std::map<std::string, Eigen::Vector3d> by_name;
  // Then all are merged into so many (colour_merging.h).
  std::optional<std::size_t> merged = std::nullopt;
  // Stands for every colour that the file names and that is not found; without it that is an error.
  std::optional<Eigen::Vector3d> missing = std::nullopt;
};

// Paints the mesh so. Empty, or what is wrong: with the mesh, or a name that it does not have.
std::string repaint(ColouredMesh& mesh, const MeshColours& colours);

// One primitive for each piece of surface: triangles of one colour that are joined by edges. Flat
// simple pieces become polygons. Colours at most 2/255 apart are one surface. Past 65534 pieces all
// triangles of a colour are one primitive.
// The object is centred on its bounding box and scaled to 0.9 of the radius that fits, seen in
// ambient light of 1 at 45 degrees with z upwards; Scene::source_from_object leads back.
// Colours are taken as they are: a picture shows 255 * colour.
// What a file lacks where a colour by name stands for it is not missed.
// Fails where nothing is left to be seen, a colour names no part, or a vertex is not finite; the
// error has no file name in front. O(n log n).
Result<Scene> scene_of_mesh(ColouredMesh mesh, const MeshColours& colours = {});

}  // namespace aspect
