#include "tools/draw/region_draw.h"

#include <fmt/format.h>

#include "tools/draw/frame_canvas.h"
#include "tools/draw/id_colour.h"

namespace aspect {

cv::Mat draw_regions(const RegionMap& map, int width_px, int height_px) {
  cv::Mat picture(height_px, width_px, CV_8UC3, cv::Scalar(0, 0, 0));
  for (const Run& run : map.runs) {
    if (run.label == 0) continue;
    picture(cv::Rect(run.begin, run.row, run.end - run.begin, 1)).setTo(id_colour(run.label));
  }
  return picture;
}

cv::Mat draw_numbered_regions(const RegionMap& map, const ViewGraph& graph, int width_px,
                              int height_px) {
  FrameCanvas canvas(draw_regions(map, width_px, height_px));
  const TextStyle style = canvas.text_style();
  LabelPlacer labels(canvas.picture());
  for (std::size_t k = 0; k < graph.contours.size(); ++k) {
    const Contour& contour = graph.contours[k];
    const Point2 point = label_point(contour, map);
    labels.draw_centred(contour.external ? fmt::to_string(k) : fmt::format("({})", k),
                        canvas.at(point.x, point.y), style, {255, 255, 255});
  }
  return canvas.picture();
}

}  // namespace aspect
