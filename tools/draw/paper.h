// What sheets of pictures are drawn on: light, so that dark surfaces show too. In OpenCV's order.
#pragma once

#include <opencv2/core.hpp>

namespace aspect {

inline const cv::Scalar kPaper(248, 246, 244);  // behind an object
inline const cv::Scalar kDesk(226, 222, 218);   // around pictures
inline const cv::Scalar kInk(40, 36, 32), kQuietInk(110, 104, 98);

}  // namespace aspect
