#include "compiler/aspects/view_codec.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <random>

#include "compiler/aspects/observer.h"
#include "tests/compiler/aspects/compiled_model.h"

namespace aspect {
namespace {

ObservedView seen_view(const std::string& model, const Eigen::Vector3d& direction) {
  const Scene scene = model_scene(model);
  const Result<Renderer> renderer = Renderer::create(scene);
  return Observer(renderer.value(), scene.studio, VisionParameters{}).observe(direction);
}

}  // namespace

TEST_CASE("a view that was written and read again is the same, contour by contour") {
  const ObservedView view = seen_view("holeblock", Eigen::Vector3d(0.3, 0.4, 0.9).normalized());
  REQUIRE(view.external_count > 2);
  const std::vector<std::byte> bytes = encode_view(view);
  const auto read = decode_view(view.direction, bytes);
  REQUIRE(read.has_value());
  CHECK(encode_view(*read) == bytes);
  CHECK(read->direction == view.direction);
  CHECK(read->right == view.right);
  CHECK(read->area_px == view.area_px);
  CHECK(read->external_count == view.external_count);
  REQUIRE(read->contours.size() == view.contours.size());
  for (std::size_t i = 0; i < view.contours.size(); ++i) {
    const ObservedContour &a = view.contours[i], &b = read->contours[i];
    CHECK(std::memcmp(&a.feature, &b.feature, sizeof a.feature) == 0);
    CHECK((a.external == b.external && a.shape == b.shape && a.area_px == b.area_px));
    CHECK(a.centre_object == b.centre_object);
    REQUIRE(a.surfaces.size() == b.surfaces.size());
    for (std::size_t k = 0; k < a.surfaces.size(); ++k) {
      CHECK(a.surfaces[k].surface == b.surfaces[k].surface);
      CHECK(a.surfaces[k].pixels == b.surfaces[k].pixels);
    }
  }
  REQUIRE(read->relations.size() == view.relations.size());
  for (std::size_t i = 0; i < view.relations.size(); ++i) {
    const Relation &a = view.relations[i], &b = read->relations[i];
    CHECK((a.from == b.from && a.to == b.to && a.direction == b.direction && a.kind == b.kind));
  }
}

TEST_CASE("a view cut short anywhere, or with bytes after it, is none") {
  const ObservedView view = seen_view("cube", Eigen::Vector3d(1, 1, 1).normalized());
  std::vector<std::byte> bytes = encode_view(view);
  for (std::size_t length = 0; length < bytes.size(); ++length)
    CHECK_FALSE(decode_view(view.direction, std::span(bytes).first(length)).has_value());
  bytes.push_back(std::byte{0});
  CHECK_FALSE(decode_view(view.direction, bytes).has_value());
}

TEST_CASE("whatever bytes say, relations stay between nodes") {
  const ObservedView view = seen_view("cube", Eigen::Vector3d(1, 1, 1).normalized());
  const std::vector<std::byte> bytes = encode_view(view);
  std::mt19937 random(5);
  int taken = 0;
  for (int round = 0; round < 20000; ++round) {
    std::vector<std::byte> damaged = bytes;
    for (int change = 0; change <= round % 3; ++change)
      damaged[random() % damaged.size()] = static_cast<std::byte>(random());
    const auto read = decode_view(view.direction, damaged);
    if (!read) continue;
    ++taken;
    CHECK(read->external_count <= read->contours.size());
    for (const Relation& relation : read->relations)
      CHECK((relation.from < read->external_count && relation.to < read->external_count));
  }
  CHECK(taken > 100);
}

TEST_CASE("a mapping that was written and read again is the same") {
  GraphMatch match;
  match.cost = 123.5;
  match.mapping = {3, 1, 0, 2, 255};
  const GraphMatch read = decode_match(match.cost, encode_mapping(match));
  CHECK(read.cost == match.cost);
  CHECK(read.mapping == match.mapping);
  CHECK(decode_match(kNoMatch, encode_mapping(GraphMatch{})).mapping.empty());
}

}  // namespace aspect
