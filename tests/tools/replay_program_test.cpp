// aspect-replay as its users start it.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <chrono>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "tests/child_program.h"
#include "tests/runtime/capture/sample_pictures.h"
#include "tests/temporary_folder.h"
#include "tests/tools/json_lines.h"
#include "tests/tools/tiny_index.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using nlohmann::json;

// An object of four coloured fields.
cv::Mat flag(int width_px, int height_px, bool mirrored = false) {
  cv::Mat picture(height_px, width_px, CV_8UC3, cv::Scalar(0, 0, 0));
  const int x = width_px / 4, y = height_px / 4, w = width_px / 4, h = height_px / 4;
  const std::array<cv::Scalar, 4> colours = {cv::Scalar(30, 30, 230), cv::Scalar(30, 220, 30),
                                             cv::Scalar(230, 40, 30), cv::Scalar(20, 220, 230)};
  picture(cv::Rect(x, y, w, h)).setTo(colours[mirrored ? 1 : 0]);
  picture(cv::Rect(x + w, y, w, h)).setTo(colours[mirrored ? 0 : 1]);
  picture(cv::Rect(x, y + h, w, h / 2)).setTo(colours[2]);
  picture(cv::Rect(x + w, y + h, w, h)).setTo(colours[3]);
  return picture;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class Replay {
 public:
  Replay() {
    write_tiny_index(folder_.path() / "flag.aspect", "flag", flag(320, 240));
    write_tiny_index(folder_.path() / "mirror.aspect", "mirror", flag(320, 240, true));
    add_frame("frames/0.png", flag(320, 240));
    add_frame("frames/1.png", flag(320, 240, true));
    add_frame("frames/2.png", flag(480, 480));
  }

  void add_frame(const std::string& name, const cv::Mat& picture) const {
    folder_.write(name, encoded(picture, ".png"));
  }

  Outcome run(const std::string& arguments, const std::string& redirection = "") const {
    return run_shell(folder_.path(), "'" ASPECT_REPLAY "' " + arguments + " " + redirection);
  }

  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

TEST_CASE("Frames of different sizes are recognised, each on a line") {
  const Outcome outcome = Replay().run("--index flag.aspect --index mirror.aspect frames");
  CHECK(outcome.err == "");
  CHECK(outcome.exit_code == 0);
  const auto lines = json_lines(outcome.out);
  REQUIRE(lines.size() == 3);
  const std::array<const char*, 3> objects = {"flag", "mirror", "flag"};
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(lines[k]["frame"] == "frames/" + std::to_string(k) + ".png");
    CHECK(lines[k]["sequence"] == k);
    CHECK(lines[k]["elapsed_ms"].get<double>() > 0);
    REQUIRE(lines[k]["objects"].size() == 1);
    CHECK(lines[k]["objects"][0]["regions"] == 4);
    const json& best = lines[k]["objects"][0]["hypotheses"][0];
    CHECK(best["object"] == objects[k]);
    CHECK(best["matched"] == 4);
    CHECK(best["contours"].size() == 4);
  }
  CHECK(lines[2]["width"] == 480);
  CHECK(lines[0]["objects"][0]["box"] == json::array({80, 60, 160, 120}));
}

TEST_CASE("Bad frames are reported, and the others are processed") {
  const Replay replay;
  replay.folder().write("frames/00.png", "");
  replay.folder().write("frames/3.png", "text");
  const Outcome outcome = replay.run("--index flag.aspect frames missing.png");
  CHECK(outcome.exit_code == 1);
  const auto lines = json_lines(outcome.out);
  REQUIRE(lines.size() == 3);
  CHECK(lines[0]["frame"] == "frames/0.png");
  CHECK(lines[1]["frame"] == "frames/1.png");
  CHECK(lines[1]["sequence"] == 2);
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 3);
  for (const char* name : {"frames/00.png: an empty", "frames/3.png: not a", "missing.png: no"})
    CHECK_THAT(outcome.err, Contains("aspect-replay: " + std::string(name)));
}

