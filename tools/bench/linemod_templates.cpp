// Idea: S. Hinterstoisser et al., "Gradient response maps for real-time detection of textureless
// objects", PAMI 2012, and "Model based training, detection and pose estimation of texture-less 3D
// objects in heavily cluttered scenes", ACCV 2012: a template a view, turn and distance; the best
// match at a place is the object, and its template's pose the pose.
// OpenCV's has no more than this. The second paper checks what it found by colour, which is here
// too, by hue, because gradients cannot tell objects of one shape apart; its figures are ours.
// Where we deviate: no depth, and so neither its test nor the refinement of the pose on it.
// Weak side: places are as coarse as the spread of the finest level, and of equally good ones the
// upper left is taken; a view is rendered once a distance and turned as a picture.
#include "tools/bench/linemod_templates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <thread>

#include "compiler/render/renderer.h"
#include "compiler/viewsphere/viewsphere.h"

namespace aspect {
namespace {

using cv::linemod::Detector;

cv::Ptr<Detector> empty_detector(const LinemodSampling& sampling) {
  const std::vector<cv::Ptr<cv::linemod::Modality>> modalities = {
      cv::makePtr<cv::linemod::ColorGradient>(static_cast<float>(sampling.weak_gradient),
                                              sampling.features,
                                              static_cast<float>(sampling.strong_gradient))};
  return cv::makePtr<Detector>(modalities, sampling.spread_px);
}

std::vector<Eigen::Vector3d> sphere_corners(int level) {
  ViewSphere sphere;
  for (int k = 0; k < level; ++k)
    for (const PatchId leaf : sphere.leaves()) sphere.split(leaf);
  std::vector<Eigen::Vector3d> corners;
  for (std::uint32_t k = 0; k < sphere.vertex_count(); ++k)
    corners.push_back(sphere.position(VertexId{k}));
  return corners;
}

// The object's own studio with such a lens, in a square that holds the object in any turn.
Studio studio_at(const Scene& scene, const Intrinsics& lens, double distance) {
  constexpr int kMargin_px = 8;
  const double radius = bounding_radius(scene);
  const double reach_px = lens.fx_px * radius / std::sqrt(distance * distance - radius * radius);
  const int half_px = static_cast<int>(std::ceil(reach_px)) + kMargin_px;
  Studio studio = scene.studio;
  studio.at.setZero();
  studio.width_px = studio.height_px = 2 * half_px;
  studio.lens = Lens{lens.fx_px, lens.fy_px, half_px - 0.5, half_px - 0.5};
  return studio;
}

constexpr std::uint8_t kNoHue = 255;  // of what is about black, grey or white

cv::Mat hues_of(const cv::Mat& picture, int conversion) {
  constexpr int kLeastValue = 30, kLeastSaturation = 30;
  cv::Mat hsv;
  cv::cvtColor(picture, hsv, conversion);
  cv::Mat hues(picture.size(), CV_8U);
  for (int y = 0; y < hsv.rows; ++y)
    for (int x = 0; x < hsv.cols; ++x) {
      const auto& [hue, saturation, value] = hsv.at<cv::Vec3b>(y, x).val;
      const bool has_hue = value >= kLeastValue && saturation >= kLeastSaturation;
      hues.at<std::uint8_t>(y, x) = has_hue ? hue : kNoHue;
    }
  return hues;
}

// So many of the object's pixels, evenly from all.
std::vector<LinemodHue> sampled_hues(const cv::Mat& rgb, const cv::Mat& mask,
                                     const cv::Rect& silhouette, cv::Point place) {
  constexpr std::size_t kSamples = 100;
  const cv::Mat hues = hues_of(rgb(silhouette), cv::COLOR_RGB2HSV);
  std::vector<cv::Point> pixels;
  cv::findNonZero(mask(silhouette), pixels);
  std::vector<LinemodHue> samples;
  for (std::size_t k = 0; k < kSamples; ++k) {
    const cv::Point pixel = pixels[k * pixels.size() / kSamples];
    const cv::Point from_match = pixel + silhouette.tl() - place;
    samples.push_back({static_cast<std::int16_t>(from_match.x),
                       static_cast<std::int16_t>(from_match.y), hues.at<std::uint8_t>(pixel)});
  }
  return samples;
}

void add_turns(const Picture& picture, const Camera& camera, double distance,
               const std::string& name, const LinemodSampling& sampling, Detector& detector,
               std::vector<LinemodView>& views) {
  const cv::Size size(picture.width_px, picture.height_px);
  cv::Mat rgb(size, CV_8UC3), mask(size, CV_8U);
  std::copy(picture.rgb.begin(), picture.rgb.end(), rgb.data);
  std::transform(picture.surface.begin(), picture.surface.end(), mask.data,
                 [](std::uint16_t surface) { return surface == 0 ? 0 : 255; });
  const cv::Point2d centre(camera.intrinsics.cx_px, camera.intrinsics.cy_px);
  const int turns = static_cast<int>(std::lround(360 / sampling.turn_deg));
  for (int k = 0; k < turns; ++k) {
    const double turn_rad = 2 * std::numbers::pi * k / turns;
    const double c = std::cos(turn_rad), s = std::sin(turn_rad);
    const cv::Matx23d turned(c, -s, centre.x - c * centre.x + s * centre.y,  //
                             s, c, centre.y - s * centre.x - c * centre.y);
    cv::Mat turned_rgb, turned_mask;
    cv::warpAffine(rgb, turned_rgb, turned, size, cv::INTER_LINEAR);
    cv::warpAffine(mask, turned_mask, turned, size, cv::INTER_NEAREST);
    // No more than blurred borders need.
    const cv::Rect whole({}, size), silhouette = cv::boundingRect(turned_mask);
    const cv::Rect around = (silhouette + cv::Size(16, 16) - cv::Point(8, 8)) & whole;
    cv::Rect features;
    if (detector.addTemplate({turned_rgb(around)}, name, turned_mask(around), &features) < 0)
      continue;
    const cv::Point place = around.tl() + features.tl();
    views.push_back({Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
                         camera.camera_from_object,
                     distance, centre - cv::Point2d(place), silhouette - place,
                     sampled_hues(turned_rgb, turned_mask, silhouette, place)});
  }
}

void add_object(const Scene& plain, const Intrinsics& lens, const LinemodSampling& sampling,
                Detector& detector, std::vector<LinemodView>& views) {
  Scene scene = plain;
  scene.studio.antialias = Antialias::kQuick;  // as borders are in frames of a camera
  const double ratio = sampling.farthest / sampling.nearest;
  const std::vector<Eigen::Vector3d> directions = sphere_corners(sampling.sphere_level);
  for (int k = 0; k < sampling.distances; ++k) {
    const double distance = sampling.nearest * std::pow(ratio, (k + 0.5) / sampling.distances);
    scene.studio = studio_at(scene, lens, distance);
    const Renderer renderer = Renderer::create(scene).value();
    Picture picture;
    for (const Eigen::Vector3d& direction : directions) {
      const Camera camera = camera_at(scene.studio, direction, distance);
      renderer.render(camera, picture);
      add_turns(picture, camera, distance, scene.name, sampling, detector, views);
    }
  }
}

// LINEMOD's views have the object in the middle; seen elsewhere it is turned towards the camera.
LinemodObject object_of(const cv::linemod::Match& match, const LinemodView& view,
                        const Intrinsics& lens) {
  const Eigen::Vector3d ray =
      lens.point_camera(match.x + view.centre_px.x, match.y + view.centre_px.y, 1);
  const Eigen::Matrix3d towards =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), ray).toRotationMatrix();
  return {match.class_id, view.silhouette_px + cv::Point(match.x, match.y), match.similarity,
          towards * view.camera_from_object, view.distance * ray};
}

