#include "tests/runtime/recognition/hostile_index.h"

#include <array>
#include <cstring>

#include "runtime/recognition/recogniser.h"
#include "runtime/recognition/self_test.h"
#include "schema/class_index_generated.h"
#include "tests/runtime/recognition/model_samples.h"
#include "tests/runtime/recognition/owned_recogniser.h"

namespace aspect {
namespace {

constexpr int kSide_px = 64;

// Three fields of a cube's colours next to each other.
std::vector<std::uint8_t> picture() {
  constexpr std::array<std::array<std::uint8_t, 3>, 3> kColours = {
      {{204, 20, 20}, {20, 204, 20}, {20, 20, 204}}};
  std::vector<std::uint8_t> rgb(3 * kSide_px * kSide_px);
  for (std::size_t y = 8; y < 56; ++y)
    for (std::size_t x = 8; x < 56; ++x)
      for (std::size_t k = 0; k < 3; ++k)
        rgb[3 * (y * kSide_px + x) + k] = kColours[(x - 8) / 16][k];
  return rgb;
}

}  // namespace

IndexBytes sample_index_bytes() {
  const std::vector<std::uint8_t> bytes = small_index_bytes();
  IndexBytes copy(bytes.size());
  std::memcpy(copy.data(), bytes.data(), bytes.size());
  return copy;
}

void repair_checksum(IndexBytes& bytes) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.data());
  flatbuffers::Verifier verifier(data, bytes.size());
  if (bytes.size() < 16 || !schema::VerifyClassIndexBuffer(verifier)) return;
  const auto* table = reinterpret_cast<const flatbuffers::Table*>(schema::GetClassIndex(data));
  const std::uint8_t* field = table->GetAddressOf(schema::ClassIndex::VT_CHECKSUM);
  if (field == nullptr) return;
  const auto place = static_cast<std::size_t>(field - data);
  const std::uint64_t sum = index_checksum(bytes, place);
  std::memcpy(bytes.data() + place, &sum, sizeof sum);
}

void damage(IndexBytes& bytes, std::mt19937& random) {
  for (std::size_t change = 0; change <= random() % 8; ++change) {
    // Half of the changes hit the tables and offsets at the beginning.
    const std::size_t range =
        random() % 2 == 0 ? std::min<std::size_t>(bytes.size(), 256) : bytes.size();
    const std::size_t place = random() % range;
    if (random() % 3 != 0) {
      bytes[place] ^= static_cast<std::byte>(1U << random() % 8);
      continue;
    }
    constexpr std::array<std::uint32_t, 6> kNumbers = {0,          1,          0x7FFFFFFF,
                                                       0x80000000, 0xFFFFFFFF, 0x7FC00000};
    const std::uint32_t number = kNumbers[random() % kNumbers.size()];
    std::memcpy(bytes.data() + std::min(place / 4 * 4, bytes.size() - 4), &number, 4);
  }
}

std::string try_index(std::span<const std::byte> bytes) {
  static const std::vector<std::uint8_t> rgb = picture();
  // Words, since FlatBuffers reads numbers in place, and no byte more than there is.
  std::vector<std::uint64_t> words((bytes.size() + 7) / 8);
  if (!bytes.empty()) std::memcpy(words.data(), bytes.data(), bytes.size());
  const Result<ClassIndex> index =
      parse_index(std::as_bytes(std::span(words)).first(bytes.size()), "hostile");
  if (!index.ok()) return index.error();
  OwnedRecogniser recogniser({&index.value(), 1}, {}, kSide_px, kSide_px);
  const Recognition seen =
      recogniser.recognise({rgb.data(), kSide_px, kSide_px, 3 * kSide_px, PixelFormat::rgb8});
  for (const SeenObject& object : seen.objects)
    for (const Hypothesis& h : object.hypotheses)
      ASPECT_CHECK(h.class_id < index.value().classes.size());
  ASPECT_CHECK(self_test(index.value()).line.find('\n') == std::string::npos);
  const auto classes = static_cast<std::int32_t>(index.value().classes.size());
  for (const SphereMap::Leaf& leaf : index.value().sphere_map.leaves()) {
    const Vector3d inside = leaf.corners[0] + leaf.corners[1] + leaf.corners[2];
    ASPECT_CHECK(index.value().sphere_map.class_at(inside) < classes);
  }
  ASPECT_CHECK(index.value().sphere_map.nearest_class({0, 0, 1}) < classes);
  return {};
}

}  // namespace aspect
