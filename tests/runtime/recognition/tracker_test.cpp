// Objects that move from frame to frame before stripes, their poses known.
#include "runtime/recognition/tracker.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <utility>
#include <vector>

#include "runtime/recognition/alike_poses.h"
#include "tests/runtime/recognition/owned_recogniser.h"
#include "tests/runtime/recognition/painted_scene.h"
#include "tests/runtime/recognition/rendered_views.h"

namespace aspect {
namespace {

constexpr int kClipWidth_px = 480, kClipHeight_px = 320, kLater = 1000;
constexpr double kClipField_deg = 50, kDegPerRad = 57.29577951308232;
const CameraModel kClipCamera = centred_camera(kClipField_deg, kClipWidth_px, kClipHeight_px);

OwnedRecogniser tracking(int search_every, bool on = true) {
  RecogniserParameters parameters;
  parameters.camera = CalibratedCamera{kClipCamera, 0};
  parameters.tracking = {on, search_every};
  return {cube_and_l_shape(), parameters, kClipWidth_px, kClipHeight_px};
}

// A turning object on its way; in radii of it.
struct Mover {
  std::size_t index = 0;  // 0: the cube, 1: the l_shape
  Vector3d direction{0.48, 0.6, 0.64};
  Vector3d from{-0.9, 0, 5.5}, speed{0.02, 0.01, 0.02};
  double roll_rad = 0.3, turn_rad = 0.03;

  PlacedModel at(double time) const {
    const ObjectModel& model = cube_and_l_shape()[index].model;
    const Rotation rotation = turn_about({0.6, 0, 0.8}, turn_rad * time) *
                              turn_about({0, 0, 1}, roll_rad) *
                              camera_from_object(direction, model.up);
    const Vector3d centre = model.radius * (from + time * speed);
    return {&model, {rotation, centre - rotation(model.centre)}};
  }
};

OwnedFrame painted(std::span<const Mover> movers, double time, bool on_stripes = true) {
  constexpr auto kBytes = std::size_t{3} * kClipWidth_px * kClipHeight_px;
  OwnedFrame frame =
      on_stripes ? striped(kClipWidth_px, kClipHeight_px)
                 : OwnedFrame{kClipWidth_px, kClipHeight_px, std::vector<std::uint8_t>(kBytes)};
  std::vector<PlacedModel> placed;
  for (const Mover& mover : movers) placed.push_back(mover.at(time));
  paint(placed, kClipCamera, frame);
  return frame;
}

// Numbers of the matches that show a mover where it is, and how many matches show anything else.
struct Seen {
  std::vector<std::uint32_t> numbers;  // by mover, 0: not seen
  int others = 0;
};

Seen seen_of(std::span<const Mover> movers, double time, const Recognition& recognition) {
  constexpr double kNear_deg = 5;
  Seen seen;
  seen.numbers.resize(movers.size());
  for (const SeenObject& object : recognition.objects) {
    if (object.judgement.verdict != Verdict::match) continue;
    const Hypothesis& best = object.hypotheses.front();
    const auto it = std::find_if(movers.begin(), movers.end(), [&](const Mover& mover) {
      const RigidPose pose = mover.at(time).pose, found = best.pose->refined.pose;
      const ObjectModel& model = *mover.at(time).model;
      return mover.index == best.index &&
             kDegPerRad * angle_between_rad(found.rotation, pose.rotation) < kNear_deg &&
             norm(found(model.centre) - pose(model.centre)) < 0.5 * model.radius;
    });
    if (it == movers.end())
      ++seen.others;
    else
      seen.numbers[static_cast<std::size_t>(it - movers.begin())] = object.track;
  }
  return seen;
}

bool is_searched(const Recognition& recognition) {
  return recognition.stages.segment.count() > 0;
}

bool same(const Recognition& a, const Recognition& b) {
  return std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(),
                    [](const SeenObject& x, const SeenObject& y) {
                      if (x.box != y.box || x.judgement.verdict != y.judgement.verdict ||
                          x.hypotheses.size() != y.hypotheses.size())
                        return false;
                      return x.hypotheses.empty() ||
                             x.hypotheses.front().score == y.hypotheses.front().score;
                    });
}

}  // namespace

