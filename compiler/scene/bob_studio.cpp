#include "compiler/scene/bob_studio.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/base/nearest_word.h"

namespace aspect {
namespace {

// A picture of this many pixels a side still fits in memory once a thread.
constexpr double kMaxResolution = 4096;
constexpr double kMaxAspect = 100;

constexpr std::array<std::string_view, 4> kAntialias = {"none", "quick", "corners", "adaptive"};
constexpr std::array<std::string_view, 3> kProjections = {"perspective", "orthogonal", "flat"};
constexpr std::array<std::string_view, 3> kLightTypes = {"point", "directional", "spherical"};

}  // namespace

void BobStudioReader::only_word(const BobWord& field, std::string_view supported,
                                std::span<const std::string_view> known) {
  const BobWord word = words_.take();
  if (word.text == supported) return;
  if (std::find(known.begin(), known.end(), word.text) != known.end()) {
    words_.fail(word, fmt::format("{0} {1} is not supported yet; write {0} {2}", field.text,
                                  word.text, supported));
  }
  words_.fail(word, fmt::format("unknown word {} behind {}; the nearest known one is '{}'",
                                quoted(word), field.text, nearest_word(word.text, known)));
}

void BobStudioReader::warn_without_effect(const BobWord& word) {
  warnings_.add(words_, word, fmt::format("{} has no effect; leave it out", word.text));
}

void BobStudioReader::read_resolution(const BobWord& word, Studio& studio) {
  const double width = numbers_.component();
  const double height = numbers_.component();
  for (const double side : {width, height}) {
    if (side == std::floor(side) && side >= 1 && side <= kMaxResolution) continue;
    words_.fail(word, fmt::format("resolution {:g} {:g}; write whole numbers within 1 .. {:g}",
                                  width, height, kMaxResolution));
  }
  studio.width_px = static_cast<int>(width);
  studio.height_px = static_cast<int>(height);
}

// What only matters together with something that is refused anyway.
void BobStudioReader::add_fields_without_effect(BobBlock& fields) {
  for (const std::string_view name : {"threshold", "samples", "depth", "focal_length"}) {
    fields.field(name, [this](const BobWord&) { numbers_.number(); });
  }
  for (const std::string_view name : {"jitter", "no_exp_trans", "caustics"}) {
    fields.field(name, [](const BobWord&) {});
  }
}

BobStudio BobStudioReader::studio(const BobWord& statement) {
  BobStudio result;
  Studio& studio = result.studio;
  bool no_shadows = false;
  BobBlock fields = block(statement);
  fields.field("from", [this](const BobWord& word) {
    numbers_.vector();
    warn_without_effect(word);
  });
  fields.vector("at", studio.at);
  fields.vector("up", studio.up);
  fields.number("angle", studio.angle_deg);
  fields.field("resolution", [&](const BobWord& word) { read_resolution(word, studio); });
  fields.number("aspect", studio.aspect);
  fields.color("ambient", studio.ambient);
  fields.color("background", studio.background);
  fields.field("antialias", [this](const BobWord& word) { only_word(word, "none", kAntialias); });
  fields.field("project",
               [this](const BobWord& word) { only_word(word, "perspective", kProjections); });
  fields.flag("no_shadows", no_shadows);
  fields.only_zero_number("haze");
  fields.only_zero_number("aperture");
  add_fields_without_effect(fields);
  fields.read();
  result.shadows = !no_shadows;
  if (studio.up.norm() < 1e-9) {
    words_.fail(statement, "up has no length; write a direction such as 0 0 1");
  }
  if (!(studio.angle_deg >= 0.1 && studio.angle_deg <= 179)) {
    words_.fail(statement,
                fmt::format("angle {:g}; write degrees within 0.1 .. 179", studio.angle_deg));
  }
  if (!fields.has("aspect")) {
    studio.aspect = static_cast<double>(studio.width_px) / studio.height_px;
  } else if (!(studio.aspect >= 1 / kMaxAspect && studio.aspect <= kMaxAspect)) {
    words_.fail(statement, fmt::format("aspect {:g}; write picture width / height, within {:g} .. "
                                       "{:g}",
                                       studio.aspect, 1 / kMaxAspect, kMaxAspect));
  }
  return result;
}

PointLight BobStudioReader::light(const BobWord& statement) {
  PointLight light;
  bool no_shadows = false;
  BobBlock fields = block(statement);
  fields.field("type", [this](const BobWord& word) { only_word(word, "point", kLightTypes); });
  fields.vector("position", light.position);
  fields.vector("center", light.position);
  fields.color("color", light.color);
  fields.only_zero_number("falloff");
  fields.flag("no_shadows", no_shadows);
  for (const std::string_view name :
       {"direction", "radius", "samples", "at", "min_angle", "max_angle"}) {
    fields.unsupported(name, "write type point with a position");
  }
  fields.read();
  if (fields.has("position") && fields.has("center")) {
    words_.fail(statement, "position and center are the same; write one of them");
  }
  if (!fields.has("center")) fields.require("position", "position x y z");
  light.casts_shadows = !no_shadows;
  return light;
}

Surface BobStudioReader::surface(const BobWord& statement) {
  Surface surface;
  BobBlock fields = block(statement);
  fields.color("diffuse", surface.diffuse);
  fields.color("ambient", surface.ambient);
  fields.only_black("specular");
  fields.only_black("transparent");
  fields.only_zero_number("fuzz");
  fields.field("ior", [this](const BobWord& word) {
    numbers_.number();
    warn_without_effect(word);
  });
  fields.field("no_antialias", [this](const BobWord& word) { warn_without_effect(word); });
  for (const std::string_view name : {"shine", "no_shadow", "texture"}) {
    fields.unsupported(name, "write diffuse and ambient alone");
  }
  fields.read();
  if (!fields.has("ambient")) surface.ambient = surface.diffuse;
  return surface;
}

}  // namespace aspect
