// Objects where there is no background, side by side, in a crowd, and cut by the picture's border.
#include "runtime/recognition/scene_search.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/rounds.h"
#include "tests/runtime/recognition/owned_recogniser.h"
#include "tests/runtime/recognition/painted_scene.h"
#include "tests/runtime/recognition/rendered_views.h"

namespace aspect {
namespace {

constexpr int kSide_px = 512;
constexpr double kField_deg = 50, kPerRad_deg = 57.29577951308232;
constexpr std::array kNames{"cube", "l_shape"};
const CameraModel kSceneCamera = centred_camera(kField_deg, kSide_px, kSide_px);

OwnedFrame black(int width_px, int height_px) {
  const auto pixels = static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
  return {width_px, height_px, std::vector<std::uint8_t>(3 * pixels)};
}

// For frames of any size whose object was looked at with kSceneCamera.
OwnedRecogniser recogniser(int height_px = kSide_px) {
  RecogniserParameters parameters;
  parameters.camera = CalibratedCamera{kSceneCamera, 0};
  return {cube_and_l_shape(), parameters, kSide_px, height_px};
}

bool is_match(const SeenObject& object) {
  return object.judgement.verdict == Verdict::match;
}

std::size_t matches(const Recognition& seen) {
  return static_cast<std::size_t>(
      std::count_if(seen.objects.begin(), seen.objects.end(), is_match));
}

// The match of an index that is nearest to a pose, in degrees of turn; infinite: there is none.
double least_turn_deg(const Recognition& seen, std::size_t index, const Rotation& rotation) {
  double least = std::numeric_limits<double>::infinity();
  for (const SeenObject& object : seen.objects) {
    if (!is_match(object)) continue;
    const Hypothesis& best = object.hypotheses[0];
    REQUIRE(best.pose != nullptr);
    if (best.index == index)
      least = std::min(least,
                       kPerRad_deg * angle_between_rad(best.pose->refined.pose.rotation, rotation));
  }
  return least;
}

bool names_another(const Recognition& seen, std::size_t index) {
  return std::any_of(seen.objects.begin(), seen.objects.end(), [&](const SeenObject& object) {
    return is_match(object) && object.hypotheses[0].index != index;
  });
}

// Cube and l_shape side by side, their centres so many radii apart, one a little behind the other,
// each any way up. Neither has a symmetry.
using Pair = std::array<PlacedModel, 2>;
Pair random_pair(std::mt19937& random, double apart) {
  std::uniform_real_distribution<double> roll(-3, 3);
  const bool cube_before = random() % 2 == 0;
  Pair pair;
  for (std::size_t i = 0; i < 2; ++i) {
    const ObjectModel& model = cube_and_l_shape()[i].model;
    const Eigen::Vector3d d = random_direction(random);
    const double depth = cube_before == (i == 0) ? 5 : 5.4, side = (i == 0 ? -apart : apart) / 2;
    const Rotation rotation =
        turn_about({0, 0, 1}, roll(random)) * camera_from_object({d.x(), d.y(), d.z()}, model.up);
    const Vector3d centre{model.radius * side, 0, model.radius * depth};
    pair[i] = {&model, {rotation, centre - rotation(model.centre)}};
  }
  return pair;
}

// How many of the two are found where they are.
std::size_t found_of(const Pair& pair, const Recognition& seen) {
  constexpr double kNear_deg = 6;
  std::size_t found = 0;
  for (std::size_t i = 0; i < 2; ++i)
    found += least_turn_deg(seen, i, pair[i].pose.rotation) < kNear_deg ? 1U : 0U;
  return found;
}

void fill(OwnedFrame& frame, const Box& box, const std::array<std::uint8_t, 3>& rgb) {
  for (int y = std::max(0, box.y); y < std::min(frame.height_px, box.y + box.height); ++y)
    for (int x = std::max(0, box.x); x < std::min(frame.width_px, box.x + box.width); ++x)
      std::copy_n(rgb.begin(), 3, frame.rgb.begin() + std::ptrdiff_t{3} * (y * frame.width_px + x));
}

// Squares of the cube's colours in rows below each other, a gap between them.
void strew_squares(OwnedFrame& frame, int count, int first_row_px, std::mt19937& random) {
  constexpr int kStep_px = 20, kSquare_px = 11, kMargin_px = 5;
  const auto& shares = cube_and_l_shape()[0].model.shares;
  const int in_row = frame.width_px / kStep_px;
  for (int k = 0; k < count; ++k) {
    std::array<std::uint8_t, 3> rgb;
    const std::array<float, 3>& share = shares[random() % shares.size()];
    for (std::size_t c = 0; c < 3; ++c) rgb[c] = static_cast<std::uint8_t>(300 * share[c]);
    fill(frame,
         {kMargin_px + kStep_px * (k % in_row), first_row_px + kStep_px * (k / in_row), kSquare_px,
          kSquare_px},
         rgb);
  }
}

// The first columns of a frame, as many as hold such a share of what is not black.
OwnedFrame cut(const OwnedFrame& frame, double share) {
  const auto is_lit = [&](int x, int y) {
    const auto* p = &frame.rgb[static_cast<std::size_t>(3 * (y * frame.width_px + x))];
    return p[0] + p[1] + p[2] >= 48;
  };
  std::vector<int> lit(static_cast<std::size_t>(frame.width_px));
  int all = 0;
  for (int y = 0; y < frame.height_px; ++y)
    for (int x = 0; x < frame.width_px; ++x) {
      lit[static_cast<std::size_t>(x)] += is_lit(x, y) ? 1 : 0;
      all += is_lit(x, y) ? 1 : 0;
    }
  int width = 0;
  for (int held = 0; held < share * all; ++width) held += lit[static_cast<std::size_t>(width)];
  OwnedFrame left = black(width, frame.height_px);
  paste(frame, 0, 0, left);
  return left;
}

// Those that stand alone are blobs, largest first; the others come behind them.
void check_order(const Recognition& seen) {
  CHECK(seen.objects.size() <= 64);
  std::size_t next_blob = 0;
  bool are_alone = true;
  for (const SeenObject& object : seen.objects) {
    REQUIRE(object.blob < seen.graph.blobs.size());
    const Box &box = object.box, &blob = seen.graph.blobs[object.blob].box;
    const bool is_alone = box.x == blob.x && box.y == blob.y && box.width == blob.width &&
                          box.height == blob.height && object.blob >= next_blob;
    CHECK((are_alone || !is_alone));
    are_alone = is_alone;
    if (is_alone) next_blob = object.blob + 1;
    if (!is_alone) CHECK(is_match(object));
  }
}

}  // namespace

TEST_CASE("an object before bright stripes is found, and stands as it does before black") {
  std::mt19937 random(21);
  OwnedRecogniser owned = recogniser();
  std::size_t all = 0, found = 0, near = 0;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    ModelCamera camera(kNames[i]);
    for (int k = 0; k < rounds(12); ++k) {
      const OwnedFrame frame = camera.view(random_direction(random), k);
      OwnedFrame scene = striped(kSide_px, kSide_px);
      paste(frame, 0, 0, scene);
      const Recognition alone = owned.recognise(frame.frame());
      REQUIRE((alone.objects.size() == 1 && is_match(alone.objects[0])));
      const int regions = alone.objects[0].regions;
      const Rotation rotation = alone.objects[0].hypotheses[0].pose->refined.pose.rotation;
      const Recognition seen = owned.recognise(scene.frame());
      CHECK(seen.objects.size() == 1);
      CHECK_FALSE(names_another(seen, i));
      // Two colours side by side are found on many things.
      if (regions < 3) continue;
      const double turn_deg = least_turn_deg(seen, i, rotation);
      ++all;
      found += turn_deg < 2 ? 1U : 0U;
      near += turn_deg < 1 ? 1U : 0U;
    }
  }
  CHECK(all > 0);
  CHECK(found == all);
  CHECK(20 * near >= 17 * all);
}