TEST_CASE("what moves is followed with its number and its pose, and costs no search") {
  const std::vector<Mover> movers{{}, {1, {0.6, -0.48, 0.64}, {1.6, 0, 6}, {0.01, 0.01, 0}}};
  for (const bool on_stripes : {true, false}) {
    OwnedRecogniser recogniser = tracking(kLater);
    std::vector<std::uint32_t> number;
    for (int time = 0; time < 24; ++time) {
      INFO(on_stripes << " " << time);
      const OwnedFrame frame = painted(movers, time, on_stripes);
      const Recognition recognition = recogniser.recognise(frame.frame());
      CHECK(is_searched(recognition) == (time == 0));
      const Seen seen = seen_of(movers, time, recognition);
      CHECK(seen.others == 0);
      if (time == 0) number = seen.numbers;
      CHECK(seen.numbers == number);
    }
    CHECK(number[0] + number[1] == 3);
  }
}

TEST_CASE("the first frame is seen as without tracking") {
  const std::vector<Mover> movers{{}, {1, {0.6, -0.48, 0.64}, {1.6, 0, 6}}};
  const OwnedFrame frame = painted(movers, 0);
  OwnedRecogniser follows = tracking(10), does_not = tracking(10, false);
  const Recognition followed = follows.recognise(frame.frame()),
                    seen = does_not.recognise(frame.frame());
  REQUIRE(seen.objects.size() >= 2);
  CHECK(same(followed, seen));
  for (const SeenObject& object : seen.objects) CHECK(object.track == 0);
  for (const SeenObject& object : followed.objects)
    CHECK((object.track > 0) == (object.judgement.verdict == Verdict::match));
}

TEST_CASE("what was out of sight is found again within two frames, elsewhere too, as the same") {
  const std::vector<Mover> before{{}};
  std::vector<Mover> after = before;
  after[0].from = {1.2, -0.3, 5};
  OwnedRecogniser recogniser = tracking(kLater);
  int searched_without = 0;
  for (int time = 0; time < 50; ++time) {
    const bool away = time >= 10 && time < 30;
    const std::vector<Mover>& there = time < 10 ? before : after;
    const OwnedFrame frame = painted(away ? std::span<const Mover>() : there, time);
    const Recognition recognition = recogniser.recognise(frame.frame());
    const Seen seen = seen_of(there, time, recognition);
    INFO(time);
    CHECK(seen.others == 0);
    if (away) {
      CHECK(seen.numbers[0] == 0);
      searched_without += is_searched(recognition) ? 1 : 0;
    } else if (time < 10 || time > 30) {
      CHECK(seen.numbers[0] == 1);
    }
  }
  CHECK(searched_without > 5);
  CHECK(searched_without < 15);
}

TEST_CASE("the only one of its object that is lost may come back anywhere at once") {
  std::vector<Mover> movers{{}};
  movers[0].from = {-1.6, -0.7, 6};
  movers[0].speed = {0, 0, 0};
  OwnedRecogniser recogniser = tracking(kLater);
  for (int time = 0; time < 12; ++time) {
    if (time == 8) movers[0].from = {1.6, 0.7, 6};
    const OwnedFrame frame = painted(movers, time);
    INFO(time);
    CHECK(seen_of(movers, time, recogniser.recognise(frame.frame())).numbers[0] == 1);
  }
}

