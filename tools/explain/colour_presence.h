// How common a colour is somewhere.
#pragma once

#include <cstdint>

namespace aspect {

struct ColourPresence {
  double pixels = 0;    // share of the pixels of all pictures
  double pictures = 0;  // share of the pictures that have a region of it
};

// rare: hardly ever in the way. common: often, or in most pictures.
enum class Commonness : std::uint8_t { rare, occasional, common };
Commonness commonness_of(const ColourPresence& presence);
const char* name_of(Commonness commonness);

}  // namespace aspect
