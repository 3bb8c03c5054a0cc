// The page from recorded lines, with and without their pictures.
#include "tools/frame_page/recorded_page.h"

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "tests/runtime/capture/sample_pictures.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;
using Catch::Matchers::StartsWith;
using nlohmann::json;

json line_of(const std::string& frame, int sequence, const char* object = nullptr) {
  json line = {{"frame", frame}, {"sequence", sequence}, {"width", 64},
               {"height", 48},   {"elapsed_ms", 1.5},    {"objects", json::array()}};
  if (object != nullptr)
    line["objects"].push_back({{"box", {4, 6, 30, 20}},
                               {"regions", 2},
                               {"verdict", "match"},
                               {"probability", 0.75},
                               {"hypotheses",
                                {{{"object", object},
                                  {"class", 0},
                                  {"score", 0.5},
                                  {"matched", 2},
                                  {"unmatched", 0},
                                  {"view", {0, 0, 1}},
                                  {"contours", {{0, "A"}}}}}}});
  return line;
}

// The JSON of all blocks of a class, and the text of others.
std::vector<std::string> blocks_of(const std::string& page, const std::string& css) {
  std::vector<std::string> texts;
  const std::string begin = "class=\"" + css + "\">";
  for (std::size_t at = page.find(begin); at != std::string::npos; at = page.find(begin, at + 1)) {
    const std::size_t from = at + begin.size();
    texts.push_back(page.substr(from, page.find("</script>", from) - from));
  }
  return texts;
}

struct Recorded {
  TemporaryFolder folder;
  fs::path lines = folder.path() / "seen.jsonl", page = folder.path() / "page.html";

  Result<RecordedPageCounts> write(const std::string& text) {
    folder.write("seen.jsonl", text);
    return write_recorded_page({lines, page, {}, {}, {}, {}});
  }
};

std::string picture_bytes(int width_px, int height_px) {
  cv::Mat picture(height_px, width_px, CV_8UC3, cv::Scalar(0, 0, 0));
  cv::rectangle(picture, cv::Rect(4, 6, 30, 20), {30, 200, 40}, cv::FILLED);
  return encoded(picture, ".png");
}

}  // namespace

TEST_CASE("Pictures that are still there are in the page, and of others why they are not") {
  Recorded recorded;
  recorded.folder.write("frames/0.png", picture_bytes(64, 48));
  recorded.folder.write("frames/2.png", picture_bytes(32, 48));
  recorded.folder.write("frames/3.png", "damaged");
  std::string text;
  for (int k = 0; k < 4; ++k)
    text +=
        line_of("frames/" + std::to_string(k) + ".png", k, k == 0 ? "cube" : nullptr).dump() + "\n";
  const auto counts = recorded.write(text);
  REQUIRE(counts);
  CHECK(counts.value().frames == 4);
  CHECK(counts.value().without_picture == 3);
  const std::string page = read_file(recorded.page);
  CHECK(page.starts_with("<!doctype html>"));
  CHECK(page.ends_with("</html>\n"));
  const auto frames = blocks_of(page, "data-frame"), pictures = blocks_of(page, "data-picture"),
             details = blocks_of(page, "data-details");
  REQUIRE(frames.size() == 4);
  REQUIRE(pictures.size() == 4);
  REQUIRE(details.size() == 4);
  CHECK_THAT(pictures[0], StartsWith("data:image/webp;base64,"));
  const std::vector<std::string> notes = {"", "no longer there", "another picture is there now",
                                          "not a picture"};
  for (std::size_t k = 0; k < 4; ++k) {
    const json frame = json::parse(frames[k]);
    CHECK(frame["name"] == "frames/" + std::to_string(k) + ".png");
    CHECK(pictures[k].empty() == (k > 0));
    CHECK(frame.contains("note") == (k > 0));
    if (k > 0) CHECK(frame["note"].get<std::string>().find(notes[k]) != std::string::npos);
  }
  CHECK(json::parse(details[0])["objects"][0]["hypotheses"][0]["contours"][0][1] == "A");
}

