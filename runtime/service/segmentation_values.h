// Every value of a [segmentation] table but the region of interest, once: from here come what a
// configuration may say, the words of help texts and compile projects, and the sliders of the
// workbench's page.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <variant>

#include "runtime/service/configuration.h"

namespace aspect {

struct SegmentationValue {
  using Member = std::variant<std::optional<int> SegmentationOverrides::*,
                              std::optional<float> SegmentationOverrides::*,
                              std::optional<bool> SegmentationOverrides::*>;

  std::string_view key;
  std::string_view unit;       // may be empty
  std::string_view meaning;    // one line, no full stop
  std::string_view advice;     // typical values and what raising it costs; may be empty
  double least = 0, most = 0;  // of numbers; whole ones where the member is an int
  Member member;
  bool of_range = false;  // means something to range sensors only
};

// In the order in which they are to be shown.
std::span<const SegmentationValue> segmentation_values();

// Null where there is none.
const SegmentationValue* find_segmentation_value(std::string_view key);

// All of them, as the parameters have them; not the region of interest.
SegmentationOverrides segmentation_of(const VisionParameters& parameters);

// Of region_of_interest, which is no number: [x, y, width, height].
inline constexpr std::string_view kRegionMeaning = "the part of the picture that is looked at";
inline constexpr std::string_view kRegionAdvice = "time grows with its area";

}  // namespace aspect
