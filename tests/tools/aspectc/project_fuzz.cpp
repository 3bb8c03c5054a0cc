// Fuzzes the reader of projects. Under ASPECT_LIBFUZZER the engine drives it; otherwise the program
// replays the files of the corpus folders it is given, whole and damaged.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "tools/aspectc/project_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto project = aspect::parse_project(text, "fuzz.toml");
  // A message is one line: more than that is a bug as well.
  if (!project.ok() && project.error().find('\n') != std::string::npos) std::abort();
  if (project.ok() && project.value().objects.empty()) std::abort();
  return 0;
}

#ifndef ASPECT_LIBFUZZER
int main(int argc, char** argv) {
  constexpr int kDamaged = 200;
  std::mt19937 random(20260102);
  int replayed = 0;
  const auto replay = [&](const std::string& text) {
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    ++replayed;
  };
  for (int i = 1; i < argc; ++i) {
    for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
      std::ifstream stream(entry.path(), std::ios::binary);
      const std::string text(std::istreambuf_iterator<char>(stream), {});
      replay(text);
      for (int round = 0; round < kDamaged && !text.empty(); ++round) {
        std::string damaged = text;
        for (int change = 0; change < 3; ++change)
          damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
        if (round % 4 == 0) damaged.resize(random() % damaged.size());
        replay(damaged);
      }
    }
  }
  std::printf("%d projects replayed\n", replayed);
  // An empty corpus would pass without a test.
  return replayed > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
#endif
