#include "runtime/vision/relations.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <tuple>
#include <vector>

#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

using Kind = Relation::Kind;

Contour contour_at(float x, float y, std::uint16_t region, std::uint16_t inside = 0) {
  Contour contour;
  contour.centre_px = {x, y};
  contour.region = region;
  contour.inside = inside;
  return contour;
}

std::vector<Relation> relations_of(const std::vector<Contour>& contours, int relations_max = 0,
                                   std::size_t room = 4096,
                                   RelationChoice choice = RelationChoice::nearest) {
  std::vector<Relation> out(room);
  out.resize(static_cast<std::size_t>(relate(contours, choice, relations_max, out)));
  return out;
}

const Relation& relation(std::span<const Relation> all, int from, int to) {
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&](const Relation& r) { return r.from == from && r.to == to; });
  REQUIRE(found != all.end());
  return *found;
}

std::vector<Contour> scattered(std::mt19937& random, int count) {
  std::uniform_real_distribution<float> place(0, 640);
  std::vector<Contour> contours;
  for (int i = 0; i < count; ++i) {
    const Point2 centre{place(random), place(random)};
    contours.push_back(contour_at(centre.x, centre.y, static_cast<std::uint16_t>(i + 1)));
  }
  return contours;
}

double distance(const Contour& a, const Contour& b) {
  return std::hypot(static_cast<double>(a.centre_px.x) - static_cast<double>(b.centre_px.x),
                    static_cast<double>(a.centre_px.y) - static_cast<double>(b.centre_px.y));
}

// Length of the minimal spanning tree, grown from contour 0 (Prim 1957).
double prim_length(const std::vector<Contour>& contours) {
  std::vector<double> nearest;
  for (const Contour& contour : contours) nearest.push_back(distance(contours[0], contour));
  std::vector<bool> joined(contours.size(), false);
  joined[0] = true;
  double length = 0;
  for (std::size_t round = 1; round < contours.size(); ++round) {
    std::size_t next = 0;
    for (std::size_t k = 1; k < contours.size(); ++k)
      if (!joined[k] && (joined[next] || nearest[k] < nearest[next])) next = k;
    joined[next] = true;
    length += nearest[next];
    for (std::size_t k = 0; k < contours.size(); ++k)
      nearest[k] = std::min(nearest[k], distance(contours[next], contours[k]));
  }
  return length;
}

}  // namespace

TEST_CASE("direction codes are sixteenths of a turn from +x towards +y") {
  // Codes of whole sixteenths, and of vectors a little to either side of a border between two,
  // at 11.25, 33.75, ... degrees (tangents 0.1989, 0.6682, 1.4966, 5.0273).
  struct Case {
    float x, y;
    int code;
  };
  for (const Case& c : {Case{1, 0, 0},
                        Case{0.9239F, 0.3827F, 1},
                        Case{1, 1, 2},
                        Case{0.3827F, 0.9239F, 3},
                        Case{0, 1, 4},
                        Case{-1, 1, 6},
                        Case{-1, 0, 8},
                        Case{-1, -1, 10},
                        Case{0, -1, 12},
                        Case{1, -1, 14},
                        Case{0.9239F, -0.3827F, 15},
                        Case{100, 19.8F, 0},
                        Case{100, 20.0F, 1},
                        Case{100, 66.7F, 1},
                        Case{100, 67.0F, 2},
                        Case{100, 149.5F, 2},
                        Case{100, 149.9F, 3},
                        Case{100, 502.5F, 3},
                        Case{100, 503.0F, 4},
                        Case{100, -19.8F, 0},
                        Case{100, -20.0F, 15},
                        Case{-100, -19.8F, 8},
                        Case{-100, -20.0F, 9},
                        Case{-100, 19.8F, 8},
                        Case{-100, 20.0F, 7}})
    CHECK(static_cast<int>(direction_code({c.x, c.y})) == c.code);
}

TEST_CASE("the direction back is opposite") {
  std::mt19937 random(28);
  std::normal_distribution<float> value(0, 100);
  for (int i = 0; i < 20000; ++i) {
    const Point2 vector{value(random), value(random)};
    REQUIRE(direction_code({-vector.x, -vector.y}) == (direction_code(vector) + 8) % 16);
  }
  const std::vector<Contour> contours = scattered(random, 30);
  const std::vector<Relation> relations = relations_of(contours);
  REQUIRE(relations.size() == 30 * 29);
  for (const Relation& r : relations)
    REQUIRE(relation(relations, r.to, r.from).direction == (r.direction + 8) % 16);
}

