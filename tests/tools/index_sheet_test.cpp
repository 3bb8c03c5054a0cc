#include "tools/draw/index_sheet.h"

#include <catch2/catch.hpp>
#include <map>
#include <numeric>

#include "tests/runtime/recognition/painted_box.h"
#include "tools/draw/class_tile.h"
#include "tools/draw/model_picture.h"
#include "tools/draw/paper.h"

namespace aspect {
namespace {

using Bgr = std::array<std::uint8_t, 3>;

// How often each colour is there.
std::map<Bgr, int> colours_in(const cv::Mat& picture) {
  std::map<Bgr, int> count;
  for (int y = 0; y < picture.rows; ++y)
    for (int x = 0; x < picture.cols; ++x) {
      const auto& p = picture.at<cv::Vec3b>(y, x);
      ++count[{p[0], p[1], p[2]}];
    }
  return count;
}

Bgr paint_of(std::size_t face) {
  const auto rgb = painted_box(1, 1, 1).paints[face];
  return {rgb[2], rgb[1], rgb[0]};
}

// A class that sees the box from there, with a key view of a contour in its middle.
void add_class(ClassIndex& index, const Vector3& view, float share,
               const std::array<float, 3>& colour) {
  AspectClass& aspect = index.classes.emplace_back();
  aspect.view = view;
  aspect.area_fraction = share;
  aspect.contours = {static_cast<std::uint32_t>(index.class_contours.size()), 1};
  index.class_contours.push_back({{}, {}, colour, {}});
  aspect.key_views = {static_cast<std::uint32_t>(index.key_views.size()), 1};
  index.key_views.push_back({view, {static_cast<std::uint32_t>(index.key_contours.size()), 1}});
  KeyContour& contour = index.key_contours.emplace_back();
  contour.feature.share = colour;
  contour.feature.area = 1;
  contour.feature.moments = {1.0F / 12, 0, 1.0F / 12, 0, 0, 0, 0};  // of a square
}

std::array<float, 3> shares_of(std::size_t face) {
  const auto rgb = painted_box(1, 1, 1).paints[face];
  const float sum = static_cast<float>(rgb[0] + rgb[1] + rgb[2]);
  return {static_cast<float>(rgb[0]) / sum, static_cast<float>(rgb[1]) / sum,
          static_cast<float>(rgb[2]) / sum};
}

// Seen from straight before its faces.
ClassIndex box_index(std::size_t classes) {
  constexpr std::array<Vector3, 6> kTowards = {
      {{0, 0, -1}, {0, 0, 1}, {0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}}};
  ClassIndex index;
  index.object = "box";
  index.field_of_view_deg = 45;
  index.model = prepared_model(painted_box(1, 0.8, 0.6), 3, 60);
  for (std::size_t k = 0; k < classes; ++k)
    add_class(index, kTowards[k % 6], 0.9F / static_cast<float>(classes + k), shares_of(k % 6));
  return index;
}

}  // namespace

TEST_CASE("Seen from straight before a face, the model is that face in its very colour") {
  const ClassIndex index = box_index(6);
  for (std::size_t face = 0; face < 6; ++face) {
    CAPTURE(face);
    const auto& view = index.classes[face].view;
    const ModelPicture drawn = model_picture(
        index.model,
        {static_cast<double>(view[0]), static_cast<double>(view[1]), static_cast<double>(view[2])},
        45, 120);
    const auto colours = colours_in(drawn.picture);
    CHECK(colours.at(paint_of(face)) > 0.9 * cv::countNonZero(drawn.covered));
    for (std::size_t other = 0; other < 6; ++other)
      if (other != face) CHECK(colours.count(paint_of(other)) == 0);
    // A pinhole's picture of a rectangle, by the box's sides and the distance that holds its ball.
    const double radius = std::sqrt(1 + 0.64 + 0.36);
    const std::array<double, 3> half = {1, 0.8, 0.6};
    const std::size_t along = 2 - face / 2;
    const double depth = 1.04 / std::sin(CV_PI / 8) - half[along] / radius;
    double area_px = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (axis != along) area_px *= 2 * half[axis] / radius / depth * 60 / std::tan(CV_PI / 8);
    CHECK(cv::countNonZero(drawn.covered) == Approx(area_px).epsilon(0.06));
  }
}

TEST_CASE("A sheet has a tile a class, the largest first, each in the colours of what it shows") {
  const ClassIndex index = box_index(14);
  const IndexSheet sheet = index_sheet({&index, 1});
  CHECK(sheet.shown == 14);
  CHECK(sheet.classes == 14);
  REQUIRE(sheet.tiles.size() == 14);
  const std::vector<std::size_t> order = largest_first(index);
  for (std::size_t k = 0; k < sheet.tiles.size(); ++k) {
    CAPTURE(k);
    CHECK(order[k] == k);  // they were made smaller and smaller
    auto colours = colours_in(sheet.picture(sheet.tiles[k]));
    colours.erase({static_cast<std::uint8_t>(kPaper[0]), static_cast<std::uint8_t>(kPaper[1]),
                   static_cast<std::uint8_t>(kPaper[2])});
    const auto most =
        std::max_element(colours.begin(), colours.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    CHECK(most->first == paint_of(k % 6));
    for (std::size_t other = 0; other < k; ++other)
      CHECK((sheet.tiles[k] & sheet.tiles[other]).empty());
  }
}

TEST_CASE("Of too many classes the largest of the objects that have the most are left out last") {
  std::vector<ClassIndex> indexes = {box_index(3), box_index(700), box_index(900)};
  for (ClassIndex& index : indexes) index.model = {};  // ellipses are drawn faster
  const IndexSheet sheet = index_sheet(indexes);
  CHECK(sheet.classes == 1603);
  CHECK(sheet.shown <= kMostTiles);
  CHECK(sheet.shown + 2 >= kMostTiles);
  CHECK(sheet.picture.cols < 6000);
  CHECK(sheet.picture.rows < 12000);
}

TEST_CASE("Without a model a contour is an ellipse of its size and colour") {
  ClassIndex index = box_index(1);
  index.model = {};
  const cv::Mat tile = class_tile(index, index.classes[0], 200);
  // Area of the ellipse with a square's moments: (4 / sqrt(12))^2 / 4 * pi of it, which is 100 px.
  const auto colours = colours_in(tile);
  const Bgr shown = {23, 23, 230};  // 20 : 20 : 200, its largest share at 230
  REQUIRE(colours.count(shown) == 1);
  CHECK(colours.at(shown) == Approx(100 * 100 * CV_PI / 3).epsilon(0.1));
}

TEST_CASE("Numbers that no object has are drawn without harm") {
  ClassIndex index = box_index(2);
  index.key_contours[0].feature.position = {1e30F, -1e30F};
  index.key_contours[1].feature.moments = {-1e30F, 1e30F, 1e30F, 0, 0, 0, 0};
  index.classes[1].key_views.count = 0;
  index.classes[1].view = {0, 0, 0};
  index.field_of_view_deg = 1e30F;
  for (const double scale : {1.0, 1e-150, 1e150}) {
    for (Vector3d& vertex : index.model.vertices) vertex = scale * vertex;
    index.model.centre = {1e200, 0, 0};
    CHECK(index_sheet({&index, 1}).tiles.size() == 2);
  }
  index.model = {};
  CHECK(index_sheet({&index, 1}).tiles.size() == 2);
  index.classes.clear();
  CHECK(index_sheet({&index, 1}).tiles.empty());
}

}  // namespace aspect
