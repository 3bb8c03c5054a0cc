#include "compiler/store/store.h"

#include <bit>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <utility>

#include "tests/compiler/store/store_samples.h"

namespace aspect {
namespace {

void check_sample_store(const Store& store) {
  const std::vector<StoredView> views = views_of(store);
  REQUIRE(views.size() == 300);
  for (int i = 0; i < 300; ++i) {
    const StoredView& stored = views[static_cast<std::size_t>(i)];
    REQUIRE(stored.direction == sample_direction(i));
    REQUIRE(stored.view == sample_bytes(i));
  }
  const std::vector<StoredMatch> matches = matches_of(store);
  REQUIRE(matches.size() == 299);
  for (int i = 1; i < 300; ++i) {
    const StoredMatch& stored = matches[static_cast<std::size_t>(i - 1)];
    REQUIRE(stored.from == sample_direction(i - 1));
    REQUIRE(stored.to == sample_direction(i));
    REQUIRE(stored.cost == i);
    REQUIRE(stored.mapping == sample_bytes(i));
  }
}

TEST_CASE("a new store is empty") {
  const TemporaryFolder folder;
  const Store store = open_sound(folder / "new.store");
  CHECK(views_of(store).empty());
  CHECK(matches_of(store).empty());
}

TEST_CASE("an empty file becomes a store") {
  const TemporaryFolder folder;
  std::ofstream(folder / "empty.store").close();
  REQUIRE(std::filesystem::file_size(folder / "empty.store") == 0);
  write_sample_store(folder / "empty.store");
  check_sample_store(open_sound(folder / "empty.store"));
}

TEST_CASE("what was added is there after reopening, in order") {
  const TemporaryFolder folder;
  write_sample_store(folder / "a.store");
  check_sample_store(open_sound(folder / "a.store"));
}

TEST_CASE("a closed store is a single file") {
  const TemporaryFolder folder;
  write_sample_store(folder / "a.store");
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    ++files;
  }
  CHECK(files == 1);
}

TEST_CASE("what was added is visited before it is committed") {
  const TemporaryFolder folder;
  Store store = open_sound(folder / "a.store");
  REQUIRE(store.add_view(sample_direction(1), sample_bytes(1)).ok());
  CHECK(views_of(store).size() == 1);
}

TEST_CASE("a reopened store goes on where it was") {
  const TemporaryFolder folder;
  write_sample_store(folder / "a.store");
  {
    Store store = open_sound(folder / "a.store");
    REQUIRE(store.add_view(sample_direction(300), sample_bytes(300)).ok());
    REQUIRE(store.add_match(sample_direction(0), sample_direction(300), 7, {}).ok());
  }
  const Store store = open_sound(folder / "a.store");
  CHECK(views_of(store).size() == 301);
  CHECK(matches_of(store).size() == 300);
  CHECK(matches_of(store)[1].to == sample_direction(300));
}

TEST_CASE("directions are told apart by their bits") {
  const TemporaryFolder folder;
  const double after = std::nextafter(0.5, 1.0);
  const std::vector<Eigen::Vector3d> directions{
      {0.5, 0.0, 1.0},
      {0.5, -0.0, 1.0},
      {after, 0.0, 1.0},
      {1.0, 0.0, 0.5},
      {std::numeric_limits<double>::denorm_min(), 0.0, 1.0}};
  {
    Store store = open_sound(folder / "a.store");
    for (const Eigen::Vector3d& direction : directions) {
      REQUIRE(store.add_view(direction, sample_bytes(1)).ok());
    }
  }
  const std::vector<StoredView> views = views_of(open_sound(folder / "a.store"));
  REQUIRE(views.size() == directions.size());
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      CHECK(std::bit_cast<std::uint64_t>(views[i].direction[axis]) ==
            std::bit_cast<std::uint64_t>(directions[i][axis]));
    }
  }
}

