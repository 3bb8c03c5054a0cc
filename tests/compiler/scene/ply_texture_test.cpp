// Pictures on the faces of PLY files, as MeshLab and scanners write them.
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>
#include <functional>
#include <opencv2/imgcodecs.hpp>

#include "compiler/scene/mesh_reader.h"
#include "mesh_samples.h"
#include "scene_samples.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kCell_px = 10;

// A row of cells, one colour each.
std::string png_of(const std::vector<Vector3d>& colours) {
  cv::Mat picture(kCell_px, kCell_px * static_cast<int>(colours.size()), CV_8UC3);
  for (int x = 0; x < picture.cols; ++x) {
    const Vector3d& colour = colours[static_cast<std::size_t>(x / kCell_px)];
    picture.col(x).setTo(cv::Scalar(255 * colour.z(), 255 * colour.y(), 255 * colour.x()));
  }
  std::vector<std::uint8_t> png;
  cv::imencode(".png", picture, png);
  return {png.begin(), png.end()};
}

// The corners of a square within cell k of n.
std::array<Vector2d, 4> cell(std::size_t k, std::size_t n) {
  const auto u = [&](double share) { return (static_cast<double>(k) + share) / double(n); };
  return {Vector2d(u(.1), .1), {u(.9), .1}, {u(.9), .9}, {u(.1), .9}};
}

// Numbers as a PLY file of that format holds them: floats, whole numbers of 4 bytes, or of 1.
class Rows {
 public:
  explicit Rows(const std::string& format) : format_(format) {}

  Rows& real(double value) { return add(static_cast<float>(value)); }
  Rows& whole(int value) { return add(static_cast<std::int32_t>(value)); }
  Rows& byte(int value) { return add(static_cast<std::uint8_t>(value)); }
  Rows& reals(const Vector3d& v) { return real(v.x()).real(v.y()).real(v.z()); }
  const std::string& bytes() const { return bytes_; }

 private:
  template <typename Value>
  Rows& add(Value value) {
    if (format_ == "ascii") {
      bytes_ += fmt::format("{} ", value);
      return *this;
    }
    std::string raw(sizeof value, '\0');
    std::memcpy(raw.data(), &value, sizeof value);
    if (format_ == "binary_big_endian") std::reverse(raw.begin(), raw.end());
    bytes_ += raw;
    return *this;
  }

  std::string format_, bytes_;
};

std::string ply(const std::string& format, const std::string& comments, const std::string& elements,
                const Rows& rows) {
  return "ply\nformat " + format + " 1.0\n" + comments + elements + "end_header\n" + rows.bytes();
}

std::string vertices_of(std::size_t count, const std::string& more = {}) {
  return fmt::format("element vertex {}\nproperty float x\nproperty float y\nproperty float z\n{}",
                     count, more);
}

// Twelve triangles, each with its own coordinates in the picture, and all vertices white.
std::string meshlab_cube(const std::string& format) {
  Rows rows(format);
  for (const CubeFace& face : cube_faces())
    for (const Vector3d& corner : face.corners) rows.reals(corner).byte(255).byte(255).byte(255);
  for (int k = 0; k < 6; ++k)
    for (const auto& triangle : {std::array{0, 1, 2}, {0, 2, 3}}) {
      rows.byte(3);
      for (const int corner : triangle) rows.whole(4 * k + corner);
      rows.byte(6);
      for (const int corner : triangle) {
        const Vector2d uv = cell(static_cast<std::size_t>(k), 6)[static_cast<std::size_t>(corner)];
        rows.real(uv.x()).real(uv.y());
      }
    }
  return ply(format, "comment VCGLIB generated\ncomment TextureFile all sides.png\n",
             vertices_of(24, "property uchar red\nproperty uchar green\nproperty uchar blue\n") +
                 "element face 12\nproperty list uchar int vertex_indices\n"
                 "property list uchar float texcoord\n",
             rows);
}

std::vector<Vector3d> cube_colours() {
  std::vector<Vector3d> colours;
  for (const CubeFace& face : cube_faces()) colours.push_back(face.colour);
  return colours;
}

