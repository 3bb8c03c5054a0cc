#include "tools/replay/stage_pictures.h"

#include <fmt/format.h>
#include <cctype>
#include <exception>
#include <opencv2/imgcodecs.hpp>
#include <system_error>

#include "tools/draw/frame_canvas.h"
#include "tools/draw/recognition_draw.h"
#include "tools/draw/region_draw.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

std::optional<Error> make_folder(const fs::path& folder) {
  std::error_code code;
  fs::create_directories(folder, code);
  if (code || !fs::is_directory(folder, code))
    return Error{folder.native() + ": cannot be made a folder" +
                 (code ? ": " + code.message() : std::string()) + "; give another one"};
  return std::nullopt;
}

std::optional<Error> write_picture(const fs::path& file, const cv::Mat& picture) {
  // Little effort to compress: the pictures are looked at and thrown away.
  const std::vector<int> settings = {cv::IMWRITE_PNG_COMPRESSION, 1};
  try {
    if (cv::imwrite(file.native(), picture, settings)) return std::nullopt;
  } catch (const cv::Exception&) {
    return Error{file.native() + ": cannot be written; check the folder's permissions"};
  }
  return Error{file.native() + ": cannot be written; check the folder and the space left"};
}

}  // namespace

Result<StagePictures> StagePictures::create(const std::optional<fs::path>& overlay_folder,
                                            const std::optional<fs::path>& dump_folder) {
  for (const auto& folder : {overlay_folder, dump_folder})
    if (folder)
      if (auto error = make_folder(*folder)) return *error;
  StagePictures pictures;
  pictures.overlay_folder_ = overlay_folder;
  pictures.dump_folder_ = dump_folder;
  return pictures;
}

std::optional<Error> StagePictures::write(const CapturedFrame& frame,
                                          const Recognition& recognition, const RegionMap& regions,
                                          std::span<const ClassIndex> indexes,
                                          std::span<const CameraModel> cameras) const {
  if (!overlay_folder_ && !dump_folder_) return std::nullopt;
  const Frame view = frame.view();
  const cv::Mat overlay = draw_recognition(view, recognition, regions, indexes, cameras);
  if (overlay_folder_)
    if (auto error = write_picture(*overlay_folder_ / (overlay_name(frame) + ".png"), overlay))
      return error;
  if (!dump_folder_) return std::nullopt;
  const auto stage = [&](const char* name) {
    return *dump_folder_ / fmt::format("{:06}_{}.png", frame.sequence, name);
  };
  if (auto error = write_picture(stage("1_input"), picture_of(view))) return error;
  const cv::Mat map = draw_regions(regions, frame.width_px, frame.height_px);
  if (auto error = write_picture(stage("2_regions"), map)) return error;
  if (auto error = write_picture(stage("3_overlay"), overlay)) return error;
  return write_picture(stage("4_numbers"), draw_numbered_regions(regions, recognition.graph,
                                                                 frame.width_px, frame.height_px));
}

std::string overlay_name(const CapturedFrame& frame) {
  constexpr std::size_t kMostLetters = 80;
  std::string name = fs::path(frame.name).filename().native();
  const std::string ending = fs::path(name).extension().native();
  // A video's frames have their number behind the ending.
  if (ending.find('#') == std::string::npos) name.resize(name.size() - ending.size());
  for (char& c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-' && c != '_' && c != '.')
      c = '_';
  return fmt::format("{:06}_{}", frame.sequence, name.substr(0, kMostLetters));
}

}  // namespace aspect