TEST_CASE("what passes behind another is followed, and found again where it was hidden") {
  // Four fifths of the cube are hidden in the middle.
  const std::vector<Mover> movers{{0, {0.48, 0.6, 0.64}, {-3.2, 0.3, 8.5}, {0.16, 0, 0}},
                                  {1, {0.6, -0.48, 0.64}, {0, 0, 5}, {0, 0, 0}}};
  OwnedRecogniser recogniser = tracking(kLater);
  std::array<std::uint32_t, 2> number{};
  for (int time = 0; time < 40; ++time) {
    const OwnedFrame frame = painted(movers, time);
    const Seen seen = seen_of(movers, time, recogniser.recognise(frame.frame()));
    INFO(time);
    // What little is seen of the cube in the middle says little of how it stands.
    const bool is_hidden = time >= 13 && time <= 30;
    if (!is_hidden) CHECK(seen.others == 0);
    for (std::size_t k = 0; k < 2; ++k) {
      if (time == 0) number[k] = seen.numbers[k];
      const bool may_be_hidden = k == 0 && is_hidden;
      if (seen.numbers[k] > 0 || !may_be_hidden) CHECK(seen.numbers[k] == number[k]);
    }
  }
  CHECK(number[0] + number[1] == 3);
}

TEST_CASE("two of one object keep their numbers when they cross") {
  const std::vector<Mover> movers{
      {0, {0.48, 0.6, 0.64}, {-2, 0.8, 6}, {0.1, -0.04, 0}},
      {0, {-0.6, 0.48, 0.64}, {2.4, -0.8, 7.5}, {-0.12, 0.04, 0}, 1.2, -0.02}};
  OwnedRecogniser recogniser = tracking(kLater);
  std::vector<std::uint32_t> number;
  for (int time = 0; time < 40; ++time) {
    const OwnedFrame frame = painted(movers, time);
    const Seen seen = seen_of(movers, time, recogniser.recognise(frame.frame()));
    INFO(time);
    CHECK(seen.others == 0);
    if (time == 0) number = seen.numbers;
    for (std::size_t k = 0; k < 2; ++k)
      if (seen.numbers[k] > 0 || time < 10 || time > 30) CHECK(seen.numbers[k] == number[k]);
  }
  CHECK(number[0] + number[1] == 3);
}

TEST_CASE("between searches only the parts of a frame count in which something is expected") {
  const std::vector<Mover> movers{{}};
  OwnedRecogniser recogniser = tracking(kLater), other = tracking(kLater);
  for (int time = 0; time < 5; ++time) {
    OwnedFrame frame = painted(movers, time);
    const Recognition recognition = recogniser.recognise(frame.frame());
    REQUIRE(recognition.objects.size() >= 1);
    const Box box = recognition.objects.back().box;
    // All but the box and a margin is black.
    const int margin_px = 40;
    for (int y = 0; time > 0 && y < kClipHeight_px; ++y)
      for (int x = 0; x < kClipWidth_px; ++x)
        if (x < box.x - margin_px || x >= box.x + box.width + margin_px || y < box.y - margin_px ||
            y >= box.y + box.height + margin_px)
          for (std::size_t c = 0; c < 3; ++c)
            frame.rgb[3 * static_cast<std::size_t>(y * kClipWidth_px + x) + c] = 0;
    CHECK(same(recognition, other.recognise(frame.frame())));
  }
}

TEST_CASE("what is new is looked for in every n-th frame") {
  const std::vector<Mover> one{{}};
  const std::vector<Mover> both{{}, {1, {0.6, -0.48, 0.64}, {1.6, 0, 6}}};
  for (const int every : {1, 4}) {
    OwnedRecogniser recogniser = tracking(every);
    for (int time = 0; time < 9; ++time) {
      const OwnedFrame frame = painted(time == 0 ? one : both, time);
      const Recognition recognition = recogniser.recognise(frame.frame());
      INFO(every << " " << time);
      CHECK(is_searched(recognition) == (time % every == 0));
      const Seen seen = seen_of(both, time, recognition);
      CHECK(seen.numbers[0] == 1);
      CHECK(seen.numbers[1] == (time >= every ? 2U : 0U));
    }
  }
}

