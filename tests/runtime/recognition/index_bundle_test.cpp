// Index files with several indexes: good ones, and every kind of bad ones.
#include "runtime/recognition/index_bundle.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <random>

#include "compiler/index/bundle_writer.h"
#include "schema/index_bundle_generated.h"
#include "tests/rounds.h"
#include "tests/runtime/recognition/hostile_index.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Contains;
using Catch::StartsWith;
using Bytes = std::vector<std::uint8_t>;

const Bytes& sample() {
  static const Bytes bytes = [] {
    const IndexBytes made = sample_index_bytes();
    Bytes copy(made.size());
    std::memcpy(copy.data(), made.data(), made.size());
    return copy;
  }();
  return bytes;
}

Bytes bundle_of(const std::vector<Bytes>& parts) {
  return write_bundle(parts);
}

// The objects, or the error.
std::string parse(const Bytes& bytes) {
  // Words, since FlatBuffers reads numbers in place, and no byte more than there is.
  std::vector<std::uint64_t> words((bytes.size() + 7) / 8);
  if (!bytes.empty()) std::memcpy(words.data(), bytes.data(), bytes.size());
  const auto indexes =
      parse_index_file(std::as_bytes(std::span(words)).first(bytes.size()), "hostile");
  if (!indexes) return indexes.error();
  std::string objects;
  for (const ClassIndex& index : indexes.value()) objects += index.object + " ";
  return objects;
}

}  // namespace

TEST_CASE("a file of one index and a bundle of one or three are read in order") {
  CHECK(parse(sample()) == "cube ");
  CHECK(parse(bundle_of({sample()})) == "cube ");
  CHECK(parse(bundle_of({sample(), sample(), sample()})) == "cube cube cube ");
}

TEST_CASE("a bundle in a file is loaded, and is no single index") {
  const TemporaryFolder folder;
  const Bytes bytes = bundle_of({sample(), sample()});
  folder.write("two.aspect", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  CHECK(load_index_file(folder.path() / "two.aspect").value().size() == 2);
  CHECK_THAT(load_index(folder.path() / "two.aspect").error(), Contains("several objects"));
  CHECK_THAT(load_index_file(folder.path() / "none.aspect").error(), Contains("cannot be read"));
}

TEST_CASE("a bundle of nothing or of too many is refused with its number") {
  CHECK_THAT(parse(bundle_of({})), Contains("holds 0 indexes, not 1 to 64"));
  CHECK_THAT(parse(bundle_of(std::vector<Bytes>(65, Bytes{1}))), Contains("holds 65 indexes"));
}

TEST_CASE("what is wrong with one index of a bundle is told with its place") {
  Bytes damaged = sample();
  damaged[damaged.size() / 2] ^= 1;
  CHECK_THAT(parse(bundle_of({sample(), damaged})),
             StartsWith("hostile (index 2 of 2): is damaged"));
  CHECK_THAT(parse(bundle_of({Bytes(500, 'x')})), StartsWith("hostile (index 1 of 1): is not a"));
  CHECK_THAT(parse(bundle_of({Bytes{}})), StartsWith("hostile (index 1 of 1): is empty"));
  // A bundle in a bundle is no index.
  CHECK_THAT(parse(bundle_of({bundle_of({sample()})})), StartsWith("hostile (index 1 of 1): "));
}

TEST_CASE("a bundle whose parts are one and the same piece of the file is refused") {
  flatbuffers::FlatBufferBuilder builder;
  const auto part = schema::CreateBundledIndex(builder, builder.CreateVector(sample()));
  const std::vector<flatbuffers::Offset<schema::BundledIndex>> parts(5, part);
  schema::FinishIndexBundleBuffer(builder,
                                  schema::CreateIndexBundle(builder, builder.CreateVector(parts)));
  CHECK_THAT(parse({builder.GetBufferPointer(), builder.GetBufferPointer() + builder.GetSize()}),
             Contains("its indexes overlap"));
}

TEST_CASE("a bundle cut short anywhere or damaged at random is one line, or as it was") {
  const Bytes bundle = bundle_of({sample(), sample()});
  // The last bytes are padding.
  for (std::size_t length = 0; length + 16 < bundle.size(); length += 7)
    REQUIRE_THAT(parse({bundle.begin(), bundle.begin() + static_cast<std::ptrdiff_t>(length)}),
                 StartsWith("hostile"));
  std::mt19937 random(3);
  int refused = 0;
  for (int round = 0; round < rounds(3000); ++round) {
    Bytes bytes = bundle;
    const std::size_t range = round % 2 == 0 ? 64 : bytes.size();
    for (int change = 0; change < 2; ++change)
      bytes[random() % range] = static_cast<std::uint8_t>(random() % 256);
    const std::string outcome = parse(bytes);
    REQUIRE(outcome.find('\n') == std::string::npos);
    if (outcome.starts_with("hostile")) ++refused;
  }
  CHECK(refused > rounds(2000));
}

}  // namespace aspect
