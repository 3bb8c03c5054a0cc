#include "tests/compiler/store/store_samples.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <sstream>
#include <utility>

namespace aspect {

const StoreKey& sample_key() {
  static const StoreKey key{"3f2a90", "min_level=2 max_level=7 threshold=10000"};
  return key;
}

Eigen::Vector3d sample_direction(int number) {
  return {std::sin(number), std::cos(number), 1e-3 * number};
}

ByteList sample_bytes(int number, std::size_t size) {
  std::mt19937 random(static_cast<std::mt19937::result_type>(number));
  ByteList bytes(size);
  for (std::byte& byte : bytes) byte = static_cast<std::byte>(random() & 0xff);
  return bytes;
}

ByteList sample_bytes(int number) {
  return sample_bytes(number, static_cast<std::size_t>(number * 37 % 500));
}

std::vector<StoredView> views_of(const Store& store) {
  std::vector<StoredView> views;
  const auto keep = [&](const Eigen::Vector3d& direction, Store::Bytes view) {
    views.push_back({direction, ByteList(view.begin(), view.end())});
  };
  REQUIRE(store.each_view(keep).ok());
  return views;
}

std::vector<StoredMatch> matches_of(const Store& store) {
  std::vector<StoredMatch> matches;
  const auto keep = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to, double cost,
                        Store::Bytes mapping) {
    matches.push_back({from, to, cost, ByteList(mapping.begin(), mapping.end())});
  };
  REQUIRE(store.each_match(keep).ok());
  return matches;
}

Store open_sound(const std::filesystem::path& path) {
  Result<Store> store = Store::open(path, sample_key());
  if (!store) FAIL(store.error());
  return std::move(store).value();
}

std::string attempt(const std::filesystem::path& path, const StoreKey& key) {
  const Result<Store> store = Store::open(path, key);
  std::ostringstream outcome;
  if (store) {
    outcome << "opened";
  } else {
    outcome << store.error();
  }
  return outcome.str();
}

std::string refusal(const std::filesystem::path& path, const StoreKey& key) {
  std::string message = attempt(path, key);
  REQUIRE(message != "opened");
  CHECK(message.starts_with(path.string() + ": "));
  CHECK(message.find('\n') == std::string::npos);
  return message;
}

void write_sample_store(const std::filesystem::path& path) {
  Store store = open_sound(path);
  for (int i = 0; i < 300; ++i) {
    REQUIRE(store.add_view(sample_direction(i), sample_bytes(i)).ok());
    if (i == 0) continue;
    REQUIRE(store.add_match(sample_direction(i - 1), sample_direction(i), i, sample_bytes(i)).ok());
  }
}

}  // namespace aspect
