#include "runtime/workbench/workbench_desk.h"

#include <catch2/catch.hpp>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

#include "runtime/service/segmentation_values.h"
#include "runtime/vision/components.h"
#include "tests/runtime/capture/fake_kernel.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;
using nlohmann::json;

constexpr int kWidth_px = 64, kHeight_px = 48;

// Left red, right green, on black.
std::vector<std::uint8_t> two_colours() {
  std::vector<std::uint8_t> rgb(std::size_t{3} * kWidth_px * kHeight_px);
  for (int y = 8; y < 40; ++y)
    for (int x = 8; x < 56; ++x)
      rgb[static_cast<std::size_t>(3 * (y * kWidth_px + x) + (x < 32 ? 0 : 1))] = 200;
  return rgb;
}

struct Station {
  TemporaryFolder folder;
  std::filesystem::path file;
  FakeCamera device;
  FakeKernel kernel;
  PlayControl play;
  std::vector<ClassIndex> indexes{1};
  Configuration configuration;
  RecogniserParameters parameters;
  std::unique_ptr<Workbench> desk;
  std::vector<std::uint8_t> picture = two_colours();

  explicit Station(const std::string& text = "# mine\n[segmentation]\nchroma_step = 9 # why\n",
                   bool recorded = true)
      : file(folder.write("aspectd.toml", text)) {
    kernel.nodes["/dev/video0"] = &device;
    device.controls = {{.id = V4L2_CID_GAIN, .name = "Gain", .most = 100},
                       {.id = V4L2_CID_AUTOGAIN,
                        .name = "Gain, Automatic",
                        .type = V4L2_CTRL_TYPE_BOOLEAN,
                        .most = 1},
                       {.id = V4L2_CID_DO_WHITE_BALANCE,
                        .name = "Do White Balance",
                        .type = V4L2_CTRL_TYPE_BUTTON}};
    indexes[0].object = "flag";
    indexes[0].model.shares = {{0.5F, 0.25F, 0.25F}};
    desk = make_workbench({&kernel, recorded ? &play : nullptr});
    use(text);
  }
  void use(const std::string& text) {
    configuration = parse_configuration(text, "aspectd.toml").value();
    configuration.apply(parameters);
    desk->use({configuration, file, indexes, parameters, [](const std::string& after) {
                 const auto read = parse_configuration(after, "aspectd.toml");
                 return read ? std::nullopt : std::optional(Error{read.error()});
               }});
  }
  json state() { return json::parse(*desk->state().body); }
  json value(const std::string& key) {
    const json all = state();
    for (const json& each : all["values"])
      if (each["key"] == key) return each;
    return nullptr;
  }
  json act(const std::string& action, const json& body) {
    const PageAnswer answer = desk->act(action, body.dump());
    INFO(*answer.body);
    CHECK(answer.status == 200);
    const json said = json::parse(*answer.body);
    CHECK_FALSE(said.contains("refused"));
    return said;
  }
  // Why it is not done.
  std::string refusal(const std::string& action, const json& body) {
    const PageAnswer answer = desk->act(action, body.dump());
    CHECK(answer.status == 200);
    return json::parse(*answer.body).value("refused", "");
  }
  void show(std::uint64_t line) {
    desk->show({picture.data(), kWidth_px, kHeight_px, 3 * kWidth_px, PixelFormat::rgb8}, {}, {},
               line);
  }
};

struct View {
  json label;
  std::string bmp;
  std::vector<Run> runs;
};

View read_view(const std::string& bundle) {
  View view;
  std::uint32_t length = 0;
  std::memcpy(&length, bundle.data(), sizeof length);
  view.label = json::parse(bundle.substr(4, length));
  const std::size_t picture = view.label["picture"];
  view.bmp = bundle.substr(4 + length, picture);
  view.runs.resize(view.label["runs"].get<std::size_t>());
  const std::size_t start = 4 + length + picture;
  REQUIRE(bundle.size() == start + view.runs.size() * sizeof(Run));
  if (!view.runs.empty())
    std::memcpy(view.runs.data(), bundle.data() + start, view.runs.size() * sizeof(Run));
  return view;
}

// Pixels by label.
std::map<int, int> areas(const View& view) {
  std::map<int, int> area;
  for (const Run& run : view.runs)
    if (run.label > 0) area[run.label] += run.end - run.begin;
  return area;
}

}  // namespace

TEST_CASE("every value of the segmentation has a range, words and what holds") {
  Station station;
  const json state = station.state();
  CHECK(state["values"].size() == segmentation_values().size());
  for (const json& value : state["values"]) {
    INFO(value.dump());
    CHECK(value["words"].get<std::string>().ends_with('.'));
    if (value["kind"] != "truth") {
      CHECK(value["least"] <= value["value"]);
      CHECK(value["value"] <= value["most"]);
    }
  }
  CHECK(station.value("chroma_step")["value"] == 9);
  CHECK(station.value("chroma_step")["otherwise"] == 8);
  CHECK(station.value("range_depth_step")["value"] == 0.01);
  CHECK(state["models"] == json::parse(R"([{"object": "flag", "colours": [[0.5, 0.25, 0.25]]}])"));
  CHECK(state["file"] == "aspectd.toml");
  CHECK(state["changed"] == false);
  CHECK(state["region"].is_null());
}

