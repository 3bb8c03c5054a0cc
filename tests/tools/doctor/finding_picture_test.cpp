// Marks are held against OpenCV's projection of where the fault is.
#include "tools/doctor/finding_picture.h"

#include <catch2/catch.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "tests/temporary_folder.h"
#include "tests/tools/doctor/sick_meshes.h"
#include "tools/doctor/repair.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

struct Shown {
  Diagnosis diagnosis;
  std::vector<FindingLine> lines;
  FindingPicture picture;

  std::vector<MarkedPlace> marks_of(std::string_view code) const {
    std::vector<MarkedPlace> found;
    for (const FindingLine& line : lines)
      for (const MarkedPlace& mark : picture.marks)
        if (line.code == code && line.label == mark.label) found.push_back(mark);
    return found;
  }
};

Shown shown(const std::filesystem::path& file) {
  const Result<PreparedObject> object = read_prepared_object(file, kUncoloured);
  REQUIRE(object);
  Result<Diagnosis> diagnosis = diagnose(object.value());
  REQUIRE(diagnosis);
  const std::vector<FindingLine> lines = finding_lines(diagnosis.value());
  Result<FindingPicture> picture = finding_picture(object.value(), diagnosis.value(), lines);
  REQUIRE(picture);
  return {std::move(diagnosis).value(), lines, std::move(picture).value()};
}

Shown shown(const ColouredMesh& mesh) {
  const TemporaryFolder folder;
  return shown(folder.write("mesh.ply", ply_text(mesh)));
}

const Vector3d kMost(40, 30, 20);

ColouredMesh box() {
  return cuboid(-kMost, kMost);
}

// Where a point of the box is in the picture of a view: a pinhole of 32 degrees at the distance
// from which a ball about the box has 6 % of its radius to spare.
std::vector<cv::Point2f> projected(const std::vector<Vector3d>& points, const Shown& shown,
                                   std::size_t view) {
  const double half = 16 * CV_PI / 180, focal = 310 / std::tan(half);
  const Vector3d z = -shown.picture.views[view], x = z.cross(Vector3d::UnitZ()).normalized(),
                 y = z.cross(x);
  const cv::Matx33d rotation(x.x(), x.y(), x.z(), y.x(), y.y(), y.z(), z.x(), z.y(), z.z());
  cv::Mat turn;
  cv::Rodrigues(rotation, turn);
  std::vector<cv::Point3d> input;
  for (const Vector3d& p : points) input.emplace_back(p.x(), p.y(), p.z());
  std::vector<cv::Point2d> output;
  cv::projectPoints(input, turn, cv::Vec3d(0, 0, 1.06 * kMost.norm() / std::sin(half)),
                    cv::Matx33d(focal, 0, 309.5, 0, focal, 309.5, 0, 0, 1), cv::noArray(), output);
  std::vector<cv::Point2f> found;
  for (const cv::Point2d& p : output)
    found.emplace_back(p + cv::Point2d(shown.picture.places[view].tl()));
  return found;
}

std::vector<Vector3d> corners_of(const ColouredMesh& mesh, std::size_t triangle) {
  std::vector<Vector3d> corners;
  for (const std::uint32_t corner : mesh.triangles[triangle])
    corners.push_back(mesh.vertices[corner]);
  return corners;
}

bool sees(const Shown& shown, std::size_t view, const Vector3d& outwards) {
  return shown.picture.views[view].dot(outwards) > 0.2;
}

}  // namespace

TEST_CASE("Open edges are marked on the rim of the hole") {
  ColouredMesh mesh = box();
  const std::vector<Vector3d> hole = corners_of(mesh, 2);  // of +x
  erase_triangle(mesh, 2);
  const Shown picture = shown(mesh);
  const auto marks = picture.marks_of("open_edges");
  REQUIRE_FALSE(marks.empty());
  CHECK(sees(picture, 0, Vector3d::UnitX()));
  for (const MarkedPlace& mark : marks) {
    CAPTURE(mark.view, mark.at);
    const auto rim = projected(hole, picture, mark.view);
    CHECK(std::abs(cv::pointPolygonTest(rim, cv::Point2f(mark.at), true)) < 2.5);
  }
}

