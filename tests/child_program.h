// A program as its users start it: a process that can be waited for, interrupted and killed.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace aspect {

struct Outcome {
  int exit_code = -1;  // -1: ended by a signal
  std::string out, err;
};

class ChildProgram {
 public:
  // Starts it in that folder, where its output goes to the files out and err.
  ChildProgram(const std::filesystem::path& program, const std::filesystem::path& folder,
               const std::vector<std::string>& arguments);
  ~ChildProgram();
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;

  void send(int signal) const;
  bool has_ended();
  Outcome wait();

 private:
  std::filesystem::path folder_;
  pid_t id_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

// Runs a line of the shell's in that folder. What it prints goes to the files out and err there.
Outcome run_shell(const std::filesystem::path& folder, const std::string& line);

}  // namespace aspect
