// Ctrl-C, SIGTERM and a terminal that is closed.
#pragma once

#include <atomic>
#include <string>

namespace aspect {

// From now on the first of these signals sets what is returned, and the program is expected to end.
// Where it does not within 0.8 s, in one long step that cannot be cut short, it says its
// last words on stderr and exits with 1: a store survives that. A second signal ends it at once.
const std::atomic<bool>& stop_on_signals(const std::string& last_words);

}  // namespace aspect
