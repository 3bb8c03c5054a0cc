// The page's own text, put into the program at build time: what comes before the frames, and the
// scripts behind them.
#pragma once

#include <string_view>

namespace aspect {

extern const std::string_view kPageHead, kPageTail;

}  // namespace aspect
