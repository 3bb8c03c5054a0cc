#include "runtime/c_interface/aspect.h"

#include <array>
#include <catch2/catch.hpp>
#include <cstring>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include "runtime/recognition/recogniser.h"
#include "tests/runtime/c_interface/opened.h"
#include "tests/runtime/recognition/owned_recogniser.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Catch::Contains;

std::string why_not(const std::vector<aspect_source>& sources, const char* file = nullptr,
                    const char* configuration = nullptr) {
  char message[ASPECT_MESSAGE_BYTES] = "";
  const Opened opened(aspect_open(sources.data(), sources.size(), file, configuration, message));
  CHECK(!opened);
  return message;
}

bool same_box(const aspect_box& plain, const Box& box) {
  return Box{plain.x, plain.y, plain.width, plain.height} == box;
}

void check_same(const aspect_hypothesis& plain, const Hypothesis& hypothesis) {
  CHECK(plain.object == cube_and_l_shape()[hypothesis.index].object);
  CHECK(plain.known_object == hypothesis.index);
  CHECK(plain.class_id == hypothesis.class_id);
  CHECK(plain.score == hypothesis.score);
  CHECK(plain.matched == hypothesis.matched);
  CHECK(plain.unmatched == hypothesis.unmatched);
  CHECK(std::equal(plain.view, plain.view + 3, hypothesis.view.begin()));
  REQUIRE(plain.contour_count == hypothesis.contours.size());
  for (std::size_t k = 0; k < plain.contour_count; ++k) {
    CHECK(plain.contours[k].contour == hypothesis.contours[k].contour);
    CHECK(plain.contours[k].name == hypothesis.contours[k].name);
  }
  REQUIRE((plain.pose == nullptr) == (hypothesis.pose == nullptr));
  if (plain.pose == nullptr) return;
  const RefinedPose& refined = hypothesis.pose->refined;
  const Rotation& q = refined.pose.rotation;
  CHECK(std::equal(plain.pose->quaternion, plain.pose->quaternion + 4,
                   std::array{q.w, q.x, q.y, q.z}.begin()));
  CHECK(std::equal(plain.pose->translation, plain.pose->translation + 3,
                   refined.pose.translation.begin()));
  CHECK(plain.pose->reprojection_px == static_cast<double>(refined.reprojection_px));
  CHECK(
      std::equal(plain.pose->covariance, plain.pose->covariance + 36, refined.covariance.begin()));
}

void check_same(const aspect_object& object, const SeenObject& other) {
  CHECK(same_box(object.box, other.box));
  CHECK(object.regions == other.regions);
  CHECK(aspect_verdict_name(object.verdict) == name_of(other.judgement.verdict));
  CHECK(object.probability == static_cast<double>(other.judgement.probability));
  CHECK(object.rival_count == other.judgement.rival_count);
  REQUIRE(object.hypothesis_count == other.hypotheses.size());
  for (std::size_t h = 0; h < object.hypothesis_count; ++h)
    check_same(object.hypotheses[h], other.hypotheses[h]);
}

void check_same(const aspect_contour& contour, const Contour& other) {
  CHECK(same_box(contour.box, other.box));
  CHECK(contour.centre_x_px == other.centre_px.x);
  CHECK(contour.area_px == other.area_px);
  CHECK(contour.mean_rgb[2] == other.mean_rgb[2]);
  CHECK((contour.is_hole == 0) == other.external);
  CHECK(std::equal(contour.chain, contour.chain + contour.chain_length, other.chain.begin(),
                   other.chain.end()));
}

}  // namespace

