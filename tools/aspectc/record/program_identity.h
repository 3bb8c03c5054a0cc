// Which program this is, to the bit.
#pragma once

#include <string>

namespace aspect {

// Of this program and the shared libraries that it was started with: other code, other identity.
// Takes their linkers' build ids, or where one has none, all of its bytes.
std::string program_identity();

}  // namespace aspect