TEST_CASE("frames that were not seen are bridged, and a second run gives the same") {
  std::vector<Mover> movers{{}};
  movers[0].speed = {0.04, 0.01, 0.02};
  movers[0].turn_rad = 0.1;
  OwnedRecogniser recogniser = tracking(kLater), again = tracking(kLater);
  // Seen moving, and then only now and then.
  for (int time = 0; time < 3; ++time) {
    const OwnedFrame frame = painted(movers, time);
    recogniser.recognise(frame.frame());
    again.recognise(frame.frame());
  }
  int last = 2;
  for (const int time : {3, 8, 9, 14, 15, 20, 21, 26}) {
    const int steps = time - std::exchange(last, time);
    const OwnedFrame frame = painted(movers, time);
    const Recognition recognition = recogniser.recognise(frame.frame(), steps);
    INFO(time);
    CHECK_FALSE(is_searched(recognition));
    CHECK(seen_of(movers, time, recognition).numbers[0] == 1);
    CHECK(same(recognition, again.recognise(frame.frame(), steps)));
  }
}

TEST_CASE("frames of another size begin anew, and no number is given twice") {
  const std::vector<Mover> movers{{}};
  OwnedRecogniser recogniser = tracking(kLater);
  const OwnedFrame frame = painted(movers, 0);
  CHECK(seen_of(movers, 0, recogniser.recognise(frame.frame())).numbers[0] == 1);
  const OwnedFrame small = striped(kClipWidth_px / 2, kClipHeight_px / 2);
  CHECK(is_searched(recogniser.recognise(small.frame())));
  CHECK(seen_of(movers, 0, recogniser.recognise(frame.frame())).numbers[0] == 2);
}

TEST_CASE("of poses that look alike the one nearest to a reference is the same in the picture") {
  ClassIndex index;
  index.model.centre = {0.1, 0.2, 0.3};
  index.symmetries = {{0, 0, 1, 0}};  // half a turn about y
  const Rotation rotation = turn_about({0.6, 0, 0.8}, 0.4);
  const RigidPose pose{rotation * turn_about({0, 1, 0}, 3.1), {0, 0, 5}};
  const RigidPose alike = alike_pose_nearest(pose, rotation, index);
  CHECK(angle_between_rad(alike.rotation, rotation) < 0.05);
  CHECK(norm(alike(index.model.centre) - pose(index.model.centre)) < 1e-12);
  // Half a turn about y it is.
  CHECK(angle_between_rad(alike.rotation * Rotation{0, 0, 1, 0}, pose.rotation) < 1e-6);
  CHECK(angle_between_rad(alike_pose_nearest(pose, pose.rotation, index).rotation, pose.rotation) <
        1e-6);
}

TEST_CASE("what a drawing covers is hidden, and nothing far from it") {
  const Mover mover;
  const PlacedModel placed = mover.at(0);
  ModelDrawing drawing;
  PlannedMemory memory;
  memory.plan([&](Arena& arena) { drawing.prepare(arena, placed.model->vertices.size()); });
  REQUIRE(drawing.draw_alone(*placed.model, placed.pose, kClipCamera, kClipWidth_px, kClipHeight_px,
                             32));
  HiddenPart hidden;
  hidden.start({0, 0, kClipWidth_px, kClipHeight_px});
  CHECK_FALSE(hidden.any());
  hidden.hide(drawing, kClipCamera);
  CHECK(hidden.any());
  const float slack_px = 2 * drawing.cell_px() + static_cast<float>(kClipWidth_px) / 32;
  int covered = 0;
  for (int y = -50; y < kClipHeight_px + 50; y += 5)
    for (int x = -50; x < kClipWidth_px + 50; x += 5) {
      const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
      if (drawing.at(fx, fy).covered) {
        ++covered;
        CHECK(hidden.hides(fx, fy));
      }
      const bool near = fx > drawing.x_px(0) - slack_px && fy > drawing.y_px(0) - slack_px &&
                        fx < drawing.x_px(drawing.width()) + slack_px &&
                        fy < drawing.y_px(drawing.height()) + slack_px;
      if (!near) CHECK_FALSE(hidden.hides(fx, fy));
    }
  CHECK(covered > 50);
}

}  // namespace aspect
