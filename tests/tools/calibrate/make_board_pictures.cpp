// Writes pictures of a board and the camera that took them: what aspect-calibrate is measured with.
//   make_board_pictures FOLDER [checkerboard|charuco] [COUNT] [WIDTH] [SEED] [BLUR] [NOISE]
#include <fmt/format.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "tests/tools/calibrate/board_picture.h"

int main(int argc, char** argv) {
  using namespace aspect;
  if (argc < 2) return fmt::print(stderr, "make_board_pictures: give a folder\n"), 2;
  const auto word = [&](int place, const char* otherwise) {
    return std::string(argc > place ? argv[place] : otherwise);
  };
  const std::filesystem::path folder = argv[1];
  Board board;
  if (word(2, "checkerboard") == "charuco") board.kind = Board::Kind::charuco;
  const int count = std::stoi(word(3, "12")), width = std::stoi(word(4, "640"));
  const auto seed = static_cast<unsigned>(std::stoi(word(5, "1")));
  TakingCamera camera = wide_camera(width, width * 3 / 4);
  camera.blur_px = std::stod(word(6, "0.7"));
  camera.noise = std::stod(word(7, "2"));
  const BoardStudio studio(board, camera);
  std::filesystem::create_directories(folder);
  const auto poses = studio.poses(count, seed, board.kind == Board::Kind::checkerboard);
  for (std::size_t k = 0; k < poses.size(); ++k)
    cv::imwrite((folder / fmt::format("{:02}.png", k)).native(),
                studio.take(poses[k], seed * 1000 + static_cast<unsigned>(k)));
  const CameraModel& m = camera.model;
  fmt::print(
      "{} pictures of {}\nfx {:.2f} fy {:.2f} cx {:.2f} cy {:.2f} k1 {} k2 {} p1 {} p2 {} k3 {}\n",
      count, words_of(board), m.fx_px, m.fy_px, m.cx_px, m.cy_px, m.k1, m.k2, m.p1, m.p2, m.k3);
  return 0;
}
