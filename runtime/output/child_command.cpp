#include "runtime/output/child_command.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <string_view>

#include "runtime/output/descriptor.h"

namespace aspect {

std::optional<Error> ChildCommand::check(const std::vector<std::string>& command) {
  if (command.empty()) return std::nullopt;
  const std::string& program = command.front();
  if (!program.starts_with('/'))
    return Error{"trigger command \"" + program + "\": give the program's whole path"};
  if (::access(program.c_str(), X_OK) == 0) return std::nullopt;
  return Error{"trigger command " + program + ": cannot be run: " + system_error() +
               "; check the path and its permissions"};
}

ChildCommand::ChildCommand(std::vector<std::string> command, const std::string& object)
    : command_(std::move(command)) {
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (!std::string_view(*entry).starts_with("ASPECT_SEEN=") &&
        !std::string_view(*entry).starts_with("ASPECT_OBJECT="))
      environment_.emplace_back(*entry);
  environment_.push_back("ASPECT_OBJECT=" + object);
  environment_.emplace_back("ASPECT_SEEN=0");
}

ChildCommand::Pointers ChildCommand::pointers_to(std::vector<std::string>& texts) {
  Pointers pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

bool ChildCommand::start(bool seen) {
  environment_.back().back() = seen ? '1' : '0';
  posix_spawn_file_actions_t files;
  ::posix_spawn_file_actions_init(&files);
  ::posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  // Lines are read from standard output: nothing else may get between them.
  ::posix_spawn_file_actions_adddup2(&files, STDERR_FILENO, STDOUT_FILENO);
  // Libraries of ours leave descriptors open that are none of its business.
  ::posix_spawn_file_actions_addclosefrom_np(&files, STDERR_FILENO + 1);
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  sigset_t none, all;
  ::sigemptyset(&none);
  ::sigfillset(&all);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &all);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  const int failure = ::posix_spawn(&child_, command_.front().c_str(), &files, &attributes,
                                    pointers_to(command_).data(), pointers_to(environment_).data());
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&files);
  if (failure != 0) child_ = 0;
  return failure == 0;
}

bool ChildCommand::running() {
  // Anything but 0 means that it is over, or that somebody else took note of its end.
  if (child_ != 0 && ::waitpid(child_, nullptr, WNOHANG) != 0) child_ = 0;
  return child_ != 0;
}

}  // namespace aspect
