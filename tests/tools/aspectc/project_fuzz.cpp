// Fuzzes the reader of projects. Under ASPECT_LIBFUZZER the engine drives it; otherwise the program
// replays the files of the corpus folders it is given, whole and damaged.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "tests/damaged_corpus.h"
#include "tools/aspectc/project/project_file.h"

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
  return aspect::replay_damaged_corpus(argc, argv, LLVMFuzzerTestOneInput);
}
#endif
