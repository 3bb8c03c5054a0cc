// The text below a picture of findings: what its numbers mean, and the cures.
#pragma once

#include <opencv2/core.hpp>
#include <span>
#include <string>
#include <vector>

#include "tools/doctor/finding_lines.h"

namespace aspect {

class FindingLegend {
 public:
  // By line: whether it is to be seen in the picture, or has a place that could be.
  struct Shown {
    bool marked = false, has_place = false;
  };
  FindingLegend(std::span<const FindingLine> lines, std::span<const Shown> shown, int width_px);

  int height_px() const;
  void draw(cv::Mat& page, cv::Point corner) const;

 private:
  struct Entry {
    std::string label;
    cv::Scalar colour;
    std::vector<std::string> words, cure;
  };
  std::vector<Entry> entries_;
  std::string last_;  // of what has no entry; may be empty
};

}  // namespace aspect
