// The same scene and options give the same bytes: for any number of threads, with or without a
// store, in one go or in pieces.
#include <array>
#include <catch2/catch.hpp>
#include <set>

#include "compiler/aspects/view_codec.h"
#include "compiler/compile.h"
#include "tests/compiler/aspects/compiled_model.h"
#include "tests/temporary_folder.h"

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

// Subdivision by itself, with a store of any key.
struct Bench {
  Scene scene;
  CompileOptions options;
  Renderer renderer;
  Bench(const std::string& model, int level)
      : scene(small_model_scene(model)),
        options(options_of_level(level)),
        renderer(Renderer::create(scene).value()) {}
  Subdivision subdivided(Store* store) const {
    return subdivide({renderer, scene.studio, options, store, {}, nullptr}).value();
  }
};

// From the lower vertex to the higher, as the table's mappings go.
std::set<std::pair<VertexId, VertexId>> matched_pairs(const Subdivision& s) {
  std::set<std::pair<VertexId, VertexId>> pairs;
  for (const PatchId leaf : s.sphere.leaves()) {
    const auto& c = s.sphere.patch(leaf).corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(c[k], c[(k + 1) % 3]);
      if (s.matches.find(a, b) != nullptr) pairs.emplace(a, b);
    }
  }
  return pairs;
}

void check_same_matches(const Subdivision& found, const Subdivision& wanted) {
  CHECK(matched_pairs(found) == matched_pairs(wanted));
  for (const auto& [a, b] : matched_pairs(wanted)) {
    const GraphMatch &x = *found.matches.find(a, b), &y = *wanted.matches.find(a, b);
    CHECK(x.mapping == y.mapping);
    CHECK(x.cost == y.cost);
  }
}

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
  CHECK(first.statistics.subdivision.views_rendered ==
        without.statistics.subdivision.views + without.statistics.subdivision.border_views);
  CHECK(second.statistics.subdivision.views == first.statistics.subdivision.views);
  CHECK(second.statistics.subdivision.views_rendered == 0);
  CHECK(second.statistics.subdivision.matches_executed == 0);
  CHECK(second.statistics.subdivision.match_calls == first.statistics.subdivision.match_calls);
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
    CHECK(resumed.statistics.subdivision.views_rendered + views <=
          whole.statistics.subdivision.views + whole.statistics.subdivision.border_views);
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
  CHECK(runs >= whole.statistics.subdivision.views / 200);
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
  CHECK(shallow.statistics.subdivision.views == 642);
  // Views on the edges of level 3 are of use again where level 4 has vertices there.
  CHECK(deepened.statistics.subdivision.views_rendered <
        deep.statistics.subdivision.views_rendered - 642);
  CHECK(deepened.statistics.subdivision.views == deep.statistics.subdivision.views);
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
    CHECK(with.statistics.subdivision.views_rendered <
          without.statistics.subdivision.views_rendered);
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
  const Bench bench("cube", 3);
  const Subdivision plain = bench.subdivided(nullptr);
  Store store = Store::open(folder.path() / "cube.store", {"cube", "test"}).value();
  bench.subdivided(&store);
  // No view, a mapping to contours that are not there, one that is too short, one onto itself.
  const std::vector<std::byte> junk(7, std::byte{200}), one(1), twice(2);
  std::size_t damaged = 0;
  for (const PatchId leaf : plain.sphere.leaves()) {
    const auto& c = plain.sphere.patch(leaf).corners;
    const GraphMatch* match = plain.matches.find(c[0], c[1]);
    if (match == nullptr || match->mapping.size() < 2 || ++damaged > 90) continue;
    const auto at = [&](std::size_t k) { return plain.sphere.position(c[k]); };
    REQUIRE(store.add_match(at(0), at(1), 5, std::array{junk, one, twice}[damaged % 3]).ok());
    if (damaged % 3 == 0) REQUIRE(store.add_view(at(2), junk).ok());
  }
  const Subdivision mended = bench.subdivided(&store);
  CHECK(mended.statistics.views_rendered > 0);
  CHECK(mended.statistics.views_rendered <= 30);
  CHECK(mended.statistics.matches_executed > 0);
  check_same_matches(mended, plain);
}

TEST_CASE("a match that a store knows from the other end is turned round") {
  const TemporaryFolder folder;
  Bench bench("truck_unique", 3);
  bench.options.border_views = 0;
  const Subdivision plain = bench.subdivided(nullptr);
  Store store = Store::open(folder.path() / "truck.store", {"truck_unique", "test"}).value();
  std::size_t telling = 0;
  for (const ObservedView& view : plain.views)
    REQUIRE(store.add_view(view.direction, encode_view(view)).ok());
  for (const auto& [a, b] : matched_pairs(plain)) {
    const GraphMatch back = reversed(*plain.matches.find(a, b));
    REQUIRE(store.add_match(plain.direction(b), plain.direction(a), back.cost, encode_mapping(back))
                .ok());
    telling += back.mapping != plain.matches.find(a, b)->mapping ? 1U : 0U;
  }
  // Most mappings only exchange pairs of contours and are the same from both ends.
  CHECK(telling > 10);
  const Subdivision turned = bench.subdivided(&store);
  CHECK(turned.statistics.views_rendered == 0);
  CHECK(turned.statistics.matches_executed == 0);
  check_same_matches(turned, plain);
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
