// Standard error, for a person: one line a trouble, and progress where somebody watches.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace aspect {

class Console {
 public:
  explicit Console(std::string program);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  // One line; control characters in it, as from a file's name, become question marks.
  void fail(std::string_view message);
  void warn(std::string_view message);
  void tell(std::string_view message);
  // Nothing where standard error is no terminal, or standard output is one and fills it already.
  void progress(std::uint64_t done, std::optional<std::size_t> all, std::string_view name);

  int failures() const { return failures_; }

 private:
  void clear_progress();

  std::string program_;
  int failures_ = 0;
  bool shows_progress_ = false, progress_shown_ = false;
};

}  // namespace aspect
