#include "runtime/output/descriptor.h"

#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace aspect {

void Descriptor::reset(int number) noexcept {
  if (number_ >= 0) ::close(number_);
  number_ = number;
}

std::string system_error() {
  // Unlike strerror this is safe in any thread, and not translated.
  const char* text = ::strerrordesc_np(errno);
  return text == nullptr ? "error " + std::to_string(errno) : text;
}

void warn(const std::string& message) {
  std::fprintf(stderr, "aspectd: %s\n", message.c_str());
}

}  // namespace aspect
