#include "tools/calibrate/colours/project_colours.h"

#include <fmt/format.h>

#include <algorithm>

#include "tools/aspectc/project/prepared_object.h"
#include "tools/aspectc/project/project_file.h"
#include "tools/calibrate/output/table_edit.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBegin =
    "# ---- measured by aspect-calibrate colours, which replaces all from here\n";
constexpr std::string_view kEnd = "# ---- to here\n";

// What a surface must have of each channel so that this light shows the share; no channel of a
// light is taken for less than a hundredth.
Eigen::Vector3d under_light(const Eigen::Vector3d& share, const Eigen::Vector3d& light,
                            double brightness) {
  if (light.maxCoeff() <= 0) return Eigen::Vector3d::Constant(brightness / 3);
  const Eigen::Vector3d needed =
      shares_of(share.cwiseQuotient((light / light.maxCoeff()).cwiseMax(0.01)));
  return needed * std::min(brightness, 1 / needed.maxCoeff());
}

std::string vector_text(const Eigen::Vector3d& v) {
  return fmt::format("[{:.4f}, {:.4f}, {:.4f}]", v.x(), v.y(), v.z());
}

std::string share_text(const Eigen::Vector3d& share) {
  return fmt::format("{:.3f} {:.3f} {:.3f}", share.x(), share.y(), share.z());
}

std::string block_of(const Scene& scene, const std::vector<Paint>& paints,
                     const std::vector<PaintColour>& colours, std::string_view table) {
  std::string block(kBegin);
  for (const NewSurface& surface : new_surfaces(scene, paints, colours)) {
    const auto paint = static_cast<std::size_t>(
        paint_by_surface(scene, paints)[static_cast<std::size_t>(surface.index)]);
    const PaintColour& colour = colours[paint];
    const std::string source = colour.is_estimate
                                   ? std::string("not seen, by the light on the others")
                                   : fmt::format("+- {:.3f} in {} frames, {} pixels", colour.spread,
                                                 colour.frames, colour.pixels);
    block += fmt::format(
        "[[{}]]  # r g b of 1: {} {}; {} before\nindex = {}\ndiffuse = {}\nambient = {}\n", table,
        share_text(colour.share), source, share_text(shares_of(paints[paint].shown)), surface.index,
        vector_text(surface.diffuse), vector_text(surface.ambient));
  }
  return block + std::string(kEnd);
}

std::string without_block(std::string text) {
  const std::size_t begin = text.find(kBegin);
  if (begin == std::string::npos) return text;
  const std::size_t end = text.find(kEnd, begin);
  const std::string rest = end == std::string::npos ? "" : text.substr(end + kEnd.size());
  return text.substr(0, begin) + rest;
}

std::string toml_quoted(const std::string& text) {
  std::string quoted(1, '"');
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

Result<std::string> of_project(const fs::path& project, const fs::path& output, const Scene& scene,
                               const std::vector<Paint>& paints,
                               const std::vector<PaintColour>& colours) {
  const auto folder = [](const fs::path& file) {
    return fs::weakly_canonical(fs::absolute(file).parent_path());
  };
  if (folder(project) != folder(output))
    return Error{output.native() + ": a project names its scene from its own folder; write it to " +
                 folder(project).native()};
  const Result<Project> read = read_project(project);
  if (!read) return Error{read.error()};
  const Result<std::string> there = read_toml_text(project);
  if (!there) return there;
  std::string text = without_block(there.value());
  if (!text.empty() && text.back() != '\n') text += '\n';
  text += block_of(scene, paints, colours, read.value().has_list ? "object.surface" : "surface");
  if (const auto after = parse_project(text, output); !after)
    return Error{after.error() + " (with the measured [[surface]] tables at the end of the file)"};
  return text;
}

}  // namespace

std::vector<NewSurface> new_surfaces(const Scene& scene, const std::vector<Paint>& paints,
                                     const std::vector<PaintColour>& colours) {
  Eigen::Vector3d lamps(0, 0, 0);
  for (const Light& light : scene.lights) lamps += light.color;
  if (scene.lights.empty()) lamps = scene.studio.ambient;
  std::vector<NewSurface> surfaces;
  for (std::size_t p = 0; p < paints.size(); ++p) {
    if ((colours[p].frames == 0 && !colours[p].is_estimate) || paints[p].textured) continue;
    for (const int index : paints[p].surfaces) {
      const Surface& surface = scene.surfaces[static_cast<std::size_t>(index)];
      surfaces.push_back(
          {index, under_light(colours[p].share, lamps, surface.diffuse.sum()),
           under_light(colours[p].share, scene.studio.ambient, surface.ambient.sum())});
    }
  }
  std::sort(surfaces.begin(), surfaces.end(),
            [](const NewSurface& a, const NewSurface& b) { return a.index < b.index; });
  return surfaces;
}

Result<std::string> project_with_colours(const fs::path& scene_or_project, const fs::path& output,
                                         const Scene& scene, const std::vector<Paint>& paints,
                                         const std::vector<PaintColour>& colours) {
  if (scene_or_project.extension() == ".toml")
    return of_project(scene_or_project, output, scene, paints, colours);
  std::error_code code;
  fs::path named = fs::relative(scene_or_project, fs::absolute(output).parent_path(), code);
  if (code || named.empty()) named = fs::absolute(scene_or_project);
  const std::string text = fmt::format("# {} in the colours that a camera sees.\nscene = {}\n\n",
                                       scene.name, toml_quoted(named.native())) +
                           block_of(scene, paints, colours, "surface");
  if (const auto read = parse_project(text, output); !read) return Error{read.error()};
  return text;
}

}  // namespace aspect
