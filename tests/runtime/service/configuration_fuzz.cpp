// Fuzzes the reader of configurations. Under ASPECT_LIBFUZZER the engine drives it; otherwise the
// program replays the files of the corpus folders it is given, whole and damaged.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "runtime/service/configuration.h"
#include "tests/damaged_corpus.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto configuration = aspect::parse_configuration(text, "fuzz.toml");
  // A message is one line: more than that is a bug as well.
  if (!configuration && configuration.error().find('\n') != std::string::npos) std::abort();
  return 0;
}

#ifndef ASPECT_LIBFUZZER
int main(int argc, char** argv) {
  return aspect::replay_damaged_corpus(argc, argv, LLVMFuzzerTestOneInput);
}
#endif
