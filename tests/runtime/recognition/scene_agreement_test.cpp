// A box painted into a picture by plain loops, with this and that before and around it.
#include "runtime/recognition/scene_agreement.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "runtime/base/planned_memory.h"
#include "tests/runtime/recognition/painted_box.h"

namespace aspect {
namespace {

constexpr int kWidth_px = 320, kHeight_px = 240, kCells = 40;
const CameraModel kCamera{400, 410, 160, 120, 0, 0, 0, 0, 0};
using Rgb = std::array<std::uint8_t, 3>;
constexpr Rgb kBlack{0, 0, 0};
constexpr Rgb kGrey{120, 120, 120};
constexpr Rgb kPaper{160, 150, 140};

const PaintedModel& painted() {
  static const PaintedModel box = painted_box(1, 0.6, 0.4);
  return box;
}

const ObjectModel& model() {
  static const ObjectModel box = prepared_model(painted(), 3, 60);
  return box;
}

// Three faces are seen from there, two, and one.
RigidPose corner_pose() {
  return {turn_about({1, 0, 0}, 0.6) * turn_about({0, 1, 0}, 0.7), {0.1, 0, 5}};
}
RigidPose edge_pose() {
  return {turn_about({0, 1, 0}, 1.1), {0, 0, 5}};
}
const RigidPose kFacePose{{}, {0, 0, 5}};

// Pixels, and one region for each of their colours but black.
class Picture {
 public:
  explicit Picture(const Rgb& background) { fill({0, 0, kWidth_px, kHeight_px}, background); }

  void fill(const Box& box, const Rgb& colour) {
    for (int y = box.y; y < box.y + box.height; ++y)
      for (int x = box.x; x < box.x + box.width; ++x) at(x, y) = colour;
  }

  // The box is convex: its faces that are turned to the camera hide none of each other.
  void paint(const RigidPose& pose, const PaintedModel& box = painted()) {
    for (std::size_t f = 0; f < kBoxFaces.size(); ++f) {
      std::array<Point2d, 4> p;
      for (std::size_t k = 0; k < 4; ++k) {
        const Vector3d q = pose(box.vertices[kBoxFaces[f][k]]);
        p[k] = {kCamera.cx_px + kCamera.fx_px * q[0] / q[2],
                kCamera.cy_px + kCamera.fy_px * q[1] / q[2]};
      }
      if (!is_turned_away(pose, f)) paint(p, box.paints[f]);
    }
  }

  SeenColours seen() {
    labels_.assign(pixels_.size(), 0);
    regions_.clear();
    std::vector<Rgb> colours;
    for (std::size_t k = 0; k < pixels_.size(); ++k) {
      const Rgb& colour = pixels_[k];
      for (std::size_t c = 0; c < 3; ++c) planes_[c].push_back(colour[c]);
      if (colour == kBlack) continue;
      const auto found = std::find(colours.begin(), colours.end(), colour);
      const auto place = static_cast<std::size_t>(found - colours.begin());
      if (found == colours.end()) {
        colours.push_back(colour);
        regions_.emplace_back().mean_rgb = {static_cast<float>(colour[0]),
                                            static_cast<float>(colour[1]),
                                            static_cast<float>(colour[2])};
      }
      ++regions_[place].sums.area;
      labels_[k] = static_cast<std::uint16_t>(place + 1);
    }
    map_.labels = labels_;
    map_.stride_px = kWidth_px;
    map_.active = {0, 0, kWidth_px, kHeight_px};
    map_.regions = regions_;
    shown_ = {planes_[0], planes_[1], planes_[2], kWidth_px, map_.active};
    SeenColours seen;
    seen.look(map_, shown_, SeenColours::kAllBlobs, model(), {});
    return seen;
  }

 private:
  Rgb& at(int x, int y) { return pixels_[static_cast<std::size_t>(y * kWidth_px + x)]; }

  static bool is_turned_away(const RigidPose& pose, std::size_t face) {
    Vector3d middle{};
    for (const std::uint16_t corner : kBoxFaces[face])
      middle = middle + 0.25 * painted().vertices[corner];
    // From the box's middle to the face's: its normal, as a box has them.
    return dot(pose.rotation(middle), pose(middle)) >= 0;
  }

