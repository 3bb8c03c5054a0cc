// The other ends of outputs.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <thread>

#include "runtime/output/descriptor.h"

namespace aspect {

// Connected, from any thread; throws otherwise. They wait for at most 5 s when read.
Descriptor connect_unix(const std::filesystem::path& path);
Descriptor connect_tcp(int port, const std::string& address = "127.0.0.1");

// What comes within 5 s, at most so much; empty at the end.
std::string read_some(int descriptor, std::size_t most);

// Until it is restored, standard output goes into a pipe.
class StandardOutputPipe {
 public:
  StandardOutputPipe();
  ~StandardOutputPipe() { restore(); }
  void restore();
  Descriptor reader;

 private:
  Descriptor before_;
};

// Asks again and again, for at most 5 s.
template <typename Condition>
bool comes_true(Condition condition) {
  for (int k = 0; k < 1000; ++k) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

}  // namespace aspect
