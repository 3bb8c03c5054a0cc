// From scene to answer: two objects compiled at a low level, recognised from anywhere.
#include "runtime/recognition/recogniser.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>
#include <sstream>

#include "tests/rounds.h"
#include "tests/runtime/recognition/made_index.h"
#include "tests/runtime/recognition/owned_recogniser.h"
#include "tests/runtime/recognition/rendered_views.h"

namespace aspect {
namespace {

constexpr int kSide_px = 512;
constexpr int kViews = 100;

struct Model {
  std::string name;
  std::size_t place;  // of its index
  ModelCamera camera;
};

std::vector<Model> models() {
  std::vector<Model> both;
  both.push_back({"cube", 0, ModelCamera("cube")});
  both.push_back({"l_shape", 1, ModelCamera("l_shape")});
  return both;
}

OwnedRecogniser recogniser(int width_px = kSide_px) {
  return {cube_and_l_shape(), {}, width_px, kSide_px};
}

struct Score {
  std::size_t views = 0, right = 0;
  std::vector<double> errors_deg, roll_errors_deg;

  double median(std::vector<double> values) const {
    REQUIRE_FALSE(values.empty());
    std::nth_element(values.begin(),
                     values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
  }
};

// The roll of the best key view is against an upright picture of that view, so that it says
// something of the camera only where the view found is near the true one.
void add_answer(Score& score, const Recognition& seen, const Model& model,
                const Eigen::Vector3d& direction, double roll_rad) {
  ++score.views;
  if (seen.objects.empty() || seen.objects[0].hypotheses.empty()) return;
  const Hypothesis& best = seen.objects[0].hypotheses[0];
  if (best.index != model.place) return;
  ++score.right;
  score.errors_deg.push_back(angle_deg(best.view, direction));
  const double roll_error =
      std::remainder(static_cast<double>(best.roll_rad) - roll_rad, 2 * std::numbers::pi);
  score.roll_errors_deg.push_back(std::abs(roll_error) * 180 / std::numbers::pi);
}

// Canonical form of an answer, to compare two.
std::string words(const Recognition& seen) {
  std::ostringstream text;
  text.precision(17);
  for (const SeenObject& object : seen.objects) {
    text << "object " << object.box.x << ' ' << object.regions;
    for (const Hypothesis& h : object.hypotheses) {
      text << " (" << h.index << ' ' << h.class_id << ' ' << h.score << ' ' << h.view[0] << ' '
           << h.view[1] << ' ' << h.view[2] << ' ' << h.roll_rad;
      for (const ContourMatch& m : h.contours) text << ' ' << m.contour << '-' << m.name;
      text << ')';
    }
  }
  return text.str();
}

}  // namespace

TEST_CASE("objects are recognised from anywhere, and the view is found") {
  std::mt19937 random(1);
  OwnedRecogniser owned = recogniser();
  for (Model& model : models()) {
    Score score;
    for (int k = 0; k < rounds(kViews); ++k) {
      const Eigen::Vector3d direction = random_direction(random);
      const OwnedFrame frame = model.camera.view(direction);
      add_answer(score, owned.recognise(frame.frame()), model, direction, 0);
    }
    INFO(model.name);
    CHECK(score.right * 100 >= score.views * 98);
    CHECK(score.median(score.errors_deg) <= 8);
  }
}

TEST_CASE("objects in rolled frames are recognised, and the roll is found") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-std::numbers::pi, std::numbers::pi);
  OwnedRecogniser owned = recogniser();
  for (Model& model : models()) {
    Score score;
    for (int k = 0; k < rounds(kViews); ++k) {
      const Eigen::Vector3d direction = random_direction(random);
      const double roll = any(random);
      const OwnedFrame frame = model.camera.view(direction, roll);
      add_answer(score, owned.recognise(frame.frame()), model, direction, roll);
    }
    INFO(model.name);
    CHECK(score.right * 100 >= score.views * 97);
    CHECK(score.median(score.errors_deg) <= 9);
    CHECK(score.median(score.roll_errors_deg) <= 12);
  }
}