TEST_CASE("the picture and its regions are seen, and follow values that are changed") {
  Station station;
  CHECK_FALSE(station.desk->wants_frame());
  CHECK(station.desk->view({}).status == 204);
  CHECK(station.desk->wants_frame());
  station.show(1);
  CHECK(station.desk->view({}).status == 204);
  station.show(2);
  const PageAnswer first = station.desk->view({});
  REQUIRE(first.status == 200);
  View view = read_view(*first.body);
  CHECK(view.label["line"] == 2);
  CHECK(view.label["width"] == kWidth_px);
  CHECK(view.bmp.size() == 54 + 3 * kWidth_px * kHeight_px);
  CHECK(areas(view).size() == 2);
  // The median takes the corners.
  CHECK(areas(view)[1] > 24 * 31);
  CHECK(areas(view)[1] <= 24 * 32);
  // The same again is not sent, and not drawn again for another one who looks.
  const std::uint64_t number = view.label["view"];
  CHECK(station.desk->view(number).status == 204);
  CHECK(station.desk->view({}).body == first.body);

  // The frame stands still, what is seen of it does not.
  station.act("settings", {{"area_min_px", 2000}});
  view = read_view(*station.desk->view(number).body);
  CHECK(view.label["view"] == number + 1);
  CHECK(areas(view).empty());
  station.act("settings", {{"area_min_px", 40}, {"region_of_interest", {0, 0, 32, 48}}});
  CHECK(areas(read_view(*station.desk->view(number + 1).body)).size() == 1);
  CHECK(station.state()["region"] == json({0, 0, 32, 48}));
  station.act("settings", {{"region_of_interest", nullptr}});
  CHECK(areas(read_view(*station.desk->view(number + 2).body)).size() == 2);
}

TEST_CASE("the loop gets the last of the values that were changed, once") {
  Station station;
  VisionParameters vision;
  CHECK_FALSE(station.desk->take_vision(vision));
  station.act("settings", {{"chroma_step", 20}});
  station.act("settings", {{"smooth", false}, {"thickness_min_px", 2.5}});
  REQUIRE(station.desk->take_vision(vision));
  CHECK(vision.chroma_step == 20);
  CHECK_FALSE(vision.smooth);
  CHECK(vision.thickness_min_px == 2.5F);
  CHECK_FALSE(station.desk->take_vision(vision));
  station.act("forget", json::object());
  REQUIRE(station.desk->take_vision(vision));
  CHECK(vision.chroma_step == 9);
  CHECK(vision.smooth);
  CHECK(station.state()["changed"] == false);
}

TEST_CASE(
    "a value that is no good is refused with the reason, and nothing is written until it is "
    "mended") {
  Station station;
  const std::string before = read_file(station.file);
  const std::string reason =
      "[segmentation] chroma_step is 999; it must be a whole number from 1 to 255";
  CHECK(station.refusal("settings", {{"chroma_step", 999}}) == reason);
  VisionParameters vision;
  CHECK_FALSE(station.desk->take_vision(vision));
  CHECK(station.state()["fault"] == reason);
  CHECK(station.value("chroma_step")["value"] == 999);
  CHECK_THAT(station.refusal("save", json::object()), Contains(reason));
  CHECK(read_file(station.file) == before);
  station.act("settings", {{"chroma_step", 12}});
  CHECK(station.state()["fault"].is_null());
  station.act("save", json::object());
  CHECK(read_file(station.file) == "# mine\n[segmentation]\nchroma_step = 12 # why\n");
}

