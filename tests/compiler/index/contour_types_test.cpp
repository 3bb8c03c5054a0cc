#include "compiler/index/contour_types.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/core.hpp>
#include <random>
#include <set>

#include "compiler/index/class_model.h"
#include "tests/compiler/aspects/compiled_model.h"

namespace aspect {
namespace {

using Samples = std::vector<TypeAttributes>;

double squared_distance(const TypeAttributes& a, const TypeAttributes& b) {
  double sum = 0;
  for (std::size_t d = 0; d < kTypeDimensions; ++d) {
    const double difference = static_cast<double>(a[d]) - static_cast<double>(b[d]);
    sum += difference * difference;
  }
  return sum;
}

// The sum that k-means makes small.
double scatter(const Samples& samples, const Samples& types) {
  double sum = 0;
  for (const TypeAttributes& sample : samples) {
    double least = std::numeric_limits<double>::infinity();
    for (const TypeAttributes& type : types)
      least = std::min(least, squared_distance(sample, type));
    sum += least;
  }
  return sum;
}

double opencv_scatter(const Samples& samples, std::size_t count) {
  const cv::Mat data(static_cast<int>(samples.size()), static_cast<int>(kTypeDimensions), CV_32F,
                     const_cast<float*>(samples.front().data()));
  cv::Mat labels;
  cv::setRNGSeed(1);
  return cv::kmeans(data, static_cast<int>(count), labels,
                    {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-6}, 5,
                    cv::KMEANS_PP_CENTERS);
}

TypeAttributes random_point(std::mt19937& random, float size) {
  std::uniform_real_distribution<float> coordinate(0, size);
  TypeAttributes point;
  for (float& x : point) x = coordinate(random);
  return point;
}

// Around each centre equally many, normally distributed with deviation 1.
Samples blobs(std::mt19937& random, const Samples& centres, std::size_t each) {
  std::normal_distribution<float> noise(0, 1);
  Samples samples;
  for (std::size_t i = 0; i < each * centres.size(); ++i) {
    TypeAttributes sample = centres[i % centres.size()];
    for (float& x : sample) x += noise(random);
    samples.push_back(sample);
  }
  return samples;
}

// Centres none of which is nearer than `apart` to another.
Samples separate_centres(std::mt19937& random, std::size_t count, double apart) {
  Samples centres;
  while (centres.size() < count) {
    const TypeAttributes point = random_point(random, 100);
    const bool free = std::all_of(centres.begin(), centres.end(), [&](const TypeAttributes& c) {
      return squared_distance(point, c) > apart * apart;
    });
    if (free) centres.push_back(point);
  }
  return centres;
}

}  // namespace

TEST_CASE("separate blobs are found, each by one type at its middle") {
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    const Samples centres = separate_centres(random, 2 + static_cast<std::size_t>(round) % 12, 40);
    const Samples types = find_contour_types(blobs(random, centres, 100), centres.size());
    INFO("round " << round << ", " << centres.size() << " blobs");
    REQUIRE(types.size() == centres.size());
    for (const TypeAttributes& centre : centres) {
      const auto near = std::count_if(types.begin(), types.end(), [&](const TypeAttributes& type) {
        return squared_distance(type, centre) < 1;
      });
      CHECK(near == 1);
    }
  }
}

TEST_CASE("types scatter at most a tenth more than the best of five attempts of OpenCV's") {
  std::mt19937 random(2);
  std::vector<Samples> sets = {blobs(random, separate_centres(random, 12, 20), 200),
                               blobs(random, {random_point(random, 1)}, 3000)};
  for (const auto& [name, level] : {std::pair("cube", 3), {"l_shape", 3}, {"holeblock", 3}}) {
    const CompiledModel& model = compiled_model(name, level);
    sets.push_back(contour_samples(model.subdivision, model.clusters));
  }
  for (std::size_t set = 0; set < sets.size(); ++set) {
    for (const std::size_t count : {5U, 12U, 60U}) {
      const double ours = scatter(sets[set], find_contour_types(sets[set], count));
      INFO("set " << set << ", " << count << " types");
      CHECK(ours <= 1.1 * opencv_scatter(sets[set], count));
    }
  }
}

TEST_CASE("the same samples give the same types, for one thread and for two") {
  std::mt19937 random(3);
  const Samples samples = blobs(random, separate_centres(random, 9, 5), 500);
  const Samples types = find_contour_types(samples, 20);
  for (const std::size_t threads : {1U, 2U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    CHECK(find_contour_types(samples, 20) == types);
  }
}

TEST_CASE("fewer different samples than types give one type a sample") {
  std::mt19937 random(4);
  const Samples different = separate_centres(random, 4, 1);
  Samples samples;
  for (std::size_t i = 0; i < 50; ++i) samples.push_back(different[i % 4]);
  const Samples types = find_contour_types(samples, 10);
  CHECK(std::set<TypeAttributes>(types.begin(), types.end()) ==
        std::set<TypeAttributes>(different.begin(), different.end()));
  CHECK(types.size() == 4);
  CHECK(find_contour_types({}, 10).empty());
  CHECK(find_contour_types(samples, 0).empty());
  CHECK(find_contour_types(samples, 1).size() == 1);
}

TEST_CASE("more samples than are looked at give about the same types") {
  std::mt19937 random(5);
  const Samples centres = separate_centres(random, 3, 40);
  const Samples types = find_contour_types(blobs(random, centres, 150000), 3);
  REQUIRE(types.size() == 3);
  for (const TypeAttributes& type : types)
    CHECK(squared_distance(type, centres[nearest_type(centres, type)]) < 0.01);
  CHECK(nearest_type(centres, types[0]) != nearest_type(centres, types[1]));
}

TEST_CASE("the nearest type is the nearest, and the lower one of two as near") {
  std::mt19937 random(6);
  Samples types;
  for (int k = 0; k < 30; ++k) types.push_back(random_point(random, 1));
  types.insert(types.end(), types.begin(), types.begin() + 10);
  for (int round = 0; round < 1000; ++round) {
    const TypeAttributes sample = random_point(random, 1);
    const std::uint16_t found = nearest_type(types, sample);
    CHECK(found < 30);
    for (const TypeAttributes& type : types)
      CHECK(squared_distance(types[found], sample) <= squared_distance(type, sample) + 1e-6);
  }
}

}  // namespace aspect
