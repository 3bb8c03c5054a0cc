#include "tools/report/report_json.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "compiler/index/object_facets.h"
#include "tools/aspectc/project/distance_check.h"
#include "tools/report/aspect_colours.h"
#include "tools/report/aspect_figures.h"

namespace aspect {
namespace {

using Json = nlohmann::ordered_json;

// A number with no more digits than it needs.
double rounded(double value, double unit) {
  const double per_unit = std::round(1 / unit);
  return std::round(value * per_unit) / per_unit;
}

double percent(double share) {
  return std::round(share * 100'000) / 1000;
}

Json vector_json(const Eigen::Vector3d& v) {
  const auto four = [](double value) { return std::round(value * 10'000) / 10'000; };
  return {four(v.x()), four(v.y()), four(v.z())};
}

template <typename Number>
std::string packed_text(const std::vector<Number>& numbers) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(numbers.size() * sizeof(Number));
  for (const Number number : numbers)
    for (std::size_t k = 0; k < sizeof(Number); ++k)
      bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(number) >> (8 * k)));
  return base64(bytes);
}

// Pieces with a finer one beside them are cut into more triangles, so that no gap is seen between
// their sides.
Json sphere_json(const SphereMesh& mesh) {
  std::vector<std::int16_t> points, classes;
  std::vector<std::uint32_t> corners, borders, others;
  for (const Eigen::Vector3d& p : mesh.points)
    for (int axis = 0; axis < 3; ++axis)
      points.push_back(static_cast<std::int16_t>(std::lround(32767 * p[axis])));
  for (const SpherePiece& piece : mesh.pieces) {
    const std::vector<PointId> rim = mesh.rim(piece);
    for (std::size_t k = 2; k < rim.size(); ++k) {
      corners.insert(corners.end(), {rim[0], rim[k - 1], rim[k]});
      classes.push_back(static_cast<std::int16_t>(piece.class_id));
    }
  }
  for (const MeshSide& side : sides_of(mesh)) {
    auto& kind =
        mesh.pieces[side.left].class_id == mesh.pieces[side.right].class_id ? others : borders;
    kind.insert(kind.end(), {side.from, side.to});
  }
  return {{"points", packed_text(points)},
          {"corners", packed_text(corners)},
          {"aspects", packed_text(classes)},
          {"borders", packed_text(borders)},
          {"sides", packed_text(others)}};
}

Json model_json(const ReportContents& contents) {
  const Scene& scene = contents.recipe.scene;
  const PackedModel model = packed_model(scene);
  Json vertices = Json::array(), triangles = Json::array(), paints = Json::array();
  const Eigen::Vector3d& at = scene.studio.at;
  const double radius = std::max(radius_around(scene, at), 1e-12);
  for (const auto& v : model.vertices) {
    const Eigen::Vector3d place =
        (model.least + model.unit.cwiseProduct(Eigen::Vector3d(v.x(), v.y(), v.z())) - at) / radius;
    for (int axis = 0; axis < 3; ++axis) vertices.push_back(rounded(place[axis], 1e-4));
  }
  for (const auto& t : model.triangles)
    for (const int number : {t.a(), t.b(), t.c(), t.paint()}) triangles.push_back(number);
  for (const auto& paint : model.paints)
    for (const int level : {paint.red(), paint.green(), paint.blue()}) paints.push_back(level);
  return {{"vertices", vertices},
          {"triangles", triangles},
          {"paints", paints},
          {"up", vector_json(contents.studio.up)},
          {"front", vector_json(contents.overview.frame.towards)}};
}

const char* shape_name(ShapeClass shape) {
  switch (shape) {
    case ShapeClass::circle:
      return "ellipse";
    case ShapeClass::square:
      return "parallelogram";
    case ShapeClass::triangle:
      return "triangle";
    case ShapeClass::other:
      break;
  }
  return "other";
}

// The contours by name: what they are over the aspect, and what its typical view shows of them.
Json contours_json(const ReportContents& contents, std::size_t aspect) {
  const Cluster& cluster = contents.model.clusters[aspect];
  const ClassDescription& description = contents.model.classes[aspect];
  const ClusterView& typical = cluster.views[description.typical_view];
  const ObservedView& view = contents.model.subdivision.views[number(typical.vertex)];
  const Scene& scene = contents.recipe.scene;
  std::vector<Json> list(description.contours.size());
  for (std::size_t k = 0; k < list.size(); ++k) {
    const ContourDescription& contour = description.contours[k];
    std::array<float, 3> share{};
    for (std::size_t c = 0; c < 3; ++c) share[c] = static_cast<float>(contour.share[c]);
    list[k] = {{"name", contour_letters(k)},
               {"colour", colour_of_shares(share)},
               {"surfaces", contour.surfaces},
               {"types", contour.score_of_type.size()}};
    Json names = Json::array();
    for (const std::uint16_t surface : contour.surfaces)
      if (surface >= 1 && surface <= scene.names.size() && !scene.names[surface - 1U].empty())
        names.push_back(scene.names[surface - 1U]);
    if (!names.empty()) list[k]["surface_names"] = names;
  }
  for (std::size_t i = 0; i < typical.names.size(); ++i) {
    const ObservedContour& seen = view.contours[i];
    Json& contour = list[typical.names[i]];
    contour["area_percent"] = rounded(100 * static_cast<double>(seen.feature.area), 0.01);
    contour["x"] = rounded(static_cast<double>(seen.feature.position.x), 0.001);
    contour["y"] = rounded(static_cast<double>(seen.feature.position.y), 0.001);
    contour["shape"] = shape_name(seen.shape);
  }
  return list;
}

Json aspect_json(const ReportContents& contents, std::size_t aspect) {
  const Cluster& cluster = contents.model.clusters[aspect];
  Json neighbours = Json::array(), views = Json::array();
  for (const AspectNeighbour& neighbour : contents.neighbours[aspect])
    neighbours.push_back({neighbour.aspect, rounded(neighbour.border_deg, 0.1), neighbour.gap});
  for (const SeenView& view : contents.views[aspect])
    views.push_back({{"from", vector_json(view.direction)},
                     {"in_index", view.is_in_index},
                     {"width", view.width_px},
                     {"height", view.height_px},
                     {"svg", inline_svg(view_figure(view))}});
  return {{"percent", percent(contents.areas[aspect])},
          {"uniform_percent", percent(cluster.area_fraction)},
          {"colour", kMapColours[contents.colours[aspect]]},
          {"in_index", contents.is_in_index(aspect)},
          {"views_seen", cluster.views.size()},
          {"from", views.empty() ? Json() : views.front()["from"]},
          {"contours", contours_json(contents, aspect)},
          {"neighbours", neighbours},
          {"views", views},
          {"graph", inline_svg(graph_figure(contents, aspect))}};
}

Json axes_json(const ReportContents& contents) {
  Json list = Json::array();
  for (const ObjectAxis& axis : contents.axes)
    list.push_back({{"direction", vector_json(axis.direction)}, {"fold", axis.fold}});
  return list;
}

Json tried_json(const Explanation& explanation) {
  Json list = Json::array();
  for (const TriedView& view : explanation.tried_views)
    list.push_back({{"from", vector_json(view.direction)},
                    {"kind", view.is_wrong   ? "wrong"
                             : view.is_right ? "right"
                                             : "near"}});
  return list;
}

Json spots_json(const Explanation& explanation) {
  Json list = Json::array();
  for (const Spot& spot : explanation.blind_spots)
    list.push_back(
        {{"from", vector_json(spot.centre)}, {"radius_deg", rounded(spot.radius_deg, 0.1)}});
  return list;
}

// In a script element only "</" and "<!" mean something.
std::string safe_in_script(const std::string& text) {
  std::string safe;
  safe.reserve(text.size());
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '<' && k + 1 < text.size() && (text[k + 1] == '/' || text[k + 1] == '!'))
      safe += "\\u003c";
    else
      safe += text[k];
  }
  return safe;
}

}  // namespace

std::string report_json(const ReportContents& contents) {
  Json aspects = Json::array();
  for (std::size_t k = 0; k < contents.aspects(); ++k) aspects.push_back(aspect_json(contents, k));
  const Json json{{"object", contents.model.index.statistics.object},
                  {"sphere", sphere_json(contents.mesh)},
                  {"model", model_json(contents)},
                  {"axes", axes_json(contents)},
                  {"tried_views", tried_json(contents.explanation)},
                  {"blind_spots", spots_json(contents.explanation)},
                  {"none", kNoAspectColour},
                  {"aspects", aspects}};
  return safe_in_script(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace aspect