TEST_CASE("a C program is told what a C++ program is told") {
  const Opened opened = open();
  for (const char* model : {"cube", "l_shape"}) {
    const OwnedFrame frame = frame_of(model);
    OwnedRecogniser owned(cube_and_l_shape(), {}, frame.width_px, frame.height_px);
    const Recognition expected = owned.recognise(frame.frame());
    const aspect_recognition seen = recognised(opened, plain(frame));

    REQUIRE(seen.object_count == 1);
    REQUIRE(expected.objects.size() == 1);
    check_same(seen.objects[0], expected.objects[0]);
    CHECK(seen.objects[0].verdict == ASPECT_MATCH);
    CHECK(seen.objects[0].hypotheses[0].object == std::string(model));
    CHECK(seen.objects[0].hypotheses[0].pose != nullptr);

    REQUIRE(seen.contour_count == expected.graph.contours.size());
    for (std::size_t i = 0; i < seen.contour_count; ++i)
      check_same(seen.contours[i], expected.graph.contours[i]);
    REQUIRE(seen.camera_count == 2);
    CHECK(seen.cameras[0].cx_px == (frame.width_px - 1) / 2.0);
    CHECK(seen.elapsed_ms > 0);
    CHECK(seen.left_undone.objects == 0);
  }
}

TEST_CASE("a frame is the same in every format of colours, with rows apart and upside down") {
  const OwnedFrame frame = frame_of("cube");
  const Opened opened = open();
  const auto summary = [&](const aspect_frame& plain) {
    const aspect_recognition seen = recognised(opened, plain);
    std::vector<double> values;
    for (std::size_t i = 0; i < seen.object_count; ++i) {
      REQUIRE(seen.objects[i].hypotheses[0].pose != nullptr);
      values.push_back(seen.objects[i].probability);
      const aspect_pose& pose = *seen.objects[i].hypotheses[0].pose;
      values.insert(values.end(), pose.quaternion, pose.quaternion + 4);
      values.insert(values.end(), pose.translation, pose.translation + 3);
    }
    return values;
  };
  const std::vector<double> expected = summary(plain(frame));
  REQUIRE(expected.size() == 8);

  struct Layout {
    aspect_format format;
    std::size_t bytes, red;
    int gap;
  };
  for (const Layout& layout : {Layout{ASPECT_RGB8, 3, 0, 7}, Layout{ASPECT_BGR8, 3, 2, 0},
                               Layout{ASPECT_RGBX8, 4, 0, 4}, Layout{ASPECT_BGRX8, 4, 2, 0}})
    for (const bool upside_down : {false, true}) {
      const auto width = static_cast<std::size_t>(frame.width_px),
                 height = static_cast<std::size_t>(frame.height_px);
      const std::size_t row = layout.bytes * width + static_cast<std::size_t>(layout.gap);
      std::vector<std::uint8_t> pixels(row * height, 200);
      for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
          for (std::size_t channel = 0; channel < 3; ++channel)
            pixels[(upside_down ? height - 1 - y : y) * row + x * layout.bytes +
                   (layout.red == 0 ? channel : 2 - channel)] =
                frame.rgb[(y * width + x) * 3 + channel];
      aspect_frame other = plain(frame);
      other.format = layout.format;
      other.stride_bytes = static_cast<std::ptrdiff_t>(row);
      other.data = pixels.data();
      if (upside_down) {
        other.data = pixels.data() + row * (height - 1);
        other.stride_bytes = -other.stride_bytes;
      }
      INFO(layout.format << (upside_down ? " upside down" : ""));
      CHECK(summary(other) == expected);
    }
}

