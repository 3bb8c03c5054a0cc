// The light statement: the other half of BobStudioReader.
#include <fmt/format.h>

#include <array>

#include "compiler/scene/bob_studio.h"

namespace aspect {
namespace {

constexpr int kMaxSamples = 4096;
constexpr double kLeastLength = 1e-9;

constexpr std::array<std::string_view, 3> kTypes = {"point", "directional", "spherical"};

}  // namespace

Light BobStudioReader::light(const BobWord& statement) {
  Light light;
  Light::Spot spot;
  bool no_shadows = false;
  std::size_t type = 0;
  BobBlock fields = block(statement);
  fields.word("type", type, kTypes);
  fields.vector("position", light.position);
  fields.vector("center", light.position);
  fields.vector("direction", light.direction);
  fields.number("radius", light.radius);
  fields.whole_number("samples", light.samples, 1, kMaxSamples);
  fields.color("color", light.color);
  fields.whole_number("falloff", light.falloff, 0, 2);
  fields.vector("at", spot.at);
  fields.number_within("min_angle", spot.min_angle_deg, 0, 360);
  fields.number_within("max_angle", spot.max_angle_deg, 0, 360);
  fields.flag("no_shadows", no_shadows);
  fields.read();
  light.type = static_cast<Light::Type>(type);
  light.casts_shadows = !no_shadows;
  if (fields.has("at") || fields.has("min_angle") || fields.has("max_angle")) {
    fields.require("at", "at x y z min_angle a max_angle b");
    fields.require("min_angle", "at x y z min_angle a max_angle b");
    fields.require("max_angle", "at x y z min_angle a max_angle b");
    light.spot = spot;
  }
  check_light_type(fields, light, statement);
  place(light, statement);
  return light;
}

void BobStudioReader::check_light_type(const BobBlock& fields, const Light& light,
                                       const BobWord& statement) {
  const std::string_view type = kTypes[static_cast<std::size_t>(light.type)];
  const auto refuse = [&](std::string_view field) {
    if (!fields.has(field)) return;
    words_.fail(statement,
                fmt::format("{} of a {} light; leave it out or write another type", field, type));
  };
  if (light.type == Light::Type::kDirectional) {
    for (const std::string_view field : {"position", "center", "falloff", "at"}) refuse(field);
    fields.require("direction", "direction x y z, the way the light goes");
    if (light.direction.norm() < kLeastLength) {
      words_.fail(statement, "direction has no length; write one such as 0 0 -1");
    }
  } else {
    refuse("direction");
    if (fields.has("position") && fields.has("center")) {
      words_.fail(statement, "position and center are the same; write one of them");
    }
    if (!fields.has("center")) fields.require("position", "position x y z");
  }
  if (light.type != Light::Type::kSpherical) {
    for (const std::string_view field : {"radius", "samples"}) refuse(field);
  } else {
    fields.require("radius", "radius r");
    if (light.radius < 0) {
      words_.fail(statement,
                  fmt::format("radius {:g} of light is negative; write 0 or more", light.radius));
    }
  }
  if (!light.spot) return;
  if (light.spot->min_angle_deg > light.spot->max_angle_deg) {
    words_.fail(statement, fmt::format("min_angle {:g} is above max_angle {:g}; write the inner "
                                       "opening as min_angle",
                                       light.spot->min_angle_deg, light.spot->max_angle_deg));
  }
  if ((light.spot->at - light.position).norm() < kLeastLength) {
    words_.fail(statement, "the spot looks at its own position; move at");
  }
}

void BobStudioReader::place(Light& light, const BobWord& statement) const {
  const Eigen::Affine3d& scene_from_written = transforms_.scene_from_written();
  light.position = scene_from_written * light.position;
  light.direction = (scene_from_written.linear() * light.direction.normalized()).normalized();
  if (light.spot) light.spot->at = scene_from_written * light.spot->at;
  if (light.type != Light::Type::kSpherical) return;
  const std::optional<double> factor = transforms_.length_factor();
  if (!factor) {
    words_.fail(statement,
                "a spherical light cannot be scaled differently along its axes; write scale with "
                "one number");
  }
  light.radius *= *factor;
}

}  // namespace aspect
