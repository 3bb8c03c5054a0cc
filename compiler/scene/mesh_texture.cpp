#include "compiler/scene/mesh_texture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "compiler/scene/colour_palette.h"
#include "compiler/scene/srgb.h"

namespace aspect {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kUniform = 24.0 / 255, kAlike = 12.0 / 255;
constexpr int kMaxSamples = 32;  // along an edge

struct Seen {
  Vector3d mean = Vector3d::Zero();
  Vector3d commonest = Vector3d::Zero();  // the mean of those near the commonest
  bool uniform = false;
};

// One sample a texel along the longest edge, at the middles of small triangles.
std::vector<Vector3d> samples_of(const TexturedTriangle& triangle, const MeshTexture& texture) {
  double texels = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector2d edge = triangle.uv[(k + 1) % 3] - triangle.uv[k];
    texels = std::max(
        {texels, std::abs(edge.x()) * texture.width_px, std::abs(edge.y()) * texture.height_px});
  }
  const int n = static_cast<int>(std::ceil(std::min<double>(texels, kMaxSamples)));
  std::vector<Vector3d> samples;
  for (int row = 0; row < n; ++row)
    for (int k = 0; k < 2 * (n - row) - 1; ++k) {
      const double third = k % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
      const double a = (k / 2 + third) / n, b = (row + third) / n;
      samples.push_back(
          texture.at((1 - a - b) * triangle.uv[0] + a * triangle.uv[1] + b * triangle.uv[2]));
    }
  return samples;
}

Seen seen_on(const TexturedTriangle& triangle, const MeshTexture& texture) {
  const std::vector<Vector3d> samples = samples_of(triangle, texture);
  Seen seen;
  Vector3d least = samples[0], greatest = samples[0];
  ColourPalette palette(kUniform);
  std::vector<std::pair<int, Vector3d>> sums;
  for (const Vector3d& sample : samples) {
    seen.mean += sample / static_cast<double>(samples.size());
    least = least.cwiseMin(sample);
    greatest = greatest.cwiseMax(sample);
    const std::size_t index = palette.find_or_add(sample);
    if (index == sums.size()) sums.emplace_back(0, Vector3d::Zero());
    ++sums[index].first;
    sums[index].second += sample;
  }
  const auto most = std::max_element(
      sums.begin(), sums.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  seen.commonest = most->second / most->first;
  seen.uniform = (greatest - least).maxCoeff() <= kUniform;
  return seen;
}

double longest_edge(const TexturedTriangle& triangle) {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k)
    longest = std::max(longest, (triangle.corners[(k + 1) % 3] - triangle.corners[k]).norm());
  return longest;
}

Vector3d coloured_by(const TexturedTriangle& triangle, const Vector3d& colour) {
  if (!triangle.linear_factor) return colour.cwiseProduct(triangle.factor);
  if (triangle.factor == Vector3d::Ones()) return colour;
  return srgb_of_linear(linear_of_srgb(colour).cwiseProduct(triangle.factor));
}

std::array<TexturedTriangle, 4> cut(const TexturedTriangle& whole) {
  std::array<TexturedTriangle, 4> parts = {whole, whole, whole, whole};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const Vector3d corner = (whole.corners[k] + whole.corners[next]) / 2;
    const Vector2d uv = (whole.uv[k] + whole.uv[next]) / 2;
    parts[k].corners[next] = parts[next].corners[k] = parts[3].corners[k] = corner;
    parts[k].uv[next] = parts[next].uv[k] = parts[3].uv[k] = uv;
  }
  return parts;
}

}  // namespace

Vector3d MeshTexture::at(const Vector2d& uv) const {
  const auto texel = [](double coordinate, Wrap wrap, int size) {
    double within = coordinate - std::floor(coordinate);
    if (wrap == Wrap::clamp) within = std::clamp(coordinate, 0.0, 1.0);
    if (wrap == Wrap::mirror && std::fmod(std::floor(coordinate), 2) != 0) within = 1 - within;
    return std::min(static_cast<int>(within * size), size - 1);
  };
  const int x = texel(uv.x(), wrap_u, width_px),
            y = height_px - 1 - texel(uv.y(), wrap_v, height_px);
  const std::uint8_t* pixel =
      rgb.data() + 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                        static_cast<std::size_t>(x));
  return Vector3d(pixel[0], pixel[1], pixel[2]) / 255.0;
}

MeshTexture decode_texture(std::span<const std::uint8_t> file) {
  cv::Mat bgr;
  try {
    if (!file.empty())
      bgr = cv::imdecode(
          cv::Mat(1, static_cast<int>(file.size()), CV_8U, const_cast<std::uint8_t*>(file.data())),
          cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
  }
  if (bgr.empty()) throw MeshError("is no picture that is read; write PNG or JPEG");
  cv::Mat rgb;
  cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
  MeshTexture texture;
  texture.width_px = rgb.cols;
  texture.height_px = rgb.rows;
  texture.rgb.assign(rgb.datastart, rgb.dataend);
  return texture;
}

void add_textured(ColouredMesh& mesh, std::span<const TexturedTriangle> triangles,
                  const MeshTexture& texture, double least_edge) {
  ColourPalette palette(kAlike);
  for (const TexturedTriangle& whole : triangles) {
    std::vector<TexturedTriangle> open = {whole};
    while (!open.empty()) {
      const TexturedTriangle triangle = open.back();
      open.pop_back();
      for (const Vector2d& uv : triangle.uv)
        if (!(uv.cwiseAbs().maxCoeff() < 1e6))
          throw MeshError("a texture coordinate is not finite; export it again");
      const Seen seen = seen_on(triangle, texture);
      if (!seen.uniform && longest_edge(triangle) > least_edge) {
        for (const TexturedTriangle& part : cut(triangle)) open.push_back(part);
        continue;
      }
      const std::size_t colour = palette.find_or_add(seen.uniform ? seen.mean : seen.commonest);
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) corners[k] = add_vertex(mesh, triangle.corners[k]);
      add_face(mesh, corners, coloured_by(triangle, palette.colours()[colour]), triangle.part);
    }
  }
}

}  // namespace aspect
