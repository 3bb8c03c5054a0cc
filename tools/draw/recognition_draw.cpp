#include "tools/draw/recognition_draw.h"

#include <algorithm>
#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "runtime/service/recognition_json.h"
#include "tools/draw/frame_canvas.h"
#include "tools/draw/id_colour.h"

namespace aspect {
namespace {

// The contour's number, with its name where the best hypothesis of its object has one for it.
std::string label_of(std::size_t contour, std::span<const SeenObject> objects) {
  for (const SeenObject& object : objects) {
    if (object.hypotheses.empty()) continue;
    for (const ContourMatch& match : object.hypotheses.front().contours) {
      char name[4];
      if (match.contour == contour)
        return fmt::format("{} {}", contour, contour_name(match.name, name));
    }
  }
  return fmt::to_string(contour);
}

std::string caption_of(const SeenObject& object, std::span<const ClassIndex> indexes) {
  if (object.hypotheses.empty()) return "nothing known";
  const Hypothesis& best = object.hypotheses.front();
  return fmt::format("{} class {}  score {:.3g}  view {:+.2f} {:+.2f} {:+.2f}",
                     indexes[best.index].object, best.class_id, best.score, best.view[0],
                     best.view[1], best.view[2]);
}

void draw_object(FrameCanvas& canvas, const SeenObject& object,
                 std::span<const ClassIndex> indexes) {
  const cv::Rect box = canvas.at(object.box);
  const cv::Scalar white(255, 255, 255), dark(20, 20, 20);
  cv::rectangle(canvas.picture(), box, dark, canvas.line_px() + 2);
  cv::rectangle(canvas.picture(), box, object.hypotheses.empty() ? cv::Scalar(150, 150, 150) : white,
                canvas.line_px());
  const std::string caption = caption_of(object, indexes);
  const TextStyle style = fitted(canvas.text_style(), caption, canvas.picture().cols);
  // Above the box; below it where there is no room above.
  const int height = text_size(caption, style).height + canvas.line_px();
  const int y = box.y >= height ? box.y - height : box.y + box.height + canvas.line_px();
  draw_text(canvas.picture(), caption, {box.x, y}, style, {170, 255, 255});
}

}  // namespace

cv::Mat draw_recognition(const Frame& frame, const Recognition& recognition, const RegionMap& map,
                         std::span<const ClassIndex> indexes) {
  FrameCanvas canvas(picture_of(frame));
  const auto contours = recognition.graph.contours;
  for (const Contour& contour : contours) canvas.draw_outline(contour, id_colour(contour.region));
  LabelPlacer labels(canvas.picture(), canvas.text_style());
  for (std::size_t k = 0; k < contours.size(); ++k) {
    if (!contours[k].external) continue;
    const Point2 point = label_point(contours[k], map);
    labels.draw(label_of(k, recognition.objects), canvas.at(point.x, point.y),
                id_colour(contours[k].region));
  }
  for (const SeenObject& object : recognition.objects) draw_object(canvas, object, indexes);
  return canvas.picture();
}

}  // namespace aspect
