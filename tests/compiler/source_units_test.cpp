// Meshes are centred and scaled to be compiled; a device knows nothing of that.
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "compiler/compile.h"
#include "compiler/render/camera.h"
#include "compiler/render/renderer.h"
#include "compiler/scene/mesh_reader.h"
#include "runtime/recognition/sized_recogniser.h"
#include "tests/compiler/aspects/compiled_model.h"

namespace aspect {
namespace {

// A box of three by two by one, each side of its own colour, in such units and at such a place.
std::string box_ply(double unit, const Eigen::Vector3d& place) {
  std::string text =
      "ply\nformat ascii 1.0\nelement vertex 8\nproperty double x\nproperty double y\nproperty "
      "double z\nelement face 6\nproperty list uchar int vertex_indices\nproperty uchar "
      "red\nproperty uchar green\nproperty uchar blue\nend_header\n";
  for (int k = 0; k < 8; ++k) {
    const Eigen::Vector3d corner(k % 2 * 3, k / 2 % 2 * 2, k / 4);
    const Eigen::Vector3d at = unit * corner + place;
    text +=
        std::to_string(at.x()) + " " + std::to_string(at.y()) + " " + std::to_string(at.z()) + "\n";
  }
  return text +
         "4 0 2 3 1 220 30 30\n4 4 5 7 6 30 180 40\n4 0 1 5 4 30 50 220\n"
         "4 2 6 7 3 220 200 30\n4 0 4 6 2 200 40 180\n4 1 3 7 5 30 190 200\n";
}

struct Compiled {
  Scene scene;
  ClassIndex index;
};

Compiled compiled(double unit, const Eigen::Vector3d& place) {
  Compiled made{parse_mesh(box_ply(unit, place), "box.ply").value(), {}};
  const std::vector<std::uint8_t> bytes = index_bytes_of(made.scene, options_of_level(2));
  made.index = parse_index(std::as_bytes(std::span(bytes)), "box").value();
  return made;
}

Eigen::Vector3d eigen(const Vector3d& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

TEST_CASE("an index of a mesh, and its poses, are in the units and coordinates of the file") {
  const Eigen::Vector3d place(5000, -200, 70);
  const Compiled small = compiled(1, {0, 0, 0}), large = compiled(25, place);
  CHECK(eigen(large.index.extent.least).isApprox(place, 1e-6));
  CHECK(eigen(large.index.extent.most).isApprox(place + 25 * Eigen::Vector3d(3, 2, 1), 1e-6));
  CHECK(large.index.extent.diameter == Approx(25 * std::sqrt(14)));
  CHECK(large.index.model.error == Approx(25 * small.index.model.error).margin(1e-9));
  CHECK(eigen(large.index.model.centre).isApprox(place + 25 * Eigen::Vector3d(1.5, 1, 0.5), 1e-6));

  const Scene& scene = large.scene;
  const Renderer renderer = Renderer::create(scene).value();
  const Camera camera = camera_at(scene.studio, Eigen::Vector3d(1, 0.7, 0.5).normalized());
  Picture picture;
  renderer.render(camera, picture);
  const Frame frame{picture.rgb.data(), picture.width_px, picture.height_px,
                    std::ptrdiff_t{3} * picture.width_px, PixelFormat::rgb8};
  const auto pose_by = [&](const ClassIndex& index) {
    SizedRecogniser recogniser({&index, 1}, {});
    recogniser.make_room(frame.width_px, frame.height_px);
    const Recognition seen = recogniser.recognise(frame);
    REQUIRE(seen.objects.size() == 1);
    REQUIRE(seen.objects[0].judgement.verdict == Verdict::match);
    return seen.objects[0].hypotheses[0].pose->refined.pose;
  };
  const RigidPose by_large = pose_by(large.index), by_small = pose_by(small.index);
  // The camera is where the scene's file has it.
  const Eigen::Vector3d camera_source = scene.source_from_object(camera.position_object);
  const Eigen::Vector3d at =
      eigen(by_large({camera_source.x(), camera_source.y(), camera_source.z()}));
  CHECK(at.norm() < 0.005 * scene.source_from_object.scale * scene.studio.distance);
  // Each tells the same of one corner of the box, in its own units.
  const Eigen::Vector3d corner = eigen(by_large({5000 + 75, -200, 70 + 25}));
  CHECK((corner - 25 * eigen(by_small({3, 0, 1}))).norm() < 1e-3 * corner.norm());
}

}  // namespace aspect
