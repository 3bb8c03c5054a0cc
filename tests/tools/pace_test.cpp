#include "tools/replay/pace.h"

#include <catch2/catch.hpp>
#include <cstdio>
#include <thread>

namespace aspect {
namespace {

using namespace std::chrono_literals;

struct Report {
  int frames = 0, late = 0;
  double fps = 0, lateness_ms = 0, median_ms = 0, most_ms = 0;
};

Report read(const std::string& line) {
  INFO(line);
  Report report;
  const int numbers = std::sscanf(line.c_str(),
                                  "%d frames at %lf a second: %d started late, by %lf ms at most; "
                                  "from due to written %lf ms median, %lf ms 99th percentile",
                                  &report.frames, &report.fps, &report.late, &report.lateness_ms,
                                  &report.median_ms, &report.most_ms);
  REQUIRE(numbers == 6);
  return report;
}

}  // namespace

TEST_CASE("A frame that takes too long makes the next one late, and the pace goes on from there") {
  Pace pace(20);
  const auto begin = Pace::Clock::now();
  for (int k = 0; k < 4; ++k) {
    pace.wait();
    if (k == 0) std::this_thread::sleep_for(170ms);
    pace.finish();
  }
  const std::chrono::duration<double, std::milli> took = Pace::Clock::now() - begin;
  const Report report = read(pace.report());
  CHECK(report.frames == 4);
  CHECK(report.fps == 20);
  // The second was due at 50 ms; the third is due a period after 170 - 50 ms, and so late no more.
  CHECK(report.late >= 1);
  CHECK(report.lateness_ms >= 119);
  CHECK(report.most_ms >= 169);
  CHECK(report.median_ms <= report.most_ms);
  CHECK(took.count() >= 219);
}

TEST_CASE("Without a rate, or without frames, there is nothing to report") {
  Pace fast(std::nullopt);
  fast.wait();
  fast.finish();
  CHECK(fast.report() == "");
  CHECK(Pace(30.0).report() == "");
}

}  // namespace aspect
