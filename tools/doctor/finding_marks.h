// The marks of findings on a view of the object.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "tools/doctor/finding.h"
#include "tools/doctor/object_view.h"
#include "tools/doctor/sight.h"

namespace aspect {

// BGR: errors in red, all else by its place among the lines in colours that objects seldom have.
cv::Scalar mark_colour(Severity severity, std::size_t place);

// Edges and borders of colours as lines, faces and surfaces hatched, points as rings, all with a
// light rim, so that they show on anything. What lies behind a surface is dotted, if there is not
// too much of it, as the outlines of surfaces that are never seen are.
class MarkPainter {
 public:
  // Of the scene that was diagnosed.
  MarkPainter(const Scene& scene, const ColourGroups& groups) : scene_(scene), groups_(groups) {}

  // On a picture of the view's size. Returns pixels that are marked; if all is behind surfaces,
  // where it is.
  std::vector<cv::Point> draw(cv::Mat& picture, const ObjectView& view, const FindingMarks& marks,
                              const cv::Scalar& colour) const;

 private:
  const Scene& scene_;
  const ColourGroups& groups_;
};

}  // namespace aspect
