#include "tools/draw/recognition_draw.h"

#include <fmt/format.h>
#include <array>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "runtime/recognition/model_lines.h"
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
  const Judgement& judgement = object.judgement;
  const std::string& name = indexes[best.index].object;
  if (judgement.verdict == Verdict::unknown)
    return fmt::format("unknown, {} {:.2f}", name, judgement.probability);
  const std::string verdict =
      judgement.verdict == Verdict::none
          ? ""
          : fmt::format("{} {:.2f} ", name_of(judgement.verdict), judgement.probability);
  const std::string track = object.track > 0 ? fmt::format("#{} ", object.track) : "";
  return fmt::format("{}{} {}class {} score {:.3g} view {:.2f} {:.2f} {:.2f}", track, name, verdict,
                     best.class_id, best.score, best.view[0], best.view[1], best.view[2]);
}

void draw_box(FrameCanvas& canvas, const SeenObject& object) {
  const cv::Rect box = canvas.at(object.box);
  const cv::Scalar dark(20, 20, 20), grey(150, 150, 150), white(255, 255, 255);
  cv::rectangle(canvas.picture(), box, dark, canvas.line_px() + 2);
  cv::rectangle(canvas.picture(), box, object.hypotheses.empty() ? grey : white, canvas.line_px());
}

const Hypothesis* drawn_hypothesis(const SeenObject& object) {
  const Verdict verdict = object.judgement.verdict;
  if (verdict != Verdict::match && verdict != Verdict::ambiguous) return nullptr;
  const Hypothesis& best = object.hypotheses.front();
  return best.pose == nullptr ? nullptr : &best;
}

void draw_line(FrameCanvas& canvas, const PictureLine& line, const cv::Scalar& colour,
               int width_px) {
  std::vector<cv::Point> points;
  points.reserve(line.size());
  for (const Point2d& p : line)
    points.push_back(canvas.at(static_cast<float>(p.x), static_cast<float>(p.y)));
  cv::polylines(canvas.picture(), points, false, colour, width_px);
}

void draw_model(FrameCanvas& canvas, const ObjectModel& model, const RigidPose& pose,
                const CameraModel& camera, cv::Size frame) {
  const cv::Scalar dark(20, 20, 20);
  const int thin = canvas.line_px();
  const std::vector<PictureLine> edges = edges_seen(model, pose, camera, frame.width, frame.height);
  for (const PictureLine& edge : edges) draw_line(canvas, edge, dark, thin + 2);
  for (const PictureLine& edge : edges) draw_line(canvas, edge, kModelEdgeColour, thin);
  const std::array<cv::Scalar, 3> colours = {cv::Scalar(0, 0, 255), {0, 255, 0}, {255, 0, 0}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vector3d tip = model.centre;
    tip[axis] += model.radius / 2;
    for (const PictureLine& line :
         line_through(pose(model.centre), pose(tip), camera, frame.width, frame.height)) {
      draw_line(canvas, line, dark, thin + 4);
      draw_line(canvas, line, colours[axis], thin + 2);
    }
  }
}

// Above the box or, where there is no room, below it.
void draw_caption(FrameCanvas& canvas, LabelPlacer& labels, const SeenObject& object,
                  std::span<const ClassIndex> indexes) {
  const cv::Rect box = canvas.at(object.box);
  const std::string caption = caption_of(object, indexes);
  const TextStyle style = fitted(canvas.text_style(), caption, canvas.picture().cols);
  const cv::Point above(box.x, box.y - text_size(caption, style).height - canvas.line_px());
  const cv::Point below(box.x, box.y + box.height + canvas.line_px());
  const std::array<cv::Point, 2> corners = {above.y >= 0 ? above : below, below};
  labels.draw(caption, corners, style, {170, 255, 255});
}

// Of a frame full of things, specks that are nothing known would cover what is.
bool is_worth_a_caption(const SeenObject& object, const Frame& frame) {
  constexpr int kLeastShare = 50;
  return object.judgement.verdict != Verdict::unknown ||
         kLeastShare * object.box.width * object.box.height > frame.width_px * frame.height_px;
}

// Light enough to be read; the outlines have the full colour.
cv::Scalar text_colour(int id) {
  return id_colour(id) * 0.45 + cv::Scalar::all(140);
}

}  // namespace

cv::Mat draw_recognition(const Frame& frame, const Recognition& recognition, const RegionMap& map,
                         std::span<const ClassIndex> indexes,
                         std::span<const CameraModel> cameras) {
  FrameCanvas canvas(picture_of(frame));
  const auto contours = recognition.graph.contours;
  for (const Contour& contour : contours) canvas.draw_outline(contour, id_colour(contour.region));
  for (const SeenObject& object : recognition.objects)
    if (is_worth_a_caption(object, frame)) draw_box(canvas, object);
  for (const SeenObject& object : recognition.objects)
    if (const Hypothesis* best = drawn_hypothesis(object))
      draw_model(canvas, indexes[best->index].model, best->pose->refined.pose, cameras[best->index],
                 {frame.width_px, frame.height_px});

  const TextStyle style = canvas.text_style();
  LabelPlacer labels(canvas.picture());
  for (const SeenObject& object : recognition.objects)
    if (is_worth_a_caption(object, frame)) draw_caption(canvas, labels, object, indexes);
  for (std::size_t k = 0; k < contours.size(); ++k) {
    if (!contours[k].external) continue;
    const Point2 point = label_point(contours[k], map);
    labels.draw_centred(label_of(k, recognition.objects), canvas.at(point.x, point.y), style,
                        text_colour(contours[k].region));
  }
  return canvas.picture();
}

}  // namespace aspect