bool lies_on(const ColouredMesh& mesh, std::size_t triangle, const CubeFace& side) {
  const Vector3d normal =
      (side.corners[1] - side.corners[0]).cross(side.corners[2] - side.corners[0]).normalized();
  return std::ranges::all_of(mesh.triangles[triangle], [&](std::uint32_t corner) {
    return std::abs(normal.dot(mesh.vertices[corner] - side.corners[0])) < 1e-3;
  });
}

// Every side is covered, and by its colour alone.
void require_cube_sides(const ColouredMesh& mesh) {
  for (const CubeFace& side : cube_faces()) {
    double area = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (!lies_on(mesh, t, side)) continue;
      const auto& [a, b, c] = mesh.triangles[t];
      area +=
          (mesh.vertices[b] - mesh.vertices[a]).cross(mesh.vertices[c] - mesh.vertices[a]).norm() /
          2;
      INFO(side.name << ": " << mesh.colours[t].transpose());
      REQUIRE((mesh.colours[t] - side.colour).cwiseAbs().maxCoeff() < .5 / 255);
    }
    CHECK(area == Approx(400));
  }
}

ColouredMesh read(const std::filesystem::path& file) {
  Result<ColouredMesh> mesh = read_coloured_mesh(file);
  if (!mesh) FAIL(mesh.error());
  return std::move(mesh).value();
}

// Three unit squares side by side, textured as `comments`, `face_properties` and `row` say.
std::string squares(const std::string& comments, const std::string& face_properties,
                    const std::function<std::string(int)>& row) {
  std::string rows;
  for (int k = 0; k < 3; ++k)
    rows += fmt::format("{0} 0 0\n{1} 0 0\n{1} 1 0\n{0} 1 0\n", 2 * k, 2 * k + 1);
  for (int k = 0; k < 3; ++k)
    rows += fmt::format("4 {} {} {} {} {}\n", 4 * k, 4 * k + 1, 4 * k + 2, 4 * k + 3, row(k));
  return "ply\nformat ascii 1.0\n" + comments + vertices_of(12) +
         "element face 3\nproperty list uchar int vertex_indices\n" + face_properties +
         "end_header\n" + rows;
}

std::string whole_picture() {
  return "8 0.1 0.1 0.9 0.1 0.9 0.9 0.1 0.9";
}

Vector3d colour_of_square(const ColouredMesh& mesh, int k) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (std::floor(mesh.vertices[mesh.triangles[t][0]].x() / 2) == k) return mesh.colours[t];
  FAIL("square " << k << " is not there");
  return {};
}

const Vector3d kRed(1, 0, 0), kGreen(0, 1, 0), kBlue(0, 0, 1);
const std::string kTexcoord = "property list uchar float texcoord\n";
const std::string kTexnumber = "property int texnumber\n";
const std::string kTwo = "comment TextureFile red.png\ncomment TextureFile green.png\n";

std::string error_of_ply(const TemporaryFolder& folder, const std::string& bytes) {
  const auto file = folder.write("a.ply", bytes);
  const Result<Scene> scene = read_mesh(file);
  if (scene.ok()) return "no error";
  CHECK(scene.error().starts_with(file.string()));
  return scene.error().substr(file.string().size());
}

}  // namespace

TEST_CASE("coordinates in a PLY file's faces put each colour on its side, in every format") {
  const TemporaryFolder folder;
  folder.write("all sides.png", png_of(cube_colours()));
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    INFO(format);
    const ColouredMesh mesh = read(folder.write("cube.ply", meshlab_cube(format)));
    require_cube_sides(mesh);
    CHECK(mesh.warnings.empty());
  }
}

