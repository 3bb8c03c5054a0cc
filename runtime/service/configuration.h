// A configuration file: the camera, and what is to be done otherwise than the index was compiled.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/base/result.h"
#include "runtime/recognition/recogniser.h"

namespace aspect {

// A pinhole camera in OpenCV's coordinates; pixel centres are at whole numbers.
struct CameraConfiguration {
  int width_px = 0, height_px = 0;
  double fx_px = 0, fy_px = 0;  // focal lengths
  double cx_px = 0, cy_px = 0;  // principal point
};

// What a [segmentation] table says; the meanings are those of VisionParameters.
struct SegmentationOverrides {
  std::optional<int> intensity_min, chroma_step, noise_steps, intensity_step, area_min_px;
  std::optional<float> thickness_min_px;
  std::optional<bool> smooth, one_blob;
  std::optional<Box> region_of_interest;
  std::optional<int> range_steps_min, range_steps_max;
  std::optional<float> range_step_length, range_depth_step, range_normal_step_deg;

  void apply(VisionParameters& parameters) const;
};

// What a [recognition] table says; the meanings are those of RecogniserParameters.
struct RecognitionOverrides {
  std::optional<Matching> matching;
  std::optional<RecogniserParameters::Ranking> ranking;
  std::optional<int> top, shortlist_slack;

  void apply(RecogniserParameters& parameters) const;
};

struct Configuration {
  std::optional<CameraConfiguration> camera;
  SegmentationOverrides segmentation;
  RecognitionOverrides recognition;

  void apply(RecogniserParameters& parameters) const;
};

// TOML with the tables [camera], [segmentation] and [recognition], all of them optional. Errors
// name file and line: unknown tables and keys, wrong types, numbers out of range, a camera of which
// something is missing. A file has at most 1 MiB.
Result<Configuration> read_configuration(const std::filesystem::path& file);
Result<Configuration> parse_configuration(std::string_view text, const std::string& name);

}  // namespace aspect
