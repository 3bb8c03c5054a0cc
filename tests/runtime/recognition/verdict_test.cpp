#include "runtime/recognition/verdict.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

namespace aspect {
namespace {

// Hypotheses with poses that agree so well, of the object with that number.
struct Ranked {
  std::vector<VerifiedPose> poses;
  std::vector<Hypothesis> list;

  explicit Ranked(const std::vector<std::pair<int, float>>& agreements) {
    poses.resize(agreements.size());
    for (std::size_t k = 0; k < agreements.size(); ++k) {
      const auto& [index, agreement] = agreements[k];
      poses[k].agreement = {agreement, agreement};
      Hypothesis hypothesis;
      hypothesis.index = static_cast<std::uint16_t>(index);
      hypothesis.score = static_cast<double>(agreement);
      hypothesis.pose = &poses[k];
      list.push_back(hypothesis);
    }
  }
};

Judgement judged(const std::vector<std::pair<int, float>>& agreements,
                 double confidence_min = 0.5) {
  std::vector<ClassIndex> indexes(2);
  for (ClassIndex& index : indexes) index.calibration = {100, 0.9F};
  return judge(Ranked(agreements).list, indexes, confidence_min);
}

}  // namespace

TEST_CASE("What agrees well and has no rival is a match") {
  const Judgement judgement = judged({{0, 0.99F}, {1, 0.5F}});
  CHECK(judgement.verdict == Verdict::match);
  CHECK(judgement.probability == Approx(1 / (1 + std::exp(-9.0))).epsilon(1e-4));
  CHECK(judgement.rival_count == 0);
}

TEST_CASE("What agrees badly is unknown, whatever else there is") {
  CHECK(judged({{0, 0.8F}}).verdict == Verdict::unknown);
  CHECK(judged({{0, 0.8F}, {1, 0.8F}}).verdict == Verdict::unknown);
  CHECK(judged({{0, 0.9F}}).probability == Approx(0.5).margin(1e-4));
}

TEST_CASE(
    "Another object that explains the picture as well makes it ambiguous, and shares the "
    "probability") {
  const Judgement judgement = judged({{0, 0.99F}, {1, 0.99F}});
  CHECK(judgement.verdict == Verdict::ambiguous);
  CHECK(judgement.probability == Approx(0.5).epsilon(0.01));
  REQUIRE(judgement.rival_count == 1);
  CHECK(judgement.rivals[0] == 1);
}

TEST_CASE("Another pose of the same object is a rival, and the object still a match") {
  const Judgement judgement = judged({{0, 0.99F}, {0, 0.985F}, {1, 0.6F}});
  CHECK(judgement.verdict == Verdict::match);
  REQUIRE(judgement.rival_count == 1);
  CHECK(judgement.rivals[0] == 1);
}

TEST_CASE("A match needs the confidence that is asked for") {
  CHECK(judged({{0, 0.92F}}, 0.5).verdict == Verdict::match);
  CHECK(judged({{0, 0.92F}}, 0.99).verdict == Verdict::unknown);
}

TEST_CASE("Without a pose there is no verdict") {
  CHECK(judge({}, {}, 0.5).verdict == Verdict::none);
  std::vector<ClassIndex> indexes(1);
  const std::vector<Hypothesis> plain(1);
  CHECK(judge(plain, indexes, 0.5).verdict == Verdict::none);
}

}  // namespace aspect
