// Fuzzes the readers of meshes that are ours. The first letter of the input chooses the format, or,
// when corpus folders are replayed, a file's extension does; each file is also replayed with bytes
// changed by a fixed rule.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <string_view>

#include "compiler/scene/bob_sources.h"
#include "compiler/scene/mesh_reader.h"
#include "compiler/scene/threemf_model.h"

namespace {

// A model part of a 3MF archive, whose checksums keep most damage from it.
void try_model(std::string_view bytes) {
  try {
    (void)aspect::parse_threemf_model(bytes, "fuzz.model");
  } catch (const aspect::MeshError& error) {
    if (std::string_view(error.what()).find('\n') != std::string_view::npos) std::abort();
  }
}

void try_bytes(std::string_view bytes, const std::string& extension) {
  if (extension == ".model") return try_model(bytes);
  const aspect::Result<aspect::Scene> scene = aspect::parse_mesh(bytes, "fuzz" + extension);
  // A message is one line: more than that is a bug as well.
  if (!scene.ok() && scene.error().find('\n') != std::string::npos) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array<const char*, 8> kExtensions = {".ply", ".off",  ".stl", ".dxf",
                                                      ".obj", ".gltf", ".3mf", ".model"};
  if (size == 0) return 0;
  try_bytes({reinterpret_cast<const char*>(data) + 1, size - 1}, kExtensions[data[0] % 8]);
  return 0;
}

#ifndef ASPECT_LIBFUZZER
int main(int argc, char** argv) {
  int replayed = 0;
  std::mt19937 random(1);
  for (int i = 1; i < argc; ++i) {
    for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
      const auto text = aspect::load_text(entry.path(), aspect::BobSources::kMaxBytes);
      if (!text.ok()) continue;
      const std::string extension = entry.path().extension().string();
      try_bytes(text.value(), extension);
      for (int round = 0; round < 300 && !text.value().empty(); ++round) {
        std::string bytes = text.value();
        for (int k = 0; k <= round % 5; ++k)
          bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
        try_bytes(bytes, extension);
      }
      ++replayed;
    }
  }
  std::printf("%d files replayed\n", replayed);
  // An empty corpus would pass without a test.
  return replayed > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
#endif
