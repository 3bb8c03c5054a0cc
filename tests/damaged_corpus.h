// What fuzzers of text do where no engine drives them: every file of the corpus folders given, whole
// and damaged, with the same damage on every machine.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

namespace aspect {

// The exit code: an empty corpus would pass without a test.
template <typename Try>
int replay_damaged_corpus(int argc, char** argv, Try try_text) {
  constexpr int kDamaged = 200;
  std::mt19937 random(20260102);
  int replayed = 0;
  const auto replay = [&](const std::string& text) {
    try_text(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
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
  std::printf("%d texts replayed\n", replayed);
  return replayed > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace aspect
