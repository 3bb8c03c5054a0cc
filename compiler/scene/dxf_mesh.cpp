// Steps: the file's records; layers and blocks by name; then every entity, those of blocks once for
// each INSERT, with the transform from its coordinates to the file's.
#include "compiler/scene/dxf_mesh.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <span>

#include "compiler/scene/dxf_groups.h"
#include "compiler/scene/dxf_layers.h"
#include "compiler/scene/dxf_names.h"
#include "compiler/scene/dxf_omissions.h"
#include "compiler/scene/dxf_paths.h"

namespace aspect {
namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;

constexpr int kMaxDepth = 16;  // of blocks in blocks
constexpr std::size_t kMaxInserts = 1'000'000;

using Records = std::span<const DxfRecord>;

struct Block {
  Vector3d base = Vector3d::Zero();
  Records entities;
  bool external = false;  // of another file, or laid over from one
};

// The direction of a thickness.
Vector3d extrusion_of(const DxfRecord& record) {
  const Vector3d z(record.number(210, 0), record.number(220, 0), record.number(230, 1));
  return z.norm() > 0 ? z.normalized() : Vector3d::UnitZ();
}

// World coordinates from an entity's own, by its extrusion: the arbitrary axis algorithm.
Affine3d world_from_entity(const DxfRecord& record) {
  const Vector3d z = extrusion_of(record);
  const bool near_z = std::abs(z.x()) < 1.0 / 64 && std::abs(z.y()) < 1.0 / 64;
  const Vector3d x = (near_z ? Vector3d::UnitY() : Vector3d::UnitZ()).cross(z).normalized();
  Affine3d result = Affine3d::Identity();
  result.linear() << x, z.cross(x), z;
  return result;
}

class DxfReader {
 public:
  explicit DxfReader(std::string_view file) : records_(read_dxf_records(file)) {}

  ColouredMesh read() {
    Records drawn;
    for (std::size_t k = 0; k < records_.size(); ++k) {
      if (records_[k].kind == "LAYER") layers_.add(records_[k]);
      if (records_[k].kind == "BLOCK") add_block(k);
      if (records_[k].kind == "SECTION" && records_[k].text(2) == "ENTITIES")
        drawn = until(k + 1, "ENDSEC");
    }
    draw(drawn, Affine3d::Identity(), {}, 0);
    mesh_.warnings = omissions_.lines();
    if (mesh_.triangles.empty() && !mesh_.warnings.empty())
      throw MeshError(fmt::format("holds no faces; {}", fmt::join(mesh_.warnings, "; ")));
    return std::move(mesh_);
  }

 private:
  Records until(std::size_t begin, std::string_view kind) const {
    std::size_t end = begin;
    while (end < records_.size() && records_[end].kind != kind) ++end;
    return Records(records_).subspan(begin, end - begin);
  }

  void add_block(std::size_t k) {
    blocks_[dxf_key(records_[k].text(2))] = {records_[k].point(10), until(k + 1, "ENDBLK"),
                                             (records_[k].whole(70, 0) & (4 | 8)) != 0};
  }

  void draw(Records entities, const Affine3d& world, const DxfOwner& owner, int depth) {
    for (std::size_t k = 0; k < entities.size(); ++k) {
      const DxfRecord& entity = entities[k];
      const std::size_t first = k + 1;
      if (entity.kind == "POLYLINE")
        while (k + 1 < entities.size() && entities[k + 1].kind == "VERTEX") ++k;
      const DxfHiding hiding = layers_.hiding_of(entity, owner);
      if (entity.kind == "SEQEND" || entity.kind == "VERTEX") continue;
      if (hiding != DxfHiding::none)
        omissions_.count_hidden(hiding, layers_.layer_of(entity, owner));
      else if (entity.kind == "INSERT")
        insert(entity, world, owner, depth);
      else if (!add_surface(entity, entities.subspan(first, k + 1 - first), world, owner))
        omissions_.count_kind(std::string(entity.kind));
    }
  }

  // False where it has none that is read.
  bool add_surface(const DxfRecord& entity, Records vertices, const Affine3d& world,
                   const DxfOwner& owner) {
    if (entity.kind == "3DFACE") {
      face(entity, world, {10, 11, 12, 13}, owner);
      return true;
    }
    if (entity.kind == "SOLID" || entity.kind == "TRACE") {
      solid(entity, world * world_from_entity(entity), owner);
      return true;
    }
    if (entity.kind == "POLYLINE" && (entity.whole(70, 0) & (16 | 64)) != 0) {
      polyline(entity, vertices, world, owner);
      return true;
    }
    const double thickness = entity.number(39, 0);
    if (thickness == 0) return false;
    const Affine3d placed = world * world_from_entity(entity);
    const Vector3d upwards = placed.linear() * Vector3d(0, 0, thickness);
    if (entity.kind == "LINE") {
      const DxfPath line{{entity.point(10), entity.point(11)}, false, false};
      extrude(entity, line, world, world.linear() * (thickness * extrusion_of(entity)), owner);
    } else if (entity.kind == "CIRCLE") {
      prism(entity, path_of_circle(entity), placed, upwards, owner);
    } else if (entity.kind == "ARC") {
      extrude(entity, path_of_arc(entity), placed, upwards, owner);
    } else if (entity.kind == "LWPOLYLINE") {
      extrude_line(entity, path_of_lwpolyline(entity), placed, upwards, owner);
    } else if (entity.kind == "POLYLINE" && (entity.whole(70, 0) & 8) == 0) {
      extrude_line(entity, path_of_polyline(entity, vertices), placed, upwards, owner);
    } else {
      return false;
    }
    return true;
  }