TEST_CASE("A flipped face is marked within it, and nowhere else") {
  ColouredMesh mesh = box();
  const std::vector<Vector3d> face = corners_of(mesh, 10);  // of +z
  std::swap(mesh.triangles[10][0], mesh.triangles[10][1]);
  const Shown picture = shown(mesh);
  const auto marks = picture.marks_of("flipped_faces");
  REQUIRE_FALSE(marks.empty());
  for (const MarkedPlace& mark : marks) {
    CHECK(sees(picture, mark.view, Vector3d::UnitZ()));
    const auto outline = projected(face, picture, mark.view);
    CHECK(cv::pointPolygonTest(outline, cv::Point2f(mark.at), true) > -2.5);
    // The other half of the side keeps its colour.
    const auto other = projected(corners_of(box(), 11), picture, mark.view);
    const cv::Point2f middle = (other[0] + other[1] + other[2]) * (1 / 3.0F);
    const auto& pixel = picture.picture.picture.at<cv::Vec3b>(cv::Point(middle));
    const Vector3d colour = 255 * box().colours[11];
    const double light = pixel[2] / colour.x();
    CHECK(light > 0.6);
    CHECK(pixel[1] == Approx(light * colour.y()).margin(3));
    CHECK(pixel[0] == Approx(light * colour.z()).margin(3));
  }
}

TEST_CASE("Colours that are too near are marked along the edge where they touch") {
  ColouredMesh mesh = box();
  for (const std::size_t k : {6U, 7U}) mesh.colours[k] = mesh.colours[2] * 0.98;  // +y like +x
  const Shown picture = shown(mesh);
  const auto marks = picture.marks_of("inseparable_colours");
  REQUIRE_FALSE(marks.empty());
  for (const MarkedPlace& mark : marks) {
    const auto edge = projected({{40, 30, -20}, {40, 30, 20}}, picture, mark.view);
    const cv::Point2d way = edge[1] - edge[0], off = cv::Point2f(mark.at) - edge[0];
    const double length = cv::norm(way);
    CHECK(std::abs(way.cross(off)) / length < 3);
    CHECK(off.dot(way) / length > -3);
    CHECK(off.dot(way) / length < length + 3);
  }
}

TEST_CASE("What is never seen is pointed at behind the surface before it") {
  ColouredMesh mesh = box();
  add_cuboid(mesh, {-20, -5, -5}, {-10, 5, 5}, {.8, .8, .8});
  const Shown picture = shown(mesh);
  const auto marks = picture.marks_of("part_hidden");
  REQUIRE_FALSE(marks.empty());
  for (const MarkedPlace& mark : marks) {
    std::vector<Vector3d> corners;
    for (int k = 0; k < 8; ++k)
      corners.emplace_back((k & 1) != 0 ? -20 : -10, (k & 2) != 0 ? -5 : 5, (k & 4) != 0 ? -5 : 5);
    std::vector<cv::Point2f> hull;
    cv::convexHull(projected(corners, picture, mark.view), hull);
    CHECK(cv::pointPolygonTest(hull, cv::Point2f(mark.at), true) > -2.5);
  }
}

TEST_CASE("Faults on opposite sides are seen from both, and a sound object once") {
  ColouredMesh mesh = box();
  erase_triangle(mesh, 2);
  erase_triangle(mesh, 0);
  const Shown sick = shown(mesh);
  CHECK(sick.picture.views.size() >= 2);
  bool front = false, back = false;
  for (std::size_t view = 0; view < sick.picture.views.size(); ++view) {
    front = front || sees(sick, view, Vector3d::UnitX());
    back = back || sees(sick, view, -Vector3d::UnitX());
  }
  CHECK((front && back));
  const Shown sound = shown(box());
  CHECK(sound.picture.views.size() == 1);
  CHECK(sound.picture.marks.empty());
}

}  // namespace aspect
