// Colours counted in pictures made by hand.
#include "tools/explain/background_colours.h"

#include <catch2/catch.hpp>

#include "tests/compiler/aspects/symmetric_scenes.h"
#include "tools/explain/background_advice.h"

namespace aspect {
namespace {

constexpr int kIntensityMin = 48;

cv::Mat picture_of(int width, int height, const cv::Vec3b& rgb) {
  return {height, width, CV_8UC3, cv::Scalar(rgb[0], rgb[1], rgb[2])};
}

void fill(cv::Mat& picture, const cv::Rect& box, const cv::Vec3b& rgb) {
  picture(box).setTo(cv::Scalar(rgb[0], rgb[1], rgb[2]));
}

ColourPresence presence(const Eigen::Vector3d& colour, const std::vector<cv::Mat>& pictures) {
  return presence_of({&colour, 1}, pictures, kIntensityMin).front();
}

const Eigen::Vector3d kRed(.8, .1, .1), kGreen(.1, .8, .1), kGrey(.5, .5, .5);

const BackgroundColour& colour_of_surface(const BackgroundColours& colours, std::uint16_t surface) {
  for (const BackgroundColour& colour : colours.colours)
    if (colour.face.primitives.front() == surface) return colour;
  FAIL("no such colour");
  return colours.colours.front();
}

}  // namespace

TEST_CASE("Pixels of a colour are counted over all pictures, dark and light ones alike") {
  cv::Mat first = picture_of(100, 50, {100, 100, 100}), second = picture_of(50, 40, {0, 0, 0});
  fill(first, {10, 10, 20, 10}, {240, 30, 30});
  fill(first, {40, 10, 5, 10}, {40, 5, 5});
  fill(second, {0, 0, 10, 10}, {80, 10, 10});
  const std::vector<cv::Mat> pictures = {first, second};
  CHECK(presence(kRed, pictures).pixels == Approx(350.0 / 7000));
  CHECK(presence(kGreen, pictures).pixels == 0);
  CHECK(presence(kGrey, pictures).pixels == Approx(4750.0 / 7000));
}

TEST_CASE("A colour reaches as far as the recogniser's, and dark pixels are of none") {
  // Shares .8 .1 .1; off by .07 and -.07 is a distance of .099, by .072 one of .102.
  CHECK(presence(kRed, {picture_of(9, 9, {73, 17, 10})}).pixels == 1);
  CHECK(presence(kRed, {picture_of(9, 9, {182, 43, 25})}).pixels == 0);
  CHECK(presence(kRed, {picture_of(9, 9, {40, 4, 4})}).pixels == 1);
  CHECK(presence(kRed, {picture_of(9, 9, {39, 4, 4})}).pixels == 0);
  CHECK(presence(kGrey, {picture_of(9, 9, {0, 0, 0})}).pixels == 0);
}

TEST_CASE("A picture has a region where pixels hang together by their sides") {
  // A thousandth of 100 x 100 pixels are ten.
  cv::Mat nine = picture_of(100, 100, {100, 100, 100}), ten = nine.clone(), apart = nine.clone();
  fill(nine, {5, 5, 9, 1}, {200, 25, 25});
  fill(ten, {5, 5, 10, 1}, {200, 25, 25});
  fill(apart, {5, 5, 5, 1}, {200, 25, 25});
  fill(apart, {10, 6, 5, 1}, {200, 25, 25});
  CHECK(presence(kRed, {nine}).pictures == 0);
  CHECK(presence(kRed, {ten}).pictures == 1);
  CHECK(presence(kRed, {apart}).pictures == 0);
  CHECK(presence(kRed, {nine, ten, apart, ten}).pictures == 0.5);
  CHECK(presence(kRed, {}).pictures == 0);
}

TEST_CASE("A colour is common by its pixels or by its pictures, and rare by both") {
  CHECK(commonness_of({0, 0}) == Commonness::rare);
  CHECK(commonness_of({0.001, 0.09}) == Commonness::rare);
  CHECK(commonness_of({0.001, 0.1}) == Commonness::occasional);
  CHECK(commonness_of({0.01, 0.05}) == Commonness::occasional);
  CHECK(commonness_of({0.02, 0.05}) == Commonness::common);
  CHECK(commonness_of({0.001, 0.25}) == Commonness::common);
}

TEST_CASE("For a common colour one is proposed that is rare and far from all others") {
  // Before the colour of two faces: the best paint for them is another.
  const Scene scene = block_scene({.2, .2, .2}, {0, 0, 1, 2, 3, 4});
  const Faces faces = faces_of(scene);
  VisionParameters vision;
  const auto byte_colour = [](const Eigen::Vector3d& c) {
    return cv::Vec3b(cv::saturate_cast<std::uint8_t>(255 * c.x()),
                     cv::saturate_cast<std::uint8_t>(255 * c.y()),
                     cv::saturate_cast<std::uint8_t>(255 * c.z()));
  };
  BackgroundPictures pictures{"room", 1, {picture_of(100, 100, byte_colour(test_colour(0)))}};
  const auto report = [&] {
    return background_colours(faces, pictures, palette_before(pictures, vision), vision);
  };
  const BackgroundColours before = report();
  REQUIRE(before.colours.size() == 5);
  CHECK(before.folder == "room");
  CHECK(before.pictures == 1);
  const BackgroundColour& first = before.colours.front();
  CHECK(first.face.primitives == std::vector<std::uint16_t>{1, 2});
  CHECK(first.commonness == Commonness::common);
  CHECK(first.presence.pixels == 1);
  REQUIRE(first.better);
  CHECK(first.better->paint.commonness == Commonness::rare);
  for (std::uint16_t surface = 3; surface <= 6; ++surface) {
    const BackgroundColour& other = colour_of_surface(before, surface);
    CHECK(other.commonness == Commonness::rare);
    CHECK_FALSE(other.better);
    CHECK(colour_separation(first.better->paint.colour, other.face.colour, vision) >=
          first.better->separation - 1e-9);
  }
  CHECK(first.better->separation > 4);

  // Where that paint is common as well, another one is proposed.
  pictures.rgb.push_back(picture_of(100, 100, byte_colour(first.better->paint.colour)));
  const BackgroundColours after = report();
  REQUIRE(after.colours.front().better);
  CHECK(after.colours.front().better->paint.name != first.better->paint.name);
  CHECK(after.colours.front().better->paint.commonness == Commonness::rare);
}

TEST_CASE(
    "Surfaces that are seen as black are no colour, and without a palette nothing is better") {
  Scene scene = block_scene({.2, .2, .2}, {0, 1, 2, 3, 4, 5});
  const Surface& first = scene.surfaces[static_cast<std::size_t>(scene.primitives[0].surface)];
  const cv::Vec3b seen(cv::saturate_cast<std::uint8_t>(255 * test_colour(1).x()),
                       cv::saturate_cast<std::uint8_t>(255 * test_colour(1).y()),
                       cv::saturate_cast<std::uint8_t>(255 * test_colour(1).z()));
  scene.surfaces[static_cast<std::size_t>(scene.primitives[0].surface)].ambient =
      first.ambient * 0.01;
  const BackgroundPictures pictures{"room", 1, {picture_of(10, 10, seen)}};
  const BackgroundColours colours = background_colours(faces_of(scene), pictures, {}, {});
  REQUIRE(colours.colours.size() == 5);
  CHECK(colours.colours.front().commonness == Commonness::common);
  CHECK_FALSE(colours.colours.front().better);
}

}  // namespace aspect
