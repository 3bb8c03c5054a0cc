// Symmetries and extent of an index: read as written, refused where they cannot be.
#include <catch2/catch.hpp>
#include <cstring>
#include <limits>

#include "runtime/recognition/class_index.h"
#include "schema/class_index_generated.h"
#include "tests/runtime/recognition/hostile_index.h"

namespace aspect {
namespace {

using Catch::Contains;

IndexBytes bytes_with(const std::vector<schema::Rotation>& rotations,
                      const std::vector<schema::Axis>& axes, const schema::Extent* extent) {
  flatbuffers::FlatBufferBuilder builder;
  const auto provenance = schema::CreateProvenanceDirect(builder, "test");
  const auto segmentation = schema::CreateSegmentation(builder);
  const std::vector<float> types;
  const std::vector<std::uint16_t> surfaces;
  const std::vector<std::uint8_t> map = map_of_nothing();
  const auto none = [&builder](auto like) {
    return builder.CreateVectorOfStructs(std::vector<decltype(like)>{});
  };
  schema::FinishClassIndexBuffer(
      builder,
      schema::CreateClassIndex(
          builder, kIndexFormatVersion, 1, builder.CreateString("made"), provenance, segmentation,
          schema::Scoring::none, 50, 512, 512, kTypeDimensions, builder.CreateVector(types),
          none(schema::AspectClass{}), none(schema::ClassContour{}), none(schema::TypeScore{}),
          builder.CreateVector(surfaces), none(schema::KeyView{}), none(schema::KeyContour{}),
          builder.CreateVector(map), builder.CreateVectorOfStructs(rotations),
          builder.CreateVectorOfStructs(axes), extent));
  IndexBytes bytes(builder.GetSize());
  std::memcpy(bytes.data(), builder.GetBufferPointer(), bytes.size());
  repair_checksum(bytes);
  return bytes;
}

constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();

}  // namespace

TEST_CASE("symmetries and extent are read as they were written") {
  const schema::Extent extent(-1, -2, -3, 4, 5, 6, 7, .5, .25, .125);
  const IndexBytes bytes = bytes_with({{0, 0, 1, 0}, {.6F, 0, 0, .8F}}, {{0, -1, 0}}, &extent);
  const ClassIndex index = parse_index(bytes, "made").value();
  CHECK(index.symmetries == std::vector<std::array<float, 4>>{{0, 0, 1, 0}, {.6F, 0, 0, .8F}});
  CHECK(index.symmetry_axes == std::vector<Vector3>{{0, -1, 0}});
  CHECK(index.extent.least == std::array<double, 3>{-1, -2, -3});
  CHECK(index.extent.most == std::array<double, 3>{4, 5, 6});
  CHECK(index.extent.diameter == 7);
  CHECK(index.extent.centre == std::array<double, 3>{.5, .25, .125});
}

TEST_CASE("an index without them is one of an object without symmetries") {
  const ClassIndex index = parse_index(bytes_with({}, {}, nullptr), "made").value();
  CHECK(index.symmetries.empty());
  CHECK(index.symmetry_axes.empty());
  CHECK(index.extent.diameter == 0);
}

TEST_CASE("rotations and axes that are none, too many of them and endless extents are refused") {
  const auto refuses = [](const IndexBytes& bytes, const char* words) {
    CHECK_THAT(try_index(bytes), Contains(words));
  };
  const char* symmetries = "hostile: holds symmetries that cannot be";
  refuses(bytes_with({{0, 0, 0, 0}}, {}, nullptr), symmetries);
  refuses(bytes_with({{1, 1, 0, 0}}, {}, nullptr), symmetries);
  refuses(bytes_with({{1, kNotANumber, 0, 0}}, {}, nullptr), symmetries);
  refuses(bytes_with({}, {{0, 0, .9F}}, nullptr), symmetries);
  refuses(bytes_with({}, {{kNotANumber, 0, 1}}, nullptr), symmetries);
  refuses(bytes_with({}, std::vector<schema::Axis>(4, {0, 0, 1}), nullptr), symmetries);
  refuses(bytes_with(std::vector<schema::Rotation>(129, {1, 0, 0, 0}), {}, nullptr), symmetries);
  const schema::Extent endless(-1, -2, -3, 4, 5, 6, std::numeric_limits<double>::infinity(), 0, 0,
                               0);
  refuses(bytes_with({}, {}, &endless), "hostile: holds a number that is not finite");
}

}  // namespace aspect