  void paint(const std::array<Point2d, 4>& p, const Rgb& colour) {
    for (int y = 0; y < kHeight_px; ++y)
      for (int x = 0; x < kWidth_px; ++x) {
        int left = 0, right = 0;
        for (std::size_t k = 0; k < 4; ++k) {
          const Point2d &a = p[k], &b = p[(k + 1) % 4];
          const double side = (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
          ++(side > 0 ? left : right);
        }
        if (left == 0 || right == 0) at(x, y) = colour;
      }
  }

  std::vector<Rgb> pixels_ = std::vector<Rgb>(std::size_t{kWidth_px} * kHeight_px);
  std::array<std::vector<std::uint8_t>, 3> planes_;
  std::vector<std::uint16_t> labels_;
  std::vector<Region> regions_;
  RegionMap map_;
  Planes shown_;
};

class Drawer {
 public:
  explicit Drawer(const RigidPose& pose, const ObjectModel& drawn = model()) {
    memory_.plan([&](Arena& arena) { drawing_.prepare(arena, drawn.vertices.size()); });
    is_drawn = drawing_.draw_alone(drawn, pose, kCamera, kWidth_px, kHeight_px, kCells);
  }

  SceneAgreement in(Picture& picture, float borders_met = 1, const Labels& of_others = {}) const {
    const SeenColours seen = picture.seen();
    return scene_agreement(drawing_, kCamera, seen, kWidth_px, kHeight_px, borders_met, of_others);
  }

  // The share of the drawn cells whose centres lie in a part of the picture.
  float share_in(const Box& box) const {
    int inside = 0, all = 0;
    for (int row = 0; row < drawing_.height(); ++row)
      for (int column = 0; column < drawing_.width(); ++column) {
        if (!drawing_.cell(column, row).covered) continue;
        const float x = drawing_.x_px(column), y = drawing_.y_px(row);
        ++all;
        inside += x >= static_cast<float>(box.x) && y >= static_cast<float>(box.y) &&
                          x < static_cast<float>(box.x + box.width) &&
                          y < static_cast<float>(box.y + box.height)
                      ? 1
                      : 0;
      }
    return static_cast<float>(inside) / static_cast<float>(all);
  }

  bool is_drawn = false;

