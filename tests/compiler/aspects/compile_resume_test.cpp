// The same scene and options give the same bytes: for any number of threads, with or without a
// store, in one go or in pieces.
#include <catch2/catch.hpp>

#include "compiler/compile.h"
#include "tests/compiler/aspects/compiled_model.h"
#include "tests/runtime/capture/temporary_folder.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Catch::Contains;

struct Job {
  Scene scene = small_model_scene("l_shape");
  CompileOptions options = options_of_level(4);
  std::optional<fs::path> store;

  CompiledIndex run() const { return compile(scene, options, store, {}, nullptr).value(); }

  // Asks to stop at the first word of progress after that many views.
  Result<CompiledIndex> run_until(std::size_t views) const {
    std::atomic<bool> stop{false};
    return compile(
        scene, options, store, [&](const Progress& p) { stop = stop || p.views_total >= views; },
        &stop);
  }
};

}  // namespace

TEST_CASE("one thread and two give the same bytes, and so does a second run") {
  Job job;
  job.options.jobs = 1;
  const CompiledIndex once = job.run();
  CHECK(once.bytes.size() > 1000);
  CHECK(once.statistics.threads == 1);
  CHECK(job.run().bytes == once.bytes);
  job.options.jobs = 2;
  CHECK(job.run().bytes == once.bytes);
}

TEST_CASE("with a store the bytes are the same, and a second run renders nothing") {
  const TemporaryFolder folder;
  Job job;
  const CompiledIndex without = job.run();
  job.store = folder.path() / "l.store";
  const CompiledIndex first = job.run(), second = job.run();
  CHECK(first.bytes == without.bytes);
  CHECK(second.bytes == without.bytes);
  CHECK(first.statistics.views_rendered == without.statistics.views);
  CHECK(second.statistics.views == first.statistics.views);
  CHECK(second.statistics.views_rendered == 0);
  CHECK(second.statistics.matches_executed == 0);
  CHECK(second.statistics.match_calls == first.statistics.match_calls);
}

TEST_CASE("a run that was stopped goes on where it was, to the same bytes") {
  const TemporaryFolder folder;
  Job job;
  const CompiledIndex whole = job.run();
  for (const std::size_t views : {1U, 400U, 650U, 900U}) {
    job.store = folder.path() / (std::to_string(views) + ".store");
    const Result<CompiledIndex> stopped = job.run_until(views);
    INFO("stopped after " << views << " views");
    REQUIRE_FALSE(stopped.ok());
    CHECK_THAT(stopped.error(), Contains("run the same command again"));
    CHECK(stopped.error().find('\n') == std::string::npos);
    const CompiledIndex resumed = job.run();
    CHECK(resumed.bytes == whole.bytes);
    CHECK(resumed.statistics.views_rendered + views <= whole.statistics.views);
  }
}

TEST_CASE("a run that is stopped again and again comes to its end, and renders no view twice") {
  const TemporaryFolder folder;
  Job job;
  const CompiledIndex whole = job.run();
  job.store = folder.path() / "l.store";
  std::size_t runs = 1;
  Result<CompiledIndex> outcome = job.run_until(100);
  for (; !outcome.ok() && runs < 100; ++runs) outcome = job.run_until(100);
  REQUIRE(outcome.ok());
  CHECK(runs >= whole.statistics.views / 200);
  CHECK(outcome.value().bytes == whole.bytes);
}

TEST_CASE("a deeper level takes the views of the one before from the store") {
  const TemporaryFolder folder;
  Job job;
  const CompiledIndex deep = job.run();
  job.store = folder.path() / "l.store";
  job.options.level = 3;
  const CompiledIndex shallow = job.run();
  job.options.level = 4;
  const CompiledIndex deepened = job.run();
  CHECK(shallow.statistics.views_rendered == 642);
  CHECK(deepened.statistics.views_rendered == deep.statistics.views - 642);
  CHECK(deepened.bytes == deep.bytes);
}

TEST_CASE("a store filled with another threshold gives the bytes of no store") {
  const TemporaryFolder folder;
  for (const char* model : {"l_shape", "holeblock"}) {
    Job job;
    job.scene = small_model_scene(model);
    job.store = folder.path() / (std::string(model) + ".store");
    // Vertices get other numbers where other patches are split, or all down to another level.
    job.options.threshold = 90000;
    job.options.min_level = 1;
    job.run();
    job.options.min_level = 3;
    job.options.threshold = 3000;
    const CompiledIndex with = job.run();
    job.store.reset();
    const CompiledIndex without = job.run();
    CHECK(with.statistics.views_rendered < without.statistics.views_rendered);
    CHECK(with.bytes == without.bytes);
  }
}

TEST_CASE("a store of other matching or another object is refused in one line that names it") {
  const TemporaryFolder folder;
  Job job;
  job.options.level = 2;
  job.options.min_level = 2;
  job.store = folder.path() / "l.store";
  static_cast<void>(job.run_until(1000));
  const auto refused = [&](const Job& other) {
    const Result<CompiledIndex> outcome =
        compile(other.scene, other.options, other.store, {}, nullptr);
    REQUIRE_FALSE(outcome.ok());
    CHECK_THAT(outcome.error(), Contains("l.store"));
    CHECK(outcome.error().find('\n') == std::string::npos);
  };
  Job other = job;
  other.options.cluster_threshold *= 2;
  refused(other);
  other = job;
  other.options.vision.area_min_px += 1;
  refused(other);
  other = job;
  other.options.match_scales.kind *= 2;
  refused(other);
  other = job;
  other.scene = small_model_scene("cube");
  refused(other);
}

TEST_CASE("damaged views and mappings in a store are made anew") {
  const TemporaryFolder folder;
  const Scene scene = small_model_scene("cube");
  const CompileOptions options = options_of_level(3);
  const Result<Renderer> renderer = Renderer::create(scene);
  const auto subdivided = [&](Store* store) {
    return subdivide({renderer.value(), scene.studio, options, store, {}, nullptr}).value();
  };
  const Subdivision plain = subdivided(nullptr);
  Store store = Store::open(folder.path() / "cube.store", {"cube", "test"}).value();
  subdivided(&store);
  const std::vector<std::byte> junk(7, std::byte{200});
  std::size_t damaged = 0;
  for (const PatchId leaf : plain.sphere.leaves()) {
    const auto& c = plain.sphere.patch(leaf).corners;
    if (plain.matches.find(c[0], c[1]) == nullptr || ++damaged > 50) continue;
    const auto at = [&](std::size_t k) { return plain.sphere.position(c[k]); };
    REQUIRE(store.add_match(at(0), at(1), 5, junk).ok());
    REQUIRE(store.add_view(at(2), junk).ok());
  }
  const Subdivision mended = subdivided(&store);
  CHECK(mended.views_rendered > 0);
  CHECK(mended.views_rendered <= 50);
  CHECK(mended.matches_executed > 0);
  for (const PatchId leaf : plain.sphere.leaves())
    CHECK(is_uniform(plain, plain.sphere.patch(leaf), options.threshold) ==
          is_uniform(mended, mended.sphere.patch(leaf), options.threshold));
}

TEST_CASE("an object that nobody can see is refused with what to do") {
  Job job;
  job.options = options_of_level(1);
  for (Surface& surface : job.scene.surfaces) surface.diffuse = surface.ambient = {0, 0, 0};
  const Result<CompiledIndex> outcome = compile(job.scene, job.options, {}, {}, nullptr);
  REQUIRE_FALSE(outcome.ok());
  CHECK_THAT(outcome.error(), Contains("l_shape") && Contains("raise --level"));
}

}  // namespace aspect
