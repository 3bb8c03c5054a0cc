#include "tools/aspectc/record/settings_text.h"

#include <fmt/format.h>

#include "compiler/recipe.h"
#include "tools/aspectc/options/option_text.h"

namespace aspect {
namespace {

std::string words_of(const Eigen::Vector3d& v) {
  return fmt::format("{} {} {}", v.x(), v.y(), v.z());
}

std::string words_of(const SurfaceSettings& surface) {
  std::string words = "surface";
  if (surface.index) words += fmt::format(" index {}", *surface.index);
  if (surface.colour) words += " colour " + words_of(*surface.colour);
  if (surface.diffuse) words += " diffuse " + words_of(*surface.diffuse);
  if (surface.ambient) words += " ambient " + words_of(*surface.ambient);
  return words + "\n";
}

}  // namespace

std::string settings_text(const CompileSettings& settings) {
  std::string text = options_text(settings.options);
  for (const Option& option : compile_option_table()) {
    if (option.text.table == "run") continue;
    if (const auto value = option.get(settings))
      text +=
          fmt::format("{} {} {}\n", option.text.table, option.text.key, toml_text(option, *value));
  }
  for (const LampSettings& lamp : settings.light.lamps)
    text += fmt::format("lamp {} {} {}\n", words_of(lamp.position), words_of(lamp.colour),
                        lamp.shadows);
  for (const SurfaceSettings& surface : settings.surfaces) text += words_of(surface);
  for (const auto& [part, colour] : settings.mesh.colours)
    text += fmt::format("mesh {} {}\n", part, words_of(colour));
  return text;
}

}  // namespace aspect
