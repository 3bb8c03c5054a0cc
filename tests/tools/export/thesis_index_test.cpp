// aspect-replay --thesis-index: its .index beside the .class that aspect-export writes of the same
// model.
#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <set>

#include "compiler/aspects/observer.h"
#include "tests/tools/export/exported_store.h"
#include "tests/tools/json_lines.h"
#include "tools/export/formats/class_file.h"
#include "tools/export/formats/pose_file.h"

namespace aspect {
namespace {

using Catch::Contains;
using Words = std::vector<std::string>;

Outcome run_replay(const TemporaryFolder& here, const Words& words) {
  return ChildProgram(ASPECT_REPLAY, here.path(), words).wait();
}

// The index, and the typical view of each class as a frame.
class Frames : public TemporaryFolder {
 public:
  Frames() {
    const auto bytes = sample_index_bytes();
    write("l_shape.aspect", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    const StoredModel& model = sample_model();
    Observer observer(model.renderer, model.recipe.scene.studio, model.recipe.options.vision);
    for (std::size_t c = 0; c < model.clusters.size(); ++c) {
      const Cluster& cluster = model.clusters[c];
      const ClusterView& view = cluster.views[model.classes[c].typical_view];
      observer.observe(model.subdivision.direction(view.vertex));
      write("frames/" + std::string(c < 10 ? "0" : "") + std::to_string(c) + ".ppm",
            ppm(observer.picture()));
    }
  }

 private:
  static std::string ppm(const Picture& picture) {
    std::string bytes = "P6 " + std::to_string(picture.width_px) + " " +
                        std::to_string(picture.height_px) + " 255\n";
    return bytes.append(picture.rgb.begin(), picture.rgb.end());
  }
};

// Equation 4.2; each weight is a number of graphs that the class has of the region.
void check_proposal(const PoseProposal& proposal, std::size_t regions_seen,
                    const std::vector<ListedClass>& classes) {
  REQUIRE(proposal.pose >= 1);
  REQUIRE(proposal.pose <= static_cast<std::int64_t>(classes.size()));
  const ListedClass& listed = classes[static_cast<std::size_t>(proposal.pose - 1)];
  double score = 1e6 * static_cast<double>(proposal.matches.size());
  if (listed.size() > regions_seen)
    score -= 1e5 * static_cast<double>(listed.size() - regions_seen);
  for (const RegionMatch& match : proposal.matches) {
    CHECK(match.seen < static_cast<std::int64_t>(regions_seen));
    REQUIRE(match.known < static_cast<std::int64_t>(listed.size()));
    const RegionTypes& types = listed[static_cast<std::size_t>(match.known)];
    CHECK(std::any_of(types.begin(), types.end(), [&](const TypeCount& type) {
      return static_cast<double>(type.graphs) == match.weight;
    }));
    score += match.weight;
  }
  CHECK(proposal.score == score);
}

}  // namespace

TEST_CASE("results are read back, and their weights are those of the exported classes") {
  const Frames here;
  REQUIRE(
      run_export(here.path(), {sample_store().string(), "files", "--format", "class"}).exit_code ==
      0);
  const auto classes = parse_classes(read_file(here / "files/l_shape.class"), "class").value();
  const Outcome outcome =
      run_replay(here, {"--index", "l_shape.aspect", "--thesis-index", "--top", "64", "frames"});
  CHECK(outcome.err == "");
  REQUIRE(outcome.exit_code == 0);
  const auto pictures = parse_poses(outcome.out, "out").value();
  CHECK(poses_text(pictures) == outcome.out);
  const StoredModel& model = sample_model();
  REQUIRE(pictures.size() == model.clusters.size());
  std::size_t right = 0;
  for (std::size_t c = 0; c < pictures.size(); ++c) {
    const auto& proposals = pictures[c].proposals;
    CHECK_THAT(pictures[c].name, Catch::StartsWith("frames/"));
    REQUIRE_FALSE(proposals.empty());
    std::set<std::int64_t> named;
    for (const PoseProposal& proposal : proposals) {
      check_proposal(proposal, model.clusters[c].contour_count, classes);
      CHECK(named.insert(proposal.pose).second);
      CHECK(proposal.score <= proposals.front().score);
    }
    if (proposals.front().pose == static_cast<std::int64_t>(c) + 1) ++right;
  }
  CHECK(2 * right > pictures.size());
}

TEST_CASE(
    "the best class and its score are those of the lines of JSON, whose classes count from 0") {
  const Frames here;
  const Words common = {"--index", "l_shape.aspect", "frames/03.ppm"};
  const auto run = [&](Words words) {
    words.insert(words.end(), common.begin(), common.end());
    return run_replay(here, words).out;
  };
  const auto line = json_lines(run({"--ranking", "classes"})).at(0);
  const auto& best = line["objects"][0]["hypotheses"][0];
  const auto picture = parse_poses(run({"--thesis-index"}), "out").value().at(0);
  CHECK(picture.name == line["frame"]);
  CHECK(picture.proposals.at(0).pose == best["class"].get<int>() + 1);
  CHECK(picture.proposals[0].score == best["score"].get<double>());
  CHECK(picture.proposals.size() <= 10);
}

TEST_CASE("a frame with nothing is a name alone, and contradicting options are refused") {
  const Frames here;
  here.write("dark one.ppm", "P6 8 8 255\n" + std::string(192, '\0'));
  const Outcome dark =
      run_replay(here, {"--index", "l_shape.aspect", "--thesis-index", "dark one.ppm"});
  CHECK(dark.exit_code == 0);
  CHECK(dark.out == "dark%20one.ppm\n");
  for (const Words& other : {Words{"--track"},
                             {"--ranking", "views"},
                             {"--explain"},
                             {"--explain=l_shape"},
                             {"--index", "other.aspect"}}) {
    Words words = {"--index", "l_shape.aspect", "--thesis-index"};
    words.insert(words.end(), other.begin(), other.end());
    words.emplace_back("dark one.ppm");
    const Outcome outcome = run_replay(here, words);
    CHECK(outcome.exit_code == 2);
    CHECK_THAT(outcome.err, Contains("--thesis-index"));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
}

}  // namespace aspect