TEST_CASE("Wrong usage is told in one line") {
  const Replay replay;
  for (const char* arguments :
       {"", "frames", "--index flag.aspect", "--index flag.aspect --top 0 frames",
        "--index flag.aspect --top 65 frames", "--index flag.aspect --top x frames",
        "--index flag.aspect --matching best frames", "--index flag.aspect --ranking best frames",
        "--index flag.aspect --pace 0 frames", "--index flag.aspect --pace nan frames",
        "--self-test", "--index flag.aspect --self-test frames",
        "--index flag.aspect --bogus frames", "--index flag.aspect --search-every 0 frames",
        "--index flag.aspect --time-limit-ms 0 frames",
        "--index flag.aspect --time-limit-ms -1 frames",
        "--index flag.aspect --time-limit-ms nan frames",
        "--index flag.aspect --time-limit-ms soon frames"}) {
    const Outcome outcome = replay.run(arguments);
    INFO(arguments);
    CHECK(outcome.exit_code == 2);
    CHECK(outcome.out == "");
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK_THAT(outcome.err, StartsWith("aspect-replay: ") && Contains("--help"));
  }
}

TEST_CASE("Within a time limit each frame has its line, which tells what was left undone") {
  const Replay replay;
  replay.folder().write("limited.toml", "[recognition]\ntime_limit_ms = 0.001\n");
  for (const char* arguments : {"--time-limit-ms 0.001", "--config limited.toml",
                                "--config limited.toml --time-limit-ms 50000", ""}) {
    const Outcome outcome =
        replay.run(std::string("--index flag.aspect ") + arguments + " frames/0.png");
    INFO(arguments);
    CHECK(outcome.exit_code == 0);
    const auto lines = json_lines(outcome.out);
    REQUIRE(lines.size() == 1);
    const bool is_cut =
        std::string(arguments).ends_with(".001") || std::string(arguments).ends_with(".toml");
    CHECK(lines[0].contains("left_undone") == is_cut);
    REQUIRE(lines[0]["objects"].size() == 1);
    CHECK(lines[0]["objects"][0]["hypotheses"].empty() == is_cut);
    if (is_cut) CHECK(lines[0]["left_undone"]["objects"] == 1);
  }
}

TEST_CASE("Help and version are printed") {
  const Replay replay;
  const Outcome help = replay.run("--help");
  CHECK(help.exit_code == 0);
  for (const char* option :
       {"--index", "--config", "--top", "--overlay", "--dump", "--pace", "--matching", "--ranking",
        "--self-test", "--explain", "--track", "--search-every", "--time-limit-ms", "--html",
        "--truth", "--symmetries", "--bop", "--bop-unit-mm"})
    CHECK_THAT(help.out, Contains(option));
  const Outcome version = replay.run("--version");
  CHECK(version.exit_code == 0);
  CHECK_THAT(version.out, StartsWith("aspect-replay "));
}

TEST_CASE("Indexes that cannot be used are reported, and the others are used") {
  const Replay replay;
  fs::copy(replay.folder().path() / "flag.aspect", replay.folder().path() / "copy.aspect");
  replay.folder().write("bad.aspect", "not an index at all");
  const auto run = [&](const std::string& indexes) {
    const Outcome outcome = replay.run(indexes + " --index flag.aspect frames/0.png");
    CHECK(outcome.exit_code == 1);
    CHECK(json_lines(outcome.out).size() == 1);
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    return outcome.err;
  };
  CHECK_THAT(run("--index none.aspect"), StartsWith("aspect-replay: none.aspect: "));
  CHECK_THAT(run("--index bad.aspect"), StartsWith("aspect-replay: bad.aspect: "));
  CHECK_THAT(run("--index ./flag.aspect"), Contains("flag.aspect: given twice"));
  CHECK_THAT(run("--index copy.aspect"), Contains("holds the object flag like copy.aspect"));
  const Outcome none = replay.run("--index none.aspect frames/0.png");
  CHECK(none.exit_code == 1);
  CHECK(none.out == "");
}

