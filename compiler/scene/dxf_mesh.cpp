// Steps: the file's records; layers and blocks by name; then every entity, those of blocks once for
// each INSERT, with the transform from its coordinates to the file's.
#include "compiler/scene/dxf_mesh.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <set>
#include <span>

#include "compiler/scene/dxf_colours.h"
#include "compiler/scene/dxf_groups.h"

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
};

// World coordinates from an entity's own, by its extrusion: the arbitrary axis algorithm.
Affine3d world_from_entity(const DxfRecord& record) {
  Vector3d z(record.number(210, 0), record.number(220, 0), record.number(230, 1));
  if (!(z.norm() > 0)) z = Vector3d::UnitZ();
  z.normalize();
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
    for (const std::string& kind : left_out_)
      mesh_.warnings.push_back(
          fmt::format("{} is left out; export it as a mesh or as 3DFACEs", kind));
    return std::move(mesh_);
  }

 private:
  Records until(std::size_t begin, std::string_view kind) const {
    std::size_t end = begin;
    while (end < records_.size() && records_[end].kind != kind) ++end;
    return Records(records_).subspan(begin, end - begin);
  }

  void add_block(std::size_t k) {
    blocks_[std::string(records_[k].text(2))] = {records_[k].point(10), until(k + 1, "ENDBLK")};
  }

  void draw(Records entities, const Affine3d& world, const DxfOwner& owner, int depth) {
    static const std::set<std::string_view> kModellers = {"3DSOLID", "BODY", "REGION", "SURFACE",
                                                          "MESH"};
    for (std::size_t k = 0; k < entities.size(); ++k) {
      const DxfRecord& entity = entities[k];
      if (entity.kind == "3DFACE") face(entity, world, {10, 11, 12, 13}, owner);
      if (entity.kind == "SOLID" || entity.kind == "TRACE")
        face(entity, world * world_from_entity(entity), {10, 11, 13, 12}, owner);
      if (entity.kind == "INSERT") insert(entity, world, owner, depth);
      if (kModellers.contains(entity.kind)) left_out_.insert(std::string(entity.kind));
      if (entity.kind != "POLYLINE") continue;
      std::size_t end = k + 1;
      while (end < entities.size() && entities[end].kind == "VERTEX") ++end;
      polyline(entity, entities.subspan(k + 1, end - k - 1), world, owner);
      k = end - 1;
    }
  }

  std::uint32_t part(const std::string& layer) {
    const auto [place, added] =
        parts_.try_emplace(layer, static_cast<std::uint32_t>(mesh_.parts.size()));
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
    add_face(mesh_, kept, layers_.colour_of(entity, owner),
             part(DxfLayers::layer_of(entity, owner)));
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
    const auto block = blocks_.find(std::string(entity.text(2)));
    if (block == blocks_.end()) return;
    if (depth == kMaxDepth)
      throw MeshError(fmt::format("blocks within blocks past {} levels; explode some", kMaxDepth),
                      entity.line);
    const Vector3d scale(entity.number(41, 1), entity.number(42, 1), entity.number(43, 1));
    const Eigen::AngleAxisd turn(entity.number(50, 0) * std::numbers::pi / 180, Vector3d::UnitZ());
    const DxfOwner inner = {layers_.colour_of(entity, owner), DxfLayers::layer_of(entity, owner)};
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
  std::map<std::string, Block> blocks_;
  std::map<std::string, std::uint32_t> parts_;
  std::set<std::string> left_out_;
  std::size_t inserts_ = 0;
  ColouredMesh mesh_;
};

}  // namespace

ColouredMesh parse_dxf(std::string_view file) {
  return DxfReader(file).read();
}

}  // namespace aspect
