#include "tests/tools/aspectc/terminal_program.h"

#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace aspect {
namespace {

[[noreturn]] void become_aspectc(const std::filesystem::path& folder,
                                 const std::vector<std::string>& arguments,
                                 const std::string& kind) {
  std::vector<std::string> words = {"aspectc"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const bool ready = chdir(folder.c_str()) == 0 && setenv("TERM", kind.c_str(), 1) == 0;
  if (ready) execv(ASPECTC, pointers.data());
  _exit(127);
}

}  // namespace

TerminalProgram::TerminalProgram(const std::filesystem::path& folder,
                                 const std::vector<std::string>& arguments, int columns,
                                 const std::string& kind) {
  winsize size{};
  size.ws_row = 24;
  size.ws_col = static_cast<unsigned short>(columns);
  id_ = forkpty(&terminal_, nullptr, nullptr, &size);
  if (id_ < 0) throw std::runtime_error("no terminal");
  if (id_ == 0) become_aspectc(folder, arguments, kind);
}

TerminalProgram::~TerminalProgram() {
  if (!reaped_) {
    send(SIGKILL);
    waitpid(id_, nullptr, 0);
  }
  close(terminal_);
}

bool TerminalProgram::watch_until(Clock::time_point end) {
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
    if (left.count() <= 0) return true;
    pollfd ready{terminal_, POLLIN, 0};
    if (poll(&ready, 1, static_cast<int>(left.count())) <= 0) continue;
    std::string bytes(4096, '\0');
    const ssize_t count = read(terminal_, bytes.data(), bytes.size());
    if (count <= 0) return false;
    bytes.resize(static_cast<std::size_t>(count));
    shown_.push_back({Clock::now(), std::move(bytes)});
  }
}

void TerminalProgram::send(int signal) const {
  if (!reaped_) kill(id_, signal);
}

void TerminalProgram::type(const std::string& keys) const {
  if (write(terminal_, keys.data(), keys.size()) < 0) throw std::runtime_error("no terminal");
}

int TerminalProgram::wait() {
  while (watch_until(Clock::now() + std::chrono::minutes(1))) {
  }
  int status = 0;
  waitpid(id_, &status, 0);
  reaped_ = true;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string TerminalProgram::all_shown() const {
  std::string text;
  for (const Shown& part : shown_) text += part.text;
  return text;
}

std::vector<std::string> screen_of(const std::string& text) {
  std::vector<std::string> lines(1);
  std::size_t column = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& line = lines.back();
    if (text[i] == '\r') {
      column = 0;
    } else if (text[i] == '\n') {
      lines.emplace_back();
    } else if (text.compare(i, 3, "\033[K") == 0) {
      line.resize(std::min(column, line.size()));
      i += 2;
    } else if (text.compare(i, 2, "\033[") == 0 &&
               text.find_first_not_of("0123456789;", i + 2) == text.find('m', i + 2)) {
      i = std::min(text.find('m', i + 2), text.size());  // a colour takes no room
    } else {
      line.resize(std::max(column, line.size()), ' ');
      line.replace(column, 1, 1, text[i]);
      ++column;
    }
  }
  return lines;
}

}  // namespace aspect
