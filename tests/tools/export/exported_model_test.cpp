// What aspect-export writes, read by the readers of its formats, against the store's model.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "runtime/recognition/class_index.h"
#include "tests/tools/export/exported_store.h"
#include "tools/export/formats/attribute_file.h"
#include "tools/export/formats/chain_file.h"
#include "tools/export/formats/class_file.h"
#include "tools/export/formats/detail_file.h"
#include "tools/export/formats/graph_file.h"
#include "tools/export/formats/means_file.h"
#include "tools/export/formats/partition_file.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

// The files of the whole model, made once.
const TemporaryFolder& exported() {
  static const TemporaryFolder folder;
  static const Outcome outcome = run_export(folder.path(), {sample_store().string(), "files"});
  REQUIRE(outcome.err == "");
  REQUIRE(outcome.exit_code == 0);
  return folder;
}

std::string file_text(const std::string& name) {
  const fs::path file = exported().path() / "files" / ("l_shape" + name);
  REQUIRE(fs::exists(file));
  return read_file(file);
}

// What a file says, which is written as the same bytes.
template <typename Parse, typename Write>
auto read_back(const std::string& name, Parse parse, Write write) {
  const std::string text = file_text(name);
  auto read = parse(text, name);
  INFO((read.ok() ? "" : read.error()));
  REQUIRE(read.ok());
  if (write(read.value()) != text) FAIL("not the bytes of " << name);
  return std::move(read).value();
}

std::vector<std::string> names_of_views() {
  std::vector<Direction3> directions;
  for (const ObservedView& view : sample_model().subdivision.views)
    directions.push_back({view.direction.x(), view.direction.y(), view.direction.z()});
  return view_names(directions);
}

bool has_hole(const ObservedView& view) {
  return view.external_count < view.contours.size();
}

void check_node(const GraphNode& node, const ObservedContour& contour) {
  CHECK(node.external == contour.external);
  CHECK(node.shape == contour.shape);
  CHECK(node.attributes[0] == std::lround(contour.area_px));
  // Shares of the colour, from whole numbers.
  const double sum =
      static_cast<double>(node.attributes[7] + node.attributes[8] + node.attributes[9]);
  for (std::size_t channel = 0; channel < 3; ++channel)
    CHECK(static_cast<double>(node.attributes[7 + channel]) / sum ==
          Approx(static_cast<double>(contour.feature.share[channel])).margin(1.5 / sum));
}

void check_arc(const GraphArc& arc, const Relation& relation) {
  CHECK(arc.from == relation.from);
  CHECK(arc.to == relation.to);
  // 0 to the right and on with the clock; a compass's 0 is up.
  const double right = std::sin(2 * std::numbers::pi * arc.direction / 16);
  const double down = -std::cos(2 * std::numbers::pi * arc.direction / 16);
  const double angle = 2 * std::numbers::pi * relation.direction / 16;
  CHECK(right == Approx(std::cos(angle)).margin(1e-9));
  CHECK(down == Approx(std::sin(angle)).margin(1e-9));
  CHECK((arc.kind == ' ') == (relation.kind == Relation::Kind::apart));
}

}  // namespace

TEST_CASE("graphs and chains of all views are those of the store, and agree with each other") {
  const std::vector<ObservedView>& views = sample_model().subdivision.views;
  const std::vector<std::string> names = names_of_views();
  CHECK(std::set<std::string>(names.begin(), names.end()).size() == views.size());
  for (std::size_t v = 0; v < views.size(); ++v) {
    CAPTURE(names[v]);
    const auto graph = read_back(names[v] + ".sgm", parse_graph, graph_text);
    const auto chains = read_back(names[v] + ".chn8", parse_chains, chains_text);
    REQUIRE(graph.nodes.size() == views[v].contours.size());
    REQUIRE(chains.size() == views[v].contours.size());
    for (std::size_t i = 0; i < chains.size(); ++i) {
      check_node(graph.nodes[i], views[v].contours[i]);
      const AttributeVector within = attributes_of(chains[i]);
      CHECK(std::equal(within.begin() + 1, within.begin() + 7,
                       graph.nodes[i].attributes.begin() + 1));
      // But for holes too small to have a contour.
      if (has_hole(views[v])) continue;
      CHECK(within[0] >= graph.nodes[i].attributes[0]);
      CHECK(100 * within[0] <= 103 * graph.nodes[i].attributes[0]);
    }
    REQUIRE(graph.arcs.size() == views[v].relations.size());
    for (std::size_t k = 0; k < graph.arcs.size(); ++k)
      check_arc(graph.arcs[k], views[v].relations[k]);
  }
}

