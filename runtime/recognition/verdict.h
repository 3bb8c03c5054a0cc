// Whether the best hypothesis can be trusted.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "runtime/recognition/hypothesis.h"

namespace aspect {

enum class Verdict : std::uint8_t {
  none,       // no pose was looked for, so nothing can be said
  match,      // the best hypothesis's object, with that probability
  ambiguous,  // another object explains the picture as well
  unknown,    // no object that is known
};

std::string_view name_of(Verdict verdict);  // empty: none

// At most so many rivals are named.
inline constexpr std::size_t kMaxRivals = 3;

struct Judgement {
  Verdict verdict = Verdict::none;
  float probability = 0;  // of the best hypothesis's object being there
  // Places in the list of those that explain the picture as well: other objects, or the same one
  // in other poses, which a view of one face alone may allow. A match may have the latter.
  std::array<std::uint8_t, kMaxRivals> rivals{};
  std::uint8_t rival_count = 0;

  std::span<const std::uint8_t> rival_places() const {
    return std::span(rivals).first(rival_count);
  }
};

// `ranked` is best first. A match needs `confidence_min`, 0 to 1.
Judgement judge(std::span<const Hypothesis> ranked, std::span<const ClassIndex> indexes,
                double confidence_min);

}  // namespace aspect
