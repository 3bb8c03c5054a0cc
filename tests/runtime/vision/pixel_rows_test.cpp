// Camera formats against the exact formulas in doubles, and against OpenCV.
#include "runtime/vision/pixel_rows.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <vector>

#include "runtime/vision/planes.h"
#include "tests/runtime/vision/pictures.h"

namespace aspect {
namespace {

constexpr std::array kYuvFormats = {PixelFormat::yuyv8, PixelFormat::uyvy8, PixelFormat::nv12,
                                    PixelFormat::nv21};
constexpr std::array kBayerFormats = {PixelFormat::bayer_rggb8, PixelFormat::bayer_grbg8,
                                      PixelFormat::bayer_gbrg8, PixelFormat::bayer_bggr8};

// A frame of random bytes, with rows longer than the pixels need. Memory ends where the last row's
// pixels do, so that a sanitizer sees what reads on.
struct NoiseFrame {
  std::vector<std::uint8_t> bytes, chroma;
  Frame frame;

  NoiseFrame(std::mt19937& random, PixelFormat format, int width, int height, int range = 256) {
    const int row = width * bytes_per_pixel(format);
    frame = {nullptr, width, height, row + static_cast<int>(random() % 9), format};
    bytes.resize(static_cast<std::size_t>(frame.stride_bytes * (height - 1) + row));
    if (has_chroma_plane(format)) {
      frame.chroma_stride_bytes = width + static_cast<int>(random() % 9);
      chroma.resize(static_cast<std::size_t>(frame.chroma_stride_bytes * (height / 2 - 1) + width));
    }
    for (auto* plane : {&bytes, &chroma})
      for (std::uint8_t& byte : *plane)
        byte = static_cast<std::uint8_t>(random() % static_cast<unsigned>(range));
    frame.data = bytes.data();
    frame.chroma = chroma.empty() ? nullptr : chroma.data();
  }
};

struct Yuv {
  int y, u, v;
};

Yuv yuv_at(const Frame& frame, int x, int y) {
  const std::uint8_t* row = frame.data + y * frame.stride_bytes;
  const std::uint8_t* pair = row + x / 2 * 4;
  if (frame.format == PixelFormat::yuyv8) return {pair[x % 2 * 2], pair[1], pair[3]};
  if (frame.format == PixelFormat::uyvy8) return {pair[x % 2 * 2 + 1], pair[0], pair[2]};
  const std::uint8_t* chroma = frame.chroma + y / 2 * frame.chroma_stride_bytes + x / 2 * 2;
  const int u = frame.format == PixelFormat::nv12 ? 0 : 1;
  return {row[x], chroma[u], chroma[1 - u]};
}

// As the standards have it.
std::array<double, 3> exact_rgb(const Yuv& yuv, const YuvCoding& coding) {
  const std::array<std::array<double, 2>, 3> shares = {
      {{0.299, 0.114}, {0.2126, 0.0722}, {0.2627, 0.0593}}};
  const auto [red, blue] = shares[static_cast<std::size_t>(coding.matrix)];
  const double y = coding.full_range ? yuv.y / 255.0 : (yuv.y - 16) / 219.0;
  const double reach = coding.full_range ? 255 : 224;
  const double u = (yuv.u - 128) / reach, v = (yuv.v - 128) / reach;
  const double r = y + 2 * (1 - red) * v, b = y + 2 * (1 - blue) * u;
  const double g = (y - red * r - blue * b) / (1 - red - blue);
  return {255 * std::clamp(r, 0.0, 1.0), 255 * std::clamp(g, 0.0, 1.0),
          255 * std::clamp(b, 0.0, 1.0)};
}

struct Rows {
  std::array<std::vector<std::uint8_t>, 3> channels;
  Rows(const Frame& frame, int y, int x, int count) {
    for (auto& channel : channels) channel.assign(static_cast<std::size_t>(count), 77);
    PixelRows(frame).colours(y, x, count,
                             {channels[0].data(), channels[1].data(), channels[2].data()});
  }
  cv::Vec3b at(int i) const {
    const auto k = static_cast<std::size_t>(i);
    return {channels[0][k], channels[1][k], channels[2][k]};
  }
};

cv::Mat whole_picture(const Frame& frame) {
  cv::Mat picture(frame.height_px, frame.width_px, CV_8UC3);
  for (int y = 0; y < frame.height_px; ++y) {
    const Rows rows(frame, y, 0, frame.width_px);
    for (int x = 0; x < frame.width_px; ++x) picture.at<cv::Vec3b>(y, x) = rows.at(x);
  }
  return picture;
}

double largest_difference(const cv::Mat& a, const cv::Mat& b) {
  return cv::norm(a, b, cv::NORM_INF);
}

// The planes of a frame as one packed picture, which is what OpenCV reads.
cv::Mat packed(const Frame& frame) {
  const int type = bytes_per_pixel(frame.format) == 2 ? CV_8UC2 : CV_8UC1;
  const bool chroma = has_chroma_plane(frame.format);
  cv::Mat out(frame.height_px * (chroma ? 3 : 2) / 2, frame.width_px, type);
  if (!chroma) out.create(frame.height_px, frame.width_px, type);
  for (int y = 0; y < frame.height_px; ++y)
    std::copy_n(frame.data + y * frame.stride_bytes, frame.width_px * bytes_per_pixel(frame.format),
                out.ptr(y));
  for (int y = 0; chroma && y < frame.height_px / 2; ++y)
    std::copy_n(frame.chroma + y * frame.chroma_stride_bytes, frame.width_px,
                out.ptr(frame.height_px + y));
  return out;
}

}  // namespace

TEST_CASE("Y, U and V become colours within one of the exact formula, in every coding") {
  std::mt19937 random(51);
  for (const PixelFormat format : kYuvFormats)
    for (const YuvMatrix matrix : {YuvMatrix::bt601, YuvMatrix::bt709, YuvMatrix::bt2020})
      for (const bool full_range : {false, true}) {
        NoiseFrame noise(random, format, 2 * (1 + static_cast<int>(random() % 90)), 22);
        noise.frame.yuv = {matrix, full_range};
        for (int y = 0; y < noise.frame.height_px; ++y) {
          const Rows rows(noise.frame, y, 0, noise.frame.width_px);
          for (int x = 0; x < noise.frame.width_px; ++x) {
            const auto exact = exact_rgb(yuv_at(noise.frame, x, y), noise.frame.yuv);
            for (int channel = 0; channel < 3; ++channel)
              REQUIRE(std::abs(rows.at(x)[channel] - exact[static_cast<std::size_t>(channel)]) <
                      0.75);
          }
        }
      }
}

TEST_CASE("grey in full range stays what it is, and black and white are their extremes") {
  std::array<std::uint8_t, 2 * 256> bytes;
  for (std::size_t i = 0; i < 256; ++i) {
    bytes[2 * i] = static_cast<std::uint8_t>(i);
    bytes[2 * i + 1] = 128;
  }
  Frame frame{bytes.data(), 256, 1, 512, PixelFormat::yuyv8};
  frame.yuv.full_range = true;
  const Rows full(frame, 0, 0, 256);
  for (int i = 0; i < 256; ++i) {
    const auto grey = static_cast<std::uint8_t>(i);
    REQUIRE(full.at(i) == cv::Vec3b(grey, grey, grey));
  }
  frame.yuv.full_range = false;
  const Rows limited(frame, 0, 0, 256);
  REQUIRE(limited.at(16) == cv::Vec3b(0, 0, 0));
  REQUIRE(limited.at(0) == cv::Vec3b(0, 0, 0));
  REQUIRE(limited.at(235) == cv::Vec3b(255, 255, 255));
  std::array<std::uint8_t, 256> greys;
  PixelRows(frame).greys(0, 0, 256, greys.data());
  for (int i = 0; i < 256; ++i) REQUIRE(greys[static_cast<std::size_t>(i)] == limited.at(i)[1]);
}

TEST_CASE("BT.601 in limited range is OpenCV's within one or two") {
  std::mt19937 random(52);
  const std::array codes = {cv::COLOR_YUV2RGB_YUYV, cv::COLOR_YUV2RGB_UYVY, cv::COLOR_YUV2RGB_NV12,
                            cv::COLOR_YUV2RGB_NV21};
  for (std::size_t k = 0; k < codes.size(); ++k) {
    NoiseFrame noise(random, kYuvFormats[k], 130, 64);
    // OpenCV takes what is blacker than black for black before it adds chroma.
    for (std::uint8_t& byte : noise.bytes) byte = std::max<std::uint8_t>(byte, 16);
    cv::Mat expected;
    cv::cvtColor(packed(noise.frame), expected, codes[k]);
    REQUIRE(largest_difference(whole_picture(noise.frame), expected) <= 2);
  }
}

TEST_CASE("Bayer pictures are OpenCV's bilinear ones but for the rim") {
  std::mt19937 random(53);
  const std::array codes = {cv::COLOR_BayerBG2RGB, cv::COLOR_BayerGB2RGB, cv::COLOR_BayerGR2RGB,
                            cv::COLOR_BayerRG2RGB};
  for (std::size_t k = 0; k < codes.size(); ++k) {
    const NoiseFrame noise(random, kBayerFormats[k], 138, 60);
    cv::Mat expected;
    cv::cvtColor(packed(noise.frame), expected, codes[k]);
    const cv::Rect inner(2, 2, 134, 56);
    REQUIRE(largest_difference(whole_picture(noise.frame)(inner), expected(inner)) <= 1);
  }
}

TEST_CASE("a flat colour behind a Bayer filter is that colour up to the corners") {
  const cv::Vec3b flat(200, 90, 30);
  const std::array<std::array<int, 4>, 4> letters = {
      {{0, 1, 1, 2}, {1, 0, 2, 1}, {1, 2, 0, 1}, {2, 1, 1, 0}}};
  std::mt19937 random(54);
  for (std::size_t k = 0; k < kBayerFormats.size(); ++k)
    for (const cv::Size size : {cv::Size(2, 2), cv::Size(4, 6), cv::Size(130, 4)}) {
      NoiseFrame mosaic(random, kBayerFormats[k], size.width, size.height);
      for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x)
          mosaic.bytes[static_cast<std::size_t>(y * mosaic.frame.stride_bytes + x)] =
              flat[letters[k][static_cast<std::size_t>(y % 2 * 2 + x % 2)]];
      const cv::Mat expected(size, CV_8UC3, cv::Scalar(flat));
      REQUIRE(largest_difference(whole_picture(mosaic.frame), expected) == 0);
    }
}

