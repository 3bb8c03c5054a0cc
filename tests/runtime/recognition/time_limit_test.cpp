// Frames whose time is over after a number of steps: a clock that goes on whenever it is asked
// makes that exact.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "tests/rounds.h"
#include "tests/runtime/recognition/owned_recogniser.h"
#include "tests/runtime/recognition/painted_scene.h"
#include "tests/runtime/recognition/rendered_views.h"

namespace aspect {
namespace {

constexpr int kTimedSide_px = 384;
constexpr std::chrono::nanoseconds kLong = std::chrono::hours(1);
const CameraModel kTimedCamera = centred_camera(50, kTimedSide_px, kTimedSide_px);

// The first answer is the start; of those after it, `granted` are before the end.
long asked = 0, granted = 0;
Deadline::Time steps_clock() {
  const bool is_over = asked++ > granted;
  return Deadline::Time(is_over ? kLong : std::chrono::nanoseconds(0));
}

void grant(long steps) {
  asked = 0;
  granted = steps;
}

constexpr long kAllSteps = 1'000'000'000;

RecogniserParameters timed_parameters(std::chrono::nanoseconds limit,
                                      Deadline::Clock clock = steps_clock) {
  RecogniserParameters parameters;
  parameters.camera = CalibratedCamera{kTimedCamera, 0};
  parameters.time_limit = limit;
  parameters.clock = clock;
  return parameters;
}

OwnedRecogniser timed(const RecogniserParameters& parameters) {
  return {cube_and_l_shape(), parameters, kTimedSide_px, kTimedSide_px};
}

// The cube and the l_shape so many radii apart, any way up.
OwnedFrame both_painted(std::mt19937& random, double apart, bool on_stripes) {
  constexpr auto kBytes = std::size_t{3} * kTimedSide_px * kTimedSide_px;
  OwnedFrame frame =
      on_stripes ? striped(kTimedSide_px, kTimedSide_px)
                 : OwnedFrame{kTimedSide_px, kTimedSide_px, std::vector<std::uint8_t>(kBytes)};
  std::uniform_real_distribution<double> roll(-3, 3);
  std::array<PlacedModel, 2> placed;
  for (std::size_t i = 0; i < 2; ++i) {
    const ObjectModel& model = cube_and_l_shape()[i].model;
    const Eigen::Vector3d d = random_direction(random);
    const Rotation rotation =
        turn_about({0, 0, 1}, roll(random)) * camera_from_object({d.x(), d.y(), d.z()}, model.up);
    const Vector3d centre{model.radius * (i == 0 ? -apart : apart) / 2, 0,
                          model.radius * (i == 0 ? 5.6 : 6)};
    placed[i] = {&model, {rotation, centre - rotation(model.centre)}};
  }
  paint(placed, kTimedCamera, frame);
  return frame;
}

// Before stripes, touching there, and alone before black.
std::vector<OwnedFrame> timed_frames(int each) {
  std::mt19937 random(41);
  std::vector<OwnedFrame> frames;
  for (int k = 0; k < each; ++k) {
    frames.push_back(both_painted(random, 2.2, true));
    frames.push_back(both_painted(random, 1.4, true));
    frames.push_back(both_painted(random, 2.2, false));
  }
  return frames;
}

struct TimedMatch {
  std::uint16_t index = 0;
  Box box;
};

std::vector<TimedMatch> timed_matches(const Recognition& seen) {
  std::vector<TimedMatch> found;
  for (const SeenObject& object : seen.objects)
    if (object.judgement.verdict == Verdict::match)
      found.push_back({object.hypotheses.front().index, object.box});
  return found;
}

bool overlap_much(const Box& a, const Box& b) {
  const int width = std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x),
            height = std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y);
  return width > 0 && height > 0 &&
         3 * width * height > a.width * a.height + b.width * b.height - width * height;
}

bool is_among(const TimedMatch& match, const std::vector<TimedMatch>& others) {
  return std::any_of(others.begin(), others.end(), [&](const TimedMatch& other) {
    return other.index == match.index && overlap_much(other.box, match.box);
  });
}

bool same_hypothesis(const Hypothesis& a, const Hypothesis& b) {
  if (a.index != b.index || a.class_id != b.class_id || a.score != b.score || a.view != b.view ||
      a.matched != b.matched || a.contours.size() != b.contours.size() ||
      (a.pose == nullptr) != (b.pose == nullptr))
    return false;
  if (a.pose == nullptr) return true;
  const RefinedPose &p = a.pose->refined, &q = b.pose->refined;
  return p.pose.translation == q.pose.translation && p.covariance == q.covariance &&
         p.pose.rotation.w == q.pose.rotation.w && p.pose.rotation.x == q.pose.rotation.x;
}