TEST_CASE("coordinates of a PLY file's vertices do the same, whatever they are called") {
  const TemporaryFolder folder;
  folder.write("sides.png", png_of(cube_colours()));
  for (const auto& [u, v] : {std::pair{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}) {
    Rows rows("ascii");
    for (std::size_t k = 0; k < 6; ++k)
      for (std::size_t c = 0; c < 4; ++c)
        rows.reals(cube_faces()[k].corners[c]).real(cell(k, 6)[c].x()).real(cell(k, 6)[c].y());
    for (int k = 0; k < 6; ++k)
      rows.byte(4).whole(4 * k).whole(4 * k + 1).whole(4 * k + 2).whole(4 * k + 3);
    require_cube_sides(read(folder.write(
        "cube.ply",
        ply("ascii", "comment TextureFile sides.png\n",
            vertices_of(24, fmt::format("property float {}\nproperty float {}\n", u, v)) +
                "element face 6\nproperty list uchar int vertex_index\n",
            rows))));
  }
}

TEST_CASE("coordinates that faces of a scanner's PLY file point at do the same") {
  const TemporaryFolder folder;
  const std::vector<Vector3d> colours = cube_colours();
  folder.write("0.png", png_of({colours[0], colours[1], colours[2]}));
  folder.write("1.png", png_of({colours[3], colours[4], colours[5]}));
  Rows rows("binary_little_endian");
  for (const CubeFace& face : cube_faces())
    for (const Vector3d& corner : face.corners) rows.reals(corner);
  for (int k = 0; k < 6; ++k)
    rows.byte(4).whole(4 * k).whole(4 * k + 1).whole(4 * k + 2).whole(4 * k + 3);
  for (std::size_t k = 0; k < 3; ++k)
    for (const Vector2d& uv : cell(k, 3)) rows.byte(0).real(uv.x()).real(uv.y());
  for (int k = 5; k >= 0; --k) {
    rows.byte(k / 3).whole(k).byte(4);
    for (int c = 0; c < 4; ++c) rows.whole(4 * (k % 3) + c);
  }
  require_cube_sides(read(folder.write(
      "cube.ply",
      ply("binary_little_endian", "comment TextureFile 0.png\ncomment TextureFile 1.png\n",
          vertices_of(24) + "element face 6\nproperty list uchar int vertex_indices\n"
                            "element multi_texture_vertex 12\nproperty uchar tx\nproperty float u\n"
                            "property float v\nelement multi_texture_face 6\nproperty uchar tx\n"
                            "property uint tn\nproperty list uchar int texture_vertex_indices\n",
          rows))));
}

TEST_CASE("of several textures a PLY face has the one of its number, below zero none") {
  const TemporaryFolder folder;
  folder.write("red.png", png_of({kRed}));
  folder.write("green.png", png_of({kGreen}));
  const std::string bytes =
      squares(kTwo + "comment TextureFile not there.png\n",  // and no face has it
              kTexcoord + kTexnumber +
                  "property uchar red\nproperty uchar green\n"
                  "property uchar blue\n",
              [](int k) { return fmt::format("{} {} 0 0 255", whole_picture(), 1 - k); });
  const ColouredMesh mesh = read(folder.write("a.ply", bytes));
  CHECK(colour_of_square(mesh, 0) == kGreen);
  CHECK(colour_of_square(mesh, 1) == kRed);
  CHECK(colour_of_square(mesh, 2) == kBlue);
  CHECK(mesh.warnings.empty());
}

TEST_CASE("PLY faces without coordinates among textured ones are counted, and grey") {
  const TemporaryFolder folder;
  folder.write("red.png", png_of({kRed}));
  const ColouredMesh mesh =
      read(folder.write("a.ply", squares("comment TextureFile red.png\n", kTexcoord, [](int k) {
                          return k == 1 ? std::string("0") : whole_picture();
                        })));
  CHECK(colour_of_square(mesh, 0) == kRed);
  CHECK(colour_of_square(mesh, 1) == kUncoloured);
  REQUIRE(mesh.warnings.size() == 1);
  CHECK(mesh.warnings[0] == "1 of 3 faces have no texture; they are grey");
}

TEST_CASE("a PLY texture that is not there is an error with the line that names it") {
  const TemporaryFolder folder;
  const auto textured = [](const std::string& comments) {
    return squares(comments, kTexcoord, [](int) { return whole_picture(); });
  };
  const std::string way_out =
      "; put it beside the mesh, or go on with --missing-colour R,G,B ([mesh] missing_colour in a "
      "project)";
  CHECK(error_of_ply(folder, textured("comment x\ncomment TextureFile sides.png\n")) ==
        ":4: texture 'sides.png' is not there" + way_out);
  folder.write("sides.png", "no picture");
  CHECK(error_of_ply(folder, textured("comment TextureFile sides.png\n")) ==
        ":3: texture 'sides.png' is no picture that is read; write PNG or JPEG" + way_out);
  std::filesystem::remove(folder.path() / "sides.png");
  folder.write("Sides.PNG", png_of({kRed}));
  const ColouredMesh guessed =
      read(folder.write("a.ply", textured("comment TextureFile sides.png\n")));
  CHECK(colour_of_square(guessed, 0) == kRed);
  REQUIRE(guessed.warnings.size() == 1);
  CHECK(guessed.warnings[0].starts_with("texture 'sides.png' of line 3 is taken to be "));
  folder.write("maps/sides.png", png_of({kGreen}));
  folder.write("sides.png", png_of({kRed}));
  for (const auto& [name, colour] : {std::pair{"maps\\sides.png", kGreen},
                                     {"C:\\models\\sides.png", kRed},
                                     {"/home/nobody/sides.png", kRed}}) {
    INFO(name);
    const std::string bytes = textured(fmt::format("comment TextureFile {}\r\n", name));
    CHECK(colour_of_square(read(folder.write("a.ply", bytes)), 0) == colour);
  }
}

TEST_CASE("PLY textures that fit no face, or no one face, are errors") {
  const TemporaryFolder folder;
  folder.write("red.png", png_of({kRed}));
  folder.write("green.png", png_of({kGreen}));
  const auto whole = [](int) { return whole_picture(); };
  CHECK(error_of_ply(folder, squares(kTwo, kTexcoord, whole)) ==
        ":4: names 2 textures, but not which of them a face has (texnumber); export it again");
  CHECK(error_of_ply(folder, squares(kTwo, kTexcoord + kTexnumber,
                                     [](int) { return whole_picture() + " 2"; })) ==
        ": a face has texture 2, but the header names 2; write a comment TextureFile for each");
  CHECK(error_of_ply(folder, squares("comment TextureFile red.png\n", kTexcoord,
                                     [](int) { return std::string("6 0 0 1 0 1 1"); })) ==
        ": a face of 4 corners has 6 texture coordinates, not 8; export it again");
  CHECK(error_of_ply(folder, squares("comment TextureFile red.png\n", {},
                                     [](int) { return std::string(); })) ==
        ":3: texture 'red.png' is named, but there are no texture coordinates; export them, or go "
        "on with --missing-colour R,G,B ([mesh] missing_colour in a project)");
  const ColouredMesh grey = read(folder.write("a.ply", squares("", kTexcoord, whole)));
  REQUIRE(grey.warnings.size() == 1);
  CHECK(grey.warnings[0].starts_with("has texture coordinates, but names no texture"));
}

TEST_CASE("a colour that is given stands for a PLY texture that is not there, and it is told") {
  const TemporaryFolder folder;
  folder.write("green.png", png_of({kGreen}));
  const auto file = folder.write("a.ply", squares(kTwo, kTexcoord + kTexnumber, [](int k) {
                                   return fmt::format("{} {}", whole_picture(), k % 2);
                                 }));
  const Result<ColouredMesh> mesh = read_coloured_mesh(file, {.5, 0, .5});
  if (!mesh) FAIL(mesh.error());
  CHECK(colour_of_square(mesh.value(), 0) == Vector3d(.5, 0, .5));
  CHECK(colour_of_square(mesh.value(), 1) == kGreen);
  CHECK(colour_of_square(mesh.value(), 2) == Vector3d(.5, 0, .5));
  REQUIRE(mesh.value().missing.size() == 1);
  CHECK(line_of(mesh.value().missing[0]) == ":3: texture 'red.png' is not there");
  MeshColours colours;
  colours.missing = Vector3d(.5, 0, .5);
  const Result<Scene> scene = read_mesh(file, colours);
  if (!scene) FAIL(scene.error());
  CHECK(scene.value().missing_colours.size() == 1);
}

}  // namespace aspect
