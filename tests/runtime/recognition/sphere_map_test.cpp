// Maps out of random bits. Run under the sanitizers and on devices too.
#include "runtime/recognition/sphere_map.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "runtime/base/fnv1a.h"

namespace aspect {
namespace {

// Whole numbers, since distributions differ between libraries.
Vector3d random_direction(std::mt19937& random) {
  for (;;) {
    Vector3d v;
    for (double& x : v) x = (static_cast<double>(random() % 2000001) - 1000000) / 1000000;
    const double length = norm(v);
    if (length > 0.1 && length <= 1) return {v[0] / length, v[1] / length, v[2] / length};
  }
}

class MapBits {
 public:
  void put(std::uint32_t value, int bits) {
    for (int bit = bits - 1; bit >= 0; --bit, ++used_) {
      if (used_ % 8 == 0) bytes.push_back(0);
      if ((value >> bit & 1U) != 0)
        bytes.back() = static_cast<std::uint8_t>(bytes.back() | 0x80U >> used_ % 8);
    }
  }
  std::vector<std::uint8_t> bytes;

 private:
  std::size_t used_ = 0;
};

constexpr std::uint32_t kClasses = 5;
constexpr int kClassBits = 3;

void put_random_patch(MapBits& bits, std::mt19937& random, int level) {
  const auto some_class = [&] { return static_cast<std::uint32_t>(random() % (kClasses + 1)); };
  const bool split = random() % 8 < (level < 2 ? 4U : level < 7 ? 2U : 0U);
  bits.put(split ? 1 : 0, 1);
  if (split) {
    for (int child = 0; child < 4; ++child) put_random_patch(bits, random, level + 1);
    return;
  }
  const bool same = random() % 2 == 0;
  bits.put(same ? 1 : 0, 1);
  if (same) return;
  const bool divided = random() % 2 == 0;
  bits.put(divided ? 1 : 0, 1);
  if (!divided) return bits.put(some_class(), kClassBits);
  const auto count = static_cast<std::uint32_t>(2 + random() % 4);
  bits.put(count - 2, 2);
  for (std::uint32_t k = 0; k < count; ++k) {
    const auto place = 48 * k / count + random() % (48 / count);
    bits.put(static_cast<std::uint32_t>(place), 6);
    bits.put(some_class(), kClassBits);
  }
}

std::vector<std::uint8_t> random_map_bytes(std::mt19937& random) {
  MapBits bits;
  for (int root = 0; root < 20; ++root) put_random_patch(bits, random, 0);
  return std::move(bits.bytes);
}

bool holds(const SphereMap::Leaf& leaf, const Vector3d& direction) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3d& a = leaf.corners[k];
    if (dot(cross(a, leaf.corners[(k + 1) % 3]), direction) < 0) return false;
  }
  return true;
}

// As the thesis says it, view by view.
std::int32_t plain_nearest(const std::vector<SphereMap::Leaf>& leaves, const Vector3d& direction) {
  double best_corner = -2, best_centre = -2;
  std::int32_t found = SphereMap::kNone;
  for (const SphereMap::Leaf& leaf : leaves) {
    if (leaf.class_id == SphereMap::kNone) continue;
    const Vector3d sum = leaf.corners[0] + leaf.corners[1] + leaf.corners[2];
    const double centre = dot(sum, direction) / norm(sum);
    double corner = -2;
    for (const Vector3d& c : leaf.corners) corner = std::max(corner, dot(c, direction));
    if (corner < best_corner || (corner == best_corner && centre <= best_centre)) continue;
    best_corner = corner;
    best_centre = centre;
    found = leaf.class_id;
  }
  return found;
}

}  // namespace

TEST_CASE("a map names the classes of the leaves, and of the pieces of those that are divided") {
  std::mt19937 random(3);
  int pieces = 0;
  for (int round = 0; round < 30; ++round) {
    const SphereMap map = SphereMap::decode(random_map_bytes(random), kClasses).value();
    const std::vector<SphereMap::Leaf> leaves = map.leaves();
    for (int k = 0; k < 30; ++k) {
      const Vector3d direction = random_direction(random);
      const auto leaf = std::find_if(leaves.begin(), leaves.end(),
                                     [&](const auto& l) { return holds(l, direction); });
      REQUIRE(leaf != leaves.end());
      const std::int32_t seen = map.class_at(direction);
      if (leaf->division == nullptr) {
        CHECK(seen == leaf->class_id);
        continue;
      }
      ++pieces;
      const auto named = std::span(leaf->division->classes).first(leaf->division->count);
      CHECK(std::find(named.begin(), named.end(), seen) != named.end());
    }
  }
  CHECK(pieces > 100);
}

TEST_CASE("the nearest class is that of the nearest view") {
  std::mt19937 random(4);
  for (int round = 0; round < 30; ++round) {
    const SphereMap map = SphereMap::decode(random_map_bytes(random), kClasses).value();
    const std::vector<SphereMap::Leaf> leaves = map.leaves();
    for (int k = 0; k < 30; ++k) {
      const Vector3d direction = random_direction(random);
      CHECK(map.nearest_class(direction) == plain_nearest(leaves, direction));
    }
  }
}

