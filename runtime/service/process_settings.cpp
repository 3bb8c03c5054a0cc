#include "runtime/service/process_settings.h"

#include <sched.h>
#include <sys/mman.h>
#include <cerrno>
#include <cstring>

namespace aspect {
namespace {

Error refusal(const std::string& key, const char* remedy) {
  return Error{"[process] " + key + ": " + std::strerror(errno) + "; " + remedy};
}

}  // namespace

std::optional<Error> apply(const ProcessSettings& settings) {
  if (!settings.cpus.empty()) {
    cpu_set_t cpus;
    CPU_ZERO(&cpus);
    for (const int cpu : settings.cpus)
      if (cpu >= 0 && cpu < CPU_SETSIZE) CPU_SET(static_cast<std::size_t>(cpu), &cpus);
    if (sched_setaffinity(0, sizeof cpus, &cpus) != 0)
      return refusal("cpus", "name processors that this board has, counted from 0");
  }
  if (settings.realtime_priority > 0) {
    const sched_param priority{settings.realtime_priority};
    if (sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &priority) != 0)
      return refusal("realtime_priority", "the unit needs LimitRTPRIO, or leave it out");
  }
  if (settings.lock_memory && mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
    return refusal("lock_memory", "the unit needs LimitMEMLOCK=infinity, or leave it out");
  return std::nullopt;
}

}  // namespace aspect
