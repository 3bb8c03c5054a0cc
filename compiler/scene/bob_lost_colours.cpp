#include "compiler/scene/bob_lost_colours.h"

#include <fmt/format.h>

#include <algorithm>

namespace aspect {
namespace {

constexpr std::size_t kMostNoted = 100;

}  // namespace

Eigen::Vector3d BobLostColours::stand_in(const BobWords& words, const BobWord& word,
                                         std::string what, std::string cure) {
  if (!stand_in_) words.fail(word, fmt::format("{}; {}{}", what, cure, kOrGoOn));
  const bool known = std::any_of(missing_.begin(), missing_.end(),
                                 [&](const MissingColour& other) { return other.what == what; });
  if (!known && missing_.size() < kMostNoted)
    missing_.push_back({words.locate(word), 0, std::move(what), std::move(cure)});
  return *stand_in_;
}

}  // namespace aspect