TEST_CASE("Frames of a video are found one by one, whatever their order") {
  Recorded recorded;
  std::string raw;
  for (int k = 0; k < 3; ++k) raw += std::string(2 * 64 * 48, static_cast<char>(60 + 50 * k));
  recorded.folder.write("clip.64x48.YUYV", raw);
  std::string text;
  for (const int k : {0, 2, 1, 9})
    text += line_of("clip.64x48.YUYV#" + std::to_string(k), k).dump() + "\n";
  const auto counts = recorded.write(text);
  REQUIRE(counts);
  CHECK(counts.value().without_picture == 1);
  const auto pictures = blocks_of(read_file(recorded.page), "data-picture");
  REQUIRE(pictures.size() == 4);
  CHECK(pictures[0] != pictures[1]);
  CHECK(pictures[1] != pictures[2]);
  CHECK(pictures[3].empty());
}

TEST_CASE("A line that is none of aspect-replay's leaves no page") {
  const std::string good = line_of("0.png", 0).dump() + "\n";
  for (const auto& [text, begin] : std::vector<std::pair<std::string, std::string>>{
           {good + good.substr(0, 40), ":2: not a line of aspect-replay"},
           {good + "\n\n" + "hello\n" + good, ":4: not a line of aspect-replay"},
           {good + std::string(9 << 20, 'x') + "\n", ":2: not a line of aspect-replay (longer"},
           {"", ": holds no lines"},
           {"\n\n", ": holds no lines"}}) {
    Recorded recorded;
    recorded.folder.write("page.html", "the last one");
    const auto counts = recorded.write(text);
    REQUIRE_FALSE(counts);
    CHECK_THAT(counts.error(), StartsWith(recorded.lines.native() + begin));
    CHECK(counts.error().find('\n') == std::string::npos);
    CHECK(read_file(recorded.page) == "the last one");
    CHECK(std::distance(fs::directory_iterator(recorded.folder.path()), {}) == 2);
  }
  Recorded recorded;
  CHECK_THAT(write_recorded_page({recorded.lines, recorded.page, {}, {}, {}, {}}).error(),
             StartsWith(recorded.lines.native() + ": no such file"));
}

TEST_CASE("With indexes their models are in the page, and with a truth table what is right") {
  Recorded recorded;
  recorded.folder.write("truth.csv",
                        "file,object,vx,vy,vz,x,y,w,h,visible\n"
                        "0.png,cube,0,0.6,0.8,4,6,30,20,1\n"
                        "1.png,cube,0,0,1,4,6,30,20,1\n"
                        "2.png,,,,,,,,,\n"
                        "8.png,cube,0,0,1,4,6,30,20,1\n");
  recorded.folder.write("seen.jsonl", line_of("0.png", 0, "cube").dump() + "\n" +
                                          line_of("1.png", 1).dump() + "\n" +
                                          line_of("2.png", 2, "cube").dump() + "\n" +
                                          line_of("7.png", 3).dump() + "\n");
  ClassIndex index;
  index.object = "cube";
  index.classes.resize(3);
  const std::vector<ClassIndex> indexes = {index};
  auto truth = PageTruth::read(recorded.folder / "truth.csv", {});
  REQUIRE(truth);
  std::vector<std::string> told;
  const auto counts =
      write_recorded_page({recorded.lines,
                           recorded.page,
                           indexes,
                           {},
                           std::move(truth).value(),
                           [&](std::uint64_t, std::string_view name) { told.emplace_back(name); }});
  REQUIRE(counts);
  CHECK(told == std::vector<std::string>{"0.png", "1.png", "2.png", "7.png"});
  const std::string page = read_file(recorded.page);
  const auto models = blocks_of(page, "data-model"), frames = blocks_of(page, "data-frame");
  REQUIRE(models.size() == 1);
  CHECK(json::parse(models[0])["classes"] == 3);
  CHECK_FALSE(json::parse(models[0]).contains("vertices"));
  const auto truth_of = [&](std::size_t k) { return json::parse(frames[k])["truth"]; };
  // The angle whose cosine is 0.8, of the triangle with sides 3, 4, 5.
  CHECK(truth_of(0)[0]["deg"].get<double>() == Approx(36.87).margin(0.1));
  CHECK(truth_of(0)[0]["right"] == true);
  CHECK(truth_of(1)[0]["right"] == false);
  CHECK_FALSE(truth_of(1)[0].contains("found"));
  CHECK(truth_of(2)[0]["found"] == "cube");
  CHECK_FALSE(truth_of(2)[0].contains("truth"));
  CHECK(truth_of(3).is_null());
  CHECK(json::parse(blocks_of(page, "data-end")[0])["missing"] == 1);
}

}  // namespace aspect
