// Signals as something to wait for beside a camera.
#pragma once

namespace aspect {

class SignalDescriptor {
 public:
  // Blocks SIGTERM, SIGINT and SIGHUP in this thread and in those that it starts from then on.
  SignalDescriptor();
  ~SignalDescriptor();
  SignalDescriptor(const SignalDescriptor&) = delete;
  SignalDescriptor& operator=(const SignalDescriptor&) = delete;

  // Readable while a signal waits; -1 where the kernel has none.
  int descriptor() const { return descriptor_; }
  // The next signal that waits, 0: none.
  int take() noexcept;

 private:
  int descriptor_ = -1;
};

}  // namespace aspect
