#include "compiler/index/bundle_writer.h"

#include "schema/index_bundle_generated.h"

namespace aspect {

std::vector<std::uint8_t> write_bundle(std::span<const std::vector<std::uint8_t>> indexes) {
  constexpr std::size_t kAlignment = 16;
  flatbuffers::FlatBufferBuilder builder;
  std::vector<flatbuffers::Offset<schema::BundledIndex>> parts;
  for (const std::vector<std::uint8_t>& index : indexes) {
    builder.ForceVectorAlignment(index.size(), sizeof(std::uint8_t), kAlignment);
    parts.push_back(schema::CreateBundledIndex(builder, builder.CreateVector(index)));
  }
  schema::FinishIndexBundleBuffer(builder,
                                  schema::CreateIndexBundle(builder, builder.CreateVector(parts)));
  return {builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize()};
}

}  // namespace aspect
