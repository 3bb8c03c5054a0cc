// The view of BLOCKCYL of which the thesis prints graph and chain codes, rendered from our model of
// it. The model's dimensions were measured from these very contours, to about 5 %.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "compiler/aspects/compile_options.h"
#include "tests/compiler/aspects/compiled_model.h"
#include "tests/tools/export/formats/thesis_examples.h"
#include "tools/export/described_view.h"
#include "tools/export/formats/view_name.h"

namespace aspect {
namespace {

// Its picture is upright along z, other than our studio's.
RelationalGraph our_graph() {
  Scene scene = model_scene("blockcyl2");
  scene.studio.up = {0, 0, 1};
  const Renderer renderer = Renderer::create(scene).value();
  const CompileOptions options;
  Observer observer(renderer, scene.studio, options.vision);
  const Direction3 d = direction_of_view_name("+0.222-0.842+0.491").value();
  const ObservedView view = observer.observe(Eigen::Vector3d(d[0], d[1], d[2]).normalized());
  return graph_of(view, described_contours(observer));
}

void check_near(const AttributeVector& ours, const AttributeVector& theirs, std::size_t k,
                std::int64_t within) {
  CAPTURE(k);
  CHECK(std::abs(ours[k] - theirs[k]) <= within);
}

}  // namespace

TEST_CASE("our BLOCKCYL has the thesis's regions where the thesis has them, and its directions") {
  const std::string name = std::string(kExampleView) + ".sgm";
  const RelationalGraph theirs = parse_graph(thesis_example(name), name).value();
  const RelationalGraph ours = our_graph();
  // The example breaks off before the block's front.
  REQUIRE(ours.nodes.size() == theirs.nodes.size() + 1);
  for (std::size_t i = 0; i < theirs.nodes.size(); ++i) {
    const AttributeVector &a = ours.nodes[i].attributes, &b = theirs.nodes[i].attributes;
    CAPTURE(ours.nodes[i].name);
    check_near(a, b, 0, b[0] / 7);
    check_near(a, b, 1, b[1] / 30);
    check_near(a, b, 2, 80);
    for (const std::size_t centre : {5U, 6U}) check_near(a, b, centre, 8);
    // At nine tenths of the brightness.
    for (const std::size_t colour : {7U, 8U, 9U})
      CHECK(std::abs(10 * a[colour] - 9 * b[colour]) <= 10);
  }
  for (std::size_t k = 0; k < theirs.arcs.size(); ++k) {
    CHECK(ours.arcs[k].from == theirs.arcs[k].from);
    CHECK(ours.arcs[k].to == theirs.arcs[k].to);
    CHECK(ours.arcs[k].direction == theirs.arcs[k].direction);
  }
}

}  // namespace aspect
