// Fuzzes the reader of scenes. Under ASPECT_LIBFUZZER the engine drives it; otherwise the program
// replays the files of the corpus folders it is given, so that ctest runs it with any compiler.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "compiler/scene/bob_reader.h"
#include "compiler/scene/bob_sources.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const aspect::Result<aspect::Scene> scene = aspect::parse_bob(text, "fuzz.b");
  // A message is one line: more than that is a bug as well.
  if (!scene.ok() && scene.error().find('\n') != std::string::npos) std::abort();
  return 0;
}

#ifndef ASPECT_LIBFUZZER
int main(int argc, char** argv) {
  int replayed = 0;
  for (int i = 1; i < argc; ++i) {
    for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
      const auto text = aspect::load_text(entry.path(), aspect::BobSources::kMaxBytes);
      if (!text.ok()) continue;
      const auto* bytes = reinterpret_cast<const std::uint8_t*>(text.value().data());
      LLVMFuzzerTestOneInput(bytes, text.value().size());
      ++replayed;
    }
  }
  std::printf("%d files replayed\n", replayed);
  // An empty corpus would pass without a test.
  return replayed > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
#endif