bool same_objects(const Recognition& a, const Recognition& b) {
  return std::equal(a.objects.begin(), a.objects.end(), b.objects.begin(), b.objects.end(),
                    [](const SeenObject& x, const SeenObject& y) {
                      return x.box == y.box && x.judgement.verdict == y.judgement.verdict &&
                             x.judgement.probability == y.judgement.probability &&
                             x.track == y.track &&
                             std::equal(x.hypotheses.begin(), x.hypotheses.end(),
                                        y.hypotheses.begin(), y.hypotheses.end(), same_hypothesis);
                    });
}

Deadline::Time never_asked() {
  FAIL("the clock was asked");
  return {};
}

}  // namespace

TEST_CASE("of a frame whose time is over at once regions are seen, and nothing is a match") {
  OwnedRecogniser owned =
      timed(timed_parameters(std::chrono::nanoseconds(1), std::chrono::steady_clock::now));
  for (const OwnedFrame& frame : timed_frames(2)) {
    const Recognition seen = owned.recognise(frame.frame());
    CHECK_FALSE(seen.graph.contours.empty());
    CHECK(timed_matches(seen).empty());
    CHECK(seen.objects.size() == seen.graph.blobs.size());
    CHECK(seen.left_undone.objects + seen.left_undone.indexes > 0);
    const auto seeing =
        seen.stages.convert + seen.stages.enhance + seen.stages.segment + seen.stages.features;
    CHECK(seen.stages.match + seen.stages.pose < seeing);
  }
}

TEST_CASE("a limit that is not reached changes nothing, and without one no clock is asked") {
  OwnedRecogniser free = timed(timed_parameters({}, never_asked)),
                  limited = timed(timed_parameters(kLong, std::chrono::steady_clock::now));
  std::size_t found = 0;
  for (const OwnedFrame& frame : timed_frames(rounds(6))) {
    const Recognition expected = free.recognise(frame.frame()),
                      seen = limited.recognise(frame.frame());
    CHECK(same_objects(seen, expected));
    CHECK_FALSE(expected.left_undone.any());
    CHECK_FALSE(seen.left_undone.any());
    found += timed_matches(seen).size();
  }
  CHECK(found > 0);
}

TEST_CASE("wherever a frame is cut short, what is found is there without a limit, and it is said") {
  OwnedRecogniser free = timed(timed_parameters({})), limited = timed(timed_parameters(kLong));
  std::size_t found = 0, possible = 0;
  for (const OwnedFrame& frame : timed_frames(rounds(3))) {
    const std::vector<TimedMatch> expected = timed_matches(free.recognise(frame.frame()));
    grant(kAllSteps);
    limited.recognise(frame.frame());
    const long last = asked - 1;
    for (long steps = 0; steps < last; steps += 1 + last / 24) {
      grant(steps);
      const Recognition seen = limited.recognise(frame.frame());
      INFO(steps << " of " << last);
      CHECK(seen.left_undone.any());
      for (const TimedMatch& match : timed_matches(seen)) CHECK(is_among(match, expected));
      // What was not looked at to its end is none, though it may look like one already.
      if (seen.left_undone.objects > 0)
        CHECK(timed_matches(seen).size() + static_cast<std::size_t>(seen.left_undone.objects) <=
              seen.graph.blobs.size());
      found += timed_matches(seen).size();
      possible += expected.size();
    }
  }
  // Not only at the end.
  CHECK(4 * found > possible);
}

TEST_CASE(
    "objects that there is no time to follow are not lost, and come first in the next frame") {
  RecogniserParameters parameters = timed_parameters(kLong);
  parameters.tracking = {true, 1000};
  OwnedRecogniser owned = timed(parameters);
  std::mt19937 random(44);
  const OwnedFrame frame = both_painted(random, 2.2, true);
  grant(kAllSteps);
  REQUIRE(timed_matches(owned.recognise(frame.frame())).size() == 2);
  const auto numbers_with = [&](long steps) {
    grant(steps);
    const Recognition seen = owned.recognise(frame.frame());
    CHECK(seen.graph.contours.empty());
    CHECK(seen.left_undone.tracks + static_cast<int>(seen.objects.size()) == 2);
    CHECK(seen.left_undone.searches == 0);
    std::vector<std::uint32_t> numbers;
    for (const SeenObject& object : seen.objects) numbers.push_back(object.track);
    return numbers;
  };
  CHECK(numbers_with(0).empty());
  // One box, and one object in it.
  const std::vector<std::uint32_t> first = numbers_with(2), second = numbers_with(2);
  REQUIRE(first.size() == 1);
  REQUIRE(second.size() == 1);
  CHECK(first != second);
  CHECK(numbers_with(kAllSteps).size() == 2);
}

}  // namespace aspect
