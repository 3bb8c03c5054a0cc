// An index and frames for the test of the page: page_test_data FOLDER writes flag.aspect and
// frames/0.png to 3.png, in which the flag moves.
#include <exception>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "tests/tools/tiny_index.h"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  try {
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder / "frames");
    for (int k = 0; k < 4; ++k) {
      cv::Mat frame(240, 320, CV_8UC3, cv::Scalar(0, 0, 0));
      frame(cv::Rect(80 + 10 * k, 60, 70, 110)).setTo(cv::Scalar(30, 30, 210));
      frame(cv::Rect(150 + 10 * k, 60, 70, 110)).setTo(cv::Scalar(30, 180, 30));
      if (k == 0) aspect::write_tiny_index(folder / "flag.aspect", "flag", frame);
      cv::imwrite(folder / "frames" / (std::to_string(k) + ".png"), frame);
    }
    return 0;
  } catch (const std::exception&) {
    return 1;
  }
}