TEST_CASE("bodies that nobody would send change nothing") {
  Station station;
  for (const char* body :
       {"", "{", "[]", "null", "17", "\"settings\"", "{\"chroma_step\": 9", "{\"a\": 1} x"})
    CHECK(station.desk->act("settings", body).status == 400);
  CHECK(station.desk->act("settings", std::string(60'000, '[')).status == 400);
  const std::string nested =
      "{\"region_of_interest\": " + std::string(20'000, '[') + std::string(20'000, ']') + "}";
  for (const std::string& body :
       {std::string(R"({"nonsense": 1})"), std::string(R"({"chroma_step": "9"})"),
        std::string(R"({"chroma_step": {"a": 1}})"), std::string(R"({"chroma_step": 9.5})"),
        std::string(R"({"chroma_step": 1e400})"), std::string(R"({"chroma_step": true})"),
        std::string(R"({"smooth": 1})"), std::string(R"({"region_of_interest": [1, 2, 3]})"),
        std::string(R"({"region_of_interest": [0, 0, 0, 5]})"),
        std::string(R"({"region_of_interest": [-1, 0, 5, 5]})"), nested}) {
    INFO(body.substr(0, 60));
    const PageAnswer answer = station.desk->act("settings", body);
    CHECK((answer.status == 400 || json::parse(*answer.body).contains("refused")));
    station.act("forget", json::object());
  }
  VisionParameters vision;
  station.desk->take_vision(vision);
  CHECK(vision.chroma_step == 9);
  CHECK(station.desk->act("shutdown", "{}").status == 404);
  CHECK(station.desk->act("control", R"({"name": 1, "value": 1})").status == 400);
  CHECK(station.desk->act("play", R"({"steps": 0})").status == 400);
  CHECK(station.desk->act("play", R"({"paused": 1})").status == 400);
}

TEST_CASE(
    "what was changed is written, what was there is kept, and what is as before is no change") {
  Station station;
  station.act("settings", {{"chroma_step", 12}});
  station.act("settings", {{"chroma_step", 9}});
  CHECK(station.state()["changed"] == false);
  CHECK_THAT(station.refusal("save", json::object()), Contains("nothing has been changed"));
  const std::string before = read_file(station.file);
  station.act("settings", {{"region_of_interest", {1, 2, 3, 4}}, {"smooth", false}});
  // Somebody has edited the file meanwhile.
  station.folder.write("aspectd.toml", before + "[recognition]\ntop = 3\n");
  const json saved = station.act("save", json::object());
  CHECK(saved["kept"] == station.file.string() + ".1");
  CHECK(read_file(station.file) ==
        "# mine\n[segmentation]\nchroma_step = 9 # why\nregion_of_interest = [1, 2, 3, 4]\n"
        "smooth = false\n[recognition]\ntop = 3\n");
  CHECK(read_file(station.folder / "aspectd.toml.1") == before + "[recognition]\ntop = 3\n");
  CHECK(station.state()["changed"] == false);
  CHECK(station.state()["region"] == json({1, 2, 3, 4}));
  // A file that has become no good is not made to look as if it were.
  station.folder.write("aspectd.toml", "[segmentation]\nnonsense = 1\n");
  station.act("settings", {{"chroma_step", 30}});
  CHECK_THAT(station.refusal("save", json::object()),
             Contains("aspectd.toml:2: [segmentation] nonsense is not known here"));
}

TEST_CASE(
    "controls of the camera are set, handed to the loop and written in the order that works") {
  Station station("[camera.controls]\ngain = 3\n", false);
  CHECK(station.state()["controls"].empty());
  CHECK(station.state()["camera"] == true);
  CameraPlan plan;
  plan.node = "/dev/video0";
  station.desk->use_camera(&plan);
  const json state = station.state();
  CHECK(state["streaming"] == true);
  REQUIRE(state["controls"].size() == 3);
  for (const json& control : state["controls"]) CHECK(control["words"].get<std::string>() != "");
  CHECK(station.act("control", {{"name", "gain"}, {"value", 40}})["value"] == 40);
  CHECK(station.act("control", {{"name", "gain_automatic"}, {"value", 0}})["warnings"].empty());
  CHECK(station.device.controls[0].value == 40);
  CHECK(station.refusal("control", {{"name", "zoom"}, {"value", 1}}) != "");
  // Nothing of it is to be kept.
  station.act("control", {{"name", "do_white_balance"}, {"value", 1}});
  std::vector<CameraControl> controls;
  REQUIRE(station.desk->take_controls(controls));
  CHECK(controls == std::vector<CameraControl>{{"gain_automatic", 0}, {"gain", 40}});
  CHECK_FALSE(station.desk->take_controls(controls));
  station.act("save", json::object());
  CHECK(read_file(station.file) == "[camera.controls]\ngain_automatic = 0\ngain = 40\n");
  CHECK_THAT(station.refusal("play", {{"paused", true}}), Contains("cannot be paused"));
}

TEST_CASE("recorded frames are paused and stepped, and recording needs a folder and frames") {
  Station station;
  station.act("play", {{"steps", 2}});
  CHECK(station.play.paused);
  CHECK(station.play.steps == 2);
  station.act("play", {{"paused", false}});
  CHECK_FALSE(station.play.paused);
  CHECK(station.play.steps == 0);
  CHECK_THAT(station.refusal("record", json::object()), Contains("--record FOLDER"));
}

TEST_CASE("a configuration that is loaded anew takes the place of what was changed") {
  Station station;
  station.act("settings", {{"chroma_step", 77}});
  station.use("[segmentation]\nnoise_steps = 1\n");
  VisionParameters vision;
  CHECK_FALSE(station.desk->take_vision(vision));
  CHECK(station.value("chroma_step")["value"] == 8);
  CHECK(station.value("noise_steps")["value"] == 1);
  CHECK(station.state()["changed"] == false);
}

}  // namespace aspect
