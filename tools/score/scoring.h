// Truth and results, frame by frame, and what they add up to. The rules are those of the
// measurement that the project's figures were first taken with; changing one makes figures
// incomparable.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tools/score/known_rotations.h"
#include "tools/score/result_lines.h"
#include "tools/score/truth_table.h"

namespace aspect {

inline constexpr double kNotFound_deg = 180;
inline constexpr double kLeastVisible = 0.65;  // share of an object that counts
inline constexpr double kLeastOverlap = 0.3;   // IoU of boxes that mean the same thing

// Intersection over union.
double box_overlap(const PixelBox& a, const PixelBox& b);

// One object of the truth, or one thing named where no object is (then `truth` is empty).
struct ScoredObject {
  std::string truth, found;  // names; `found` is empty where nothing was
  bool counts = false;       // in the summary: enough of it is visible
  bool right = false;
  double error_deg = kNotFound_deg;
};

struct ScoredFrame {
  std::string file;                  // as in the truth
  const FoundFrame* line = nullptr;  // null: missing in the results
  std::vector<ScoredObject> objects;
};

struct ScoreSummary {
  std::size_t objects = 0, right = 0;
  double median_deg = 0;
  double within_5 = 0, within_10 = 0, within_20 = 0;  // shares of the objects
  std::optional<double> median_ms;                    // of the frames that show it
  double right_share() const;
};

struct Score {
  std::vector<ScoredFrame> frames;              // in the truth's order
  std::map<std::string, ScoreSummary> objects;  // by name
  ScoreSummary all;                             // its time: of all frames
  std::size_t missing = 0;                      // frames
  std::size_t falsely_named = 0;                // things named where no such object is
};

// Which frame of the truth a result is of, by its path or else by its file's name; the truth's size
// where there is none. `truth_folder` is where the truth's files are named from.
std::size_t frame_of_result(std::span<const TrueFrame> truth,
                            const std::filesystem::path& truth_folder, const std::string& frame);

// One frame: the truth's objects in their order, then what is named where no such object is.
// `line` may be null and must outlive the result. What is named falsely is counted on top.
ScoredFrame score_frame(const TrueFrame& truth, const FoundFrame* line,
                        const KnownRotations& rotations, std::size_t& falsely_named);

// `truth_folder` is where the truth's files are named from. `results` must outlive the score.
Score score_results(std::span<const TrueFrame> truth, const std::filesystem::path& truth_folder,
                    std::span<const FoundFrame> results, const KnownRotations& rotations);

}  // namespace aspect
