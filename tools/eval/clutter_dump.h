// Frames that were made, as files that aspect-replay and aspect-score take.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "runtime/base/result.h"
#include "tools/eval/cluttered_frame.h"

namespace aspect {

// A folder of PNG files and a truth.csv: object, rotation, translation, view, box of what is
// visible, share visible; of a frame without an object the row names the file alone.
class ClutterDump {
 public:
  // Makes the folder.
  static Result<ClutterDump> create(const std::filesystem::path& folder);

  std::optional<Error> add(const std::string& object, std::size_t number, const Scene& scene,
                           const ClutteredFrame& frame);
  // Writes the truth.
  std::optional<Error> finish() const;

 private:
  std::filesystem::path folder_;
  std::string truth_;
};

}  // namespace aspect
