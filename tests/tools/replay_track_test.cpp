// aspect-replay --track as its users start it.
#include <catch2/catch.hpp>
#include <string>

#include "tests/child_program.h"
#include "tests/runtime/recognition/rendered_views.h"
#include "tests/temporary_folder.h"
#include "tests/tools/json_lines.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using nlohmann::json;

std::string ppm(const OwnedFrame& frame) {
  return "P6 " + std::to_string(frame.width_px) + " " + std::to_string(frame.height_px) + " 255\n" +
         std::string(frame.rgb.begin(), frame.rgb.end());
}

// A cube that turns through six frames.
class Clip {
 public:
  Clip() {
    const auto bytes = model_index_bytes("cube", 3);
    folder_.write("cube.aspect", std::string(bytes.begin(), bytes.end()));
    ModelCamera camera("cube");
    for (int k = 0; k < 6; ++k)
      folder_.write("frames/" + std::to_string(k) + ".ppm",
                    ppm(camera.view({0.48, 0.6, 0.64}, 0.04 * k)));
  }

  Outcome run(const std::string& arguments) const {
    return run_shell(folder_.path(), "'" ASPECT_REPLAY "' --index cube.aspect " + arguments);
  }

  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

TEST_CASE("Objects have a number with --track or track = true, and none without") {
  const Clip clip;
  clip.folder().write("track.toml", "[recognition]\ntrack = true\nsearch_every = 2\n");
  for (const char* arguments : {"", "--track", "--config track.toml", "--track --search-every 1"}) {
    const std::string options = arguments;
    const Outcome outcome = clip.run(options + " frames");
    INFO(options << outcome.err);
    REQUIRE(outcome.exit_code == 0);
    const auto lines = json_lines(outcome.out);
    REQUIRE(lines.size() == 6);
    int searched = 0;
    for (const json& line : lines) {
      REQUIRE(line["objects"].size() == 1);
      const json& object = line["objects"][0];
      CHECK(object.contains("track") == !options.empty());
      CHECK(object.value("track", 1) == 1);
      CHECK(object["verdict"] == "match");
      CHECK(object["hypotheses"][0].contains("pose"));
      searched += line["stages_ms"]["segment"].get<double>() > 0 ? 1 : 0;
    }
    CHECK(searched == (options == "--track" ? 1 : options == "--config track.toml" ? 3 : 6));
  }
}

TEST_CASE("What is followed is explained, but not what was not chosen") {
  const Clip clip;
  const Outcome explained = clip.run("--track --explain -- frames");
  CHECK(explained.exit_code == 0);
  for (const json& line : json_lines(explained.out)) {
    CHECK(line["objects"][0]["track"] == 1);
    CHECK(line["objects"][0].contains("explanation"));
  }
  const Outcome refused = clip.run("--track --explain=cube frames");
  CHECK(refused.exit_code == 1);
  CHECK(refused.out.empty());
  CHECK_THAT(refused.err, StartsWith("aspect-replay: --explain cube: ") && Contains("--track"));
}

}  // namespace
}  // namespace aspect