TEST_CASE("frames that are none are refused, and say so") {
  const Opened opened = open();
  const OwnedFrame frame = frame_of("cube");
  aspect_recognition seen;
  const auto status = [&](const auto& change) {
    aspect_frame changed = plain(frame);
    change(changed);
    seen.object_count = 77;
    const aspect_status result = aspect_recognise(opened.get(), &changed, &seen);
    CHECK((result == ASPECT_OK || seen.object_count == 0));
    return result;
  };
  CHECK(status([](aspect_frame&) {}) == ASPECT_OK);
  CHECK(status([](aspect_frame& f) { f.data = nullptr; }) == ASPECT_BAD_ARGUMENT);
  CHECK(status([](aspect_frame& f) { f.stride_bytes = 3 * f.width_px - 1; }) ==
        ASPECT_BAD_ARGUMENT);
  CHECK(status([](aspect_frame& f) { f.stride_bytes = -1; }) == ASPECT_BAD_ARGUMENT);
  for (const int side : {0, -5, 8193, 1 << 30}) {
    CHECK(status([&](aspect_frame& f) { f.width_px = side; }) == ASPECT_WRONG_SIZE);
    CHECK(status([&](aspect_frame& f) { f.height_px = side; }) == ASPECT_WRONG_SIZE);
  }
  CHECK(status([](aspect_frame& f) { f.width_px = f.height_px = 8000; }) == ASPECT_WRONG_SIZE);
  CHECK(status([](aspect_frame& f) {
          f.format = ASPECT_YUYV8;
          f.width_px = 63;
        }) == ASPECT_WRONG_SIZE);
  for (const int format : {-1, 15, 1 << 20, int{ASPECT_GREY8}, int{ASPECT_DEPTH16}})
    CHECK(status([&](aspect_frame& f) { std::memcpy(&f.format, &format, sizeof format); }) ==
          ASPECT_WRONG_FORMAT);
  CHECK(status([](aspect_frame& f) {
          f.format = ASPECT_NV12;
          f.stride_bytes = -f.width_px;
        }) == ASPECT_BAD_ARGUMENT);

  const aspect_frame good = plain(frame);
  CHECK(aspect_recognise(nullptr, &good, &seen) == ASPECT_BAD_ARGUMENT);
  CHECK(aspect_recognise(opened.get(), nullptr, &seen) == ASPECT_BAD_ARGUMENT);
  CHECK(aspect_recognise(opened.get(), &good, nullptr) == ASPECT_BAD_ARGUMENT);
  for (int code = ASPECT_OK; code <= ASPECT_NO_MEMORY; ++code)
    CHECK(std::string(aspect_status_text(static_cast<aspect_status>(code))).size() > 3);
}

TEST_CASE("an NV12 frame in one piece has its chroma behind its rows") {
  const Opened opened = open();
  std::vector<std::uint8_t> joined(64 * 48 * 3 / 2, 128);
  for (std::size_t i = 0; i < 64 * 48; ++i) joined[i] = i % 64 < 32 ? 90 : 200;
  aspect_frame frame{};
  frame.data = joined.data();
  frame.width_px = 64;
  frame.height_px = 48;
  frame.format = ASPECT_NV12;
  const std::size_t contours = recognised(opened, frame).contour_count;
  CHECK(contours > 0);
  const std::vector<std::uint8_t> chroma(joined.begin() + 64 * 48, joined.end());
  frame.chroma = chroma.data();
  frame.chroma_stride_bytes = 64;
  CHECK(recognised(opened, frame).contour_count == contours);
}

TEST_CASE("what cannot be opened is said in one line") {
  const aspect_source cube{"cube", cube_bytes().data(), cube_bytes().size()};
  CHECK_THAT(why_not({{"absent.aspect", nullptr, 0}}), Contains("absent.aspect: "));
  CHECK_THAT(why_not({}), Contains("no class index is given"));
  CHECK_THAT(why_not({{nullptr, nullptr, 0}}), Contains("no name"));
  CHECK_THAT(why_not({{"flash", cube_bytes().data(), 100}}), Contains("flash: "));
  CHECK_THAT(why_not({{"flash", "x", 0}}), Contains("flash: "));
  CHECK_THAT(why_not({cube, cube}), Contains("holds the object cube"));
  CHECK_THAT(why_not({cube}, "absent.toml"), Contains("absent.toml: no such file"));
  CHECK_THAT(why_not({cube}, nullptr, "recognition.tracks = true"),
             Contains("configuration:1: ") && Contains("track"));
  CHECK_THAT(why_not({cube}, nullptr, "camera.fx = 500.0"), Contains("configuration"));
  std::vector<std::uint8_t> damaged = cube_bytes();
  damaged[damaged.size() / 2] ^= 1U;
  CHECK_THAT(why_not({{"flash", damaged.data(), damaged.size()}}), Contains("flash: "));
  CHECK(aspect_open(nullptr, 3, nullptr, nullptr, nullptr) == nullptr);
  CHECK(aspect_open(&cube, 1, "absent.toml", nullptr, nullptr) == nullptr);
  aspect_close(nullptr);
}

