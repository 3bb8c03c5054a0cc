// A device draws nothing.
#include "tools/replay/stage_pictures.h"

namespace aspect {

Result<StagePictures> StagePictures::create(
    const std::optional<std::filesystem::path>& overlay_folder,
    const std::optional<std::filesystem::path>& dump_folder) {
  if (overlay_folder || dump_folder)
    return Error{std::string(overlay_folder ? "--overlay" : "--dump") +
                 ": pictures are drawn on workstations only; leave it out"};
  return StagePictures();
}

std::optional<Error> StagePictures::write(const CapturedFrame&, const Recognition&,
                                          const RegionMap&, std::span<const ClassIndex>,
                                          std::span<const CameraModel>) const {
  return std::nullopt;
}

}  // namespace aspect
