#include "runtime/c_interface/opened_indexes.h"

#include <cstddef>
#include <cstring>
#include <filesystem>
#include <utility>

#include "runtime/recognition/index_bundle.h"
#include "runtime/recognition/self_test.h"
#include "runtime/service/configuration.h"
#include "runtime/service/index_set.h"

namespace aspect {
namespace {

void add_source(const aspect_source& source, IndexSet& set) {
  if (source.bytes == nullptr) return load_indexes(std::filesystem::path(source.name), set);
  if (source.byte_count > kMaxIndexBytes * kMaxBundledIndexes) {
    set.failures.push_back(std::string(source.name) + ": too large for a class index");
    return;
  }
  // Aligned as FlatBuffers needs it, wherever the caller has them.
  std::vector<std::uint64_t> words((source.byte_count + 7) / 8);
  if (source.byte_count > 0) std::memcpy(words.data(), source.bytes, source.byte_count);
  Result<std::vector<ClassIndex>> indexes =
      parse_index_file(std::as_bytes(std::span(words)).first(source.byte_count), source.name);
  if (!indexes)
    set.failures.push_back(indexes.error());
  else
    add_indexes(source.name, std::move(indexes).value(), set);
}

}  // namespace

Result<OpenedIndexes> open_indexes(std::span<const aspect_source> sources,
                                   const char* configuration_file, const char* configuration) {
  Configuration of_file, of_text;
  if (configuration_file != nullptr) {
    Result<Configuration> read = read_configuration(configuration_file);
    if (!read) return Error{read.error()};
    of_file = std::move(read).value();
  }
  if (configuration != nullptr) {
    Result<Configuration> parsed = parse_configuration(configuration, "configuration");
    if (!parsed) return Error{parsed.error()};
    of_text = std::move(parsed).value();
  }
  IndexSet set;
  for (const aspect_source& source : sources) {
    if (source.name == nullptr) return Error{"a source has no name; name its file"};
    add_source(source, set);
  }
  for (const Configuration* named : {&of_file, &of_text})
    for (const std::filesystem::path& file : named->indexes) load_indexes(file, set);
  if (!set.failures.empty()) return Error{set.failures.front()};
  if (set.indexes.empty()) return Error{"no class index is given; name a file NAME.aspect"};
  if (auto error = self_test(set.indexes)) return *error;

  OpenedIndexes opened;
  opened.parameters.vision = set.indexes.front().vision;
  of_file.apply(opened.parameters);
  of_text.apply(opened.parameters);
  opened.indexes = std::move(set.indexes);
  opened.warnings = std::move(set.warnings);
  return opened;
}

}  // namespace aspect