TEST_CASE("pixels of 24 and of 32 bits are what OpenCV takes them for") {
  std::mt19937 random(57);
  const std::array<std::pair<PixelFormat, int>, 4> formats = {
      {{PixelFormat::rgb8, -1},
       {PixelFormat::bgr8, cv::COLOR_BGR2RGB},
       {PixelFormat::rgbx8, cv::COLOR_RGBA2RGB},
       {PixelFormat::bgrx8, cv::COLOR_BGRA2RGB}}};
  for (const auto& [format, conversion] : formats) {
    const NoiseFrame noise(random, format, 77, 13);
    const cv::Mat view(13, 77, CV_8UC(bytes_per_pixel(format)),
                       const_cast<std::uint8_t*>(noise.frame.data),
                       static_cast<std::size_t>(noise.frame.stride_bytes));
    cv::Mat expected = view.clone();
    if (conversion >= 0) cv::cvtColor(view, expected, conversion);
    CHECK(largest_difference(whole_picture(noise.frame), expected) == 0);
  }
}

TEST_CASE("any part of a row is what it is in the whole row, and nothing beside it is written") {
  std::mt19937 random(55);
  std::vector<PixelFormat> formats = {PixelFormat::rgb8, PixelFormat::bgr8, PixelFormat::rgbx8,
                                      PixelFormat::bgrx8};
  formats.insert(formats.end(), kYuvFormats.begin(), kYuvFormats.end());
  formats.insert(formats.end(), kBayerFormats.begin(), kBayerFormats.end());
  for (const PixelFormat format : formats)
    for (int round = 0; round < 60; ++round) {
      const int width = 2 * (1 + static_cast<int>(random() % 120));
      const NoiseFrame noise(random, format, width, 6);
      const int y = static_cast<int>(random() % 6), x = static_cast<int>(random()) & (width - 1);
      const int begin = std::min(x, width - 1);
      const int count = 1 + static_cast<int>(random() % static_cast<unsigned>(width - begin));
      const Rows whole(noise.frame, y, 0, width);
      std::array<std::vector<std::uint8_t>, 3> out;
      for (auto& channel : out) channel.assign(static_cast<std::size_t>(count) + 2, 77);
      PixelRows(noise.frame)
          .colours(y, begin, count, {out[0].data() + 1, out[1].data() + 1, out[2].data() + 1});
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto from = whole.channels[channel].begin() + begin;
        REQUIRE(std::equal(from, from + count, out[channel].begin() + 1));
        REQUIRE(out[channel].front() == 77);
        REQUIRE(out[channel].back() == 77);
      }
    }
}

