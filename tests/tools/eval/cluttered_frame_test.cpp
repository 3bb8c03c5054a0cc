// Frames made in clutter, held against a plain rendering of the same object by the same camera.
#include "tools/eval/cluttered_frame.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "compiler/scene/bob_reader.h"

namespace aspect {
namespace {

using Pixel = ClutteredFrame::Pixel;

Scene small_scene(const std::string& name) {
  Result<Scene> scene = read_bob(ASPECT_SOURCE_DIR "/tests/data/rendered/" + name + ".b");
  REQUIRE(scene.ok());
  scene.value().studio.width_px = 120;
  scene.value().studio.height_px = 100;
  scene.value().studio.aspect = 1.2;
  return std::move(scene).value();
}

// All of one colour that nothing random comes near to.
Scene pure_red_scene() {
  Scene scene = small_scene("l_shape");
  for (Surface& surface : scene.surfaces) surface.ambient = {1, 0, 0};
  return scene;
}

LitObject lit(const Scene& scene) {
  Result<LitObject> object = LitObject::create(scene);
  REQUIRE(object.ok());
  return std::move(object).value();
}

double share_of_red(const ClutteredFrame& frame, std::size_t pixel) {
  const std::uint8_t* rgb = &frame.rgb[3 * pixel];
  return rgb[0] / std::max(1.0, static_cast<double>(rgb[0]) + rgb[1] + rgb[2]);
}

}  // namespace

TEST_CASE("A frame's truth is what a plain rendering shows, less what is hidden") {
  const Scene scene = small_scene("blockcyl1");
  const LitObject object = lit(scene);
  const Result<Renderer> plain = Renderer::create(scene);
  REQUIRE(plain.ok());
  for (std::size_t number = 0; number < 25; ++number) {
    const ClutteredFrame frame =
        make_cluttered_frame(scene, object, true, {}, dice_of_frame(7, 0, number));
    Picture picture;
    plain.value().render(frame.camera, picture);
    REQUIRE(picture.surface.size() == frame.pixels.size());
    std::size_t all = 0, visible = 0;
    int left = 1000, top = 1000, right = -1, bottom = -1;
    for (int y = 0; y < frame.height_px; ++y)
      for (int x = 0; x < frame.width_px; ++x) {
        const auto k = static_cast<std::size_t>(y * frame.width_px + x);
        CHECK((frame.pixels[k] != Pixel::other) == (picture.surface[k] != 0));
        if (picture.surface[k] == 0) continue;
        ++all;
        // It is wholly in the picture.
        CHECK((x > 0 && y > 0 && x + 1 < frame.width_px && y + 1 < frame.height_px));
        if (frame.pixels[k] == Pixel::hidden) continue;
        ++visible;
        left = std::min(left, x), right = std::max(right, x);
        top = std::min(top, y), bottom = std::max(bottom, y);
      }
    REQUIRE(all > 100);
    CHECK(frame.visible == Approx(static_cast<double>(visible) / static_cast<double>(all)));
    CHECK(frame.box == Box{left, top, right - left + 1, bottom - top + 1});
  }
}

TEST_CASE("What is visible shows the object, and what is hidden does not") {
  const Scene scene = pure_red_scene();
  const LitObject object = lit(scene);
  double visible = 0, visible_red = 0, hidden = 0, hidden_red = 0;
  for (std::size_t number = 0; number < 20; ++number) {
    const ClutteredFrame frame =
        make_cluttered_frame(scene, object, true, {}, dice_of_frame(1, 0, number));
    for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
      const bool is_red = share_of_red(frame, k) > 0.8;
      if (frame.pixels[k] == Pixel::visible) ++visible, visible_red += is_red ? 1 : 0;
      if (frame.pixels[k] == Pixel::hidden) ++hidden, hidden_red += is_red ? 1 : 0;
    }
  }
  REQUIRE(hidden > 1000);
  // Borders are blurred, and so narrow pictures are mostly borders.
  CHECK(visible_red > 0.8 * visible);
  CHECK(hidden_red < 0.1 * hidden);
}

TEST_CASE("Some frames hide nothing, others hide up to what was asked, none hides more") {
  const Scene scene = small_scene("cube");
  const LitObject object = lit(scene);
  const auto hidden_shares = [&](double most) {
    std::vector<double> shares;
    ClutterSettings settings;
    settings.hidden_max = most;
    for (std::size_t number = 0; number < 60; ++number)
      shares.push_back(
          1 -
          make_cluttered_frame(scene, object, true, settings, dice_of_frame(3, 0, number)).visible);
    return shares;
  };
  for (const double most : {0.3, 0.7}) {
    const std::vector<double> shares = hidden_shares(most);
    CHECK(*std::max_element(shares.begin(), shares.end()) <= most);
    CHECK(*std::max_element(shares.begin(), shares.end()) > 0.8 * most);
    const auto none = std::count(shares.begin(), shares.end(), 0.0);
    CHECK(none >= 12);
    CHECK(none <= 32);
  }
  for (const double share : hidden_shares(0)) CHECK(share == 0);
}

