#include "runtime/capture/stderr_capture.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
#include <cstdio>

namespace aspect {

StderrCapture::StderrCapture() {
  std::fflush(stderr);
  saved_ = fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, 3);
  if (saved_ < 0) return;
  memory_ = memfd_create("stderr", MFD_CLOEXEC);
  if (memory_ >= 0) dup2(memory_, STDERR_FILENO);
}

StderrCapture::~StderrCapture() {
  finish();
}

std::string StderrCapture::finish() {
  std::string text;
  if (saved_ >= 0) {
    std::fflush(stderr);
    dup2(saved_, STDERR_FILENO);
    close(saved_);
  }
  if (memory_ >= 0) {
    text.resize(4096);
    const ssize_t bytes = pread(memory_, text.data(), text.size(), 0);
    text.resize(bytes > 0 ? static_cast<std::size_t>(bytes) : 0);
    close(memory_);
  }
  saved_ = memory_ = -1;
  return text;
}

}  // namespace aspect
