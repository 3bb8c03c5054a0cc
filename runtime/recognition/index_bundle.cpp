#include "runtime/recognition/index_bundle.h"

#include <algorithm>
#include <cstring>

#include "schema/index_bundle_generated.h"

namespace aspect {
namespace {

namespace fb = ::aspect::schema;

constexpr std::size_t kSmallest = 16;

bool is_bundle(std::span<const std::byte> bytes) {
  return bytes.size() >= kSmallest &&
         flatbuffers::BufferHasIdentifier(bytes.data(), fb::IndexBundleIdentifier());
}

// Where a hostile bundle puts its parts is up to it: a copy is aligned for sure.
Result<ClassIndex> parse_part(std::span<const std::uint8_t> part, const std::string& name) {
  std::vector<std::uint64_t> words((part.size() + 7) / 8);
  if (!part.empty()) std::memcpy(words.data(), part.data(), part.size());
  return parse_index(std::as_bytes(std::span(words)).first(part.size()), name);
}

Result<std::vector<ClassIndex>> parse_bundle(std::span<const std::byte> bytes,
                                             const std::string& name) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  flatbuffers::Verifier verifier(data, bytes.size(), 16, 1000);
  if (!fb::VerifyIndexBundleBuffer(verifier))
    return Error{name +
                 ": is damaged or cut short (its structure does not hold); compile the project "
                 "again with this version of aspectc"};
  const auto& parts = *fb::GetIndexBundle(data)->indexes();
  if (parts.size() == 0 || parts.size() > kMaxBundledIndexes)
    return Error{name + ": holds " + std::to_string(parts.size()) + " indexes, not 1 to " +
                 std::to_string(kMaxBundledIndexes) + "; compile the project again"};
  // Parts that lie in one another could multiply the work of a small file.
  std::size_t total = 0;
  for (const fb::BundledIndex* part : parts) total += part->bytes()->size();
  if (total > bytes.size())
    return Error{name + ": is damaged (its indexes overlap); compile the project again"};
  std::vector<ClassIndex> indexes;
  for (const fb::BundledIndex* part : parts) {
    Result<ClassIndex> index = parse_part({part->bytes()->data(), part->bytes()->size()},
                                          name + " (index " + std::to_string(indexes.size() + 1) +
                                              " of " + std::to_string(parts.size()) + ")");
    if (!index) return Error{index.error()};
    indexes.push_back(std::move(index).value());
  }
  return indexes;
}

}  // namespace

Result<std::vector<ClassIndex>> parse_index_file(std::span<const std::byte> bytes,
                                                 const std::string& name) {
  if (is_bundle(bytes)) return parse_bundle(bytes, name);
  Result<ClassIndex> index = parse_index(bytes, name);
  if (!index) return Error{index.error()};
  std::vector<ClassIndex> indexes;
  indexes.push_back(std::move(index).value());
  return indexes;
}

Result<std::vector<ClassIndex>> load_index_file(const std::filesystem::path& file) {
  const Result<IndexFileBytes> bytes = read_index_bytes(file);
  if (!bytes) return Error{bytes.error()};
  return parse_index_file(bytes.value().bytes(), file.string());
}

}  // namespace aspect
