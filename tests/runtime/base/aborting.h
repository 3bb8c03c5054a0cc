// Tests of failed checks: runs an action in a child process and tells whether it aborted.
#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

namespace aspect {

template <typename Action>
bool aborts(Action&& action) {
  const pid_t child = fork();
  if (child == 0) {
    // The test framework and the sanitizers must not report the abort that is wanted.
    std::signal(SIGABRT, SIG_DFL);
    dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
    action();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
}

}  // namespace aspect