 private:
  PlannedMemory memory_;
  ModelDrawing drawing_;
};

SceneAgreement of_whole(const RigidPose& pose, const Rgb& background) {
  Picture picture(background);
  picture.paint(pose);
  return Drawer(pose).in(picture);
}

// What the rims of cells may lose.
constexpr float kRims = 0.03F;

}  // namespace

TEST_CASE("all of an object that is seen scores one, before whatever it stands") {
  for (const Rgb& background : {kBlack, kGrey, kPaper}) {
    const SceneAgreement agreement = of_whole(corner_pose(), background);
    CHECK(agreement.score == Approx(1).margin(kRims));
    CHECK(agreement.inside == 1);
    CHECK(agreement.colours == 3);
  }
}

TEST_CASE("the more colours are seen the more the score is above what is needed; one never is") {
  const SceneAgreement one = of_whole(kFacePose, kGrey), two = of_whole(edge_pose(), kGrey),
                       three = of_whole(corner_pose(), kGrey);
  REQUIRE((one.colours == 1 && two.colours == 2 && three.colours == 3));
  CHECK(one.score == Approx(1).margin(kRims));
  CHECK(one.margin < 0);
  CHECK(two.margin >= 0);
  CHECK(three.margin > two.margin + 0.1F);
}

TEST_CASE("borders that are met tell for the object") {
  Picture picture(kGrey);
  picture.paint(edge_pose());
  const Drawer drawer(edge_pose());
  CHECK(drawer.in(picture, 1).margin > 0);
  CHECK(drawer.in(picture, 0.5F).margin < drawer.in(picture, 1).margin - 0.05F);
  CHECK(drawer.in(picture, 0.2F).margin < 0);
  CHECK(drawer.in(picture, 0.2F).score == drawer.in(picture, 1).score);
}

TEST_CASE("regions are explained by what shows most of them, and then no longer tell for others") {
  Picture picture(kGrey);
  picture.paint(corner_pose());
  const Drawer drawer(corner_pose());
  const SceneAgreement first = drawer.in(picture);
  CHECK(first.explained.count() == 3);
  const SceneAgreement again = drawer.in(picture, 1, first.explained);
  CHECK(again.margin < 0);
  CHECK(again.colours == 0);
  CHECK(again.explained.none());
}

TEST_CASE("the box is what is drawn") {
  const SceneAgreement agreement = of_whole(kFacePose, kGrey);
  // The face in front, at a depth of 4.6.
  const double half_width = 400 / 4.6, half_height = 410 * 0.6 / 4.6;
  CHECK(agreement.box.x == Approx(160 - half_width).margin(5));
  CHECK(agreement.box.y == Approx(120 - half_height).margin(5));
  CHECK(agreement.box.width == Approx(2 * half_width).margin(8));
  CHECK(agreement.box.height == Approx(2 * half_height).margin(8));
}

TEST_CASE("hidden by what goes on beyond the outline, the score is little above the share seen") {
  constexpr float kLittle = 0.12F;
  const RigidPose pose = corner_pose();
  const Drawer drawer(pose);
  for (const Rgb& background : {kGrey, kBlack}) {
    float before = 0;
    for (const int begin_px : {150, 165, 180}) {
      Picture picture(background);
      picture.paint(pose);
      picture.fill({begin_px, 0, kWidth_px - begin_px, kHeight_px}, kPaper);
      const float visible = drawer.share_in({0, 0, begin_px, kHeight_px});
      REQUIRE((visible > 0.3F && visible < 0.8F));
      const SceneAgreement agreement = drawer.in(picture);
      CHECK(agreement.score > std::max(before, visible - kRims));
      CHECK(agreement.score < visible + kLittle);
      CHECK(agreement.inside == 1);
      before = agreement.score;
    }
  }
}

TEST_CASE("what ends within the outline, or is as black as nothing, tells against the object") {
  const RigidPose pose = corner_pose();
  const Drawer drawer(pose);
  const Box patch{130, 95, 60, 45};
  const float hidden = drawer.share_in(patch);
  REQUIRE((hidden > 0.1F && hidden < 0.5F));
  for (const Rgb& colour : {kPaper, kBlack}) {
    Picture picture(kGrey);
    picture.paint(pose);
    picture.fill(patch, colour);
    const SceneAgreement agreement = drawer.in(picture);
    CHECK(agreement.score < 1 - hidden - 0.3F * hidden);
    CHECK(agreement.score > 1 - 2 * hidden - kRims);
  }
}

TEST_CASE("a face that must be black and shows a colour that ends there tells against the object") {
  PaintedModel painted_black = painted();
  painted_black.paints.back() = {0, 0, 0};
  const RigidPose pose = corner_pose();
  const ObjectModel black_face = prepared_model(painted_black, 3, 60);
  const Drawer drawer(pose, black_face);
  Picture coloured(kGrey), black(kGrey);
  coloured.paint(pose);
  black.paint(pose, painted_black);
  const SceneAgreement with_colour = drawer.in(coloured), with_black = drawer.in(black);
  CHECK(with_black.colours == 2);
  REQUIRE((of_whole(pose, kGrey).colours == 3));
  CHECK(with_black.score == Approx(1).margin(kRims));
  CHECK(with_colour.score < with_black.score - 0.05F);
  CHECK(with_colour.score > 0);
}

TEST_CASE("what goes on beyond the outline in the object's own colour tells against it") {
  Picture picture(painted().paints[0]);
  picture.paint(kFacePose);
  const float in_own = Drawer(kFacePose).in(picture).score;
  CHECK(in_own < 0.7F);
  CHECK(of_whole(kFacePose, painted().paints[1]).score == Approx(1).margin(kRims));
}

TEST_CASE("an object cut by the picture's border counts as far as it lies within") {
  for (const double shift : {-2.2, -1.9, 1.8, 2.1}) {
    RigidPose pose = corner_pose();
    pose.translation[0] += shift;
    Picture picture(kGrey);
    picture.paint(pose);
    const Drawer drawer(pose);
    const SceneAgreement agreement = drawer.in(picture);
    const float within = drawer.share_in({0, 0, kWidth_px, kHeight_px});
    REQUIRE((within > 0.1F && within < 0.95F));
    CHECK(agreement.inside == Approx(static_cast<double>(within)).margin(kRims));
    CHECK(agreement.score == Approx(1).margin(2 * kRims));
    CHECK((agreement.box.x >= 0 && agreement.box.x + agreement.box.width <= kWidth_px));
    CHECK((agreement.box.y >= 0 && agreement.box.y + agreement.box.height <= kHeight_px));
    if (within < 0.4F) CHECK(agreement.margin < 0);
  }
}

TEST_CASE("what is not drawn, or not in the picture, is not there") {
  Picture picture(kGrey);
  RigidPose beside = corner_pose();
  beside.translation[0] += 3.6;
  const Drawer outside(beside);
  CHECK(outside.is_drawn);
  CHECK(outside.in(picture).margin < 0);
  CHECK(outside.in(picture).inside == 0);
  RigidPose far_away = corner_pose();
  far_away.translation[0] += 30;
  CHECK_FALSE(Drawer(far_away).is_drawn);
  PaintedModel dark = painted();
  for (auto& paint : dark.paints) paint = {2, 2, 2};
  CHECK(Drawer(corner_pose(), prepared_model(dark, 3, 60)).in(picture).margin < 0);
  // Drawn where it is not.
  CHECK(Drawer(corner_pose()).in(picture).margin < 0);
}

}  // namespace aspect
