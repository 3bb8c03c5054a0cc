#include "runtime/vision/components.h"

#include <catch2/catch.hpp>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "runtime/vision/vision_limits.h"
#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

struct OwnedComponents {
  OwnedArena memory;
  Components components;
  explicit OwnedComponents(cv::Size size)
      : memory(static_cast<std::size_t>(16 * size.area() + 64 * (size.width + size.height) + 256)) {
    Arena arena = memory.arena();
    components.take(arena, size.width, size.height);
  }
};

Box whole(const cv::Mat& mask) {
  return {0, 0, mask.cols, mask.rows};
}

std::span<ComponentRun> run_on(Components& components, const cv::Mat& mask, const Box& box) {
  return components.run(box, [&](int y) {
    const auto* row = mask.ptr<std::uint8_t>(y);
    return RowLinks{row, row, row};
  });
}

// Roots of the runs' pixels plus one, 0 elsewhere; checks that runs do not overlap.
cv::Mat painted(std::span<const ComponentRun> runs, cv::Size size) {
  cv::Mat labels = cv::Mat::zeros(size, CV_32S);
  for (const ComponentRun& run : runs)
    for (int x = run.begin; x < run.end; ++x) {
      REQUIRE(labels.at<int>(run.row, x) == 0);
      labels.at<int>(run.row, x) = run.root + 1;
    }
  return labels;
}

void check_against_opencv(const cv::Mat& mask) {
  // Room for twice as many runs: masks are more crowded than pictures.
  OwnedComponents owned({mask.cols, 2 * mask.rows});
  const std::span<ComponentRun> runs = run_on(owned.components, mask, whole(mask));
  REQUIRE(owned.components.dropped_rows() == 0);
  cv::Mat expected, stats, centres;
  cv::connectedComponentsWithStats(mask, expected, stats, centres, 4, CV_32S);
  REQUIRE(same_partition(painted(runs, mask.size()), expected));
  for (const ComponentRun& run : runs) {
    const ComponentRun& root = runs[static_cast<std::size_t>(run.root)];
    REQUIRE(root.root == run.root);
    REQUIRE(root.area_px == stats.at<int>(expected.at<int>(run.row, run.begin), cv::CC_STAT_AREA));
    for (int x = run.begin; x < run.end; ++x) REQUIRE(&owned.components.run_at(x, run.row) == &run);
  }
}

}  // namespace

TEST_CASE("components of random masks are OpenCV's, with their areas") {
  std::mt19937 random(4);
  for (const cv::Size size :
       {cv::Size(1, 1), cv::Size(1, 40), cv::Size(40, 1), cv::Size(2, 2), cv::Size(7, 5),
        cv::Size(17, 33), cv::Size(64, 48), cv::Size(131, 77)})
    for (const double density : {0.0, 0.03, 0.3, 0.5, 0.6, 0.7, 0.9, 1.0}) {
      const cv::Mat mask = random_mask(random, size, density);
      // Rarely more runs than there is room for: those are the next test's.
      int runs = 0;
      for (int y = 0; y < mask.rows; ++y)
        for (int x = 0; x < mask.cols; ++x)
          if (mask.at<std::uint8_t>(y, x) != 0 && (x == 0 || mask.at<std::uint8_t>(y, x - 1) == 0))
            ++runs;
      if (runs <= 2 * size.area() / kRunsPerPixelDivisor + size.width) check_against_opencv(mask);
    }
}

TEST_CASE("combs and nested cups, whose parts join late, are joined") {
  cv::Mat comb = cv::Mat::zeros(40, 41, CV_8U);
  for (int x = 0; x < 41; x += 5) comb.col(x) = 255;
  comb.row(39) = 255;
  comb.at<std::uint8_t>(39, 22) = 0;
  check_against_opencv(comb);
  cv::Mat cups = cv::Mat::zeros(40, 60, CV_8U);
  for (int k = 0; k < 28; k += 3) cv::rectangle(cups, cv::Rect(k, -5, 60 - 2 * k, 44 - k), 255);
  check_against_opencv(cups);
  cv::flip(cups, cups, 0);
  check_against_opencv(cups);
}

