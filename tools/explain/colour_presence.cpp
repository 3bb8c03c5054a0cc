#include "tools/explain/colour_presence.h"

#include <array>

namespace aspect {

Commonness commonness_of(const ColourPresence& presence) {
  // Of 50 photographs of tables and shelves greys and browns are in nearly all, saturated colours
  // in 2 to 44 of 100.
  constexpr double kCommonPixels = 0.02, kCommonPictures = 0.25;
  constexpr double kRarePixels = 0.002, kRarePictures = 0.1;
  if (presence.pixels >= kCommonPixels || presence.pictures >= kCommonPictures)
    return Commonness::common;
  const bool is_rare = presence.pixels < kRarePixels && presence.pictures < kRarePictures;
  return is_rare ? Commonness::rare : Commonness::occasional;
}

const char* name_of(Commonness commonness) {
  constexpr std::array kNames = {"rare", "occasional", "common"};
  return kNames.at(static_cast<std::size_t>(commonness));
}

}  // namespace aspect
