// A program that is started and left to itself; at most one at a time.
#pragma once

#include <sys/types.h>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/result.h"

namespace aspect {

class ChildCommand {
 public:
  // The whole path of a program, and its arguments; no shell. None of it can be mistaken later.
  ChildCommand(std::vector<std::string> command, const std::string& object);
  [[nodiscard]] static std::optional<Error> check(const std::vector<std::string>& command);

  // With ASPECT_OBJECT and ASPECT_SEEN in its environment, its standard input empty and its
  // standard output that of errors. False where it cannot be started.
  bool start(bool seen);
  // Also takes note of its end.
  bool running();

 private:
  using Pointers = std::vector<char*>;
  static Pointers pointers_to(std::vector<std::string>& texts);

  std::vector<std::string> command_, environment_;
  pid_t child_ = 0;
};

}  // namespace aspect