TEST_CASE("vertices are all views, and patches have theirs at their corners") {
  const Subdivision& subdivision = sample_model().subdivision;
  const auto vertices = read_back(".2.vert", parse_vertices, vertices_text);
  REQUIRE(vertices.size() == subdivision.views.size());
  CHECK(subdivision.views.size() > subdivision.sphere.vertex_count());
  CHECK(std::is_sorted(vertices.begin(), vertices.end(),
                       [](const auto& a, const auto& b) { return a.direction < b.direction; }));
  std::map<std::int64_t, const ListedVertex*> by_id;
  for (const ListedVertex& vertex : vertices) {
    by_id[vertex.id] = &vertex;
    const ObservedView& view = subdivision.views[static_cast<std::size_t>(vertex.id - 1)];
    CHECK(vertex.regions == static_cast<std::int64_t>(view.external_count));
    for (int axis = 0; axis < 3; ++axis)
      CHECK(vertex.direction[static_cast<std::size_t>(axis)] ==
            Approx(view.direction[axis]).margin(5.1e-11));
  }
  const auto partitions = read_back(".2.part", parse_partitions, partitions_text);
  REQUIRE(partitions.size() == sample_model().clusters.size());
  for (std::size_t c = 0; c < partitions.size(); ++c) {
    const Cluster& cluster = sample_model().clusters[c];
    REQUIRE(partitions[c].size() == cluster.patches.size());
    for (std::size_t k = 0; k < partitions[c].size(); ++k) {
      const ListedPatch& patch = partitions[c][k];
      CHECK(patch.level == subdivision.sphere.patch(cluster.patches[k]).level);
      for (const ListedVertex& corner : patch.corners) {
        const ListedVertex& vertex = *by_id.at(corner.id);
        CHECK(corner.regions == vertex.regions);
        CHECK(corner.regions == patch.corners[0].regions);
        for (std::size_t axis = 0; axis < 3; ++axis)
          CHECK(std::abs(corner.direction[axis] - vertex.direction[axis]) < 5.1e-4);
      }
    }
  }
}

TEST_CASE("details name contours as the cluster does, and attributes are those of the details") {
  const StoredModel& model = sample_model();
  const std::vector<std::string> names = names_of_views();
  const auto groups = read_back(".2.det", parse_details, details_text);
  REQUIRE(groups.size() == model.clusters.size());
  for (std::size_t c = 0; c < groups.size(); ++c) {
    const Cluster& cluster = model.clusters[c];
    REQUIRE(groups[c].size() == cluster.views.size());
    for (std::size_t g = 0; g < groups[c].size(); ++g) {
      const ClusterView& view = cluster.views[g];
      const DetailedGraph& graph = groups[c][g];
      const std::string& name = names[static_cast<std::size_t>(view.vertex)];
      CHECK(graph.view == name);
      REQUIRE(graph.nodes.size() == cluster.contour_count);
      const auto own = parse_graph(file_text(name + ".sgm"), name).value();
      for (std::size_t i = 0; i < cluster.contour_count; ++i) {
        const GraphNode& node = graph.nodes[view.names[i]];
        CHECK(place_of_name(node.name) == view.names[i]);
        CHECK(node.attributes == own.nodes[i].attributes);
      }
    }
  }
  const auto table = read_back(".attr", parse_attributes, attributes_text);
  CHECK(table == attributes_of(groups));
}

TEST_CASE(
    "classes count the graphs of the index's classes by type, and means add up to all regions") {
  const ClassIndex index = parse_index(std::as_bytes(sample_index_bytes()), "index").value();
  const auto classes = read_back(".class", parse_classes, classes_text);
  REQUIRE(classes.size() == index.classes.size());
  std::map<std::int64_t, double> regions_of_type;
  for (std::size_t c = 0; c < classes.size(); ++c) {
    const auto contours = ClassIndex::part(index.class_contours, index.classes[c].contours);
    REQUIRE(classes[c].size() == contours.size());
    for (std::size_t k = 0; k < contours.size(); ++k) {
      const auto types = ClassIndex::part(index.type_scores, contours[k].types);
      REQUIRE(classes[c][k].size() == types.size());
      std::int64_t graphs = 0;
      for (std::size_t t = 0; t < types.size(); ++t) {
        CHECK(classes[c][k][t].type == types[t].type);
        graphs += classes[c][k][t].graphs;
        regions_of_type[types[t].type] += static_cast<double>(classes[c][k][t].graphs);
      }
      CHECK(graphs == index.classes[c].view_count);
    }
  }
  const auto means = read_back(".means", parse_means, means_text);
  const auto table = parse_attributes(file_text(".attr"), "attr").value();
  REQUIRE(means.size() == index.types.size());
  for (std::size_t a = 0; a < kAttributes; ++a) {
    double from_means = 0, from_regions = 0;
    for (const auto& [type, count] : regions_of_type)
      from_means += count * static_cast<double>(means[static_cast<std::size_t>(type)][a]);
    for (const AttributeRow& row : table.rows)
      from_regions += static_cast<double>(row.attributes[a]);
    CHECK(from_means == Approx(from_regions).margin(0.5 * static_cast<double>(table.rows.size())));
  }
}

}  // namespace aspect
