#include "tools/calibrate/output/debug_pictures.h"

#include <fmt/format.h>

#include <opencv2/imgcodecs.hpp>
#include <system_error>
#include <vector>

#include "tools/aspectc/commands/whole_file.h"

namespace aspect {

Result<DebugPictures> DebugPictures::create(const std::optional<std::filesystem::path>& folder) {
  DebugPictures pictures;
  pictures.folder_ = folder;
  if (!folder) return pictures;
  std::error_code code;
  std::filesystem::create_directories(*folder, code);
  if (code || !std::filesystem::is_directory(*folder, code))
    return Error{folder->native() + ": cannot be made a folder; give another one"};
  return pictures;
}

Result<Done> DebugPictures::write(std::size_t number, const std::string& name,
                                  const cv::Mat& picture) const {
  if (!folder_) return Done{};
  const auto file = *folder_ / fmt::format("{:06}_{}.png", number, name);
  std::vector<std::uint8_t> png;
  if (!cv::imencode(".png", picture, png, {cv::IMWRITE_PNG_COMPRESSION, 1}))
    return Error{file.native() + ": the picture could not be encoded"};
  return write_whole_file(file, png);
}

}  // namespace aspect
