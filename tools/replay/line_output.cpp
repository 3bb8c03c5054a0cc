#include "tools/replay/line_output.h"

#include <unistd.h>
#include <cerrno>

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

}  // namespace aspect
