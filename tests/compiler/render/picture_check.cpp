#include "tests/compiler/render/picture_check.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "tests/compiler/render/reference_tracer.h"

namespace aspect {
namespace {

bool is_border(const Scene& scene, const Camera& camera, int x, int y, int surface) {
  constexpr double kBorder = 0.01;
  for (const double dx : {-kBorder, 0.0, kBorder})
    for (const double dy : {-kBorder, 0.0, kBorder})
      if (reference_hit(scene, camera, x + dx, y + dy).surface != surface) return true;
  return false;
}

template <typename Value>
bool same(const std::vector<Value>& a, const std::vector<Value>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Value)) == 0;
}

}  // namespace

PictureComparison compare_with_reference(const Scene& scene, const Camera& camera,
                                         const Picture& picture) {
  PictureComparison result;
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < picture.width_px; ++x) {
      const auto k = static_cast<std::size_t>(y * picture.width_px + x);
      const ReferenceHit truth = reference_hit(scene, camera, x, y);
      if (truth.surface != 0) ++result.foreground;
      if (is_border(scene, camera, x, y, truth.surface)) continue;
      ++result.compared;
      if (picture.surface[k] != truth.surface) {
        if (result.wrong_id++ == 0)
          result.first_wrong = "x " + std::to_string(x) + " y " + std::to_string(y) + ": " +
                               std::to_string(picture.surface[k]) + ", not " +
                               std::to_string(truth.surface);
      } else if (truth.surface != 0) {
        result.worst_depth =
            std::max(result.worst_depth, std::abs(double{picture.depth[k]} - truth.depth));
      }
    }
  return result;
}

void require_like_reference(const Scene& scene, const Renderer& renderer, const Camera& camera) {
  Picture picture;
  renderer.render(camera, picture);
  const PictureComparison found = compare_with_reference(scene, camera, picture);
  INFO(found.first_wrong);
  REQUIRE(found.compared * 50 >= picture.width_px * picture.height_px * 49);
  REQUIRE(found.wrong_id == 0);
  REQUIRE(found.worst_depth < 1e-4);
}

bool same_bytes(const Picture& a, const Picture& b) {
  return a.width_px == b.width_px && a.height_px == b.height_px && same(a.rgb, b.rgb) &&
         same(a.surface, b.surface) && same(a.depth, b.depth) && a.foreground == b.foreground;
}

}  // namespace aspect
