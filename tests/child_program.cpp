#include "tests/child_program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <stdexcept>

#include "tests/temporary_folder.h"

namespace aspect {
namespace {

[[noreturn]] void become(const std::filesystem::path& program, const std::filesystem::path& folder,
                         const std::vector<std::string>& arguments) {
  std::vector<std::string> words = {program.filename().native()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const bool ready = chdir(folder.c_str()) == 0 && dup2(open("/dev/null", O_RDONLY), 0) == 0 &&
                     dup2(open("out", O_WRONLY | O_CREAT | O_TRUNC, 0644), 1) == 1 &&
                     dup2(open("err", O_WRONLY | O_CREAT | O_TRUNC, 0644), 2) == 2;
  if (ready) execv(program.c_str(), pointers.data());
  _exit(127);
}

}  // namespace

ChildProgram::ChildProgram(const std::filesystem::path& program,
                           const std::filesystem::path& folder,
                           const std::vector<std::string>& arguments)
    : folder_(folder), id_(fork()) {
  if (id_ < 0) throw std::runtime_error("no process");
  if (id_ == 0) become(program, folder, arguments);
}

ChildProgram::~ChildProgram() {
  if (ended_) return;
  send(SIGKILL);
  waitpid(id_, nullptr, 0);
}

void ChildProgram::send(int signal) const {
  if (!ended_) kill(id_, signal);
}

bool ChildProgram::has_ended() {
  if (!ended_) ended_ = waitpid(id_, &status_, WNOHANG) == id_;
  return ended_;
}

Outcome ChildProgram::wait() {
  if (!ended_) ended_ = waitpid(id_, &status_, 0) == id_;
  return {WIFEXITED(status_) ? WEXITSTATUS(status_) : -1, read_file(folder_ / "out"),
          read_file(folder_ / "err")};
}

Outcome run_shell(const std::filesystem::path& folder, const std::string& line) {
  return ChildProgram("/bin/sh", folder, {"-c", line}).wait();
}

}  // namespace aspect