TEST_CASE("two objects in a picture are two objects in the answer, each with its own box") {
  std::mt19937 random(3);
  std::vector<Model> both = models();
  OwnedRecogniser owned = recogniser(2 * kSide_px);
  const auto all = static_cast<std::size_t>(rounds(30));
  std::size_t right = 0;
  for (std::size_t k = 0; k < all; ++k) {
    const OwnedFrame first = both[k % 2].camera.view(random_direction(random));
    const OwnedFrame second = both[1 - k % 2].camera.view(random_direction(random));
    const OwnedFrame frame = beside(first, second);
    const Recognition seen = owned.recognise(frame.frame());
    if (seen.objects.size() != 2) continue;
    std::size_t found = 0;
    for (const SeenObject& object : seen.objects) {
      const bool left = object.box.x + object.box.width <= kSide_px;
      const std::size_t wanted = left ? k % 2 : 1 - k % 2;
      if (!object.hypotheses.empty() && object.hypotheses[0].index == wanted) ++found;
    }
    if (found == 2) ++right;
  }
  CHECK(right + 1 >= all);
}

TEST_CASE("an empty frame, a frame of noise and no frame hold no object that matters") {
  OwnedRecogniser owned = recogniser();
  OwnedFrame frame{kSide_px, kSide_px, std::vector<std::uint8_t>(3 * kSide_px * kSide_px)};
  CHECK(owned.recognise(frame.frame()).objects.empty());
  CHECK(owned.recognise({}).objects.empty());
  std::mt19937 random(4);
  for (std::uint8_t& byte : frame.rgb) byte = static_cast<std::uint8_t>(random());
  for (const SeenObject& object : owned.recognise(frame.frame()).objects)
    for (const Hypothesis& h : object.hypotheses) CHECK(h.score < 0.5);
  const std::vector<ClassIndex> none;
  OwnedRecogniser empty(none, {}, kSide_px, kSide_px);
  for (const SeenObject& object : empty.recognise(frame.frame()).objects)
    CHECK(object.hypotheses.empty());
}

TEST_CASE("answers are ordered, within bounds, and each contour is named once") {
  std::mt19937 random(5);
  OwnedRecogniser owned = recogniser();
  for (Model& model : models()) {
    for (int k = 0; k < rounds(20); ++k) {
      const OwnedFrame frame = model.camera.view(random_direction(random));
      const Recognition seen = owned.recognise(frame.frame());
      for (const SeenObject& object : seen.objects) {
        CHECK(object.hypotheses.size() <= 10);
        CHECK(std::is_sorted(
            object.hypotheses.begin(), object.hypotheses.end(),
            [](const Hypothesis& a, const Hypothesis& b) { return a.score > b.score; }));
        for (const Hypothesis& h : object.hypotheses) {
          CHECK((h.score >= 0 && h.score <= 1));
          CHECK(h.matched + h.unmatched == object.regions);
          CHECK(h.contours.size() == static_cast<std::size_t>(h.matched));
          CHECK(std::hypot(h.view[0], h.view[1], h.view[2]) == Approx(1).epsilon(1e-4));
          std::set<int> contours, names;
          for (const ContourMatch& m : h.contours) {
            CHECK(m.contour < seen.graph.contours.size());
            CHECK(m.name < cube_and_l_shape()[h.index].classes[h.class_id].contours.count);
            contours.insert(m.contour);
            names.insert(m.name);
          }
          CHECK((contours.size() == h.contours.size() && names.size() == h.contours.size()));
        }
      }
    }
  }
}

TEST_CASE("two recognisers over the same frames answer alike, whatever each saw before") {
  std::mt19937 random(6);
  std::vector<Model> both = models();
  OwnedRecogniser first = recogniser(), second = recogniser(2 * kSide_px);
  for (std::size_t k = 0; k < static_cast<std::size_t>(rounds(30)); ++k) {
    const OwnedFrame frame = both[k % 2].camera.view(random_direction(random), 0.1);
    const OwnedFrame other = both[1 - k % 2].camera.view(random_direction(random));
    static_cast<void>(second.recognise(beside(other, frame).frame()));
    const std::string answer = words(first.recognise(frame.frame()));
    CHECK(answer.size() > 20);
    CHECK(words(second.recognise(frame.frame())) == answer);
  }
}

