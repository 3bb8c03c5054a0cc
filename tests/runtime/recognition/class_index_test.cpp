// parse_index on good bytes and on every kind of bad ones. Run under the sanitizers too.
#include "runtime/recognition/class_index.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <fstream>
#include <functional>

#include "schema/class_index_generated.h"
#include "tests/rounds.h"
#include "tests/runtime/recognition/hostile_index.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Contains;
using Catch::StartsWith;

const IndexBytes& sample() {
  static const IndexBytes bytes = sample_index_bytes();
  return bytes;
}

bool is_one_line(const std::string& error) {
  return error.find('\n') == std::string::npos && error.find('\r') == std::string::npos;
}

// The sample with a change to what its FlatBuffers fields say, and a checksum that fits.
std::string error_after(const std::function<void(schema::ClassIndex&)>& change) {
  IndexBytes bytes = sample();
  change(*flatbuffers::GetMutableRoot<schema::ClassIndex>(bytes.data()));
  repair_checksum(bytes);
  return try_index(bytes);
}

// Where the fields of the schema's structs lie.
enum class Field : std::size_t {
  class_first_contour = 0,
  class_contour_count = 4,
  class_first_key_view = 8,
  class_key_view_count = 12,
  class_area_fraction = 16,
  contour_first_type = 0,
  contour_first_surface = 6,
  contour_centre_y = 16,
  key_view_first_contour = 0,
  key_view_contour_count = 4,
  key_contour_name = 20,
  score_score = 0,
  score_type = 4,
};

template <typename Struct>
void put(const flatbuffers::Vector<const Struct*>* vector, flatbuffers::uoffset_t i, Field field,
         auto value) {
  auto* bytes = reinterpret_cast<std::uint8_t*>(const_cast<Struct*>(vector->Get(i)));
  std::memcpy(bytes + static_cast<std::size_t>(field), &value, sizeof value);
}

void set(flatbuffers::Table& table, flatbuffers::voffset_t field, auto value) {
  auto* place = const_cast<std::uint8_t*>(table.GetAddressOf(field));
  REQUIRE(place != nullptr);
  std::memcpy(place, &value, sizeof value);
}

void set(schema::ClassIndex& root, flatbuffers::voffset_t field, auto value) {
  set(reinterpret_cast<flatbuffers::Table&>(root), field, value);
}

}  // namespace

TEST_CASE("the sample is accepted and says what it is") {
  CHECK(try_index(sample()).empty());
  const ClassIndex index = parse_index(sample(), "sample").value();
  CHECK(index.object == "cube");
  CHECK(index.classes.size() > 10);
  CHECK(index.file_bytes == sample().size());
}

TEST_CASE("an empty file, a foreign file and another version are told apart") {
  CHECK(try_index({}) == "hostile: is empty; an index of a few KiB was expected");
  IndexBytes foreign(2000, std::byte{'x'});
  CHECK_THAT(try_index(foreign), StartsWith("hostile: is not a class index") && Contains("ASPX"));
  IndexBytes renamed = sample();
  renamed[7] = std::byte{'Y'};
  repair_checksum(renamed);
  CHECK_THAT(try_index(renamed), Contains("is not a class index"));
  const std::string version = error_after([](schema::ClassIndex& root) {
    set(root, schema::ClassIndex::VT_FORMAT_VERSION, std::uint32_t{77});
  });
  CHECK_THAT(version, Contains("has format version 77, this runtime reads 3") &&
                          Contains("compile the scene again"));
}

TEST_CASE("an index cut short anywhere is refused in one line") {
  for (std::size_t length = 0; length < sample().size(); ++length) {
    const std::string error = try_index(std::span(sample()).first(length));
    REQUIRE_THAT(error, StartsWith("hostile: "));
    REQUIRE(is_one_line(error));
  }
}

TEST_CASE("any flipped bit is noticed") {
  std::mt19937 random(1);
  for (int round = 0; round < rounds(4000); ++round) {
    IndexBytes bytes = sample();
    bytes[random() % bytes.size()] ^= static_cast<std::byte>(1U << random() % 8);
    const std::string error = try_index(bytes);
    REQUIRE_THAT(error, StartsWith("hostile: "));
    REQUIRE(is_one_line(error));
  }
}

