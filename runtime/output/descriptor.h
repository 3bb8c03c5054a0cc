// A file descriptor that is closed by its owner, and what system calls say when they fail.
#pragma once

#include <string>
#include <utility>

namespace aspect {

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    if (this != &other) reset(std::exchange(other.number_, -1));
    return *this;
  }
  ~Descriptor() { reset(); }

  int get() const { return number_; }
  explicit operator bool() const { return number_ >= 0; }
  void reset(int number = -1) noexcept;

 private:
  int number_ = -1;
};

// The text of errno.
std::string system_error();

// One line on standard error.
void warn(const std::string& message);

}  // namespace aspect
