// Paths of SVG as lists of points, read by the rules of the standard: M, l and z, numbers with or
// without a space before a sign.
#pragma once

#include <cstdlib>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace aspect {

inline std::vector<std::vector<cv::Point2d>> points_of_path(const std::string& path) {
  std::vector<std::vector<cv::Point2d>> lines;
  const char* at = path.c_str();
  cv::Point2d last;
  char command = 0;
  const auto number = [&] {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    if (end == at) throw std::runtime_error("no number in a path");
    at = end;
    return value;
  };
  while (*at != '\0') {
    if (*at == 'M' || *at == 'l' || *at == 'z') command = *at++;
    if (command == 'z') continue;
    const double x = number(), y = number();
    if (command == 'M') lines.emplace_back();
    last = command == 'M' ? cv::Point2d(x, y) : last + cv::Point2d(x, y);
    lines.back().push_back(last);
  }
  return lines;
}

}  // namespace aspect
