#include "tools/frame_page/page_model.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "runtime/recognition/model_lines.h"
#include "tools/frame_page/page_block.h"

namespace aspect {
namespace {

using Json = nlohmann::json;

// Shares say nothing of how bright a surface is: as bright as a screen shows them well.
std::string colour_of(const std::array<float, 3>& share) {
  const float most = std::max({share[0], share[1], share[2], 1e-6F});
  const auto level = [&](float part) {
    return std::clamp(static_cast<int>(std::lround(235 * part / most)), 0, 255);
  };
  return fmt::format("#{:02x}{:02x}{:02x}", level(share[0]), level(share[1]), level(share[2]));
}

Json numbers(const Vector3d& vector) {
  Json list = Json::array();
  for (const double part : vector) list.push_back(with_digits(part, 7));
  return list;
}

}  // namespace

Json model_json(const ClassIndex& index) {
  const ObjectModel& model = index.model;
  Json json = {{"object", index.object},
               {"classes", index.classes.size()},
               {"fov", with_digits(static_cast<double>(index.field_of_view_deg), 6)}};
  for (const auto& [surface, name] : index.surface_names)
    json["surfaces"][fmt::to_string(surface)] = name;
  if (model.empty()) return json;
  json["centre"] = numbers(model.centre);
  json["up"] = numbers(model.up);
  json["radius"] = with_digits(model.radius, 7);
  constexpr double kSteps = 4096;  // of the radius
  const double unit = model.radius / kSteps;
  json["unit"] = unit;
  Json &vertices = json["vertices"] = Json::array(), &triangles = json["triangles"] = Json::array(),
       &edges = json["edges"] = Json::array();
  for (const Vector3d& vertex : model.vertices)
    for (const double part : vertex - model.centre) vertices.push_back(std::lround(part / unit));
  for (const ModelTriangle& triangle : model.triangles) {
    for (const std::uint16_t corner : triangle.corners) triangles.push_back(corner);
    triangles.push_back(triangle.colour);
  }
  for (const ModelEdge& edge : model.edges) {
    for (const auto& corners : {edge.ends, edge.opposite})
      for (const std::uint16_t corner : corners) edges.push_back(corner);
    edges.push_back(is_smooth(model, edge) ? 1 : 0);
  }
  Json& colours = json["colours"] = {"#3c4048"};
  for (const std::array<float, 3>& share : model.shares) colours.push_back(colour_of(share));
  return json;
}

}  // namespace aspect
