// Pictures as a camera would send them: FOLDER/frames.640x480.YUYV, .NV12 and .RGB3, and the same
// scaled down, FOLDER/small.64x48.RGB3; one frame after the other without gaps. Pictures are
// centred, cut off above and below, the rest is black.
// usage: make_raw_frames FOLDER PICTURE...
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

namespace {

cv::Mat camera_picture(const cv::Mat& picture, cv::Size size) {
  cv::Mat frame = cv::Mat::zeros(size, CV_8UC3);
  const int width = std::min(picture.cols, size.width);
  const int height = std::min(picture.rows, size.height);
  const cv::Rect from((picture.cols - width) / 2, (picture.rows - height) / 2, width, height);
  const cv::Rect to((size.width - width) / 2, (size.height - height) / 2, width, height);
  picture(from).copyTo(frame(to));
  return frame;
}

struct Yuv {
  int y = 0, u = 0, v = 0;
};

// ITU-R BT.601, limited range, in 1/256.
Yuv yuv_of(const cv::Vec3b& bgr) {
  const int b = bgr[0], g = bgr[1], r = bgr[2];
  return {(66 * r + 129 * g + 25 * b + 128) / 256 + 16,
          (-38 * r - 74 * g + 112 * b + 128 + 32768) / 256,
          (112 * r - 94 * g - 18 * b + 128 + 32768) / 256};
}

char byte(int value) {
  return static_cast<char>(static_cast<std::uint8_t>(std::clamp(value, 0, 255)));
}

void append_yuyv(const cv::Mat& frame, std::string& bytes) {
  for (int y = 0; y < frame.rows; ++y)
    for (int x = 0; x < frame.cols; x += 2) {
      const Yuv left = yuv_of(frame.at<cv::Vec3b>(y, x));
      const Yuv right = yuv_of(frame.at<cv::Vec3b>(y, x + 1));
      bytes += byte(left.y);
      bytes += byte((left.u + right.u + 1) / 2);
      bytes += byte(right.y);
      bytes += byte((left.v + right.v + 1) / 2);
    }
}

void append_nv12(const cv::Mat& frame, std::string& bytes) {
  for (int y = 0; y < frame.rows; ++y)
    for (int x = 0; x < frame.cols; ++x) bytes += byte(yuv_of(frame.at<cv::Vec3b>(y, x)).y);
  for (int y = 0; y < frame.rows; y += 2)
    for (int x = 0; x < frame.cols; x += 2) {
      Yuv sum;
      for (int i = 0; i < 4; ++i) {
        const Yuv yuv = yuv_of(frame.at<cv::Vec3b>(y + i / 2, x + i % 2));
        sum.u += yuv.u;
        sum.v += yuv.v;
      }
      bytes += byte((sum.u + 2) / 4);
      bytes += byte((sum.v + 2) / 4);
    }
}

void append_rgb3(const cv::Mat& frame, std::string& bytes) {
  for (int y = 0; y < frame.rows; ++y)
    for (int x = 0; x < frame.cols; ++x)
      for (int channel = 2; channel >= 0; --channel)
        bytes += static_cast<char>(frame.at<cv::Vec3b>(y, x)[channel]);
}

}  // namespace

int main(int argc, char** argv) {
  std::string yuyv, nv12, rgb3, small;
  for (int i = 2; i < argc; ++i) {
    const cv::Mat picture = cv::imread(argv[i], cv::IMREAD_COLOR);
    if (picture.empty()) {
      std::fprintf(stderr, "make_raw_frames: %s: not a picture\n", argv[i]);
      return 1;
    }
    const cv::Mat frame = camera_picture(picture, {640, 480});
    append_yuyv(frame, yuyv);
    append_nv12(frame, nv12);
    append_rgb3(frame, rgb3);
    cv::Mat tiny;
    cv::resize(picture, tiny, {48, 48}, 0, 0, cv::INTER_NEAREST);
    append_rgb3(camera_picture(tiny, {64, 48}), small);
  }
  const std::string folder = argc > 1 ? argv[1] : ".";
  const std::string stem = folder + "/frames.640x480.";
  std::ofstream(stem + "YUYV", std::ios::binary) << yuyv;
  std::ofstream(stem + "NV12", std::ios::binary) << nv12;
  std::ofstream(stem + "RGB3", std::ios::binary) << rgb3;
  std::ofstream(folder + "/small.64x48.RGB3", std::ios::binary) << small;
  return 0;
}
