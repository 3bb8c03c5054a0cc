#include "tests/tools/export/exported_store.h"

#include <catch2/catch.hpp>

#include "compiler/compile.h"
#include "compiler/scene/bob_reader.h"
#include "tests/compiler/aspects/compiled_model.h"

namespace aspect {
namespace {

struct Sample {
  TemporaryFolder folder;
  std::filesystem::path store = folder.path() / "l_shape.store";
  std::vector<std::uint8_t> index;
};

// In small pictures, as its text says: a store's scene is read again.
Scene small_scene(const TemporaryFolder& folder) {
  std::string text = read_file(ASPECT_SOURCE_DIR "/tests/data/rendered/l_shape.b");
  const std::string large = "resolution 512 512";
  return read_bob(folder.write("l_shape.b",
                               text.replace(text.find(large), large.size(), "resolution 192 192")))
      .value();
}

const Sample& sample() {
  static const Sample* made = [] {
    static Sample fresh;
    CompileOptions options = options_of_level(2);
    options.min_level = 1;
    const Result<CompiledIndex> compiled =
        compile(small_scene(fresh.folder), options, fresh.store, {}, nullptr);
    REQUIRE(compiled.ok());
    fresh.index = compiled.value().bytes;
    return &fresh;
  }();
  return *made;
}

}  // namespace

const std::filesystem::path& sample_store() {
  return sample().store;
}

const StoredModel& sample_model() {
  static const StoredModel model =
      open_stored_model(sample_store(), read_recipe(sample_store()).value(), {}).value();
  return model;
}

std::span<const std::uint8_t> sample_index_bytes() {
  return sample().index;
}

Outcome run_export(const std::filesystem::path& folder, const std::vector<std::string>& arguments) {
  return ChildProgram(ASPECT_EXPORT, folder, arguments).wait();
}

}  // namespace aspect
