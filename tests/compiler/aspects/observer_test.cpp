#include "compiler/aspects/observer.h"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "compiler/scene/bob_reader.h"

namespace aspect {
namespace {

// Two squares side by side off the centre of what the camera looks at.
Scene scene_of(const std::string& projection) {
  Result<Scene> scene =
      parse_bob("studio { up 0 1 0 resolution 256 256 ambient 1 1 1 " + projection +
                    " } transform { translate .05 .08 .1 }"
                    "surface { diffuse .9 .2 .2 } "
                    "polygon { points 4 vertex -.2 0 0 vertex 0 0 0 vertex 0 .2 0 vertex -.2 .2 0 }"
                    "surface { diffuse .2 .2 .9 } "
                    "polygon { points 4 vertex 0 0 0 vertex .2 0 0 vertex .2 .2 0 vertex 0 .2 0 }"
                    "transform_pop",
                "s.b");
  if (!scene) FAIL(scene.error());
  return std::move(scene).value();
}

void require_centres(const std::string& projection, const Eigen::Vector3d& direction,
                     double tolerance) {
  const Scene scene = scene_of(projection);
  const Result<Renderer> renderer = Renderer::create(scene);
  REQUIRE(renderer.ok());
  Observer observer(renderer.value(), scene.studio, VisionParameters{});
  const ObservedView view = observer.observe(direction.normalized());
  REQUIRE(view.contours.size() == 2);
  for (const ObservedContour& contour : view.contours) {
    REQUIRE(contour.surfaces.size() == 1);
    const double side = contour.surfaces.front().surface == 1 ? -.1 : .1;
    const Eigen::Vector3d found(double{contour.centre_object[0]}, double{contour.centre_object[1]},
                                double{contour.centre_object[2]});
    INFO(projection << ": " << found.transpose());
    CHECK((found - Eigen::Vector3d(.05 + side, .18, .1)).norm() < tolerance);
  }
}

}  // namespace

TEST_CASE("a contour lies where its surface does, in both projections") {
  require_centres("angle 60", {0, 0, 1}, .003);
  require_centres("project flat 1", {0, 0, 1}, .003);
  require_centres("project flat 1", {.5, .3, 1}, .004);
}

}  // namespace aspect