TEST_CASE("what may be bright is never taken for dark, in any format") {
  std::mt19937 random(56);
  std::vector<PixelFormat> formats(kYuvFormats.begin(), kYuvFormats.end());
  formats.insert(formats.end(), kBayerFormats.begin(), kBayerFormats.end());
  int empty = 0;
  for (const PixelFormat format : formats)
    for (int round = 0; round < 60; ++round) {
      NoiseFrame noise(random, format, 120, 40, 17);
      for (std::uint8_t& byte : noise.chroma) byte = static_cast<std::uint8_t>(byte % 8 + 124);
      if (format == PixelFormat::yuyv8 || format == PixelFormat::uyvy8)
        for (std::size_t i = format == PixelFormat::yuyv8 ? 1 : 0; i < noise.bytes.size(); i += 2)
          noise.bytes[i] = static_cast<std::uint8_t>(noise.bytes[i] % 8 + 124);
      for (unsigned k = 0; k < random() % 4; ++k)
        noise.bytes[random() % noise.bytes.size()] = static_cast<std::uint8_t>(random());
      VisionParameters parameters;
      parameters.intensity_min = 60;
      const Box box = foreground_box(noise.frame, parameters);
      empty += box.empty() ? 1 : 0;
      const cv::Mat picture = whole_picture(noise.frame);
      for (int y = 0; y < picture.rows; ++y)
        for (int x = 0; x < picture.cols; ++x) {
          const auto& pixel = picture.at<cv::Vec3b>(y, x);
          if (pixel[0] + pixel[1] + pixel[2] < parameters.intensity_min) continue;
          const bool inside =
              x >= box.x && y >= box.y && x < box.x + box.width && y < box.y + box.height;
          REQUIRE(inside);
        }
    }
  CHECK(empty > 5);
}

