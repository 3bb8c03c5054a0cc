// Copies standard input to standard output with the time in front of each line, in seconds of
// CLOCK_MONOTONIC, and a name.
// usage: stamp NAME
#include <cstdio>
#include <cstring>
#include <ctime>

int main(int argc, char** argv) {
  static char line[65536];
  while (std::fgets(line, sizeof line, stdin) != nullptr) {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    line[std::strcspn(line, "\n")] = '\0';
    std::printf("%ld.%06ld %s: %s\n", static_cast<long>(now.tv_sec), now.tv_nsec / 1000,
                argc > 1 ? argv[1] : "", line);
    std::fflush(stdout);
  }
}
