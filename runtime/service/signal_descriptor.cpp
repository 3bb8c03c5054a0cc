#include "runtime/service/signal_descriptor.h"

#include <sys/signalfd.h>
#include <unistd.h>
#include <csignal>
#include <initializer_list>

namespace aspect {

SignalDescriptor::SignalDescriptor() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&signals, signal);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  descriptor_ = signalfd(-1, &signals, SFD_NONBLOCK | SFD_CLOEXEC);
}

SignalDescriptor::~SignalDescriptor() {
  if (descriptor_ >= 0) close(descriptor_);
}

int SignalDescriptor::take() noexcept {
  signalfd_siginfo information;
  if (read(descriptor_, &information, sizeof information) != sizeof information) return 0;
  return static_cast<int>(information.ssi_signo);
}

}  // namespace aspect
