#include "tools/explain/faces.h"

#include <catch2/catch.hpp>

#include "tests/compiler/aspects/symmetric_scenes.h"
#include "tools/explain/colour_cure.h"

namespace aspect {

TEST_CASE("polygons of one colour in one plane are one face, whatever their winding") {
  Scene scene = block_scene({.2, .2, .2}, {0, 1, 2, 2, 4, 5});
  CHECK(faces_of(scene).all.size() == 6);
  // The first face in two triangles, of either winding.
  const auto v = std::get<Polygon>(scene.primitives[0].shape).vertices;
  scene.primitives[0].shape = Polygon{{v[0], v[1], v[2]}};
  scene.primitives.push_back({Polygon{{v[3], v[2], v[0]}}, 0});
  scene.primitives.push_back({Polygon{{v[0], v[1], v[2]}}, 7});
  const Faces faces = faces_of(scene);
  REQUIRE(faces.all.size() == 7);
  CHECK(faces.all[0].primitives == std::vector<std::uint16_t>{1, 7});
  CHECK(faces.face_of[7] == faces.face_of[1]);
  CHECK(faces.face_of[8] == 6);
  CHECK(faces.all[3].colour == test_colour(2));
}

TEST_CASE("a face that is painted shows its new colour, and no other does") {
  Scene scene = block_scene({.2, .2, .2}, {0, 0, 0, 0, 0, 0});
  scene.studio.ambient = {.5, .8, 1};
  const Eigen::Vector3d wanted(.4, .4, .1);
  paint(scene, faces_of(scene).all[2], wanted);
  const Faces after = faces_of(scene);
  for (std::size_t k = 0; k < 6; ++k) CHECK(after.all[k].colour.isApprox(wanted) == (k == 2));
}

TEST_CASE("colours are apart by the largest difference of a share, in steps of the segmentation") {
  VisionParameters vision;
  vision.chroma_step = 8;
  vision.noise_steps = 0;
  // Shares 1/2 1/2 0 and 1/2 0 1/2 of 255.
  CHECK(colour_separation({.5, .5, 0}, {1, 0, 1}, vision) == Approx(127.5 / 8));
  CHECK(colour_separation({.2, .4, .4}, {.4, .8, .8}, vision) == Approx(0).margin(1e-12));
  vision.noise_steps = 3;
  CHECK(colour_separation({.5, .5, 0}, {1, 0, 1}, vision) == Approx(127.5 / 11));
  CHECK(colour_separation({.05, .05, 0}, {1, 0, 1}, vision) == 0);  // black is not seen
}

TEST_CASE("the colour proposed is farther from all others than the one mistaken") {
  const Scene scene = block_scene({.2, .2, .2}, {0, 0, 1, 2, 3, 4});
  const Faces faces = faces_of(scene);
  const VisionParameters vision;
  const auto changes = colour_changes({{0, 1, 10, 0}, {2, 3, 1, 0}}, faces, vision, palette());
  REQUIRE(changes.size() == 1);  // a tenth of the views is not worth another colour
  CHECK(changes[0].face == 1);
  for (std::size_t k = 0; k < 6; ++k)
    if (k != 1)
      CHECK(colour_separation(changes[0].colour, faces.all[k].colour, vision) >=
            changes[0].separation);
  CHECK(changes[0].separation > 3);
  CHECK(colour_changes({{2, 3, 10, 9.5}}, faces, vision, palette()).empty());
}

}  // namespace aspect