TEST_CASE("a divided patch is cut by the chord between two places") {
  // The first root is divided, from the middle of its first edge to the middle of its second.
  MapBits bits;
  bits.put(0b001'00, 5);
  bits.put(8, 6), bits.put(1, 2);   // class 0 about corner 1
  bits.put(24, 6), bits.put(2, 2);  // class 1 for the rest
  for (int root = 1; root < 20; ++root) bits.put(0b01, 2);
  const SphereMap map = SphereMap::decode(bits.bytes, 2).value();
  const SphereMap::Leaf leaf = map.leaves().front();
  const auto at = [&](double a, double b, double c) {
    return map.class_at(a * leaf.corners[0] + b * leaf.corners[1] + c * leaf.corners[2]);
  };
  CHECK(at(0.05, 0.9, 0.05) == 0);
  CHECK(at(0.40, 0.51, 0.09) == 0);  // a point is beyond the chord where its share of corner 1 is
  CHECK(at(0.09, 0.51, 0.40) == 0);  // more than half
  CHECK(at(0.40, 0.49, 0.11) == 1);
  CHECK(at(0.11, 0.49, 0.40) == 1);
  CHECK(at(0.9, 0.05, 0.05) == 1);
  CHECK(at(0.05, 0.05, 0.9) == 1);
  CHECK(map.class_at(-1 * leaf.corners[0]) == SphereMap::kNone);
  CHECK(map.nearest_class(leaf.corners[0]) == SphereMap::kNone);
}

TEST_CASE("a tree that goes on for ever, and an empty map, are refused in one line") {
  const std::vector<std::uint8_t> ones(1U << 20U, 0xFF);
  const Result<SphereMap> endless = SphereMap::decode(ones, 3);
  REQUIRE_FALSE(endless.ok());
  CHECK(endless.error() == "its map of the viewing sphere is damaged; compile the scene again");
  CHECK_FALSE(SphereMap::decode({}, 3).ok());
}

TEST_CASE("a map of more patches than any compiler writes is refused") {
  const auto uniform = [](int levels) {
    MapBits bits;
    const auto put = [&](const auto& self, int level) -> void {
      bits.put(level < levels ? 1 : 0b01, level < levels ? 1 : 2);
      for (int child = 0; child < 4 && level < levels; ++child) self(self, level + 1);
    };
    for (int root = 0; root < 20; ++root) put(put, 0);
    return std::move(bits.bytes);
  };
  CHECK(SphereMap::decode(uniform(6), kClasses).value().leaves().size() == 20U << 12U);
  CHECK_FALSE(SphereMap::decode(uniform(7), kClasses).ok());
}

TEST_CASE("a map that nobody decoded knows no class") {
  const SphereMap map;
  CHECK(map.class_at({0, 0, 1}) == SphereMap::kNone);
  CHECK(map.nearest_class({0, 0, 1}) == SphereMap::kNone);
  CHECK(map.leaves().empty());
}

TEST_CASE("a damaged map is refused, or gives classes that exist wherever one looks") {
  constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
  std::mt19937 random(6);
  int refused = 0, taken = 0;
  for (int round = 0; round < 1000; ++round) {
    std::vector<std::uint8_t> bytes = random_map_bytes(random);
    for (std::size_t change = 0; change <= random() % 4; ++change)
      bytes[random() % bytes.size()] ^= static_cast<std::uint8_t>(1U << random() % 8);
    const Result<SphereMap> map = SphereMap::decode(bytes, kClasses);
    ++(map.ok() ? taken : refused);
    if (!map.ok()) continue;
    const auto expect_class = [](std::int32_t id) {
      CHECK((id >= SphereMap::kNone && id < static_cast<std::int32_t>(kClasses)));
    };
    for (const Vector3d& direction :
         {random_direction(random), Vector3d{}, Vector3d{kNotANumber, 0, kNotANumber}}) {
      expect_class(map.value().class_at(direction));
      expect_class(map.value().nearest_class(direction));
    }
  }
  CHECK(refused > 200);
  CHECK(taken > 50);
}

TEST_CASE("the same map and directions give the same classes on every processor") {
  std::mt19937 random(5);
  std::uint64_t hash = kFnv1aStart;
  for (int round = 0; round < 20; ++round) {
    const SphereMap map = SphereMap::decode(random_map_bytes(random), kClasses).value();
    for (int k = 0; k < 100; ++k) {
      const Vector3d direction = random_direction(random);
      hash = fnv1a(hash, static_cast<std::uint8_t>(map.class_at(direction) + 1));
      hash = fnv1a(hash, static_cast<std::uint8_t>(map.nearest_class(direction) + 1));
    }
  }
  CHECK(hash == 0xE5F4C982E8F45583U);
}

}  // namespace aspect