TEST_CASE("direction distances count the shorter way round") {
  for (int a = 0; a < 16; ++a)
    for (int step = 0; step <= 8; ++step) {
      const auto b = static_cast<std::uint8_t>((a + step) % 16);
      REQUIRE(direction_distance(static_cast<std::uint8_t>(a), b) == step);
      REQUIRE(direction_distance(b, static_cast<std::uint8_t>(a)) == step);
    }
}

TEST_CASE("relations tell apart, inside, outside and superimposed") {
  const std::vector<Contour> contours = {contour_at(100, 100, 1), contour_at(110, 100, 2, 1),
                                         contour_at(101, 101, 3, 1), contour_at(200, 100, 4)};
  const std::vector<Relation> relations = relations_of(contours);
  CHECK(relation(relations, 0, 3).kind == Kind::apart);
  CHECK(relation(relations, 1, 0).kind == Kind::inside);
  CHECK(relation(relations, 0, 1).kind == Kind::outside);
  CHECK(relation(relations, 0, 2).kind == Kind::superimposed);
  CHECK(relation(relations, 2, 0).kind == Kind::superimposed);
  CHECK(relation(relations, 1, 2).kind == Kind::apart);
  CHECK(relation(relations, 0, 3).direction == 0);
  CHECK(relation(relations, 3, 0).direction == 8);
}

TEST_CASE("two holes of a region are apart, and both are inside it") {
  std::vector<Contour> contours = {contour_at(100, 100, 1), contour_at(60, 100, 1, 1),
                                   contour_at(140, 100, 1, 1)};
  contours[1].external = contours[2].external = false;
  const std::vector<Relation> relations = relations_of(contours);
  CHECK(relation(relations, 1, 0).kind == Kind::inside);
  CHECK(relation(relations, 0, 2).kind == Kind::outside);
  CHECK(relation(relations, 1, 2).kind == Kind::apart);
  CHECK(relation(relations, 2, 1).kind == Kind::apart);
}

TEST_CASE("what fills one hole of a region is inside that hole and apart from the other") {
  cv::Mat picture = cv::Mat::zeros(120, 200, CV_8UC3);
  picture(cv::Rect(5, 5, 190, 110)) = colour(0);
  picture(cv::Rect(20, 20, 60, 80)) = cv::Scalar();
  picture(cv::Rect(110, 30, 70, 50)) = colour(1);
  OwnedVision vision(200, 120);
  const ViewGraph graph = vision.run(picture, exact_parameters());
  REQUIRE(graph.contours.size() == 4);
  const auto index = [&](bool external, int x) {
    for (std::size_t k = 0; k < graph.contours.size(); ++k)
      if (graph.contours[k].external == external &&
          std::abs(graph.contours[k].centre_px.x - static_cast<float>(x)) < 8)
        return static_cast<int>(k);
    return -1;
  };
  // The centre of the frame moves with the areas of its two holes.
  const int frame = 0, empty = index(false, 50), full = index(false, 145),
            filling = index(true, 145);
  REQUIRE(empty > 0);
  REQUIRE(full > 0);
  REQUIRE(filling > 0);
  CHECK(relation(graph.relations, filling, frame).kind == Kind::inside);
  CHECK(relation(graph.relations, frame, filling).kind == Kind::outside);
  CHECK(relation(graph.relations, filling, empty).kind == Kind::apart);
  CHECK(relation(graph.relations, empty, filling).kind == Kind::apart);
  CHECK(relation(graph.relations, filling, full).kind == Kind::superimposed);
}