  std::uint32_t part(const std::string& layer) {
    const auto [place, added] =
        parts_.try_emplace(dxf_key(layer), static_cast<std::uint32_t>(mesh_.parts.size()));
    if (added) mesh_.parts.push_back({layer, {}});
    return place->second;
  }

  // Corners at one place are one: a 3DFACE of three repeats its last.
  void add(std::vector<std::uint32_t> corners, const DxfRecord& entity, const DxfOwner& owner) {
    const auto same = [&](std::uint32_t a, std::uint32_t b) {
      return mesh_.vertices[a] == mesh_.vertices[b];
    };
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t corner : corners)
      if (kept.empty() || !same(kept.back(), corner)) kept.push_back(corner);
    while (kept.size() > 1 && same(kept.front(), kept.back())) kept.pop_back();
    if (kept.size() < 3) return;
    add_face(mesh_, kept, layers_.colour_of(entity, owner), part(layers_.layer_of(entity, owner)));
  }

  void face(const DxfRecord& entity, const Affine3d& world, std::array<int, 4> codes,
            const DxfOwner& owner) {
    std::vector<std::uint32_t> corners;
    for (const int code : codes) {
      // A fourth corner that is not written is the third.
      if (entity.text(code).empty()) continue;
      corners.push_back(add_vertex(mesh_, world * entity.point(code)));
    }
    add(std::move(corners), entity, owner);
  }

  // With a thickness it is closed at both ends.
  void solid(const DxfRecord& entity, const Affine3d& placed, const DxfOwner& owner) {
    const double thickness = entity.number(39, 0);
    if (thickness == 0) return face(entity, placed, {10, 11, 13, 12}, owner);
    DxfPath outline;
    outline.closed = true;
    for (const int code : {10, 11, 13, 12})
      if (!entity.text(code).empty()) outline.points.push_back(entity.point(code));
    prism(entity, outline, placed, placed.linear() * Vector3d(0, 0, thickness), owner);
  }

  std::vector<std::uint32_t> ring(const DxfPath& path, const Affine3d& placed,
                                  const Vector3d& shift) {
    std::vector<std::uint32_t> corners;
    for (const Vector3d& point : path.points)
      corners.push_back(add_vertex(mesh_, placed * point + shift));
    return corners;
  }

