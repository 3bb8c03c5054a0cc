// How far a share that was counted can be believed.
#pragma once

#include <cstddef>

namespace aspect {

// A share, with the 95 % interval that the number of those counted leaves (Wilson, Probable
// inference, 1927).
struct Share {
  double share = 0, low = 0, high = 0;
};

// Of none, anything between 0 and 1.
Share share_of(std::size_t count, std::size_t total);

}  // namespace aspect
