#include "tools/replay/line_output.h"

#include <fcntl.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>

namespace aspect {

OutputStatus write_line(std::string_view line) {
  while (!line.empty()) {
    const ssize_t bytes = write(STDOUT_FILENO, line.data(), line.size());
    if (bytes >= 0) {
      line.remove_prefix(static_cast<std::size_t>(bytes));
    } else if (errno != EINTR) {
      return errno == EPIPE || errno == EBADF ? OutputStatus::closed : OutputStatus::failed;
    }
  }
  return OutputStatus::written;
}

void guard_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1 || errno != EBADF) continue;
    // The lowest free descriptor is taken, which is this one; opened for the wrong direction.
    static_cast<void>(open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
  std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace aspect