  void add_walls(const DxfRecord& entity, const std::vector<std::uint32_t>& lower,
                 const std::vector<std::uint32_t>& upper, bool closed, const DxfOwner& owner) {
    const std::size_t n = lower.size(), count = n == 0 ? 0 : closed ? n : n - 1;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t next = (k + 1) % n;
      if (mesh_.vertices[lower[k]] != mesh_.vertices[lower[next]])
        add({lower[k], lower[next], upper[next], upper[k]}, entity, owner);
    }
  }

  void extrude(const DxfRecord& entity, const DxfPath& path, const Affine3d& placed,
               const Vector3d& upwards, const DxfOwner& owner) {
    add_walls(entity, ring(path, placed, Vector3d::Zero()), ring(path, placed, upwards),
              path.closed, owner);
  }

  void extrude_line(const DxfRecord& entity, const DxfPath& path, const Affine3d& placed,
                    const Vector3d& upwards, const DxfOwner& owner) {
    if (path.wide)
      omissions_.count_kind(fmt::format("{} with a width", entity.kind));
    else
      extrude(entity, path, placed, upwards, owner);
  }

  void prism(const DxfRecord& entity, const DxfPath& outline, const Affine3d& placed,
             const Vector3d& upwards, const DxfOwner& owner) {
    const auto lower = ring(outline, placed, Vector3d::Zero());
    const auto upper = ring(outline, placed, upwards);
    add({lower.rbegin(), lower.rend()}, entity, owner);
    add(upper, entity, owner);
    add_walls(entity, lower, upper, true, owner);
  }

  void polyline(const DxfRecord& entity, Records vertices, const Affine3d& world,
                const DxfOwner& owner) {
    const int flags = entity.whole(70, 0);
    if ((flags & 64) != 0) polyface(entity, vertices, world, owner);
    if ((flags & 16) != 0) grid(entity, vertices, world, owner, flags);
  }

  void polyface(const DxfRecord& entity, Records vertices, const Affine3d& world,
                const DxfOwner& owner) {
    std::vector<std::uint32_t> points;
    for (const DxfRecord& vertex : vertices)
      if ((vertex.whole(70, 0) & 64) != 0)
        points.push_back(add_vertex(mesh_, world * vertex.point(10)));
    for (const DxfRecord& vertex : vertices) {
      if ((vertex.whole(70, 0) & (128 | 64)) != 128) continue;
      std::vector<std::uint32_t> corners;
      for (int code = 71; code <= 74; ++code) {
        const int index = std::abs(vertex.whole(code, 0));  // negative: the edge is not drawn
        if (index == 0) continue;
        if (static_cast<std::size_t>(index) > points.size())
          throw MeshError(fmt::format("a face has vertex {}, but there are {}; export it again",
                                      index, points.size()),
                          vertex.line);
        corners.push_back(points[static_cast<std::size_t>(index) - 1]);
      }
      const bool own = !vertex.text(62).empty() || !vertex.text(420).empty();
      add(std::move(corners), own ? vertex : entity, owner);
    }
  }

  void grid(const DxfRecord& entity, Records vertices, const Affine3d& world, const DxfOwner& owner,
            int flags) {
    constexpr int kControlPoint = 16, kFitted = 4;
    std::vector<std::uint32_t> points;
    for (const DxfRecord& vertex : vertices)
      if ((vertex.whole(70, 0) & kControlPoint) == 0)
        points.push_back(add_vertex(mesh_, world * vertex.point(10)));
    const bool fitted = (flags & kFitted) != 0;
    const int rows = entity.whole(fitted ? 73 : 71, 0), columns = entity.whole(fitted ? 74 : 72, 0);
    if (rows < 2 || columns < 2 ||
        points.size() / static_cast<std::size_t>(rows) < static_cast<std::size_t>(columns))
      throw MeshError(fmt::format("a mesh of {} x {} with {} vertices; export it again", rows,
                                  columns, points.size()),
                      entity.line);
    const auto m = static_cast<std::size_t>(rows), n = static_cast<std::size_t>(columns);
    const std::size_t last_row = (flags & 1) != 0 ? m : m - 1;
    const std::size_t last_column = (flags & 32) != 0 ? n : n - 1;
    for (std::size_t i = 0; i < last_row; ++i)
      for (std::size_t k = 0; k < last_column; ++k) {
        const std::size_t below = (i + 1) % m, right = (k + 1) % n;
        add({points[i * n + k], points[i * n + right], points[below * n + right],
             points[below * n + k]},
            entity, owner);
      }
  }

  void insert(const DxfRecord& entity, const Affine3d& world, const DxfOwner& owner, int depth) {
    const auto block = blocks_.find(dxf_key(entity.text(2)));
    if (block == blocks_.end()) return omissions_.count_kind("INSERT without its block");
    if (block->second.external) return omissions_.count_kind("INSERT of another file");
    if (depth == kMaxDepth)
      throw MeshError(fmt::format("blocks within blocks past {} levels; explode some", kMaxDepth),
                      entity.line);
    const Vector3d scale(entity.number(41, 1), entity.number(42, 1), entity.number(43, 1));
    const Eigen::AngleAxisd turn(entity.number(50, 0) * std::numbers::pi / 180, Vector3d::UnitZ());
    const DxfOwner inner = {layers_.colour_of(entity, owner), layers_.layer_of(entity, owner)};
    const int columns = std::max(1, entity.whole(70, 1)), rows = std::max(1, entity.whole(71, 1));
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        if (++inserts_ > kMaxInserts)
          throw MeshError(fmt::format("more than {} inserted blocks; explode some", kMaxInserts),
                          entity.line);
        const Vector3d step(column * entity.number(44, 0), row * entity.number(45, 0), 0);
        const Affine3d inserted = world * world_from_entity(entity) *
                                  Eigen::Translation3d(entity.point(10)) * turn *
                                  Eigen::Translation3d(step) * Eigen::Scaling(scale) *
                                  Eigen::Translation3d(-block->second.base);
        draw(block->second.entities, inserted, inner, depth + 1);
      }
  }

  std::vector<DxfRecord> records_;
  DxfLayers layers_;
  std::map<std::string, Block> blocks_;  // by dxf_key()
  std::map<std::string, std::uint32_t> parts_;
  DxfOmissions omissions_;
  std::size_t inserts_ = 0;
  ColouredMesh mesh_;
};

}  // namespace

ColouredMesh parse_dxf(std::string_view file) {
  return DxfReader(file).read();
}

}  // namespace aspect
