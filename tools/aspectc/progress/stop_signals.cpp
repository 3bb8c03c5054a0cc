#include "tools/aspectc/progress/stop_signals.h"

#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <string_view>

namespace aspect {
namespace {

// Less than the second that is promised.
constexpr suseconds_t kStopDeadline_us = 800'000;
constexpr std::string_view kEraseLine = "\r\033[K";

std::atomic<bool> stop_asked{false};
bool is_terminal = false;
std::string words;

// Nothing can be done where stderr is closed.
void say(std::string_view text) {
  if (write(STDERR_FILENO, text.data(), text.size()) < 0) return;
}

extern "C" void give_up(int) {
  if (is_terminal) say(kEraseLine);
  say(words);
  _exit(1);
}

extern "C" void ask_to_stop(int signal) {
  if (stop_asked.exchange(true)) {
    if (is_terminal) say(kEraseLine);
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    return;
  }
  const itimerval deadline{{0, 0}, {0, kStopDeadline_us}};
  setitimer(ITIMER_REAL, &deadline, nullptr);
}

}  // namespace

const std::atomic<bool>& stop_on_signals(const std::string& last_words) {
  is_terminal = isatty(STDERR_FILENO) == 1;
  words = last_words + "\n";
  std::signal(SIGALRM, give_up);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, ask_to_stop);
  return stop_asked;
}

}  // namespace aspect
