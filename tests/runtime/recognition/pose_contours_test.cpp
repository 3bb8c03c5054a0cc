#include "runtime/recognition/pose_contours.h"

#include <array>
#include <catch2/catch.hpp>
#include <random>

#include "runtime/recognition/sized_recogniser.h"
#include "tests/runtime/recognition/rendered_views.h"

namespace aspect {
namespace {

struct Named {
  std::array<ContourMatch, kMaxClassContours> matches;
  std::size_t count = 0;
  bool has(const ContourMatch& other) const {
    return std::any_of(matches.begin(), matches.begin() + static_cast<std::ptrdiff_t>(count),
                       [&](const ContourMatch& match) {
                         return match.contour == other.contour && match.name == other.name;
                       });
  }
};

Named named_at_pose(const Hypothesis& hypothesis, const SizedRecogniser& recogniser,
                    const ViewGraph& graph) {
  Named named;
  named.count = contours_at_pose(
      cube_and_l_shape()[hypothesis.index], hypothesis.class_id, hypothesis.pose->refined.pose,
      recogniser.cameras()[hypothesis.index], recogniser.regions(), graph.contours, named.matches);
  return named;
}

}  // namespace

TEST_CASE("where a pose is right, contours have the names that matching their types gives them") {
  std::mt19937 random(8);
  ModelCamera cube("cube"), l_shape("l_shape");
  SizedRecogniser recogniser(cube_and_l_shape(), {});
  std::size_t matched = 0, same = 0, named = 0;
  for (int round = 0; round < 60; ++round) {
    const OwnedFrame frame =
        (round % 2 == 0 ? cube : l_shape).view(random_direction(random), round);
    recogniser.make_room(frame.width_px, frame.height_px);
    const Recognition seen = recogniser.recognise(frame.frame());
    REQUIRE(seen.objects.size() == 1);
    const Hypothesis& best = seen.objects[0].hypotheses[0];
    if (best.pose == nullptr) continue;
    const Named at_pose = named_at_pose(best, recogniser, seen.graph);
    matched += best.contours.size();
    named += at_pose.count;
    for (const ContourMatch& match : best.contours) same += at_pose.has(match) ? 1U : 0U;
  }
  CHECK(matched > 120);
  // Matching by types names what looks alike the other way round now and then.
  CHECK(same > matched * 98 / 100);
  CHECK(named > matched * 98 / 100);
}

TEST_CASE("objects found before a background have their contours named, each once") {
  std::mt19937 random(10);
  ModelCamera cube("cube"), l_shape("l_shape");
  SizedRecogniser recogniser(cube_and_l_shape(), {});
  std::size_t found = 0, named = 0;
  for (int round = 0; round < 12; ++round) {
    const OwnedFrame object =
        (round % 2 == 0 ? cube : l_shape).view(random_direction(random), round);
    OwnedFrame frame = striped(object.width_px, object.height_px);
    paste(object, 0, 0, frame);
    recogniser.make_room(frame.width_px, frame.height_px);
    const Recognition seen = recogniser.recognise(frame.frame());
    for (const SeenObject& one : seen.objects) {
      if (one.judgement.verdict != Verdict::match) continue;
      const Hypothesis& best = one.hypotheses[0];
      ++found;
      named += best.contours.size();
      CHECK(best.matched == static_cast<int>(best.contours.size()));
      for (std::size_t k = 0; k < best.contours.size(); ++k) {
        CHECK(best.contours[k].contour < seen.graph.contours.size());
        CHECK((k == 0 || best.contours[k - 1].name < best.contours[k].name));
        const Box& box = seen.graph.contours[best.contours[k].contour].box;
        CHECK(box.x + box.width > one.box.x);
        CHECK(box.x < one.box.x + one.box.width);
      }
    }
  }
  CHECK(found >= 8);
  CHECK(named >= 2 * found);
}

TEST_CASE("nothing is named where the pose shows nothing of it") {
  std::mt19937 random(9);
  ModelCamera cube("cube");
  SizedRecogniser recogniser(cube_and_l_shape(), {});
  const OwnedFrame frame = cube.view(random_direction(random));
  recogniser.make_room(frame.width_px, frame.height_px);
  const Recognition seen = recogniser.recognise(frame.frame());
  const Hypothesis& best = seen.objects[0].hypotheses[0];
  REQUIRE(best.pose != nullptr);
  const ClassIndex& index = cube_and_l_shape()[best.index];
  std::array<ContourMatch, kMaxClassContours> out;
  RigidPose pose = best.pose->refined.pose;
  const auto count = [&](std::size_t room) {
    return contours_at_pose(index, best.class_id, pose, recogniser.cameras()[best.index],
                            recogniser.regions(), seen.graph.contours, std::span(out).first(room));
  };
  CHECK(count(out.size()) == best.contours.size());
  CHECK(count(1) == 1);
  CHECK(count(0) == 0);
  SECTION("behind the camera") {
    pose.translation[2] = -pose.translation[2];
  }
  SECTION("beside the picture") {
    pose.translation[0] += 100;
  }
  SECTION("far beyond any number of pixels") {
    pose.translation[1] = 1e300;
  }
  CHECK(count(out.size()) == 0);
}

}  // namespace aspect
