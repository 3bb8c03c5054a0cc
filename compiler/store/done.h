#pragma once

namespace aspect {

// The value of a Result that has no other: it went well.
struct Done {};

}  // namespace aspect
