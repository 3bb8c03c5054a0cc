#include "compiler/render/embree_scene.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <utility>

namespace aspect {
namespace {

using Eigen::Vector3d;

// Share of the scene's size by which round rims overlap: ten times single precision's step, a
// thousandth of a pixel.
constexpr double kOverlap = 1e-6;

double reach_of(const Scene& scene) {
  double reach = 0;
  const auto take = [&](const Vector3d& point, double radius) {
    reach = std::max(reach, point.cwiseAbs().maxCoeff() + radius);
  };
  for (const Primitive& primitive : scene.primitives) {
    if (const auto* polygon = std::get_if<Polygon>(&primitive.shape))
      for (const Vector3d& vertex : polygon->vertices) take(vertex, 0);
    if (const auto* mesh = std::get_if<Mesh>(&primitive.shape))
      for (const Vector3d& vertex : mesh->vertices) take(vertex, 0);
    if (const auto* triangle = std::get_if<SmoothTriangle>(&primitive.shape))
      for (const Vector3d& vertex : triangle->vertices) take(vertex, 0);
    if (const auto* sphere = std::get_if<Sphere>(&primitive.shape))
      take(sphere->center, sphere->radius);
    if (const auto* ring = std::get_if<Ring>(&primitive.shape))
      take(ring->center, ring->max_radius);
    if (const auto* cone = std::get_if<Cone>(&primitive.shape)) {
      take(cone->base, cone->base_radius);
      take(cone->apex, cone->apex_radius);
    }
  }
  return reach;
}

}  // namespace

Result<EmbreeScene> EmbreeScene::create(const Scene& scene,
                                        std::span<const std::vector<Triangle>> triangles) {
  EmbreeScene result;
  // Not "threads=1": that caps the parallelism of every TBB loop in the process for as long as the
  // device lives. The arena below keeps the build on one thread, and so in one order.
  result.device_ = rtcNewDevice(nullptr);
  if (result.device_ == nullptr) return Error{"Embree: no device; is the processor without SSE2?"};
  std::string failure;
  rtcSetDeviceErrorFunction(
      result.device_,
      [](void* text, RTCError, const char* message) {
        *static_cast<std::string*>(text) = message != nullptr ? message : "unknown error";
      },
      &failure);

  result.scene_ = rtcNewScene(result.device_);
  rtcSetSceneBuildQuality(result.scene_, RTC_BUILD_QUALITY_HIGH);
  // Without it rays exactly through an edge or corner slip through, as they do in views along axes
  // of symmetry; none did in 60,000 random views. It costs 30 % of the tracing.
  rtcSetSceneFlags(result.scene_, RTC_SCENE_FLAG_ROBUST);
  const double overlap = kOverlap * reach_of(scene);
  result.add_triangles(scene, triangles);
  result.add_smooth_triangles(scene);
  result.add_round_shapes<Sphere>(scene, overlap, result.spheres_);
  result.add_round_shapes<Ring>(scene, overlap, result.rings_);
  result.add_round_shapes<Cone>(scene, overlap, result.cones_);
  tbb::task_arena(1).execute([&] { rtcCommitScene(result.scene_); });

  rtcSetDeviceErrorFunction(result.device_, nullptr, nullptr);
  if (!failure.empty()) return Error{"Embree: " + failure};
  return result;
}

EmbreeScene::EmbreeScene(EmbreeScene&& other) noexcept {
  *this = std::move(other);
}

EmbreeScene& EmbreeScene::operator=(EmbreeScene&& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(scene_, other.scene_);
  spheres_.swap(other.spheres_);
  rings_.swap(other.rings_);
  cones_.swap(other.cones_);
  primitives_.swap(other.primitives_);
  first_part_.swap(other.first_part_);
  first_triangle_.swap(other.first_triangle_);
  return *this;
}

EmbreeScene::~EmbreeScene() {
  if (scene_ != nullptr) rtcReleaseScene(scene_);
  if (device_ != nullptr) rtcReleaseDevice(device_);
}

void EmbreeScene::intersect(const int* valid, RTCRayHit16& packet) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect16(valid, scene_, &context, &packet);
}

void EmbreeScene::occlude(const int* valid, RTCRay16& packet) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcOccluded16(valid, scene_, &context, &packet);
}

void EmbreeScene::add_triangles(const Scene& scene,
                                std::span<const std::vector<Triangle>> triangles) {
  std::vector<float> coordinates;
  std::vector<std::uint32_t> indices;
  std::vector<std::int32_t> owners;
  first_triangle_.resize(scene.primitives.size());
  for (std::size_t k = 0; k < scene.primitives.size(); ++k) {
    first_triangle_[k] = static_cast<std::uint32_t>(owners.size());
    const auto* polygon = std::get_if<Polygon>(&scene.primitives[k].shape);
    const auto* mesh = std::get_if<Mesh>(&scene.primitives[k].shape);
    if (polygon == nullptr && mesh == nullptr) continue;
    const auto first = static_cast<std::uint32_t>(coordinates.size() / 3);
    for (const Vector3d& vertex : mesh != nullptr ? mesh->vertices : polygon->vertices)
      for (const double coordinate : vertex) coordinates.push_back(static_cast<float>(coordinate));
    for (const Triangle& triangle : mesh != nullptr ? mesh->triangles : triangles[k]) {
      for (const std::uint32_t corner : triangle) indices.push_back(first + corner);
      owners.push_back(static_cast<std::int32_t>(k));
    }
  }
  if (owners.empty()) return;

  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* vertex_buffer =
      rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                              3 * sizeof(float), coordinates.size() / 3);
  void* index_buffer = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                               3 * sizeof(std::uint32_t), indices.size() / 3);
  if (vertex_buffer != nullptr && index_buffer != nullptr) {
    std::copy(coordinates.begin(), coordinates.end(), static_cast<float*>(vertex_buffer));
    std::copy(indices.begin(), indices.end(), static_cast<std::uint32_t*>(index_buffer));
  }
  first_part_.push_back(static_cast<std::uint32_t>(primitives_.size()));
  primitives_.insert(primitives_.end(), owners.begin(), owners.end());
  add(geometry);
}

template <typename Shape, typename Rounded>
void EmbreeScene::add_round_shapes(const Scene& scene, double overlap,
                                   std::vector<Rounded>& shapes) {
  const auto first_part = static_cast<std::uint32_t>(primitives_.size());
  for (std::size_t k = 0; k < scene.primitives.size(); ++k) {
    const auto* shape = std::get_if<Shape>(&scene.primitives[k].shape);
    if (shape == nullptr) continue;
    shapes.push_back(rounded(*shape, overlap));
    primitives_.push_back(static_cast<std::int32_t>(k));
  }
  if (shapes.empty()) return;

  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
  set_shapes(geometry, shapes.data(), static_cast<unsigned>(shapes.size()));
  first_part_.push_back(first_part);
  add(geometry);
}

// Geometries are numbered in the order in which they are added.
void EmbreeScene::add(RTCGeometry geometry) {
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
}

}  // namespace aspect
