// Readers and writers of the thesis's formats on the appendix's own examples, whose numbers also
// tell what they mean.
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "tests/tools/export/formats/thesis_examples.h"
#include "tools/export/formats/attribute_file.h"
#include "tools/export/formats/chain_file.h"
#include "tools/export/formats/class_file.h"
#include "tools/export/formats/detail_file.h"
#include "tools/export/formats/graph_file.h"
#include "tools/export/formats/means_file.h"
#include "tools/export/formats/partition_file.h"
#include "tools/export/formats/pose_file.h"
#include "tools/export/formats/vertex_file.h"

namespace aspect {
namespace {

// What an example says, which is written as it was and read as the same again.
template <typename Parse, typename Write>
auto example(const std::string& name, Parse parse, Write write) {
  const std::string text = thesis_example(name);
  const auto read = parse(text, name);
  INFO((read.ok() ? "" : read.error()));
  REQUIRE(read.ok());
  const std::string written = write(read.value());
  const auto again = parse(written, name);
  REQUIRE(again.ok());
  CHECK(again.value() == read.value());
  CHECK(write(again.value()) == written);
  // Chains are printed on several lines.
  if (text.find('\\') == std::string::npos) CHECK(written == text);
  return read.value();
}

RelationalGraph example_graph() {
  return example(std::string(kExampleView) + ".sgm", parse_graph, graph_text);
}

std::vector<ContourChain> example_chains() {
  return example(std::string(kExampleView) + ".chn8", parse_chains, chains_text);
}

double value(const AttributeVector& attributes, std::size_t k) {
  return static_cast<double>(attributes[k]);
}

}  // namespace

TEST_CASE("the thesis's graph is read, and its arcs point where their nodes lie") {
  const RelationalGraph graph = example_graph();
  REQUIRE(graph.nodes.size() == 4);
  CHECK(graph.nodes[1] == GraphNode{"B",
                                    "cftsrv",
                                    true,
                                    ShapeClass::triangle,
                                    {17180, 18086, 0, 128109, 3523, 255, 299, 158, 63, 255}});
  REQUIRE(graph.arcs.size() == 3);
  CHECK(graph.arcs[0] == GraphArc{0, 1, 8, 'i'});
  CHECK(graph.arcs[1] == GraphArc{0, 2, 10, ' '});
  CHECK(graph.arcs[2] == GraphArc{0, 3, 7, ' '});
  for (const GraphArc& arc : graph.arcs) {
    const AttributeVector &a = graph.nodes[arc.from].attributes,
                          &b = graph.nodes[arc.to].attributes;
    const double turn =
        std::atan2(value(b, 5) - value(a, 5), value(b, 6) - value(a, 6)) / (2 * M_PI);
    CHECK(static_cast<int>(std::lround(16 * (turn < 0 ? turn + 1 : turn))) % 16 == arc.direction);
  }
}

TEST_CASE("area, centre and the moments' ratios of the thesis's chains are those of its graph") {
  const std::vector<ContourChain> chains = example_chains();
  const RelationalGraph graph = example_graph();
  REQUIRE(chains.size() == 2);
  CHECK(chains[0].x == 253);
  CHECK(chains[0].y == 404);
  CHECK(chains[0].steps.substr(0, 8) == "AAAAAHAA");
  for (std::size_t k = 0; k < chains.size(); ++k) {
    const AttributeVector ours = attributes_of(chains[k]), theirs = graph.nodes[k].attributes;
    CHECK(ours[0] == theirs[0]);
    CHECK(ours[5] == theirs[5]);
    CHECK(ours[6] == theirs[6]);
    CHECK(value(ours, 1) == Approx(value(theirs, 1)).epsilon(0.03));
  }
  const AttributeVector ellipse = attributes_of(chains[0]), mantle = attributes_of(chains[1]);
  CHECK(value(ellipse, 2) * 1e6 / (value(ellipse, 1) * value(ellipse, 1)) ==
        Approx(153e6 / (19501.0 * 19501)).margin(0.5e6 / (19501.0 * 19501)));
  CHECK(value(mantle, 3) == Approx(128109).epsilon(0.13));
  CHECK(value(mantle, 3) / value(mantle, 4) == Approx(128109.0 / 3523).epsilon(2e-4));
}

TEST_CASE("a rectangle's contour has a first moment of 1/48, and its pixels are counted") {
  ContourChain chain{
      10, 50,
      std::string(40, 'A') + std::string(20, 'G') + std::string(40, 'E') + std::string(19, 'C')};
  const AttributeVector rectangle = attributes_of(chain);
  CHECK(rectangle[0] == 41 * 21);
  CHECK(value(rectangle, 1) == Approx(1e6 / 48).epsilon(0.001));
  CHECK(rectangle[3] == 0);
  CHECK(rectangle[5] == 30);
  CHECK(rectangle[6] == 40);
  CHECK(attributes_of({3, 4, ""}) == AttributeVector{1, 0, 0, 0, 0, 3, 4, 0, 0, 0});
  CHECK(attributes_of({3, 4, "A"})[0] == 2);
}

TEST_CASE("the thesis's vertices and patches are read, ids and levels in their places") {
  const auto vertices = example("blockcyl.6.vert", parse_vertices, vertices_text);
  REQUIRE(vertices.size() == 6);
  CHECK(vertices[1] == ListedVertex{{-0.9998072406, -0.0196336858, -0.0000000713}, 12743, 2});
  const auto partitions = example("blockcyl.6.part", parse_partitions, partitions_text);
  REQUIRE(partitions.size() == 1);
  REQUIRE(partitions[0].size() == 4);
  CHECK(partitions[0][0].level == 3);
  CHECK(partitions[0][1].level == 6);
  CHECK(partitions[0][1].corners[2] == ListedVertex{{-0.957, -0.290, -0.000}, 12675, 3});
}

TEST_CASE(
    "the thesis's details have the angles of their views, and det2attr makes its attributes") {
  const auto groups = example("blockcyl.6.det", parse_details, details_text);
  REQUIRE(groups.size() == 1);
  REQUIRE(groups[0].size() == 3);
  for (const DetailedGraph& graph : groups[0]) {
    const Angles angles = angles_of(direction_of_view_name(graph.view).value());
    CHECK(angles.theta_deg == graph.theta_deg);
    CHECK(angles.phi_deg == graph.phi_deg);
  }
  const auto table = example("blockcyl.attr", parse_attributes, attributes_text);
  CHECK(table.graphs == 4);
  const AttributeTable made = attributes_of(groups);
  REQUIRE(made.rows.size() == 9);
  // The example's .attr is of graphs whose contours were renamed, its .det of those before.
  for (const AttributeRow& row : made.rows)
    CHECK(std::any_of(table.rows.begin(), table.rows.end(), [&](const AttributeRow& other) {
      return other.partition == 1 && other.graph == row.graph && other.attributes == row.attributes;
    }));
}

TEST_CASE("the thesis's means and classes are read") {
  const auto means = example("blockcyl.means", parse_means, means_text);
  REQUIRE(means.size() == 6);
  CHECK(means[5] == AttributeVector{176, 18766, 350, 2, 0, 253, 200, 58, 240, 73});
  const auto classes = example("blockcyl.class", parse_classes, classes_text);
  REQUIRE(classes.size() == 4);
  CHECK(classes[0] == ListedClass{{{22, 222}, {29, 16}}, {{1, 237}, {4, 1}}, {{16, 238}}});
}

TEST_CASE("the thesis's proposals are read, and equation 4.2 gives their scores") {
  const auto pictures = example("test1.index", parse_poses, poses_text);
  REQUIRE(pictures.size() == 1);
  CHECK(pictures[0].name == "+0.015+0.442+0.897");
  REQUIRE(pictures[0].proposals.size() == 6);
  for (const PoseProposal& proposal : pictures[0].proposals) {
    const double weights =
        std::accumulate(proposal.matches.begin(), proposal.matches.end(), 0.0,
                        [](double sum, const RegionMatch& match) { return sum + match.weight; });
    // Of six regions, where the picture has five.
    const bool has_more = proposal.pose != 38 && proposal.pose != 44;
    CHECK(proposal.score ==
          1e6 * static_cast<double>(proposal.matches.size()) - (has_more ? 1e5 : 0) + weights);
  }
}

TEST_CASE("a picture's name with blanks, percent signs and line ends comes back as it was") {
  const std::vector<UnknownPicture> pictures = {
      {"my frame 5%.png", {{1, -1.5, {}}, {2, 1e20, {{0, 1, 0.25}}}}},
      {"a\nb\\", {}},
      {"Ω.png", {}}};
  const std::string text = poses_text(pictures);
  CHECK(text == "my%20frame%205%25.png\n1 -1.5\n2 1e+20 0-1(0.25)\na%0Ab%5C\nΩ.png\n");
  CHECK(parse_poses(text, "x").value() == pictures);
}

TEST_CASE("a node without arcs and a contour of one pixel have a form of their own") {
  const RelationalGraph graph = {
      {{"A", "na", false, ShapeClass::other, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10}},
       {"AB", "na", true, ShapeClass::circle, {}},
       {"AC", "na", true, ShapeClass::square, {}}},
      {{2, 0, 15, 's'}}};
  CHECK(parse_graph(graph_text(graph), "x").value() == graph);
  CHECK(parse_graph("", "x").value() == RelationalGraph{});
  const std::vector<ContourChain> chains = {{3, 4, ""}, {5, 6, "A"}};
  CHECK(chains_text(chains) == "3 4\n5 6 A\n-1 -1\n");
  CHECK(parse_chains(chains_text(chains), "x").value() == chains);
  for (const std::size_t place : {0U, 25U, 26U, 701U, 702U})
    CHECK(place_of_name(name_of_place(place)) == place);
  CHECK(name_of_place(26) == "AA");
}

TEST_CASE("views too near for three decimals get names of their own") {
  const std::vector<Direction3> near = {
      {0.2222, -0.842, 0.491}, {0.2224, -0.842, 0.491}, {1, -0.0, 0.0}};
  const std::vector<std::string> names = view_names(near);
  CHECK(names[0] == "+0.2222-0.8420+0.4910");
  CHECK(names[1] == "+0.2224-0.8420+0.4910");
  CHECK(names[2] == "+1.000-0.000+0.000");
  CHECK(direction_of_view_name(names[0]).value() == near[0]);
  for (const char* no_name : {"", "+1+0", "0.222-0.842+0.491", "+0.222-0.842+0.491x", "+1.+1.+1.",
                              "+1..0+0.0+0.0", "+nan+0+0"})
    CHECK_FALSE(direction_of_view_name(no_name));
}

}  // namespace aspect
