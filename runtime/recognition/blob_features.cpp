#include "runtime/recognition/blob_features.h"

#include <algorithm>
#include <cmath>

#include "runtime/recognition/seen_colours.h"
#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

constexpr std::uint16_t kLeastContact_px = 3;
constexpr std::uint8_t kNone = 255;
static_assert(kMaxSide < kNone);

std::span<const Contour> contours_of(const ViewGraph& graph, const Blob& blob) {
  return graph.contours.subspan(static_cast<std::size_t>(blob.first_contour),
                                static_cast<std::size_t>(blob.contour_count));
}

// By the tolerance between neighbouring pixels of one region, whose shares noise changes the more
// the darker they are.
bool is_alike(const Contour& a, const Contour& b, const VisionParameters& parameters) {
  const auto sum = [](const Contour& c) {
    return std::max(1.0F, c.mean_rgb[0] + c.mean_rgb[1] + c.mean_rgb[2]);
  };
  const std::array<float, 3> share_a = share_of(a.mean_rgb), share_b = share_of(b.mean_rgb);
  float difference = 0;
  for (std::size_t k = 0; k < 3; ++k)
    difference = std::max(difference, std::abs(share_a[k] - share_b[k]));
  constexpr float kFull = 255;
  return difference * kFull <=
         static_cast<float>(parameters.chroma_step) +
             static_cast<float>(parameters.noise_steps) * kFull / std::min(sum(a), sum(b));
}

// Sums of a contour's pixels about `origin_px`, up to the third order.
struct AreaSums {
  double area = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0, xxx = 0, xxy = 0, xyy = 0, yyy = 0;
  std::array<double, 3> rgb{};

  void add(const Contour& contour, const Point2& origin_px) {
    const auto a = static_cast<double>(contour.area_px);
    const double u = static_cast<double>(contour.centre_px.x - origin_px.x),
                 v = static_cast<double>(contour.centre_px.y - origin_px.y);
    const double second = a * a, third = second * std::sqrt(a);
    const Moments& m = contour.moments;
    const double m_xx = second * static_cast<double>(m.xx),
                 m_xy = second * static_cast<double>(m.xy),
                 m_yy = second * static_cast<double>(m.yy);
    area += a;
    x += a * u;
    y += a * v;
    xx += m_xx + a * u * u;
    xy += m_xy + a * u * v;
    yy += m_yy + a * v * v;
    xxx += third * static_cast<double>(m.xxx) + 3 * u * m_xx + a * u * u * u;
    xxy += third * static_cast<double>(m.xxy) + 2 * u * m_xy + v * m_xx + a * u * u * v;
    xyy += third * static_cast<double>(m.xyy) + 2 * v * m_xy + u * m_yy + a * u * v * v;
    yyy += third * static_cast<double>(m.yyy) + 3 * v * m_yy + a * v * v * v;
    for (std::size_t k = 0; k < 3; ++k) rgb[k] += a * static_cast<double>(contour.mean_rgb[k]);
  }

  // What a feature needs of the contour that all would be together.
  Contour together(const Point2& origin_px) const {
    const double u = x / area, v = y / area;
    const double second = area * area, third = second * std::sqrt(area);
    Contour contour;
    contour.area_px = static_cast<float>(area);
    contour.centre_px = {origin_px.x + static_cast<float>(u), origin_px.y + static_cast<float>(v)};
    Moments& m = contour.moments;
    const double m_xx = xx - u * x, m_xy = xy - u * y, m_yy = yy - v * y;
    m.xx = static_cast<float>(m_xx / second);
    m.xy = static_cast<float>(m_xy / second);
    m.yy = static_cast<float>(m_yy / second);
    m.xxx = static_cast<float>((xxx - 3 * u * m_xx - u * u * x) / third);
    m.xxy = static_cast<float>((xxy - 2 * u * m_xy - v * m_xx - u * v * x) / third);
    m.xyy = static_cast<float>((xyy - 2 * v * m_xy - u * m_yy - u * v * y) / third);
    m.yyy = static_cast<float>((yyy - 3 * v * m_yy - v * v * y) / third);
    for (std::size_t k = 0; k < 3; ++k) contour.mean_rgb[k] = static_cast<float>(rgb[k] / area);
    return contour;
  }
};

// Which of a blob's features touch, and along how many pixels.
class Contacts {
 public:
  explicit Contacts(std::size_t count) : count_(count) {}

