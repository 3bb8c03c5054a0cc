// The pictures that --overlay and --dump ask for.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "runtime/base/result.h"
#include "runtime/capture/frame_source.h"
#include "runtime/recognition/recogniser.h"

namespace aspect {

class StagePictures {
 public:
  // Makes the folders.
  static Result<StagePictures> create(const std::optional<std::filesystem::path>& overlay_folder,
                                      const std::optional<std::filesystem::path>& dump_folder);

  // Draws and writes what was asked for. The first error names the file.
  [[nodiscard]] std::optional<Error> write(const CapturedFrame& frame,
                                           const Recognition& recognition, const RegionMap& regions,
                                           std::span<const ClassIndex> indexes,
                                           std::span<const CameraModel> cameras) const;

 private:
  StagePictures() = default;
  std::optional<std::filesystem::path> overlay_folder_, dump_folder_;
};

// NNNNNN_NAME of a frame, its name without folders and with nothing a file system may object to.
std::string overlay_name(const CapturedFrame& frame);

}  // namespace aspect