TEST_CASE("Frames differ by seed, object and number, and by nothing else") {
  const Scene scene = small_scene("cube");
  const LitObject object = lit(scene);
  const auto frame_of = [&](std::uint64_t seed, std::size_t place, std::size_t number) {
    return make_cluttered_frame(scene, object, true, {}, dice_of_frame(seed, place, number)).rgb;
  };
  const auto first = frame_of(1, 0, 0);
  CHECK(first == frame_of(1, 0, 0));
  CHECK(first != frame_of(2, 0, 0));
  CHECK(first != frame_of(1, 1, 0));
  CHECK(first != frame_of(1, 0, 1));
}

TEST_CASE("A frame without the object tells of none") {
  const Scene scene = pure_red_scene();
  const ClutteredFrame frame =
      make_cluttered_frame(scene, lit(scene), false, {}, dice_of_frame(1, 0, 3));
  CHECK_FALSE(frame.has_object);
  CHECK(frame.box.empty());
  for (const Pixel pixel : frame.pixels) CHECK(pixel == Pixel::other);
  CHECK(is_empty_frame(3));
  CHECK_FALSE(is_empty_frame(4));
}

TEST_CASE("Backgrounds are pieces of the pictures given") {
  const Scene scene = small_scene("cube");
  const LitObject object = lit(scene);
  // Pure green: no shape in a random colour is.
  const std::vector<cv::Mat> pictures = {cv::Mat(200, 90, CV_8UC3, cv::Scalar(0, 200, 0))};
  const auto green = [&](std::span<const cv::Mat> backgrounds) {
    std::size_t count = 0;
    const ClutteredFrame frame =
        make_cluttered_frame(scene, object, false, {0.7, backgrounds}, dice_of_frame(1, 0, 3));
    for (std::size_t k = 0; k < frame.pixels.size(); ++k) {
      const std::uint8_t* rgb = &frame.rgb[3 * k];
      count += rgb[1] > 80 && rgb[0] < 20 && rgb[2] < 20 ? 1U : 0U;
    }
    return count;
  };
  CHECK(green(pictures) > 3000);
  CHECK(green({}) < 300);
}

TEST_CASE("A lamp changes how light an object's surfaces are, not their colours") {
  Scene scene = small_scene("cube");
  scene.studio.ambient = {0.7, 0.8, 1};
  const LitObject object = lit(scene);
  const Result<Renderer> plain = Renderer::create(scene);
  REQUIRE(plain.ok());
  double darkest = 1, lightest = 0;
  for (std::size_t number = 0; number < 10; ++number) {
    Dice dice(number);
    const Camera camera = camera_at(scene.studio, dice.direction());
    Picture flat, shaded;
    plain.value().render(camera, flat);
    object.seen_from(camera.position_object.normalized(), dice).render(camera, shaded);
    for (std::size_t k = 0; k < flat.surface.size(); ++k) {
      REQUIRE(shaded.surface[k] == flat.surface[k]);
      if (flat.surface[k] == 0) continue;
      const auto sum = [k](const Picture& picture) {
        const std::uint8_t* rgb = &picture.rgb[3 * k];
        return static_cast<double>(rgb[0]) + rgb[1] + rgb[2];
      };
      const double light = sum(shaded) / sum(flat);
      darkest = std::min(darkest, light), lightest = std::max(lightest, light);
      for (std::size_t c = 3 * k; c < 3 * k + 3; ++c)
        CHECK(std::abs(shaded.rgb[c] - light * flat.rgb[c]) <= 1.5);
    }
  }
  CHECK(darkest > 0.38);
  CHECK(darkest < 0.7);
  CHECK(lightest > 0.8);
  CHECK(lightest < 1.02);
}

TEST_CASE("A scene's own lamps stay") {
  Scene scene = small_scene("cube");
  scene.studio.ambient.setConstant(0.2);
  scene.lights.emplace_back().position = {3, 4, 5};
  const LitObject object = lit(scene);
  const Result<Renderer> plain = Renderer::create(scene);
  REQUIRE(plain.ok());
  Dice dice(1);
  const Camera camera = camera_at(scene.studio, dice.direction());
  Picture expected, seen;
  plain.value().render(camera, expected);
  object.seen_from({0, 0, 1}, dice).render(camera, seen);
  CHECK(seen.rgb == expected.rgb);
}

}  // namespace aspect
