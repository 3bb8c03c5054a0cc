// Takes frames from a capture node whose input is set up already, and prints a line of each:
// sequence number, bytes, CRC-32 (as zlib counts it), 1 where the driver flags it as damaged.
// usage: grab NODE WIDTH HEIGHT FOURCC FRAMES [FILE]   (FILE: gets the last frame)
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "video_node.h"

namespace aspect {
namespace {

std::uint32_t crc32(const std::vector<std::uint8_t>& bytes) {
  static const std::vector<std::uint32_t> table = [] {
    std::vector<std::uint32_t> values(256);
    for (std::uint32_t i = 0; i < 256; ++i) {
      values[i] = i;
      for (int bit = 0; bit < 8; ++bit)
        values[i] = (values[i] & 1U) != 0 ? 0xEDB88320U ^ (values[i] >> 1U) : values[i] >> 1U;
    }
    return values;
  }();
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const std::uint8_t byte : bytes) crc = table[(crc ^ byte) & 0xFFU] ^ (crc >> 8U);
  return ~crc;
}

int grab(char** argv, const char* file) {
  VideoNode node(argv[1], Direction::capture);
  std::vector<std::uint8_t> frame;
  int error = node.open();
  if (error == 0)
    error = node.set_format(fourcc_of(argv[4]), std::atoi(argv[2]), std::atoi(argv[3]));
  if (error == 0) error = node.start(4);
  for (int i = 0; i < std::atoi(argv[5]) && error == 0; ++i) {
    std::uint32_t sequence = 0;
    bool damaged = false;
    error = node.take(frame, sequence, damaged);
    if (error == 0)
      std::printf("%u %zu %08x %d\n", sequence, frame.size(), crc32(frame), damaged ? 1 : 0);
  }
  if (error != 0) std::fprintf(stderr, "grab: %s\n", node.what().c_str());
  if (std::FILE* last = file != nullptr ? std::fopen(file, "wb") : nullptr) {
    std::fwrite(frame.data(), 1, frame.size(), last);
    std::fclose(last);
  }
  return error == 0 ? 0 : 1;
}

}  // namespace
}  // namespace aspect

int main(int argc, char** argv) {
  if (argc >= 6) return aspect::grab(argv, argc > 6 ? argv[6] : nullptr);
  std::fputs("usage: grab NODE WIDTH HEIGHT FOURCC FRAMES [FILE]\n", stderr);
  return 2;
}