TEST_CASE("a frame larger than was prepared for gives nothing") {
  OwnedRecogniser owned = recogniser();
  ModelCamera camera("cube");
  const OwnedFrame frame = camera.view({1, 0, 0});
  CHECK(owned.recognise(beside(frame, frame).frame()).objects.empty());
  CHECK(owned.recognise(frame.frame()).objects.size() == 1);
}

TEST_CASE("ranked by classes, a hundredth of weight decides between classes alike") {
  const ClassIndex& cube = cube_and_l_shape()[0];
  ClassIndex twice = cube;
  // The second half is the first half once more, each type worth a little more.
  const auto classes = static_cast<std::uint32_t>(cube.classes.size());
  for (TypeScore& score : twice.type_scores) score.score = 0.25F;
  const auto scores = static_cast<std::uint32_t>(cube.type_scores.size());
  const auto contours = static_cast<std::uint32_t>(cube.class_contours.size());
  for (std::uint32_t k = 0; k < scores; ++k)
    twice.type_scores.push_back({cube.type_scores[k].type, 0.26F});
  for (std::uint32_t k = 0; k < contours; ++k) {
    twice.class_contours.push_back(cube.class_contours[k]);
    twice.class_contours.back().types.first += scores;
  }
  for (std::uint32_t k = 0; k < classes; ++k) {
    twice.classes.push_back(cube.classes[k]);
    twice.classes.back().contours.first += contours;
  }
  RecogniserParameters parameters;
  parameters.ranking = RecogniserParameters::Ranking::classes;
  OwnedRecogniser owned({&twice, 1}, parameters, kSide_px, kSide_px);
  ModelCamera camera("cube");
  std::mt19937 random(7);
  for (int k = 0; k < rounds(20); ++k) {
    const OwnedFrame frame = camera.view(random_direction(random));
    const Recognition seen = owned.recognise(frame.frame());
    REQUIRE(seen.objects.size() == 1);
    REQUIRE(seen.objects[0].hypotheses.size() > 1);
    CHECK(seen.objects[0].hypotheses[0].class_id >= classes);
    CHECK(seen.objects[0].hypotheses[1].class_id < classes);
  }
}

TEST_CASE("values changed between frames give what a recogniser made with them gives") {
  ModelCamera cube("cube"), l_shape("l_shape");
  const std::vector<OwnedFrame> frames = {cube.view({0.48, 0.6, 0.64}),
                                          l_shape.view({-0.6, 0.48, 0.64})};
  std::vector<VisionParameters> all(6, cube_and_l_shape()[0].vision);
  all[1].intensity_min = 300;
  all[2].chroma_step = 60;
  all[3].area_min_px = 6000;
  all[3].smooth = false;
  all[4].region_of_interest = {100, 120, 200, 260};
  all[5].one_blob = true;
  OwnedRecogniser changed = recogniser();
  std::set<std::string> answers;
  for (const VisionParameters& vision :
       {all[0], all[1], all[2], all[0], all[3], all[4], all[5], all[0]}) {
    RecogniserParameters parameters;
    parameters.vision = vision;
    OwnedRecogniser made(cube_and_l_shape(), parameters, kSide_px, kSide_px);
    REQUIRE(changed.cut_with(vision));
    for (const OwnedFrame& frame : frames) {
      const std::string answer = words(changed.recognise(frame.frame()));
      CHECK(answer == words(made.recognise(frame.frame())));
      answers.insert(answer);
    }
  }
  // The values do something.
  CHECK(answers.size() > 6);
}

TEST_CASE("what needs other memory is not changed between frames") {
  RecogniserParameters parameters;
  parameters.vision = cube_and_l_shape()[0].vision;
  parameters.vision.one_blob = true;
  OwnedRecogniser one(cube_and_l_shape(), parameters, kSide_px, kSide_px);
  VisionParameters vision = parameters.vision;
  vision.one_blob = false;
  CHECK_FALSE(one.cut_with(vision));
  vision.one_blob = true;
  CHECK(one.cut_with(vision));
  vision.sensor = SensorKind::grey;
  CHECK_FALSE(one.cut_with(vision));
}

}  // namespace aspect