  void add(std::uint8_t a, std::uint8_t b, int length_px) {
    if (a == kNone || b == kNone || a == b) return;
    std::uint16_t& length = of(a, b);
    length = static_cast<std::uint16_t>(std::min(65535, length + length_px));
  }
  bool touch(std::size_t a, std::size_t b) const {
    return lengths_[std::min(a, b) * count_ + std::max(a, b)] >= kLeastContact_px;
  }

 private:
  std::uint16_t& of(std::size_t a, std::size_t b) {
    return lengths_[std::min(a, b) * count_ + std::max(a, b)];
  }
  std::size_t count_;
  std::array<std::uint16_t, kMaxSide * kMaxSide> lengths_{};
};

// Runs of regions come row by row, left to right.
void find_contacts(std::span<const Run> runs, const Box& box,
                   std::span<const std::uint8_t> place_of, Contacts& contacts) {
  const auto row = [&](int y) {
    return std::lower_bound(runs.begin(), runs.end(), y,
                            [](const Run& run, int at) { return run.row < at; });
  };
  auto above = row(box.y), below = above;
  const auto above_end = row(box.y + box.height);
  for (; above != above_end; ++above) {
    const std::uint8_t place = place_of[above->label];
    const auto next = above + 1;
    if (next != above_end && next->row == above->row && next->begin == above->end)
      contacts.add(place, place_of[next->label], 1);
    while (below != above_end && (below->row <= above->row ||
                                  (below->row == above->row + 1 && below->end <= above->begin)))
      ++below;
    for (auto other = below;
         other != above_end && other->row == above->row + 1 && other->begin < above->end; ++other)
      contacts.add(place, place_of[other->label],
                   std::min(above->end, other->end) - std::max(above->begin, other->begin));
  }
}

// By place, the lowest place of what it is taken together with.
using Groups = std::array<std::uint8_t, kMaxSide>;

void join(Groups& groups, std::size_t count, std::size_t a, std::size_t b) {
  const std::uint8_t from = std::max(groups[a], groups[b]), to = std::min(groups[a], groups[b]);
  std::replace(groups.begin(), groups.begin() + static_cast<std::ptrdiff_t>(count), from, to);
}

}  // namespace

void features_of(const ViewGraph& graph, std::size_t blob_place, BlobFeatures& out) {
  const Blob& blob = graph.blobs[blob_place];
  out.count = 0;
  for (const Contour& contour : contours_of(graph, blob)) {
    if (!contour.external || out.count == kMaxSide) continue;
    out.contours[out.count] = static_cast<std::uint16_t>(&contour - graph.contours.data());
    out.features[out.count++] = feature_of(contour, blob);
  }
}

bool join_alike(const ViewGraph& graph, const RegionMap& regions, std::size_t blob_place,
                const VisionParameters& parameters, BlobFeatures& out) {
  const Blob& blob = graph.blobs[blob_place];
  std::array<const Contour*, kMaxSide> parts;
  std::size_t count = 0;
  for (const Contour& contour : contours_of(graph, blob))
    if (contour.external && count < kMaxSide) parts[count++] = &contour;
  std::array<std::uint8_t, kMaxRegions + 1> place_of;
  place_of.fill(kNone);
  bool any = false;
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a + 1; b < count; ++b) {
      if (!is_alike(*parts[a], *parts[b], parameters)) continue;
      any = true;
      for (const std::size_t k : {a, b}) place_of[parts[k]->region] = static_cast<std::uint8_t>(k);
    }
  if (!any) return false;

  Contacts contacts(count);
  find_contacts(regions.runs, blob.box, place_of, contacts);
  Groups groups;
  for (std::size_t k = 0; k < count; ++k) groups[k] = static_cast<std::uint8_t>(k);
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a + 1; b < count; ++b)
      if (contacts.touch(a, b) && is_alike(*parts[a], *parts[b], parameters))
        join(groups, count, a, b);

  out.count = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (groups[k] != k) continue;
    AreaSums sums;
    const Contour* largest = parts[k];
    for (std::size_t other = k; other < count; ++other) {
      if (groups[other] != k) continue;
      sums.add(*parts[other], blob.centre_px);
      if (parts[other]->area_px > largest->area_px) largest = parts[other];
    }
    out.contours[out.count] = static_cast<std::uint16_t>(largest - graph.contours.data());
    out.features[out.count++] = feature_of(sums.together(blob.centre_px), blob);
  }
  return out.count < count;
}

}  // namespace aspect
