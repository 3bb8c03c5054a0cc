// Numbers in coloured pills, with a line to what they are of.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace aspect {

void draw_badge(cv::Mat& picture, cv::Point centre, const std::string& label,
                const cv::Scalar& colour);

// Each beside what it points at, outwards from the middle of the picture, and where no other one
// nor the line to it is, if there is such a place.
class Badges {
 public:
  explicit Badges(cv::Mat& picture) : picture_(picture) {}
  void add(cv::Point at, const std::string& label, const cv::Scalar& colour);

 private:
  struct Taken {
    cv::Point at, centre;
  };
  cv::Point place(cv::Point at) const;
  bool is_free(cv::Point at, cv::Point centre) const;

  cv::Mat& picture_;
  std::vector<Taken> taken_;
};

}  // namespace aspect