TEST_CASE("Another segmentation of a later index is a warning") {
  const Replay replay;
  VisionParameters parameters;
  parameters.chroma_step = 13;
  write_tiny_index(replay.folder().path() / "other.aspect", "other", flag(320, 240), parameters);
  const Outcome outcome = replay.run("--index flag.aspect --index other.aspect frames/0.png");
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.err, StartsWith("aspect-replay: warning: other.aspect: ") &&
                              Contains("chroma_step 13 not 8"));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
}

TEST_CASE("The command line wins over the configuration, the configuration over the index") {
  const Replay replay;
  replay.folder().write("c.toml", "[segmentation]\nregion_of_interest = [0, 0, 10, 10]\n");
  const Outcome blind = replay.run("--index flag.aspect --config c.toml frames/0.png");
  CHECK(blind.exit_code == 0);
  CHECK(json_lines(blind.out)[0]["objects"].empty());

  replay.folder().write("top.toml", "[recognition]\ntop = 1\n");
  const std::string both = "--index flag.aspect --index mirror.aspect frames/0.png ";
  const auto hypotheses = [&](const std::string& more) {
    return json_lines(replay.run(both + more).out)[0]["objects"][0]["hypotheses"].size();
  };
  CHECK(hypotheses("") == 2);
  CHECK(hypotheses("--config top.toml") == 1);
  CHECK(hypotheses("--config top.toml --top 2") == 2);

  replay.folder().write("bad.toml", "\n[recognition]\ntopp = 1\n");
  const Outcome bad = replay.run("--index flag.aspect --config bad.toml frames/0.png");
  CHECK(bad.exit_code == 1);
  CHECK(bad.out == "");
  CHECK_THAT(bad.err, StartsWith("aspect-replay: bad.toml:3: "));
}

TEST_CASE("Matching and ranking can be chosen") {
  const Replay replay;
  const auto score = [&](const std::string& more) {
    return json_lines(replay.run("--index flag.aspect frames/0.png " + more)
                          .out)[0]["objects"][0]["hypotheses"][0]["score"]
        .get<double>();
  };
  CHECK(score("--ranking views") <= 1);
  CHECK(score("--ranking classes") > 1);
  CHECK(score("--ranking classes --matching simple") !=
        score("--ranking classes --matching weighted"));
}

TEST_CASE("What was chosen is explained, and why something else was not") {
  const Replay replay;
  cv::Mat bar(240, 320, CV_8UC3, cv::Scalar(0, 0, 0));
  bar(cv::Rect(40, 100, 240, 20)).setTo(cv::Scalar(200, 30, 200));
  write_tiny_index(replay.folder().path() / "bar.aspect", "bar", bar);
  const std::string indexes = "--index flag.aspect --index mirror.aspect --index bar.aspect ";
  const auto objects = [&](const std::string& arguments) {
    const Outcome outcome = replay.run(indexes + arguments);
    INFO(outcome.err);
    REQUIRE(outcome.exit_code == 0);
    return json_lines(outcome.out)[0]["objects"];
  };
  const json plain = objects("frames/0.png");
  CHECK_FALSE(plain[0].contains("explanation"));
  // A file is no name.
  for (const char* arguments : {"--explain frames/0.png", "frames/0.png --explain",
                                "--explain --top 10 frames/0.png", "--explain -- frames/0.png"}) {
    INFO(arguments);
    json explained = objects(arguments);
    const json explanation = explained[0]["explanation"];
    REQUIRE(explanation["contours"].size() == 4);
    CHECK(explanation["contours"][0]["name"] == "A");
    CHECK(explanation["missing"].empty());
    CHECK(explanation["contradicts"].empty());
    CHECK_FALSE(explanation.contains("expected"));
    explained[0].erase("explanation");
    CHECK(explained == plain);
  }

  const auto expected = [&](const std::string& arguments) {
    return objects(arguments)[0]["explanation"]["expected"];
  };
  CHECK(expected("--explain flag frames/0.png")["chosen"] == true);
  for (const char* name : {"--explain mirror", "--explain=mirror:0"}) {
    const json mirror = expected(std::string(name) + " frames/0.png --top 1");
    CHECK(mirror["chosen"] == false);
    CHECK(mirror["on_shortlist"] == true);
    CHECK(mirror["object"] == "mirror");
    CHECK(mirror["rank"] == 2);
    CHECK(mirror["score"] < plain[0]["hypotheses"][0]["score"]);
  }
  CHECK(expected("--explain 0 frames/0.png")["object"] == "flag");
  const json other = expected("frames/0.png --explain bar");
  CHECK(other["on_shortlist"] == false);
  CHECK(other["least_cost"] > 8);
  CHECK_FALSE(other.contains("rank"));

  for (const char* name : {"flags", "flag:1", "flag:x", "70000", "7"}) {
    const Outcome outcome = replay.run(indexes + "frames/0.png --explain " + name);
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.out == "");
    CHECK_THAT(outcome.err, StartsWith("aspect-replay: --explain " + std::string(name) + ": "));
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  }
}