bool are_alike(int hue, int other) {
  constexpr int kMostOff = 10;  // half degrees; red and orange are 13 apart
  if (hue == kNoHue || other == kNoHue) return hue == other;
  const int off = std::abs(hue - other);
  return std::min(off, 180 - off) <= kMostOff;
}

bool has_colours(const cv::Mat& hues, const cv::linemod::Match& match, const LinemodView& view) {
  constexpr double kLeastShare = 0.7;  // views lie up to 10 degrees from the next template's
  int right = 0;
  for (const LinemodHue& sample : view.hues) {
    const cv::Point pixel(match.x + sample.x_px, match.y + sample.y_px);
    if (cv::Rect({}, hues.size()).contains(pixel) &&
        are_alike(hues.at<std::uint8_t>(pixel), sample.hue))
      ++right;
  }
  return right >= kLeastShare * static_cast<double>(view.hues.size());
}

bool are_apart(const cv::Rect& a, const cv::Rect& b) {
  return 2 * (a & b).area() <= std::min(a.area(), b.area());
}

}  // namespace

LinemodModel linemod_model(const std::vector<Scene>& scenes, const Intrinsics& lens,
                           const LinemodSampling& sampling) {
  std::vector<cv::Ptr<Detector>> detectors;
  std::vector<std::vector<LinemodView>> views(scenes.size());
  for (std::size_t k = 0; k < scenes.size(); ++k) detectors.push_back(empty_detector(sampling));
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t k = next++; k < scenes.size(); k = next++)
      add_object(scenes[k], lens, sampling, *detectors[k], views[k]);
  };
  std::thread other(work);
  work();
  other.join();
  LinemodModel model{empty_detector(sampling), {}};
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const std::string& name = scenes[k].name;
    for (int id = 0; id < detectors[k]->numTemplates(); ++id)
      model.detector->addSyntheticTemplate(detectors[k]->getTemplates(name, id), name);
    detectors[k].release();
    model.views[name] = std::move(views[k]);
  }
  return model;
}

std::vector<LinemodObject> linemod_objects(const LinemodModel& model,
                                           const std::vector<cv::linemod::Match>& matches,
                                           const cv::Mat& picture, const Intrinsics& lens,
                                           bool test_colours) {
  const cv::Mat hues = test_colours ? hues_of(picture, cv::COLOR_BGR2HSV) : cv::Mat();
  std::vector<LinemodObject> objects;
  for (const cv::linemod::Match& match : matches) {
    const LinemodView& view =
        model.views.at(match.class_id)[static_cast<std::size_t>(match.template_id)];
    const cv::Rect box = view.silhouette_px + cv::Point(match.x, match.y);
    if (std::all_of(objects.begin(), objects.end(),
                    [&](const LinemodObject& object) { return are_apart(object.box_px, box); }) &&
        (!test_colours || has_colours(hues, match, view)))
      objects.push_back(object_of(match, view, lens));
  }
  return objects;
}

cv::Mat linemod_padded(const cv::Mat& picture, const std::vector<int>& spread_px) {
  int multiple = 1;
  for (std::size_t level = 0; level < spread_px.size(); ++level)
    multiple = std::lcm(multiple, spread_px[level] << level);
  const auto missing = [&](int size) { return (multiple - size % multiple) % multiple; };
  cv::Mat padded;
  cv::copyMakeBorder(picture, padded, 0, missing(picture.rows), 0, missing(picture.cols),
                     cv::BORDER_REPLICATE);
  return padded;
}

}  // namespace aspect
