// Readers of the thesis's formats on what is none: one line of error that names file and line.
#include <catch2/catch.hpp>
#include <functional>
#include <random>

#include "tests/rounds.h"
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

using Catch::Contains;

// Reads and writes a text; its error, or nothing. What was read is written and read as the same.
using Try = std::function<std::string(std::string_view)>;

template <typename Parse, typename Write>
Try trying(Parse parse, Write write) {
  return [parse, write](std::string_view text) {
    const auto read = parse(text, "f");
    if (!read.ok()) return read.error();
    const std::string written = write(read.value());
    const auto again = parse(written, "f");
    if (!again.ok()) return "written and not read again: " + again.error();
    return write(again.value()) == written ? std::string() : "written otherwise the second time";
  };
}

struct Format {
  std::string example;
  Try attempt;
};

std::vector<Format> formats() {
  const std::string view = kExampleView;
  return {{thesis_example(view + ".sgm"), trying(parse_graph, graph_text)},
          {thesis_example(view + ".chn8"), trying(parse_chains, chains_text)},
          {thesis_example("blockcyl.6.vert"), trying(parse_vertices, vertices_text)},
          {thesis_example("blockcyl.6.part"), trying(parse_partitions, partitions_text)},
          {thesis_example("blockcyl.6.det"), trying(parse_details, details_text)},
          {thesis_example("blockcyl.attr"), trying(parse_attributes, attributes_text)},
          {thesis_example("blockcyl.means"), trying(parse_means, means_text)},
          {thesis_example("blockcyl.class"), trying(parse_classes, classes_text)},
          {thesis_example("test1.index"), trying(parse_poses, poses_text)}};
}

bool is_printable_line(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

void check_outcome(const Format& format, const std::string& text) {
  const std::string error = format.attempt(text);
  if (error.empty()) return;
  const bool well_formed = error.starts_with("f:") && is_printable_line(error) &&
                           error.find("; ") != std::string::npos && error.size() < 300;
  if (!well_formed) FAIL("error: " << error);
}

std::string with(const std::string& text, const std::string& old, const std::string& now) {
  std::string changed = text;
  REQUIRE(changed.find(old) != std::string::npos);
  return changed.replace(changed.find(old), old.size(), now);
}

}  // namespace

TEST_CASE("a file cut off at any byte ends with what it says or one line") {
  for (const Format& format : formats()) {
    REQUIRE(format.attempt(format.example).empty());
    for (std::size_t length = 0; length < format.example.size(); ++length)
      check_outcome(format, format.example.substr(0, length));
  }
  SUCCEED();
}

TEST_CASE("a file with random bytes changed ends with what it says or one line") {
  std::mt19937 random(20250311);
  const std::string alphabet = "+-.,;:()[]\\\n 0123456789eABHaionx@%";
  const auto below = [&](std::size_t count) { return random() % count; };
  for (const Format& format : formats()) {
    for (int round = 0; round < rounds(1500); ++round) {
      std::string text = format.example;
      for (std::size_t changes = 1 + below(5); changes > 0 && !text.empty(); --changes) {
        const std::size_t at = below(text.size());
        const char byte =
            below(4) == 0 ? static_cast<char>(below(256)) : alphabet[below(alphabet.size())];
        const std::size_t way = below(4);
        if (way == 0) text[at] = byte;
        if (way == 1) text.insert(at, 1, byte);
        if (way == 2) text.erase(at, 1 + below(8));
        if (way == 3) text.insert(at, text.substr(below(text.size()), below(40)));
      }
      check_outcome(format, text);
    }
  }
  SUCCEED();
}

TEST_CASE("what is wrong is said with its line and the line's form") {
  const std::string view = kExampleView;
  const std::string vertices = thesis_example("blockcyl.6.vert");
  const std::string form =
      "; the first line is the number of vertices, the others 3 X Y Z ID REGIONS";
  CHECK(parse_vertices(with(vertices, "6\n", "18039\n"), "f").error() ==
        "f:8: 6 vertices, where the first line says 18039" + form);
  CHECK(parse_vertices(with(vertices, "12743", "x12743"), "f").error() ==
        "f:3: 'x12743' is no id, a whole number from 0 to 1000000000" + form);
  CHECK(parse_vertices(with(vertices, "-0.9998072406", "-0.8"), "f").error() ==
        "f:3: the vertex is not on the unit sphere" + form);
  CHECK(parse_vertices(with(vertices, "12805", "12743"), "f").error() ==
        "f:4: a second vertex with id 12743" + form);

  const std::string graph = thesis_example(view + ".sgm");
  CHECK_THAT(parse_graph(with(graph, "aa(3812)", "aa(-1)"), "f").error(), Contains("f:4: '-1)"));
  CHECK_THAT(parse_graph(with(graph, "[[a]", "[[g]"), "f").error(),
             Contains("f:4: an arc has no direction from 0 to f"));
  const std::size_t last_a = graph.rfind("aa(5770)");
  CHECK_THAT(parse_graph(graph.substr(0, last_a) + with(graph.substr(last_a), "5770", "5771"), "f")
                 .error(),
             Contains("f:6: contour A has other attributes than in an entry before"));
  const std::string chains = thesis_example(view + ".chn8");
  CHECK_THAT(parse_chains(with(chains, "-1 -1\n", ""), "f").error(),
             Contains("f:8: the file ends where -1 -1 should follow"));
  CHECK_THAT(parse_chains(with(chains, "25A", "27A"), "f").error(),
             Contains("f:4: a contour does not come back to where it begins"));
  CHECK_THAT(parse_classes(with(thesis_example("blockcyl.class"), "1:237", "1:238"), "f").error(),
             Contains("f:3: 239 graphs, where the line says 238"));
  CHECK_THAT(parse_poses("1 2 0-0(1)\n", "f").error(),
             Contains("f:1: a proposal before the first picture"));
}

TEST_CASE("hostile sizes end quickly with an error") {
  CHECK_THAT(parse_details("1000000000\n1000000000\n1\n", "f").error(),
             Contains("f:4: the file ends where a graph should follow"));
  CHECK_THAT(parse_chains("0 0 99999999999999999999A\n-1 -1\n", "f").error(),
             Contains("f:1: '99999999999999999999A' stands where"));
  CHECK_THAT(parse_chains("0 0 67108864A67108864E\n-1 -1\n", "f").error(), Contains("f:1: "));
  CHECK_THAT(parse_graph(std::string(1'000'000, '['), "f").error(), Contains("f:1: '[[[[["));
  CHECK_THAT(parse_vertices(std::string(1'000'000, '\\'), "f").error(), Contains("f:1: "));
  std::string continued;
  for (int k = 0; k < 100'000; ++k) continued += "\\\n";
  CHECK_THAT(parse_means(continued, "f").error(), Contains("the file ends"));
}

}  // namespace aspect
