// Files and contents that the tests of the store share.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "compiler/store/store.h"
#include "tests/temporary_folder.h"

namespace aspect {

using ByteList = std::vector<std::byte>;

struct StoredView {
  Eigen::Vector3d direction;
  ByteList view;
};

struct StoredMatch {
  Eigen::Vector3d from;
  Eigen::Vector3d to;
  double cost = 0;
  ByteList mapping;
};

const StoreKey& sample_key();

// Different for every number, the same for the same number; some of the bytes are empty.
Eigen::Vector3d sample_direction(int number);
ByteList sample_bytes(int number, std::size_t size);
ByteList sample_bytes(int number);

// All views or matches of a store that must be in order.
std::vector<StoredView> views_of(const Store& store);
std::vector<StoredMatch> matches_of(const Store& store);

// Opens a store that must open.
Store open_sound(const std::filesystem::path& path);

// "opened", or why not.
std::string attempt(const std::filesystem::path& path, const StoreKey& key);

// Why the store does not open; a failed check if it does.
std::string refusal(const std::filesystem::path& path, const StoreKey& key);

// Closed, with 300 views and matches between neighbouring numbers.
void write_sample_store(const std::filesystem::path& path);

}  // namespace aspect