TEST_CASE("two objects that touch or hide a part of each other are both found where they are") {
  std::mt19937 random(22);
  OwnedRecogniser owned = recogniser();
  const auto all = static_cast<std::size_t>(rounds(24));
  std::size_t touching = 0, found = 0, both = 0;
  for (std::size_t k = 0; k < all; ++k) {
    const Pair pair = random_pair(random, 1.3);
    OwnedFrame frame = k % 2 == 0 ? black(kSide_px, kSide_px) : striped(kSide_px, kSide_px);
    paint(pair, kSceneCamera, frame);
    const Recognition seen = owned.recognise(frame.frame());
    touching += seen.graph.blobs.size() == 1 ? 1U : 0U;
    CHECK(matches(seen) <= 2);
    check_order(seen);
    found += found_of(pair, seen);
    both += found_of(pair, seen) == 2 ? 1U : 0U;
  }
  CHECK(touching * 100 >= all * 85);
  CHECK(found * 100 >= 2 * all * 85);
  CHECK(both * 100 >= all * 70);
}

TEST_CASE("rectangles of any colours over each other are no object") {
  OwnedRecogniser owned = recogniser();
  for (unsigned seed = 0; seed < static_cast<unsigned>(rounds(20)); ++seed) {
    std::mt19937 random(seed);
    const auto below = [&](unsigned most) { return static_cast<int>(random() % most); };
    OwnedFrame frame = black(kSide_px, kSide_px);
    for (int k = 0; k < 80; ++k) {
      const int x = below(kSide_px) - 40, y = below(kSide_px) - 40, width = 10 + below(120),
                height = 10 + below(120);
      fill(frame, {x, y, width, height},
           {static_cast<std::uint8_t>(below(256)), static_cast<std::uint8_t>(below(256)),
            static_cast<std::uint8_t>(below(256))});
    }
    INFO(seed);
    CHECK(matches(owned.recognise(frame.frame())) == 0);
  }
}