TEST_CASE("costs keep their bits, the infinite ones too") {
  const TemporaryFolder folder;
  const std::vector<double> costs{0.0,
                                  0.1,
                                  1e300,
                                  std::numeric_limits<double>::denorm_min(),
                                  9e15 + 1,
                                  1.0,
                                  std::numeric_limits<double>::infinity()};
  Store store = open_sound(folder / "a.store");
  REQUIRE(store.add_view(sample_direction(0), {}).ok());
  for (int i = 0; i < static_cast<int>(costs.size()); ++i) {
    REQUIRE(store.add_view(sample_direction(i + 1), {}).ok());
    const double cost = costs[static_cast<std::size_t>(i)];
    REQUIRE(store.add_match(sample_direction(0), sample_direction(i + 1), cost, {}).ok());
  }
  const std::vector<StoredMatch> matches = matches_of(store);
  REQUIRE(matches.size() == costs.size());
  for (std::size_t i = 0; i < costs.size(); ++i) CHECK(matches[i].cost == costs[i]);
}

TEST_CASE("adding again replaces, and keeps the matches of a view") {
  const TemporaryFolder folder;
  Store store = open_sound(folder / "a.store");
  REQUIRE(store.add_view(sample_direction(0), sample_bytes(5)).ok());
  REQUIRE(store.add_view(sample_direction(1), sample_bytes(6)).ok());
  REQUIRE(store.add_match(sample_direction(0), sample_direction(1), 3, sample_bytes(7)).ok());
  REQUIRE(store.add_view(sample_direction(0), sample_bytes(8)).ok());
  CHECK(views_of(store).size() == 2);
  CHECK(views_of(store)[0].view == sample_bytes(8));
  CHECK(matches_of(store).size() == 1);
}

TEST_CASE("two views have one match, which keeps the direction of its mapping") {
  const TemporaryFolder folder;
  Store store = open_sound(folder / "a.store");
  for (int i = 0; i < 2; ++i) REQUIRE(store.add_view(sample_direction(i), {}).ok());
  REQUIRE(store.add_match(sample_direction(0), sample_direction(1), 3, sample_bytes(7)).ok());
  REQUIRE(store.add_match(sample_direction(1), sample_direction(0), 4, sample_bytes(8)).ok());
  const std::vector<StoredMatch> matches = matches_of(store);
  REQUIRE(matches.size() == 1);
  CHECK(matches[0].from == sample_direction(1));
  CHECK(matches[0].to == sample_direction(0));
  CHECK(matches[0].cost == 4);
  CHECK(matches[0].mapping == sample_bytes(8));
}

TEST_CASE("a match of a view that was never added is refused and the store goes on") {
  const TemporaryFolder folder;
  Store store = open_sound(folder / "a.store");
  REQUIRE(store.add_view(sample_direction(0), {}).ok());
  const Result<Done> match = store.add_match(sample_direction(0), sample_direction(1), 3, {});
  REQUIRE_FALSE(match.ok());
  CHECK_THAT(match.error(), Catch::Contains("never added"));
  CHECK(store.add_view(sample_direction(1), {}).ok());
  CHECK(store.add_match(sample_direction(0), sample_direction(1), 3, {}).ok());
}

TEST_CASE("a moved store keeps what it had, and moving onto one closes it") {
  const TemporaryFolder folder;
  Store first = open_sound(folder / "a.store");
  REQUIRE(first.add_view(sample_direction(0), {}).ok());
  Store moved = std::move(first);
  REQUIRE(moved.add_view(sample_direction(1), {}).ok());
  moved = open_sound(folder / "b.store");
  CHECK(views_of(moved).empty());
  CHECK(views_of(open_sound(folder / "a.store")).size() == 2);
}

TEST_CASE("a visit may throw and the store can still be used") {
  const TemporaryFolder folder;
  write_sample_store(folder / "a.store");
  Store store = open_sound(folder / "a.store");
  const auto give_up = [](const Eigen::Vector3d&, Store::Bytes) { throw 1; };
  CHECK_THROWS_AS(store.each_view(give_up).ok(), int);
  CHECK(store.add_view(sample_direction(400), {}).ok());
  CHECK(store.flush().ok());
  CHECK(views_of(store).size() == 301);
}

TEST_CASE("100,000 views of 500 bytes are written in less than two seconds") {
  const TemporaryFolder folder;
  const ByteList view = sample_bytes(1, 500);
  const auto begin = std::chrono::steady_clock::now();
  {
    Store store = open_sound(folder / "a.store");
    for (int i = 0; i < 100000; ++i) {
      if (!store.add_view(sample_direction(i), view).ok()) FAIL();
    }
    REQUIRE(store.flush().ok());
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  CHECK(seconds.count() < 2);
  CHECK(views_of(open_sound(folder / "a.store")).size() == 100000);
}

}  // namespace
}  // namespace aspect
