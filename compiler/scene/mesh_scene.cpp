// Steps: colours replaced, near ones made one; vertices at one place made one; the triangles cut
// into pieces; the object placed; what the store's key hashes worked out of the outcome.
#include "compiler/scene/mesh_scene.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cstring>
#include <map>
#include <set>

#include "compiler/scene/colour_merging.h"
#include "compiler/scene/colour_palette.h"
#include "compiler/scene/mesh_pieces.h"
#include "compiler/scene/picture_fit.h"
#include "compiler/scene/scene_bounds.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

constexpr double kSameColour = 2.0 / 255;
constexpr std::size_t kMaxPrimitives = 65534;  // a picture keeps a primitive's number in 16 bits
constexpr double kShareOfPicture = 0.9;
constexpr double kMostCoordinate = 1e30;

std::string fault_of(const ColouredMesh& mesh) {
  if (mesh.triangles.empty()) return "holds no faces; export the model as a mesh";
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::uint32_t corner : mesh.triangles[t]) {
      if (corner >= mesh.vertices.size())
        return fmt::format("a face has vertex {}, but there are {}; export it again", corner,
                           mesh.vertices.size());
      if (!(mesh.vertices[corner].cwiseAbs().maxCoeff() <= kMostCoordinate))
        return fmt::format("vertex {} is not finite; export it again", corner);
    }
    if (!mesh.colours[t].allFinite())
      return fmt::format("the colour of face {} is not finite; export it again", t);
  }
  return {};
}

// The name that colours a part, of those given; empty where none does.
std::string name_for(const ColouredMesh& mesh, std::size_t part, const MeshColours& colours) {
  for (const std::string& name :
       {mesh.parts[part].name, mesh.parts[part].material, std::to_string(part)})
    if (colours.by_name.contains(name)) return name;
  return {};
}

// The first of them: a file can have thousands.
std::string some_of(const std::set<std::string>& names) {
  constexpr std::ptrdiff_t kMost = 20;
  if (std::ssize(names) <= kMost) return fmt::format("{}", fmt::join(names, ", "));
  return fmt::format("{} and {} more",
                     fmt::join(names.begin(), std::next(names.begin(), kMost), ", "),
                     std::ssize(names) - kMost);
}

std::string replace_colours(ColouredMesh& mesh, const MeshColours& colours) {
  std::set<std::string> known;
  for (std::size_t part = 0; part < mesh.parts.size(); ++part) {
    known.insert({mesh.parts[part].name, mesh.parts[part].material, std::to_string(part)});
  }
  known.erase("");
  for (const auto& [name, colour] : colours.by_name)
    if (!known.contains(name))
      return fmt::format("has no part or material '{}'; it has {}", name, some_of(known));
  std::vector<const Vector3d*> by_part;
  for (std::size_t part = 0; part < mesh.parts.size(); ++part) {
    const auto found = colours.by_name.find(name_for(mesh, part, colours));
    by_part.push_back(found != colours.by_name.end() ? &found->second : nullptr);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.part_of[t] < by_part.size() && by_part[mesh.part_of[t]] != nullptr)
      mesh.colours[t] = *by_part[mesh.part_of[t]];
  return {};
}

// What is left of the colours that the file lacks, once some are replaced.
std::vector<MissingColour> still_missing(const ColouredMesh& mesh, const MeshColours& colours) {
  std::vector<MissingColour> left;
  for (MissingColour missing : mesh.missing) {
    const std::size_t parts_before = missing.parts.size();
    std::erase_if(missing.parts, [&](std::uint32_t part) {
      return part < mesh.parts.size() && !name_for(mesh, part, colours).empty();
    });
    if (parts_before == 0 || !missing.parts.empty()) left.push_back(std::move(missing));
  }
  return left;
}

// Fewer colours, the coarser the tolerance, until each can have a primitive of its own.
std::vector<SurfaceTriangle> with_surfaces(const ColouredMesh& mesh, Scene& scene) {
  std::vector<SurfaceTriangle> triangles(mesh.triangles.size());
  for (double tolerance = kSameColour;; tolerance *= 2) {
    ColourPalette palette(tolerance);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      const Vector3d colour = mesh.colours[t].cwiseMax(0).cwiseMin(1);
      triangles[t] = {mesh.triangles[t], static_cast<std::uint32_t>(palette.find_or_add(colour)),
                      mesh.part_of[t]};
    }
    if (palette.colours().size() > kMaxPrimitives) continue;
    for (const Vector3d& colour : palette.colours()) scene.surfaces.push_back({colour, colour});
    return triangles;
  }
}

std::string place(std::vector<Vector3d>& vertices, const std::vector<SurfaceTriangle>& triangles,
                  Scene& scene) {
  Eigen::AlignedBox3d box;
  for (const SurfaceTriangle& triangle : triangles)
    for (const std::uint32_t corner : triangle.corners) box.extend(vertices[corner]);
  const Vector3d centre_source = box.center();
  double radius = 0;
  for (const SurfaceTriangle& triangle : triangles)
    for (const std::uint32_t corner : triangle.corners)
      radius = std::max(radius, (vertices[corner] - centre_source).norm());
  const double fitting = kShareOfPicture * fitting_radius(scene.studio);
  if (!(radius > 1e-30)) return "its faces have no size; export it in larger units";
  scene.source_from_object = {radius / fitting, centre_source};
  for (Vector3d& vertex : vertices) vertex = (vertex - centre_source) * (fitting / radius);
  return {};
}

