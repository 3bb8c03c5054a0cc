// Fuzzes the reader of class indexes and what is done with an index that was accepted. Under
// ASPECT_LIBFUZZER the engine drives it; otherwise seeded damage to a real index is replayed.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "compiler/index/bundle_writer.h"
#include "runtime/recognition/index_bundle.h"
#include "tests/rounds.h"
#include "tests/runtime/recognition/hostile_index.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  aspect::IndexBytes bytes(size);
  if (size > 0) std::memcpy(bytes.data(), data, size);
  // A message is one line: more than that is a bug as well.
  if (aspect::try_index(bytes).find('\n') != std::string::npos) std::abort();
  const auto indexes = aspect::parse_index_file(bytes, "hostile");
  if (!indexes.ok() && indexes.error().find('\n') != std::string::npos) std::abort();
  aspect::repair_checksum(bytes);
  if (aspect::try_index(bytes).find('\n') != std::string::npos) std::abort();
  return 0;
}

#ifndef ASPECT_LIBFUZZER
// Two of these in one file, with a change to what holds them together.
aspect::IndexBytes damaged_bundle(const aspect::IndexBytes& index, std::mt19937& random) {
  std::vector<std::uint8_t> part(index.size());
  if (!part.empty()) std::memcpy(part.data(), index.data(), index.size());
  const std::vector<std::vector<std::uint8_t>> parts(2, part);
  const std::vector<std::uint8_t> bundle = aspect::write_bundle(parts);
  aspect::IndexBytes bytes(bundle.size());
  std::memcpy(bytes.data(), bundle.data(), bundle.size());
  bytes[random() % 64] ^= static_cast<std::byte>(1U << random() % 8);
  return bytes;
}

int main() {
  const int all = aspect::rounds(3000);
  const aspect::IndexBytes sample = aspect::sample_index_bytes();
  // Without an index to damage the replay would test nothing.
  if (!aspect::try_index(sample).empty()) return EXIT_FAILURE;
  std::mt19937 random(20260101);
  for (int round = 0; round < all; ++round) {
    aspect::IndexBytes bytes = sample;
    aspect::damage(bytes, random);
    if (round % 10 == 0) bytes.resize(random() % bytes.size());
    if (round % 5 == 0) bytes = damaged_bundle(bytes, random);
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  std::printf("%d damaged indexes replayed\n", all);
  return EXIT_SUCCESS;
}
#endif