TEST_CASE("Pictures of the stages and overlays are written") {
  const Replay replay;
  const Outcome outcome =
      replay.run("--index flag.aspect --dump dumped/deep --overlay drawn frames");
  CHECK(outcome.err == "");
  CHECK(outcome.exit_code == 0);
  const fs::path top = replay.folder().path();
  for (const char* name : {"dumped/deep/000001_1_input.png", "dumped/deep/000001_2_regions.png",
                           "dumped/deep/000002_3_overlay.png", "dumped/deep/000002_4_numbers.png",
                           "drawn/000002_2.png"})
    CHECK_FALSE(cv::imread((top / name).native()).empty());

  replay.folder().write("file", "x");
  const Outcome blocked = replay.run("--index flag.aspect --dump file/x frames");
  CHECK(blocked.exit_code == 1);
  CHECK_THAT(blocked.err, StartsWith("aspect-replay: file/x: cannot be made a folder"));
}

TEST_CASE("Frames start at the pace asked for") {
  const Replay replay;
  const auto start = std::chrono::steady_clock::now();
  CHECK(json_lines(replay.run("--index flag.aspect --pace 5 frames").out).size() == 3);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  CHECK(elapsed.count() >= 0.4);
  CHECK(elapsed.count() < 5);
  const Outcome outcome = replay.run("--index flag.aspect --pace 200 frames");
  CHECK_THAT(outcome.err, Catch::StartsWith("aspect-replay: 3 frames at 200 a second: "));
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
}

TEST_CASE("Raw frames are recognised like pictures with the same pixels") {
  const Replay replay;
  const cv::Mat picture = flag(320, 240);
  const std::string bytes(picture.datastart, picture.dataend);
  replay.folder().write("clip.320x240.BGR3", bytes + bytes);
  const auto lines =
      json_lines(replay.run("--index flag.aspect clip.320x240.BGR3 frames/0.png").out);
  REQUIRE(lines.size() == 3);
  CHECK(lines[0]["frame"] == "clip.320x240.BGR3#0");
  CHECK(lines[1]["frame"] == "clip.320x240.BGR3#1");
  CHECK_FALSE(lines[0]["objects"].empty());
  for (const std::size_t k : {0U, 1U}) CHECK(lines[k]["objects"] == lines[2]["objects"]);
}

TEST_CASE("A reader that goes away ends the run quietly") {
  const Replay replay;
  const Outcome closed = replay.run("--index flag.aspect frames", ">&-");
  CHECK(closed.exit_code == 0);
  CHECK(closed.err == "");
  const Outcome full = replay.run("--index flag.aspect frames", ">/dev/full");
  CHECK(full.exit_code == 1);
  CHECK_THAT(full.err, StartsWith("aspect-replay: standard output: "));

  // Far more frames than `head` waits for.
  std::string many = "--index flag.aspect --pace 40";
  for (int k = 0; k < 100; ++k) many += " frames";
  const auto start = std::chrono::steady_clock::now();
  const fs::path folder = replay.folder().path();
  const Outcome cut =
      run_shell(folder, "( '" ASPECT_REPLAY "' " + many + "; echo $? >code ) | head -n 1");
  CHECK(cut.exit_code == 0);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(4));
  CHECK(read_file(folder / "code") == "0\n");
  CHECK(cut.err == "");
  CHECK(json::accept(cut.out));
}

