#include "tools/report/aspect_views.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgcodecs.hpp>

#include "compiler/aspects/observer.h"
#include "compiler/index/index_budget.h"
#include "runtime/service/recognition_json.h"
#include "tools/draw/frame_canvas.h"

namespace aspect {
namespace {

constexpr int kMargin_px = 6;
constexpr double kOutlineError_px = 0.75;

std::string name_of(std::uint16_t contour) {
  std::array<char, 4> buffer;
  return std::string(contour_name(contour, buffer));
}

// Centres of the border's pixels.
PixelLine border_of(const Contour& contour, const Box& box) {
  constexpr std::array<std::array<int, 2>, 8> kSteps = {
      {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
  PixelLine line;
  int x = contour.start_x, y = contour.start_y;
  for (const std::uint8_t code : contour.chain) {
    line.push_back({x - box.x, y - box.y});
    x += kSteps[code % 8U][0];
    y += kSteps[code % 8U][1];
  }
  if (line.empty()) line.push_back({x - box.x, y - box.y});
  return line;
}

Box with_margin(const Box& box, int width_px, int height_px) {
  const int left = std::max(box.x - kMargin_px, 0), top = std::max(box.y - kMargin_px, 0);
  const int right = std::min(box.x + box.width + kMargin_px, width_px);
  const int bottom = std::min(box.y + box.height + kMargin_px, height_px);
  Box cut = box;
  cut.x = left;
  cut.y = top;
  cut.width = right - left;
  cut.height = bottom - top;
  return cut;
}

// The object's part of the last picture.
Box seen_part(const Observer& observer) {
  const Frame& frame = observer.frame();
  Box box = observer.picture().foreground;
  if (!observer.graph().blobs.empty()) box = observer.graph().blobs.front().box;
  if (box.width <= 0 || box.height <= 0) {
    box.x = box.y = 0;
    box.width = frame.width_px;
    box.height = frame.height_px;
  }
  return with_margin(box, frame.width_px, frame.height_px);
}

SeenView picture_of_last(const Observer& observer, const Eigen::Vector3d& direction) {
  const Box box = seen_part(observer);
  SeenView seen;
  seen.direction = direction;
  seen.left_px = box.x;
  seen.top_px = box.y;
  seen.width_px = box.width;
  seen.height_px = box.height;
  const cv::Mat cut = picture_of(observer.frame())(cv::Rect(box.x, box.y, box.width, box.height));
  cv::imencode(".png", cut, seen.png, {cv::IMWRITE_PNG_COMPRESSION, 9});
  return seen;
}

// `names` are those of the view's external contours, in their order.
SeenView seen_view(Observer& observer, const Eigen::Vector3d& direction,
                   const std::vector<std::uint8_t>& names) {
  observer.observe(direction);
  SeenView seen = picture_of_last(observer, direction);
  const Box box = seen_part(observer);
  std::size_t place = 0;
  for (const Contour& contour : observer.graph().contours) {
    if (!contour.external || place == names.size()) continue;
    const Point2 label = label_point(contour, observer.regions());
    seen.contours.push_back(
        {name_of(names[place]),
         simplified(border_of(contour, box), kOutlineError_px),
         {label.x - static_cast<float>(box.x), label.y - static_cast<float>(box.y)}});
    ++place;
  }
  return seen;
}

double distance_from_line(const std::array<int, 2>& p, const std::array<int, 2>& a,
                          const std::array<int, 2>& b) {
  const double x = b[0] - a[0], y = b[1] - a[1], length = std::hypot(x, y);
  if (length == 0) return std::hypot(p[0] - a[0], p[1] - a[1]);
  return std::abs(x * (p[1] - a[1]) - y * (p[0] - a[0])) / length;
}

// Marks what is kept between two points that are.
void keep_far(const PixelLine& line, std::size_t from, std::size_t to, double most_px,
              std::vector<bool>& kept) {
  std::size_t farthest = from;
  double most = most_px;
  for (std::size_t k = from + 1; k < to; ++k) {
    const double distance = distance_from_line(line[k], line[from], line[to % line.size()]);
    if (distance <= most) continue;
    most = distance;
    farthest = k;
  }
  if (farthest == from) return;
  kept[farthest] = true;
  keep_far(line, from, farthest, most_px, kept);
  keep_far(line, farthest, to, most_px, kept);
}

struct Wanted {
  std::size_t aspect = 0, view = 0;  // of the cluster's views
  bool is_in_index = false;
};

std::vector<Wanted> wanted_views(const LearntModel& model, std::size_t most) {
  const IndexStatistics& index = model.index.statistics.index;
  const auto radians = [](double degrees) { return degrees * std::numbers::pi / 180; };
  std::vector<Wanted> wanted;
  for (std::size_t aspect = 0; aspect < model.clusters.size(); ++aspect) {
    const std::size_t typical = model.classes[aspect].typical_view;
    const auto chosen = choose_key_views(model.subdivision, model.clusters[aspect], typical,
                                         radians(kFinestKeyViewSpacing_deg));
    // A wider spacing stops earlier in the same order.
    std::size_t held = 0;
    if (aspect < index.classes)
      held = choose_key_views(model.subdivision, model.clusters[aspect], typical,
                              radians(index.key_view_spacing_deg))
                 .size();
    for (std::size_t k = 0; k < std::min(most, chosen.size()); ++k)
      wanted.push_back({aspect, chosen[k], k < held});
  }
  return wanted;
}

}  // namespace

PixelLine simplified(const PixelLine& line, double most_px) {
  if (line.size() < 4) return line;
  std::size_t far = 0;
  double most = -1;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const double distance = std::hypot(line[k][0] - line[0][0], line[k][1] - line[0][1]);
    if (distance <= most) continue;
    most = distance;
    far = k;
  }
  std::vector<bool> kept(line.size(), false);
  kept[0] = kept[far] = true;
  keep_far(line, 0, far, most_px, kept);
  keep_far(line, far, line.size(), most_px, kept);
  PixelLine fewer;
  for (std::size_t k = 0; k < line.size(); ++k)
    if (kept[k]) fewer.push_back(line[k]);
  return fewer;
}

std::vector<std::vector<SeenView>> aspect_views(const LearntModel& model, const Scene& scene,
                                                const Renderer& renderer,
                                                const CompileOptions& options, std::size_t most) {
  const std::vector<Wanted> wanted = wanted_views(model, most);
  std::vector<SeenView> seen(wanted.size());
  tbb::enumerable_thread_specific<Observer> observers(
      [&] { return Observer(renderer, scene.studio, options.vision); });
  tbb::parallel_for(std::size_t{0}, wanted.size(), [&](std::size_t k) {
    const ClusterView& view = model.clusters[wanted[k].aspect].views[wanted[k].view];
    seen[k] = seen_view(observers.local(), model.subdivision.direction(view.vertex), view.names);
    seen[k].is_in_index = wanted[k].is_in_index;
  });
  std::vector<std::vector<SeenView>> views(model.clusters.size());
  for (std::size_t k = 0; k < wanted.size(); ++k)
    views[wanted[k].aspect].push_back(std::move(seen[k]));
  return views;
}

SeenView picture_from(const Eigen::Vector3d& direction, const Studio& studio,
                      const Renderer& renderer, const VisionParameters& vision) {
  Observer observer(renderer, studio, vision);
  observer.observe(direction);
  return picture_of_last(observer, direction);
}

}  // namespace aspect
