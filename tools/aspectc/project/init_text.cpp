#include "tools/aspectc/project/init_text.h"

#include <fmt/format.h>

#include "tools/aspectc/options/option_text.h"
#include "tools/aspectc/project/scene_settings.h"

namespace aspect {
namespace {

constexpr std::size_t kColumns = 100;

std::string wrapped_comment(std::string_view text) {
  std::string lines, line("#");
  while (!text.empty()) {
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(text.size(), word.size() + 1));
    if (line.size() + 1 + word.size() > kColumns) {
      lines += fmt::format("{}\n", line);
      line.resize(1);
    }
    line += fmt::format(" {}", word);
  }
  return fmt::format("{}{}\n", lines, line);
}

// In TOML a basic string escapes these and control characters.
std::string toml_string(std::string_view text) {
  std::string result(1, '"');
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code == 0x7F)
      result += fmt::format("\\u{:04X}", static_cast<unsigned>(code));
    else
      result += fmt::format("{}{}", c == '"' || c == '\\' ? "\\" : "", c);
  }
  result += '"';
  return result;
}

std::string colour_text(const Eigen::Vector3d& c) {
  return fmt::format("[{}, {}, {}]", c.x(), c.y(), c.z());
}

// Where neither a default nor the scene has a value, the least there can be stands for it.
OptionValue value_of(const Option& option, const CompileSettings& settings) {
  if (const auto value = option.get(settings)) return *value;
  if (const auto* numbers = std::get_if<NumbersForm>(&option.form))
    return std::vector<double>(numbers->count, numbers->range.least);
  const auto* whole = std::get_if<WholeForm>(&option.form);
  return whole != nullptr ? whole->range.least : 0;
}

std::string option_lines(const Option& option, const CompileSettings& settings) {
  const OptionText& text = option.text;
  std::string about(text.meaning);
  if (!text.advice.empty()) about += fmt::format("; {}", text.advice);
  about +=
      fmt::format(" ({}{}{})", text.unit, text.unit.empty() ? "" : "; ", form_text(option.form));
  return wrapped_comment(about) +
         fmt::format("# {} = {}\n", text.key, toml_text(option, value_of(option, settings)));
}

std::string lamp_lines(const Scene& scene) {
  std::string text = "# Lamps, instead of the scene's: as many as there are such tables.\n";
  auto lamps = scene.lights;
  if (lamps.empty()) lamps.emplace_back().position = Eigen::Vector3d(2, 2, 2);
  for (const auto& lamp : lamps)
    text += fmt::format("# [[light.point]]\n# position = {}\n# colour = {}\n# shadows = {}\n",
                        colour_text(lamp.position), colour_text(lamp.color), lamp.casts_shadows);
  return text;
}

std::string surface_lines(const Scene& scene) {
  std::string text =
      "\n# New colours of surfaces, red green and blue from 0 to 1. A surface is named by its "
      "index "
      "or by\n# the diffuse colour that it has in the scene. As many as there are such tables.\n";
  constexpr std::size_t kMost = 12;
  for (std::size_t i = 0; i < std::min(scene.surfaces.size(), kMost); ++i)
    text +=
        fmt::format("# [[surface]]\n# index = {}\n# diffuse = {}\n# ambient = {}\n", i,
                    colour_text(scene.surfaces[i].diffuse), colour_text(scene.surfaces[i].ambient));
  return text;
}

constexpr std::string_view kPartColours =
    "# Colours for the parts of a mesh, above all one that has none: by number from 0, by the "
    "name\n"
    "# of a part or of its material; of STEP files, of a face or of a whole body.\n"
    "# colours = {0 = [1, 0, 0], lid = [0, 1, 0], \"lid.face 3\" = [0, 0, 1]}\n";

constexpr std::string_view kObjects = R"(
# Several objects: leave scene out above and name each here. All of the tables above hold for every
# object; those of an object, written [object.subdivision] and so on, win over them.
# [[object]]
# scene = "other.b"
# name = "other"
# [object.subdivision]
# level = 6
)";

}  // namespace

std::string init_text(const std::string& scene_file, const Scene& scene) {
  CompileSettings settings;
  settings.camera = studio_camera_of(scene.studio);
  const Eigen::Vector3d& ambient = scene.studio.ambient;
  settings.light.ambient = {ambient.x(), ambient.y(), ambient.z()};
  std::string text = fmt::format(
      "# A compile project: aspectc compiles it like its scene, with what is said otherwise here.\n"
      "# Every key is there with the value that it has when it is left out.\n\n"
      "# Relative to this file.\nscene = {}\n# Of the object, and of the files written.\n"
      "# name = {}\n",
      toml_string(scene_file), toml_string(scene.name));
  std::string_view table;
  for (const Option& option : compile_option_table()) {
    if (option.text.table != table) {
      if (table == "light") text += lamp_lines(scene);
      if (table == "mesh") text += kPartColours;
      table = option.text.table;
      text += fmt::format("\n[{}]\n", table);
    }
    text += option_lines(option, settings);
  }
  return text + surface_lines(scene) + std::string(kObjects);
}

}  // namespace aspect