TEST_CASE("A page has every frame, the unreadable ones as such, and lines are as without it") {
  const Replay replay;
  replay.folder().write("frames/3.png", "text");
  const std::string indexes = "--index flag.aspect --index mirror.aspect ";
  const Outcome outcome = replay.run(indexes + "--html pages/one frames");
  CHECK(outcome.exit_code == 1);
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
  const auto lines = json_lines(outcome.out),
             plain = json_lines(replay.run(indexes + "frames").out);
  REQUIRE(lines.size() == 3);
  for (std::size_t k = 0; k < 3; ++k) CHECK(lines[k]["objects"] == plain[k]["objects"]);
  const std::string page = read_file(replay.folder() / "pages/one/index.html");
  CHECK(std::distance(fs::directory_iterator(replay.folder() / "pages/one"), {}) == 1);
  std::vector<json> frames;
  for (const std::string& line : lines_of(page))
    if (line.starts_with("<script type=\"application/json\" class=\"data-frame\">"))
      frames.push_back(json::parse(line.substr(line.find('{'), line.rfind("</") - line.find('{'))));
  REQUIRE(frames.size() == 4);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(frames[k]["name"] == lines[k]["frame"]);
    CHECK(frames[k]["objects"][0]["object"] == lines[k]["objects"][0]["hypotheses"][0]["object"]);
  }
  CHECK_THAT(frames[3]["error"].get<std::string>(), StartsWith("frames/3.png: not a picture"));
  // Why not the other one, though nobody asked for it on the lines.
  CHECK_THAT(page, Contains("\"others\":[{") && Contains("\"contours\":{\"left_out\":0"));
  CHECK(outcome.out.find("explanation") == std::string::npos);
}

TEST_CASE("A page whose reader of lines has gone is written all the same") {
  const Replay replay;
  const Outcome outcome = replay.run("--index flag.aspect --html page frames", ">&-");
  CHECK(outcome.exit_code == 0);
  const std::string page = read_file(replay.folder() / "page/index.html");
  CHECK_THAT(page, Contains("frames/2.png"));
  CHECK(page.ends_with("</html>\n"));
}

TEST_CASE("Where no page can be written, or its truth is no good, nothing is done") {
  const Replay replay;
  replay.folder().write("truth.csv", "file,object\n");
  replay.folder().write("taken", "");
  fs::create_directories(replay.folder() / "folder/index.html");
  for (const auto& [arguments, words] : std::vector<std::pair<std::string, std::string>>{
           {"--html taken", "taken: cannot be made a folder"},
           {"--html folder", "folder/index.html: cannot be written"},
           {"--html page --truth none.csv", "none.csv: no such file"},
           {"--html page --truth truth.csv", "truth.csv: holds no frames"}}) {
    const Outcome outcome = replay.run("--index flag.aspect " + arguments + " frames");
    INFO(arguments);
    CHECK(outcome.exit_code == 1);
    CHECK(outcome.out == "");
    CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
    CHECK_THAT(outcome.err, StartsWith("aspect-replay: " + words));
    CHECK_FALSE(fs::exists(replay.folder() / "page/index.html"));
  }
  CHECK(replay.run("--index flag.aspect --truth truth.csv frames").exit_code == 2);
}

TEST_CASE("Followed objects are in a page, too") {
  const Replay replay;
  const Outcome outcome = replay.run("--index flag.aspect --track --html page frames");
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err == "");
  CHECK_THAT(read_file(replay.folder() / "page/index.html"), Contains("frames/2.png"));
}

}  // namespace
}  // namespace aspect