TEST_CASE("an object cut by the picture's border is itself or unknown, and no other") {
  std::mt19937 random(31);
  OwnedRecogniser owned = recogniser();
  std::size_t all = 0, found = 0;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    ModelCamera camera(kNames[i]);
    for (int k = 0; k < rounds(12); ++k) {
      const OwnedFrame alone = cut(camera.view(random_direction(random), k), 0.8);
      OwnedFrame scene = striped(alone.width_px, alone.height_px);
      paste(alone, 0, 0, scene);
      for (const OwnedFrame* frame : {&alone, static_cast<const OwnedFrame*>(&scene)}) {
        const Recognition seen = owned.recognise(frame->frame());
        CHECK(matches(seen) <= 1);
        CHECK_FALSE(names_another(seen, i));
        ++all;
        found += matches(seen);
      }
    }
  }
  CHECK(3 * found >= all);
}

TEST_CASE("frames with no blob, and with more than are kept, give objects in their blobs' order") {
  OwnedRecogniser owned = recogniser(2 * kSide_px);
  CHECK(owned.recognise(black(kSide_px, kSide_px).frame()).objects.empty());
  std::mt19937 random(24);
  for (const int squares : {1, 65, 300}) {
    OwnedFrame frame = black(kSide_px, 2 * kSide_px);
    strew_squares(frame, squares, kSide_px, random);
    const Recognition seen = owned.recognise(frame.frame());
    CHECK(seen.objects.size() == static_cast<std::size_t>(std::min(squares, 64)));
    CHECK(matches(seen) == 0);
    check_order(seen);
  }
}

TEST_CASE("objects that touch are found among as many blobs as are kept") {
  std::mt19937 random(25);
  OwnedRecogniser owned = recogniser(2 * kSide_px);
  const auto all = static_cast<std::size_t>(rounds(10));
  std::size_t found = 0;
  for (std::size_t k = 0; k < all; ++k) {
    OwnedFrame frame = black(kSide_px, 2 * kSide_px);
    strew_squares(frame, 80, kSide_px, random);
    const Pair pair = random_pair(random, 1.3);
    paint(pair, kSceneCamera, frame);
    const Recognition seen = owned.recognise(frame.frame());
    CHECK(seen.objects.size() == 64);
    check_order(seen);
    found += found_of(pair, seen);
  }
  CHECK(found * 100 >= 2 * all * 75);
}

TEST_CASE("an object below more pieces of its colours than take part is found") {
  std::mt19937 random(26);
  RecogniserParameters parameters;
  CameraModel low = kSceneCamera;
  low.cy_px += kSide_px;
  parameters.camera = CalibratedCamera{low, 0};
  OwnedRecogniser owned(cube_and_l_shape(), parameters, kSide_px, 2 * kSide_px);
  const auto all = static_cast<std::size_t>(rounds(10));
  std::size_t found = 0;
  for (std::size_t k = 0; k < all; ++k) {
    OwnedFrame frame = striped(kSide_px, 2 * kSide_px);
    strew_squares(frame, 300, 0, random);
    const Pair pair = random_pair(random, 1.3);
    paint({pair.data(), 1}, low, frame);
    found += least_turn_deg(owned.recognise(frame.frame()), 0, pair[0].pose.rotation) < 3 ? 1U : 0U;
  }
  CHECK(found * 100 >= all * 80);
}

TEST_CASE("the last of many indexes is looked for as the first one is") {
  std::vector<ClassIndex> indexes(15, cube_and_l_shape()[0]);
  indexes.push_back(cube_and_l_shape()[1]);
  OwnedRecogniser many(indexes, {}, kSide_px, kSide_px), two = recogniser();
  std::mt19937 random(27);
  for (int k = 0; k < rounds(10); ++k) {
    const Pair pair = random_pair(random, 1.4);
    OwnedFrame frame = striped(kSide_px, kSide_px);
    paint(pair, kSceneCamera, frame);
    const Rotation& rotation = pair[1].pose.rotation;
    CHECK(least_turn_deg(many.recognise(frame.frame()), 15, rotation) ==
          least_turn_deg(two.recognise(frame.frame()), 1, rotation));
  }
}

}  // namespace aspect
