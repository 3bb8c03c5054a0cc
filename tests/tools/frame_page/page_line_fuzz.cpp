// Fuzzes the reader of recorded lines. Under ASPECT_LIBFUZZER the engine drives it; otherwise the
// program replays the files of the corpus folders it is given, whole and damaged.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "tests/damaged_corpus.h"
#include "tools/frame_page/page_block.h"
#include "tools/frame_page/page_line.h"

namespace {

// A page is whole as long as no block of it holds a bracket of its own.
bool is_sound(const std::string& block) {
  return block.starts_with("<script ") && block.find('<', 1) == block.rfind("</script>\n");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto line = aspect::read_page_line(text, "fuzz.ndjson:1");
  if (!line.ok() && line.error().find('\n') != std::string::npos) std::abort();
  if (!line.ok()) return 0;
  if (!is_sound(aspect::json_block("data-frame", line.value().summary))) std::abort();
  if (!is_sound(aspect::json_block("data-details", line.value().details))) std::abort();
  if (line.value().summary["objects"].size() != line.value().details["objects"].size())
    std::abort();
  return 0;
}

#ifndef ASPECT_LIBFUZZER
int main(int argc, char** argv) {
  return aspect::replay_damaged_corpus(argc, argv, LLVMFuzzerTestOneInput);
}
#endif
