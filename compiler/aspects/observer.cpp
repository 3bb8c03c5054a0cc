#include "compiler/aspects/observer.h"

#include <algorithm>
#include <map>

namespace aspect {
namespace {

// What the pixels of one region add up to.
struct RegionPoints {
  double x = 0, y = 0, z = 0;  // camera coordinates
  double pixels = 0;
  std::map<std::uint16_t, std::uint32_t> surfaces;
};

// Pixels of one run that show the same surface: sums of whole numbers and depths, brought to camera
// coordinates once.
void add_stretch(int begin, int end, const float* depths, double slope_y, const Intrinsics& camera,
                 RegionPoints& points) {
  double depth_sum = 0, column_sum = 0;
  const bool orthogonal = camera.projection == Projection::kOrthogonal;
  for (int x = begin; x < end; ++x) {
    const auto depth = static_cast<double>(depths[x]);
    depth_sum += depth;
    column_sum += (x - camera.cx_px) * (orthogonal ? 1 : depth);
  }
  const double pixels = end - begin;
  points.x += column_sum / camera.fx_px;
  points.y += slope_y * (orthogonal ? pixels : depth_sum);
  points.z += depth_sum;
  points.pixels += pixels;
}

void add_run(const Run& run, const Picture& picture, const Intrinsics& camera,
             RegionPoints& points) {
  const std::size_t row =
      static_cast<std::size_t>(run.row) * static_cast<std::size_t>(picture.width_px);
  const std::uint16_t* surfaces = picture.surface.data() + row;
  const double slope_y = (run.row - camera.cy_px) / camera.fy_px;
  for (int begin = run.begin, end = begin; begin < run.end; begin = end) {
    while (end < run.end && surfaces[end] == surfaces[begin]) ++end;
    if (surfaces[begin] == 0) continue;
    points.surfaces[surfaces[begin]] += static_cast<std::uint32_t>(end - begin);
    add_stretch(begin, end, picture.depth.data() + row, slope_y, camera, points);
  }
}

}  // namespace

Observer::Observer(const Renderer& renderer, const Studio& studio,
                   const VisionParameters& parameters)
    : renderer_(&renderer),
      studio_(studio),
      parameters_(parameters),
      sensor_(make_sensor(parameters)) {
  parameters_.one_blob = true;
  parameters_.range.field_of_view_deg = static_cast<float>(studio.angle_deg);
  memory_.plan([&](Arena& arena) {
    vision_.prepare(arena, studio.width_px, studio.height_px, parameters.sensor);
  });
}

ObservedView Observer::observe(const Eigen::Vector3d& direction) {
  ObservedView view = observe(camera_at(studio_, direction));
  view.direction = direction;
  return view;
}

ObservedView Observer::observe(const Camera& camera) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  renderer_->render(camera, picture_);
  const auto rendered = Clock::now();
  render_time_ += rendered - start;
  frame_ = sensor_->frame_of(picture_);
  parameters_.region_of_interest = picture_.foreground;
  graph_ = vision_.run(frame_, parameters_);
  ObservedView view;
  view.direction = (camera.position_object - studio_.at).normalized();
  view.right = camera.camera_from_object.row(0);
  if (!graph_.blobs.empty()) {
    const Blob& blob = graph_.blobs.front();
    view.area_px = blob.area_px;
    for (const Contour& contour : graph_.contours) {
      ObservedContour observed;
      observed.feature = feature_of(contour, blob);
      observed.external = contour.external;
      observed.shape = contour.shape;
      observed.area_px = contour.area_px;
      view.contours.push_back(std::move(observed));
    }
    locate_contours(camera, view);
  }
  feature_time_ += Clock::now() - rendered;
  return view;
}

void Observer::locate_contours(const Camera& camera, ObservedView& view) {
  const RegionMap& map = vision_.regions();
  std::vector<RegionPoints> points(map.regions.size() + 1);
  for (const Run& run : map.runs)
    if (run.label != 0) add_run(run, picture_, camera.intrinsics, points[run.label]);
  for (std::size_t i = 0; i < view.contours.size(); ++i) {
    const RegionPoints& region = points[graph_.contours[i].region];
    ObservedContour& contour = view.contours[i];
    const Eigen::Vector3d centre_camera =
        Eigen::Vector3d(region.x, region.y, region.z) / std::max(region.pixels, 1.0);
    const Eigen::Vector3d centre =
        camera.camera_from_object.transpose() * centre_camera + camera.position_object;
    for (int axis = 0; axis < 3; ++axis)
      contour.centre_object[static_cast<std::size_t>(axis)] = static_cast<float>(centre[axis]);
    for (const auto& [surface, pixels] : region.surfaces)
      contour.surfaces.push_back({surface, pixels});
  }
  // External contours first: they are the nodes that matching works with.
  std::vector<std::uint16_t> place(view.contours.size());
  std::vector<ObservedContour> sorted;
  for (const bool external : {true, false}) {
    for (std::size_t i = 0; i < view.contours.size(); ++i) {
      if (view.contours[i].external != external) continue;
      place[i] = static_cast<std::uint16_t>(sorted.size());
      sorted.push_back(std::move(view.contours[i]));
    }
    if (external) view.external_count = sorted.size();
  }
  view.contours = std::move(sorted);
  for (const Relation& relation : graph_.relations) {
    Relation moved = relation;
    moved.from = place[relation.from];
    moved.to = place[relation.to];
    if (moved.from < view.external_count && moved.to < view.external_count)
      view.relations.push_back(moved);
  }
}

}  // namespace aspect
