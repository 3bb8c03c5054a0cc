// What --dump writes: pictures for people, thrown away once they are looked at.
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "compiler/store/done.h"
#include "runtime/base/result.h"

namespace aspect {

class DebugPictures {
 public:
  // Makes the folder; without one nothing is ever written.
  static Result<DebugPictures> create(const std::optional<std::filesystem::path>& folder);

  bool wanted() const { return folder_.has_value(); }
  // NNNNNN_NAME.png
  Result<Done> write(std::size_t number, const std::string& name, const cv::Mat& picture) const;

 private:
  std::optional<std::filesystem::path> folder_;
};

}  // namespace aspect
