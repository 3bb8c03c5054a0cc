#include "compiler/scene/zip_file.h"

#include <fmt/format.h>
#include <minizip/unzip.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

#include "compiler/scene/coloured_mesh.h"

namespace aspect {
namespace {

// minizip asks for files by these.
struct Memory {
  std::string_view bytes;
  std::size_t at = 0;
};

Memory& memory_of(voidpf stream) {
  return *static_cast<Memory*>(stream);
}

voidpf open_memory(voidpf memory, const void*, int) {
  return memory;
}
uLong read_memory(voidpf, voidpf stream, void* to, uLong count) {
  Memory& memory = memory_of(stream);
  const std::size_t taken = std::min<std::size_t>(count, memory.bytes.size() - memory.at);
  std::memcpy(to, memory.bytes.data() + memory.at, taken);
  memory.at += taken;
  return taken;
}
uLong write_nothing(voidpf, voidpf, const void*, uLong) {
  return 0;
}
ZPOS64_T tell_memory(voidpf, voidpf stream) {
  return memory_of(stream).at;
}
long seek_memory(voidpf, voidpf stream, ZPOS64_T offset, int origin) {
  Memory& memory = memory_of(stream);
  const ZPOS64_T size = memory.bytes.size();
  const ZPOS64_T base = origin == ZLIB_FILEFUNC_SEEK_END   ? size
                        : origin == ZLIB_FILEFUNC_SEEK_CUR ? memory.at
                                                           : 0;
  if (offset > size - base) return -1;
  memory.at = base + offset;
  return 0;
}
int close_memory(voidpf, voidpf) {
  return 0;
}
int no_error(voidpf, voidpf) {
  return 0;
}

[[noreturn]] void fail_broken() {
  throw MeshError("is no zip archive, or is cut off; export it again");
}

}  // namespace

std::optional<std::string> read_from_zip(std::string_view archive, const std::string& name,
                                         std::size_t max_bytes) {
  constexpr int kWithoutCase = 2;
  Memory memory{archive};
  zlib_filefunc64_def functions{open_memory, read_memory,  write_nothing, tell_memory,
                                seek_memory, close_memory, no_error,      &memory};
  const std::unique_ptr<void, int (*)(unzFile)> zip(unzOpen2_64("", &functions), unzClose);
  if (zip == nullptr) fail_broken();
  if (unzLocateFile(zip.get(), name.c_str(), kWithoutCase) != UNZ_OK) return std::nullopt;
  if (unzOpenCurrentFile(zip.get()) != UNZ_OK) fail_broken();
  std::string bytes;
  std::vector<char> buffer(1 << 16);
  for (;;) {
    const int count =
        unzReadCurrentFile(zip.get(), buffer.data(), static_cast<unsigned>(buffer.size()));
    if (count < 0) fail_broken();
    if (count == 0) break;
    bytes.append(buffer.data(), static_cast<std::size_t>(count));
    if (bytes.size() > max_bytes)
      throw MeshError(
          fmt::format("{} holds more than {} MiB; simplify the model", name, max_bytes >> 20));
  }
  if (unzCloseCurrentFile(zip.get()) != UNZ_OK) fail_broken();  // where the checksum is compared
  return bytes;
}

}  // namespace aspect