TEST_CASE("a frame without its second plane or with an odd side is no whole frame") {
  std::mt19937 random(57);
  for (const PixelFormat format : kYuvFormats) {
    NoiseFrame noise(random, format, 16, 8);
    REQUIRE(is_whole(noise.frame));
    Frame frame = noise.frame;
    frame.width_px = 15;
    REQUIRE_FALSE(is_whole(frame));
    frame = noise.frame;
    frame.chroma = nullptr;
    REQUIRE(is_whole(frame) == !has_chroma_plane(format));
    frame = noise.frame;
    frame.height_px = 7;
    REQUIRE(is_whole(frame) == !has_chroma_plane(format));
  }
}

TEST_CASE("a camera's frame is cut like the same colours in a plain one") {
  std::mt19937 random(58);
  std::vector<PixelFormat> formats(kYuvFormats.begin(), kYuvFormats.end());
  formats.insert(formats.end(), kBayerFormats.begin(), kBayerFormats.end());
  for (const PixelFormat format : formats) {
    NoiseFrame noise(random, format, 160, 120);
    for (std::size_t i = 0; i < noise.bytes.size(); ++i)
      noise.bytes[i] = static_cast<std::uint8_t>(40 + noise.bytes[i] % 4 + i / 4000 * 30);
    const cv::Mat picture = whole_picture(noise.frame);
    VisionParameters parameters;
    parameters.region_of_interest = {5, 3, 151, 113};
    OwnedVision camera(160, 120), plain(160, 120);
    camera.run(noise.frame, parameters);
    plain.run(picture, parameters);
    REQUIRE_FALSE(plain.regions().regions.empty());
    REQUIRE(cv::countNonZero(label_picture(camera.regions(), picture.size()) !=
                             label_picture(plain.regions(), picture.size())) == 0);
  }
}

}  // namespace aspect