TEST_CASE("a message that is too long is cut, and ends") {
  const std::string name(3 * ASPECT_MESSAGE_BYTES, 'n');
  const std::string message = why_not({{name.c_str(), nullptr, 0}});
  CHECK(message.size() == ASPECT_MESSAGE_BYTES - 1);
}

TEST_CASE("bytes of an index may lie anywhere, and need not stay") {
  std::vector<char> shifted(cube_bytes().size() + 3);
  std::memcpy(shifted.data() + 3, cube_bytes().data(), cube_bytes().size());
  const aspect_source source{"cube", shifted.data() + 3, cube_bytes().size()};
  const Opened opened(aspect_open(&source, 1, nullptr, nullptr, nullptr));
  std::fill(shifted.begin(), shifted.end(), '\xff');
  REQUIRE(opened);
  const OwnedFrame frame = frame_of("cube");
  CHECK(recognised(opened, plain(frame)).objects[0].verdict == ASPECT_MATCH);
}

TEST_CASE("a configuration's text wins over its file, and may name the indexes") {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "cube.aspect", std::ios::binary)
      .write(reinterpret_cast<const char*>(cube_bytes().data()),
             static_cast<std::streamsize>(cube_bytes().size()));
  const std::string file = folder.write(
      "camera.toml",
      "indexes = [\"cube.aspect\"]\n[recognition]\ntop = 2\n[camera]\nwidth = 256\nheight = 256\n"
      "fx = 300.0\nfy = 300.0\ncx = 120.0\ncy = 130.0\nk1 = 0.01\n");
  const Opened opened(aspect_open(nullptr, 0, file.c_str(), "recognition.top = 1", nullptr));
  REQUIRE(opened);
  CHECK(aspect_known_object_count(opened.get()) == 1);
  CHECK(aspect_warning(opened.get(), 0) == nullptr);
  aspect_known_object known;
  REQUIRE(aspect_known_object_at(opened.get(), 0, &known) == ASPECT_OK);
  CHECK(known.object == std::string("cube"));
  CHECK(known.class_count > 5);
  CHECK(known.diameter == Approx(std::sqrt(3) * (known.most[0] - known.least[0])).epsilon(0.01));
  CHECK(aspect_known_object_at(opened.get(), 1, &known) == ASPECT_BAD_ARGUMENT);
  const OwnedFrame frame = frame_of("cube");
  const aspect_recognition seen = recognised(opened, plain(frame));
  CHECK(seen.objects[0].hypothesis_count == 1);
  CHECK(seen.cameras[0].k1 == 0.01);
  CHECK(seen.cameras[0].fx_px == Approx(300.0 * frame.width_px / 256));
}

TEST_CASE("recognisers of several threads do not disturb each other") {
  const OwnedFrame frame = frame_of("cube");
  const aspect_frame given = plain(frame);
  std::array<std::array<double, 4>, 2> turned{};
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < 2; ++t)
    threads.emplace_back([&, t] {
      const Opened opened = open();
      aspect_recognition seen;
      for (int i = 0; i < 4; ++i)
        if (aspect_recognise(opened.get(), &given, &seen) == ASPECT_OK && seen.object_count == 1)
          std::copy_n(seen.objects[0].hypotheses[0].pose->quaternion, 4, turned[t].begin());
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(turned[0] == turned[1]);
  CHECK(turned[0][0] != 0);
}

TEST_CASE("versions are those of the header") {
  CHECK(aspect_api_version() == ASPECT_API_VERSION);
  CHECK(std::string(aspect_version()) == ASPECT_VERSION);
}

}  // namespace aspect
