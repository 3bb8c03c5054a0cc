#include <array>
#include <catch2/catch.hpp>

#include "tests/rounds.h"
#include "tests/runtime/base/allocation_counter.h"
#include "tests/runtime/recognition/owned_recogniser.h"
#include "tests/runtime/recognition/rendered_views.h"

namespace aspect {
namespace {

std::vector<OwnedFrame> varied_frames() {
  std::mt19937 random(1);
  ModelCamera cube("cube"), l_shape("l_shape");
  std::vector<OwnedFrame> frames;
  for (int k = 0; k < 10; ++k) {
    frames.push_back(cube.view(random_direction(random), k));
    frames.push_back(l_shape.view(random_direction(random), k));
    frames.push_back(beside(frames[frames.size() - 2], frames.back()));
  }
  frames.push_back({64, 64, std::vector<std::uint8_t>(std::size_t{3} * 64 * 64)});
  OwnedFrame noise{256, 256, std::vector<std::uint8_t>(std::size_t{3} * 256 * 256)};
  for (std::uint8_t& byte : noise.rgb) byte = static_cast<std::uint8_t>(random());
  frames.push_back(noise);
  // Both where there is no background, hiding a part of each other.
  OwnedFrame clutter = striped(1024, 512);
  paste(cube.view(random_direction(random)), 100, 0, clutter);
  paste(l_shape.view(random_direction(random)), 350, 0, clutter);
  frames.push_back(clutter);
  return frames;
}

}  // namespace

TEST_CASE("a thousand frames are recognised without memory from the heap") {
  const std::vector<OwnedFrame> frames = varied_frames();
  OwnedRecogniser owned(cube_and_l_shape(), {}, 1024, 512);
  std::array<std::size_t, 33> first_time{};
  REQUIRE(frames.size() == first_time.size());
  const auto all = static_cast<std::size_t>(rounds(1000));
  std::size_t answers = 0, changed = 0;
  const std::uint64_t before = allocation_count();
  for (std::size_t i = 0; i < all; ++i) {
    std::size_t hypotheses = 0;
    for (const SeenObject& object : owned.recognise(frames[i % frames.size()].frame()).objects)
      hypotheses += object.hypotheses.size();
    if (i < frames.size()) first_time[i] = hypotheses;
    changed += hypotheses == first_time[i % frames.size()] ? 0U : 1U;
    answers += hypotheses;
  }
  CHECK(allocation_count() - before == 0);
  CHECK(answers > 5 * all);
  CHECK(first_time.back() > 0);
  // Nothing is used up from frame to frame.
  CHECK(changed == 0);
}

TEST_CASE("what moves, is lost and comes back is followed without memory from the heap") {
  ModelCamera cube("cube");
  std::vector<OwnedFrame> frames;
  for (int k = 0; k < 12; ++k) {
    frames.push_back(striped(1024, 512));
    if (k != 7) paste(cube.view({0.48, 0.6, 0.64}, 0.03 * k), 20 * k, 0, frames.back());
  }
  RecogniserParameters parameters;
  parameters.tracking = {true, 5};
  OwnedRecogniser owned(cube_and_l_shape(), parameters, 1024, 512);
  int followed = 0;
  const std::uint64_t before = allocation_count();
  for (int k = 0; k < rounds(96); ++k)
    for (const SeenObject& object :
         owned.recognise(frames[static_cast<std::size_t>(k) % frames.size()].frame()).objects)
      followed += object.track > 0 ? 1 : 0;
  CHECK(allocation_count() - before == 0);
  CHECK(followed > rounds(96) / 2);
}

TEST_CASE("values are changed between frames without memory from the heap") {
  const std::vector<OwnedFrame> frames = varied_frames();
  OwnedRecogniser owned(cube_and_l_shape(), {}, 1024, 512);
  VisionParameters vision = cube_and_l_shape()[0].vision;
  int refused = 0;
  const std::uint64_t before = allocation_count();
  for (int k = 0; k < rounds(60); ++k) {
    vision.chroma_step = 2 + k % 40;
    vision.area_min_px = 1 + k * k % 500;
    vision.one_blob = k % 7 == 3;
    vision.smooth = k % 2 == 0;
    vision.region_of_interest = k % 3 == 0 ? Box{} : Box{k, k / 2, 800 - k, 400};
    refused += owned.cut_with(vision) ? 0 : 1;
    owned.recognise(frames[static_cast<std::size_t>(k) % frames.size()].frame());
  }
  CHECK(allocation_count() - before == 0);
  CHECK(refused == 0);
}

TEST_CASE("frames whose time is over anywhere are recognised without memory from the heap") {
  const std::vector<OwnedFrame> frames = varied_frames();
  std::vector<OwnedRecogniser> within;
  for (const int limit_us : {1, 3000, 6000, 1'000'000}) {
    RecogniserParameters parameters;
    parameters.time_limit = std::chrono::microseconds(limit_us);
    parameters.tracking = {limit_us != 6000, 2};
    within.emplace_back(cube_and_l_shape(), parameters, 1024, 512);
  }
  int cut = 0, whole = 0;
  const std::uint64_t before = allocation_count();
  for (int k = 0; k < rounds(100); ++k)
    for (OwnedRecogniser& owned : within)
      (owned.recognise(frames[static_cast<std::size_t>(k) % frames.size()].frame())
               .left_undone.any()
           ? cut
           : whole) += 1;
  CHECK(allocation_count() - before == 0);
  CHECK(cut > 0);
  CHECK(whole > 0);
}

TEST_CASE("the counter that says so counts in this program") {
  const std::uint64_t before = allocation_count();
  const std::vector<OwnedFrame> frames = varied_frames();
  CHECK(allocation_count() > before);
}

}  // namespace aspect