// As it may stand in a line of text.
std::string line_name(const MeshPart& part) {
  constexpr std::size_t kMostBytes = 80;
  std::string name = part.name.empty() ? part.material : part.name;
  name.resize(std::min(name.size(), kMostBytes));
  for (char& letter : name)
    if (static_cast<unsigned char>(letter) < ' ' || letter == '\x7f') letter = '?';
  return name;
}

// A piece is called after the part that has most of its area.
void name_primitives(const ColouredMesh& mesh, const std::vector<SurfaceTriangle>& triangles,
                     const std::vector<std::uint32_t>& piece_of, std::vector<std::string>& names) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> areas;  // by piece and part
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t].corners;
    const auto& v = mesh.vertices;
    areas[{piece_of[t], triangles[t].part}] += (v[b] - v[a]).cross(v[c] - v[a]).norm();
  }
  std::vector<double> most(names.size(), 0);
  std::vector<std::size_t> others(names.size(), 0);
  for (const auto& [place, area] : areas) {
    const auto [piece, part] = place;
    if (part >= mesh.parts.size()) continue;
    ++others[piece];
    if (area <= most[piece]) continue;
    most[piece] = area;
    names[piece] = line_name(mesh.parts[part]);
  }
  for (std::size_t piece = 0; piece < names.size(); ++piece)
    if (others[piece] > 1 && !names[piece].empty())
      names[piece] += fmt::format(" and {} more", others[piece] - 1);
}

// FNV-1a over whole numbers, twice with different starts.
class Digest {
 public:
  void add(std::uint64_t value) {
    low_ = (low_ ^ value) * 0x100000001b3u;
    high_ = (high_ ^ (value + (low_ >> 32))) * 0x100000001b3u;
  }
  void add(double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    add(bits);
  }
  void add(const Vector3d& vector) {
    for (const double coordinate : vector) add(coordinate);
  }
  std::string text() const { return fmt::format("{:016x}{:016x}", high_, low_); }

 private:
  std::uint64_t low_ = 0xcbf29ce484222325u, high_ = 0x84222325cbf29ce4u;
};

std::string source_of(const Scene& scene) {
  Digest digest;
  for (const Surface& surface : scene.surfaces) digest.add(surface.diffuse);
  for (const Primitive& primitive : scene.primitives) {
    digest.add(std::uint64_t{primitive.shape.index()});
    digest.add(static_cast<std::uint64_t>(primitive.surface));
    const auto* polygon = std::get_if<Polygon>(&primitive.shape);
    const auto* mesh = std::get_if<Mesh>(&primitive.shape);
    const auto& vertices = mesh != nullptr ? mesh->vertices : polygon->vertices;
    digest.add(std::uint64_t{vertices.size()});
    for (const Vector3d& vertex : vertices) digest.add(vertex);
    if (mesh == nullptr) continue;
    for (const auto& triangle : mesh->triangles)
      for (const std::uint32_t corner : triangle) digest.add(std::uint64_t{corner});
  }
  digest.add(scene.source_from_object.scale);
  digest.add(scene.source_from_object.translation);
  return "mesh 1 " + digest.text();
}

}  // namespace

std::string repaint(ColouredMesh& mesh, const MeshColours& colours) {
  if (std::string fault = fault_of(mesh); !fault.empty()) return fault;
  if (std::string fault = replace_colours(mesh, colours); !fault.empty()) return fault;
  if (colours.merged) merge_colours(mesh, *colours.merged);
  return {};
}

Result<Scene> scene_of_mesh(ColouredMesh mesh, const MeshColours& colours) {
  if (const std::string fault = repaint(mesh, colours); !fault.empty()) return Error{fault};
  for (Vector3d& vertex : mesh.vertices)
    if (!vertex.allFinite()) vertex.setZero();  // of no face
  Scene scene;
  scene.warnings = std::move(mesh.warnings);
  scene.files = std::move(mesh.files);
  scene.merged_colours = colours.merged;
  scene.missing_colours = still_missing(mesh, colours);
  scene.studio.ambient = {1, 1, 1};
  std::vector<SurfaceTriangle> triangles = with_surfaces(mesh, scene);
  weld(mesh.vertices, triangles);
  if (triangles.empty()) return Error{"its faces have no area; export the model as a mesh"};
  std::vector<std::uint32_t> piece_of = pieces_by_edges(mesh.vertices, triangles);
  if (const std::string fault = place(mesh.vertices, triangles, scene); !fault.empty())
    return Error{fault};
  if (*std::max_element(piece_of.begin(), piece_of.end()) >= kMaxPrimitives) {
    scene.warnings.push_back(fmt::format(
        "falls into more than {} pieces; all faces of a colour count as one", kMaxPrimitives));
    piece_of = pieces_by_surface(triangles);
  }
  scene.primitives = primitives_of(mesh.vertices, triangles, piece_of);
  scene.names.resize(scene.primitives.size());
  name_primitives(mesh, triangles, piece_of, scene.names);
  scene.source = source_of(scene);
  return scene;
}

}  // namespace aspect
