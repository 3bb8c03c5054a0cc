// What the controls that cameras commonly have do, for help texts and the workbench's page.
#pragma once

#include <span>
#include <string_view>

namespace aspect {

struct ControlWords {
  std::string_view name;     // as in v4l2-ctl
  std::string_view meaning;  // one line, no full stop
  std::string_view advice;   // what is good for recognition; may be empty
};

// In the order in which they are best set: what switches an automatic off comes before what it
// governed.
std::span<const ControlWords> control_words();

// Null where nothing is known of it.
const ControlWords* find_control_words(std::string_view name);

}  // namespace aspect