TEST_CASE("damage that the checksum hides neither crashes nor makes more than a line") {
  std::mt19937 random(2);
  int taken = 0;
  for (int round = 0; round < rounds(20000); ++round) {
    IndexBytes bytes = sample();
    damage(bytes, random);
    if (round % 2 == 0) repair_checksum(bytes);
    const std::string error = try_index(bytes);
    REQUIRE(is_one_line(error));
    if (error.empty()) ++taken;
  }
  // What is only wrong, not dangerous, is taken; otherwise the test would not reach far.
  CHECK(taken > rounds(1000));
}

TEST_CASE("every reference is checked") {
  using Root = schema::ClassIndex;
  const std::uint32_t far = 1U << 30U;
  CHECK_THAT(error_after([&](Root& r) { put(r.classes(), 0, Field::class_first_contour, far); }),
             Contains("a class that points outside"));
  CHECK_THAT(error_after([&](Root& r) { put(r.classes(), 1, Field::class_contour_count, far); }),
             Contains("a class that points outside"));
  CHECK_THAT(error_after([&](Root& r) { put(r.classes(), 2, Field::class_first_key_view, ~0U); }),
             Contains("a class that points outside"));
  CHECK_THAT(error_after([&](Root& r) { put(r.classes(), 2, Field::class_key_view_count, ~0U); }),
             Contains("a class that points outside"));
  CHECK_THAT(
      error_after([&](Root& r) { put(r.class_contours(), 0, Field::contour_first_type, far); }),
      Contains("a contour that points outside"));
  CHECK_THAT(error_after([&](Root& r) {
               put(r.class_contours(), 0, Field::contour_first_surface, std::uint16_t{65535});
             }),
             Contains("a contour that points outside"));
  CHECK_THAT(
      error_after([&](Root& r) { put(r.key_views(), 0, Field::key_view_first_contour, far); }),
      Contains("a key view that points outside"));
  CHECK_THAT(error_after([&](Root& r) {
               put(r.key_views(), 0, Field::key_view_contour_count, std::uint16_t{49});
             }),
             Contains("a key view that points outside"));
  CHECK_THAT(error_after([&](Root& r) {
               put(r.key_contours(), 0, Field::key_contour_name, std::uint16_t{48});
             }),
             Contains("a contour that its class does not have"));
  CHECK_THAT(
      error_after([&](Root& r) { put(r.type_scores(), 0, Field::score_type, std::uint16_t{256}); }),
      Contains("a contour type that it does not hold"));
}

TEST_CASE("every number must be finite and every setting possible") {
  using Root = schema::ClassIndex;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  for (const float bad : {nan, infinite, -infinite}) {
    CHECK_FALSE(
        error_after([&](Root& r) { put(r.type_scores(), 3, Field::score_score, bad); }).empty());
    CHECK_FALSE(error_after([&](Root& r) {
                  put(r.class_contours(), 1, Field::contour_centre_y, bad);
                }).empty());
    CHECK_FALSE(error_after([&](Root& r) {
                  put(r.classes(), 1, Field::class_area_fraction, bad);
                }).empty());
    CHECK_THAT(error_after([&](Root& r) { set(r, Root::VT_FIELD_OF_VIEW_DEG, bad); }),
               Contains("a camera that cannot be"));
    CHECK_THAT(error_after([&](Root& r) {
                 std::memcpy(const_cast<std::uint8_t*>(r.types()->Data()) + 40, &bad, sizeof bad);
               }),
               Contains("a number that is not finite"));
  }
  CHECK_FALSE(error_after([](Root& r) { set(r, Root::VT_FIELD_OF_VIEW_DEG, 180.0F); }).empty());
  CHECK_FALSE(error_after([](Root& r) { set(r, Root::VT_FIELD_OF_VIEW_DEG, 0.0F); }).empty());
  CHECK_THAT(error_after([](Root& r) { set(r, Root::VT_TYPE_DIMENSIONS, std::uint16_t{6}); }),
             Contains("contour types of another kind"));
}

TEST_CASE("more contours than the runtime has room for are refused, whoever has them") {
  const auto widen = [](const auto* list, Field first, Field count, auto number, std::size_t all) {
    std::size_t next = 0;
    for (flatbuffers::uoffset_t k = 0; k < list->size(); ++k) {
      const std::size_t taken = k == 0 ? 49 : std::min<std::size_t>(1, all - next);
      put(list, k, first, static_cast<std::uint32_t>(next));
      put(list, k, count, static_cast<decltype(number)>(taken));
      next += taken;
    }
  };
  CHECK_THAT(error_after([&](schema::ClassIndex& root) {
               widen(root.key_views(), Field::key_view_first_contour, Field::key_view_contour_count,
                     std::uint16_t{}, root.key_contours()->size());
             }),
             Contains("a key view that points outside"));
  CHECK_THAT(error_after([&](schema::ClassIndex& root) {
               widen(root.classes(), Field::class_first_contour, Field::class_contour_count,
                     std::uint32_t{}, root.class_contours()->size());
             }),
             Contains("a class that points outside"));
}