TEST_CASE("components of a box do not look outside it") {
  std::mt19937 random(5);
  const cv::Mat mask = random_mask(random, {50, 40}, 0.65);
  const Box box{11, 7, 23, 19};
  OwnedComponents owned(mask.size());
  const cv::Mat found = painted(run_on(owned.components, mask, box), mask.size());
  const cv::Rect part(box.x, box.y, box.width, box.height);
  cv::Mat expected;
  cv::connectedComponents(mask(part), expected, 4, CV_32S);
  REQUIRE(same_partition(found(part), expected));
  REQUIRE(cv::countNonZero(found) == cv::countNonZero(found(part)));
}

TEST_CASE("a link that is missing parts pixels that touch") {
  // Two columns wide, joined only along the bottom row.
  const std::uint8_t counts[] = {255, 255}, apart[] = {0, 0}, joined[] = {0, 255},
                     up[] = {255, 255};
  OwnedComponents owned({8, 8});
  const auto links = [&](int y) { return RowLinks{counts, y == 2 ? joined : apart, up}; };
  const std::span<ComponentRun> runs = owned.components.run({0, 0, 2, 3}, links);
  REQUIRE(runs.size() == 5);
  for (const ComponentRun& run : runs) REQUIRE(run.root == 0);
  REQUIRE(runs[0].area_px == 6);
  // Where nothing links upwards, rows stay apart too.
  const auto rows = [&](int) { return RowLinks{counts, joined, apart}; };
  for (const ComponentRun& run : owned.components.run({0, 0, 2, 3}, rows))
    REQUIRE(run.root == run.row);
  const std::span<ComponentRun> two = owned.components.run({0, 0, 2, 2}, links);
  REQUIRE(two.size() == 4);
  REQUIRE(two[3].root == 1);
}

TEST_CASE("too many runs drop the lowest rows and leave the rest right") {
  for (const cv::Size size : {cv::Size(64, 64), cv::Size(101, 37)}) {
    cv::Mat mask = cv::Mat::zeros(size, CV_8U);
    for (int x = 0; x < size.width; x += 2) mask.col(x) = 255;
    OwnedComponents owned(size);
    for (int round = 0; round < 2; ++round) {
      const std::span<ComponentRun> runs = run_on(owned.components, mask, whole(mask));
      const int kept = size.height - owned.components.dropped_rows();
      REQUIRE(owned.components.dropped_rows() > 0);
      REQUIRE(runs.size() <=
              static_cast<std::size_t>(size.area() / kRunsPerPixelDivisor + size.width));
      REQUIRE(runs.size() == static_cast<std::size_t>(kept * ((size.width + 1) / 2)));
      for (const ComponentRun& run : runs) REQUIRE(run.row < kept);
      for (const ComponentRun& run : runs.first(static_cast<std::size_t>((size.width + 1) / 2)))
        REQUIRE(run.area_px == kept);
    }
    // The next, easier picture is not harmed.
    const cv::Mat full(size, CV_8U, 255);
    const std::span<ComponentRun> runs = run_on(owned.components, full, whole(full));
    REQUIRE(owned.components.dropped_rows() == 0);
    REQUIRE(runs[0].area_px == size.area());
  }
}

TEST_CASE("the end of equal bytes is found at every offset and length") {
  std::vector<std::uint8_t> bytes(40);
  for (const std::uint8_t value : {std::uint8_t{0}, std::uint8_t{255}}) {
    for (int from = 0; from < 40; ++from)
      for (int stop = from; stop <= 40; ++stop) {
        std::fill(bytes.begin(), bytes.end(), value);
        if (stop < 40) bytes[static_cast<std::size_t>(stop)] = static_cast<std::uint8_t>(~value);
        REQUIRE(end_of_bytes(bytes.data(), from, 40, value) == stop);
        REQUIRE(end_of_bytes(bytes.data(), from, std::max(from, stop - 1), value) ==
                std::max(from, stop - 1));
      }
  }
}

}  // namespace aspect
