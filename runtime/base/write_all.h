// Writing to a descriptor until all is written.
#pragma once

#include <string_view>

namespace aspect {

// A call that a signal interrupted is made again. False where the rest cannot be written; errno
// says why.
[[nodiscard]] bool write_all(int descriptor, std::string_view bytes);

}  // namespace aspect
