// A configuration file: which indexes, which camera, what is to be done otherwise than the indexes
// were compiled, and where results go. One file serves aspectd and aspect-replay, which takes of it
// what is not about a live camera.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/capture/camera_settings.h"
#include "runtime/output/output_settings.h"
#include "runtime/recognition/recogniser.h"
#include "runtime/service/process_settings.h"

namespace aspect {

struct CameraConfiguration {
  int width_px = 0, height_px = 0;
  CameraModel model;
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

inline constexpr double kLeastTimeLimit_ms = 0.001, kMostTimeLimit_ms = 60'000;

// What a [recognition] table says; the meanings are those of RecogniserParameters.
struct RecognitionOverrides {
  std::optional<Matching> matching;
  std::optional<RecogniserParameters::Ranking> ranking;
  std::optional<int> top, shortlist_slack;
  std::optional<double> score_min;
  std::optional<double> confidence_min;
  std::optional<bool> anywhere, track;
  std::optional<int> search_every;
  std::optional<double> time_limit_ms;

  void apply(RecogniserParameters& parameters) const;
};

struct Configuration {
  std::vector<std::filesystem::path> indexes;  // relative ones are meant from the file's folder
  std::optional<CameraConfiguration> camera;
  CameraSettings capture;
  SegmentationOverrides segmentation;
  RecognitionOverrides recognition;
  OutputSettings output;
  ProcessSettings process;

  void apply(RecogniserParameters& parameters) const;
};

// TOML with `indexes` and the tables [camera], [segmentation], [recognition], [output] and
// [process], all of them optional. Errors name file and line: unknown tables and keys, wrong types,
// numbers out of range, a camera of which something is missing. A file has at most 1 MiB.
Result<Configuration> read_configuration(const std::filesystem::path& file);
Result<Configuration> parse_configuration(std::string_view text, const std::string& name);

}  // namespace aspect
