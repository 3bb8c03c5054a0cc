#include "tools/score/scoring.h"

#include <catch2/catch.hpp>

#include "tools/score/score_sheet.h"

namespace aspect {
namespace {

const Eigen::Vector3d kX(1, 0, 0), kY(0, 1, 0);

TrueObject is_at(const std::string& name, PixelBox box, double visible = 1) {
  return {name, kX, box, visible};
}

FoundObject seen_at(const std::string& name, PixelBox box, const Eigen::Vector3d& view = kX) {
  return {box, true, name, view};
}

Score score_of(const std::vector<TrueFrame>& truth, const std::vector<FoundFrame>& results) {
  return score_results(truth, "nowhere", results, {});
}

TEST_CASE("An object is right where an overlapping thing has its name") {
  const std::vector<TrueFrame> truth = {
      {"0.png", {is_at("cube", {0, 0, 100, 100}), is_at("ball", {200, 0, 100, 100})}}};
  std::vector<FoundFrame> seen = {{"0.png", 0, 2.0, {}}};
  seen[0].objects = {seen_at("ball", {210, 0, 100, 100}, kY), seen_at("cube", {0, 0, 90, 100})};
  Score score = score_of(truth, seen);
  CHECK(score.all.right == 2);
  CHECK(score.objects.at("cube").median_deg == 0);
  CHECK(score.objects.at("ball").median_deg == Approx(90));
  CHECK(score.all.median_deg == Approx(45));
  CHECK(score.all.within_20 == 0.5);
  CHECK(score.falsely_named == 0);
  CHECK(frame_caption(score.frames[0]) == "0: cube (0.0), ball (90.0)");

  // Too little overlap: 29 of 171 pixels.
  seen[0].objects[1].box = {0, 71, 100, 100};
  score = score_of(truth, seen);
  CHECK(score.all.right == 1);
  CHECK(score.objects.at("cube").median_deg == kNotFound_deg);
  CHECK(score.falsely_named == 1);
  CHECK(frame_caption(score.frames[0]) ==
        "0: nothing (is cube), ball (90.0), cube (nothing known there)");
}

TEST_CASE("A thing counts for one object only, the one with the most overlap is taken") {
  const std::vector<TrueFrame> truth = {
      {"0.png", {is_at("cube", {0, 0, 100, 100}), is_at("cube", {40, 0, 100, 100})}}};
  const std::vector<FoundFrame> seen = {
      {"0.png",
       0,
       2.0,
       {seen_at("cube", {20, 0, 100, 100}, kY), seen_at("cube", {0, 0, 99, 100})}}};
  const Score score = score_of(truth, seen);
  CHECK(score.all.right == 2);
  CHECK(score.frames[0].objects[0].error_deg == 0);
  CHECK(score.frames[0].objects[1].error_deg == Approx(90));
}

TEST_CASE("What is hidden does not count, but may be found") {
  const std::vector<TrueFrame> truth = {
      {"0.png", {is_at("cube", {0, 0, 100, 100}, 0.64), is_at("ball", {200, 0, 100, 100}, 0.65)}}};
  const std::vector<FoundFrame> seen = {{"0.png", 0, 2.0, {seen_at("cube", {0, 0, 100, 100})}}};
  const Score score = score_of(truth, seen);
  CHECK(score.all.objects == 1);
  CHECK(score.all.right == 0);
  CHECK(score.objects.count("cube") == 0);
  CHECK(score.falsely_named == 0);
}

TEST_CASE("What has no verdict of a match is not named") {
  const std::vector<TrueFrame> truth = {{"0.png", {is_at("cube", {0, 0, 100, 100})}}};
  std::vector<FoundFrame> seen = {{"0.png", 0, 2.0, {seen_at("cube", {0, 0, 100, 100})}}};
  seen[0].objects[0].is_named = false;
  const Score score = score_of(truth, seen);
  CHECK(score.all.right == 0);
  CHECK(score.falsely_named == 0);
  CHECK(frame_caption(score.frames[0]) == "0: nothing (is cube)");
}

TEST_CASE("Frames are found by path, by the end of the path, and by name") {
  const std::vector<TrueFrame> truth = {{"frames/0.png", {is_at("cube", {0, 0, 10, 10})}},
                                        {"frames/1.png", {}}};
  for (const char* name : {"frames/0.png", "/far/away/frames/0.png", "0.png", "other/0.png"}) {
    INFO(name);
    const std::vector<FoundFrame> seen = {{name, 0, 2.0, {seen_at("cube", {0, 0, 10, 10})}},
                                          {"2.png", 1, 9.0, {}}};
    const Score score = score_of(truth, seen);
    CHECK(score.missing == 1);
    CHECK(score.all.right == 1);
    CHECK(score.all.median_ms == 2.0);
    CHECK(frame_caption(score.frames[1]) == "1: missing");
  }
}

TEST_CASE("Times are of the frames that show an object") {
  const std::vector<TrueFrame> truth = {
      {"0.png", {is_at("cube", {0, 0, 10, 10}), is_at("cube", {20, 0, 10, 10})}},
      {"1.png", {is_at("ball", {0, 0, 10, 10})}},
      {"2.png", {}}};
  const std::vector<FoundFrame> seen = {
      {"0.png", 0, 1.0, {}}, {"1.png", 1, 3.0, {}}, {"2.png", 2, std::nullopt, {}}};
  const Score score = score_of(truth, seen);
  CHECK(score.objects.at("cube").median_ms == 1.0);
  CHECK(score.objects.at("ball").median_ms == 3.0);
  CHECK(score.all.median_ms == 2.0);
  CHECK(frame_caption(score.frames[2]) == "2: nothing");
}

TEST_CASE("Lines of aspect-replay are read") {
  const auto cut_short = parse_results("\n{\"frame\": \"a.png\", \"objects\": [", "r");
  REQUIRE_FALSE(cut_short.ok());
  CHECK(cut_short.error().substr(0, 4) == "r:2:");
  const auto good =
      parse_results(R"({"frame":"a.png","sequence":7,"elapsed_ms":1.5,"objects":[)"
                    R"({"box":[1,2,3,4],"hypotheses":[]},{"box":[1,2,3,4],"verdict":"unknown",)"
                    R"("hypotheses":[{"object":"cube","view":[0,0,2]}]}]})"
                    "\n\n"
                    R"({"frame":"b.png","objects":[]})",
                    "r");
  REQUIRE(good.ok());
  REQUIRE(good.value().size() == 2);
  const FoundFrame& frame = good.value()[0];
  CHECK(frame.sequence == 7);
  CHECK(frame.elapsed_ms == 1.5);
  REQUIRE(frame.objects.size() == 1);
  CHECK_FALSE(frame.objects[0].is_named);
  CHECK(frame.objects[0].view.isApprox(Eigen::Vector3d(0, 0, 1)));
  CHECK_FALSE(good.value()[1].elapsed_ms);
  CHECK_FALSE(parse_results("{\"frame\":3,\"objects\":[]}", "r").ok());
  CHECK_FALSE(parse_results("[]", "r").ok());
}

}  // namespace
}  // namespace aspect