TEST_CASE("classes that share key views or contours are refused: they would multiply the work") {
  const std::string views = error_after([](schema::ClassIndex& root) {
    for (flatbuffers::uoffset_t k = 0; k < root.key_contours()->size(); ++k)
      put(root.key_contours(), k, Field::key_contour_name, std::uint16_t{0});
    for (flatbuffers::uoffset_t k = 0; k < root.classes()->size(); ++k) {
      put(root.classes(), k, Field::class_first_key_view, 0U);
      put(root.classes(), k, Field::class_key_view_count, root.key_views()->size());
    }
  });
  CHECK_THAT(views, StartsWith("hostile: ") && Contains("a class that points outside"));
  const std::string contours = error_after([](schema::ClassIndex& root) {
    for (flatbuffers::uoffset_t k = 0; k < root.class_contours()->size(); ++k)
      put(root.class_contours(), k, Field::contour_first_type, 0U);
  });
  CHECK_THAT(contours, StartsWith("hostile: ") && Contains("a contour that points outside"));
}

TEST_CASE("more classes than sixteen bits can name are refused") {
  const auto bytes_with = [](std::size_t classes) {
    flatbuffers::FlatBufferBuilder builder;
    const auto provenance = schema::CreateProvenanceDirect(builder, "test");
    const auto segmentation = schema::CreateSegmentation(builder);
    const std::vector<schema::AspectClass> many(classes);
    const auto none = [&builder](auto like) {
      return builder.CreateVectorOfStructs(std::vector<decltype(like)>{});
    };
    const std::vector<float> types;
    const std::vector<std::uint16_t> surfaces;
    const std::vector<std::uint8_t> map = map_of_nothing();
    schema::FinishClassIndexBuffer(
        builder,
        schema::CreateClassIndex(
            builder, kIndexFormatVersion, 1, builder.CreateString("many"), provenance, segmentation,
            schema::Scoring::none, 50, 512, 512, kTypeDimensions, builder.CreateVector(types),
            builder.CreateVectorOfStructs(many), none(schema::ClassContour{}),
            none(schema::TypeScore{}), builder.CreateVector(surfaces), none(schema::KeyView{}),
            none(schema::KeyContour{}), builder.CreateVector(map)));
    IndexBytes bytes(builder.GetSize());
    std::memcpy(bytes.data(), builder.GetBufferPointer(), bytes.size());
    repair_checksum(bytes);
    return bytes;
  };
  CHECK(try_index(bytes_with(kMaxClasses)).empty());
  CHECK_THAT(try_index(bytes_with(kMaxClasses + 1)), Contains("has 65537 classes"));
}

TEST_CASE("a map of the viewing sphere that is no tree, or names other classes, is refused") {
  // Split for ever; a leaf of the last class that its bits can name.
  for (const std::uint8_t byte : {std::uint8_t{0xFF}, std::uint8_t{0x1F}}) {
    const std::string error = error_after([&](schema::ClassIndex& root) {
      const auto* map = root.sphere_map();
      std::memset(const_cast<std::uint8_t*>(map->data()), byte, map->size());
    });
    CHECK(error == "hostile: its map of the viewing sphere is damaged; compile the scene again");
  }
}

TEST_CASE("a file is loaded, and one that is not there, no file or too large is refused") {
  const TemporaryFolder folder;
  const auto* text = reinterpret_cast<const char*>(sample().data());
  const auto file = folder.write("cube.aspect", {text, sample().size()});
  CHECK(load_index(file).value().object == "cube");
  for (const std::string name : {"none.aspect", "."}) {
    const Result<ClassIndex> index = load_index(folder.path() / name);
    REQUIRE_FALSE(index.ok());
    CHECK_THAT(index.error(), StartsWith((folder.path() / name).string()));
    CHECK(is_one_line(index.error()));
  }
  folder.write("large.aspect", "");
  std::filesystem::resize_file(folder.path() / "large.aspect", kMaxIndexBytes + 1);
  CHECK_THAT(load_index(folder.path() / "large.aspect").error(), Contains("too many"));
}

}  // namespace aspect