TEST_CASE("a disc in a square ring is inside it, two rings deep") {
  cv::Mat picture = cv::Mat::zeros(200, 200, CV_8UC3);
  picture(cv::Rect(10, 10, 180, 180)) = colour(0);
  picture(cv::Rect(30, 30, 120, 120)) = colour(1);
  cv::circle(picture, {80, 90}, 30, colour(2), cv::FILLED);
  OwnedVision vision(200, 200);
  const ViewGraph graph = vision.run(picture);
  int ring = -1, inner = -1, disc = -1;
  for (std::size_t k = 0; k < graph.contours.size(); ++k) {
    const Contour& contour = graph.contours[k];
    if (!contour.external) continue;
    const float blue = contour.mean_rgb[2];
    (contour.mean_rgb[0] > 150 ? ring : blue > 150 ? disc : inner) = static_cast<int>(k);
  }
  REQUIRE(ring >= 0);
  REQUIRE(inner >= 0);
  REQUIRE(disc >= 0);
  const auto at = [&](int k) { return graph.contours[static_cast<std::size_t>(k)]; };
  CHECK(at(ring).inside == 0);
  CHECK(at(inner).inside == at(ring).region);
  CHECK(at(disc).inside == at(inner).region);
  CHECK(relation(graph.relations, inner, ring).kind == Kind::inside);
  CHECK(relation(graph.relations, disc, inner).kind == Kind::inside);
  CHECK(relation(graph.relations, inner, disc).kind == Kind::outside);
  CHECK(relation(graph.relations, disc, ring).kind == Kind::apart);
}

TEST_CASE("the greatest number of relations keeps the shortest, in order") {
  std::mt19937 random(29);
  const std::vector<Contour> contours = scattered(random, 20);
  const std::vector<Relation> all = relations_of(contours);
  const auto length = [&](const Relation& r) {
    const Point2 a = contours[r.from].centre_px, b = contours[r.to].centre_px;
    return std::hypot(a.x - b.x, a.y - b.y);
  };
  for (const int most : {1, 7, 50, 379, 380, 1000}) {
    const std::vector<Relation> kept = relations_of(contours, most);
    REQUIRE(kept.size() == std::min<std::size_t>(static_cast<std::size_t>(most), all.size()));
    float longest = 0;
    for (const Relation& r : kept) longest = std::max(longest, length(r));
    const auto shorter = std::count_if(
        all.begin(), all.end(), [&](const Relation& r) { return length(r) < longest * 0.9999F; });
    REQUIRE(shorter <= most);
    REQUIRE(std::is_sorted(kept.begin(), kept.end(), [](const Relation& p, const Relation& q) {
      return std::tuple(p.from, p.to) < std::tuple(q.from, q.to);
    }));
    for (const Relation& r : kept) REQUIRE(relation(all, r.from, r.to).direction == r.direction);
  }
}

TEST_CASE("important relations join the large contours first") {
  std::mt19937 random(31);
  std::vector<Contour> contours = scattered(random, 12);
  for (std::size_t k = 0; k < contours.size(); ++k) contours[k].area_px = k < 4 ? 1e9F : 10;
  const std::vector<Relation> kept = relations_of(contours, 12, 4096, RelationChoice::important);
  REQUIRE(kept.size() == 12);
  for (const Relation& r : kept) CHECK((r.from < 4 && r.to < 4));
}

TEST_CASE("the tree of relations joins all contours at the least length") {
  std::mt19937 random(32);
  for (std::size_t count = 2; count <= 40; ++count) {
    const std::vector<Contour> contours = scattered(random, static_cast<int>(count));
    const std::vector<Relation> tree = relations_of(contours, 0, 4096, RelationChoice::tree);
    REQUIRE(tree.size() == 2 * (count - 1));
    double length = 0;
    for (const Relation& r : tree) length += distance(contours[r.from], contours[r.to]) / 2;
    CHECK(length == Approx(prim_length(contours)));
    for (const Relation& r : tree) relation(tree, r.to, r.from);
    const std::vector<Relation> more =
        relations_of(contours, static_cast<int>(2 * count + 4), 4096, RelationChoice::tree);
    CHECK(more.size() == std::min(2 * count + 4, count * (count - 1)));
    for (const Relation& r : tree) relation(more, r.from, r.to);
  }
}

TEST_CASE("relations never exceed the room they are given") {
  std::mt19937 random(30);
  const std::vector<Contour> contours = scattered(random, 10);
  REQUIRE(relations_of(contours, 0, 13).size() == 13);
  REQUIRE(relations_of(contours, 5, 13).size() == 5);
  REQUIRE(relations_of(contours, 0, 0).empty());
  REQUIRE(relations_of({}, 0).empty());
  REQUIRE(relations_of({contour_at(1, 1, 1)}, 0).empty());
}

}  // namespace aspect
