#include "tools/aspectc/project/project_tables.h"

#include <fmt/format.h>

#include "tools/aspectc/options/option_text.h"

namespace aspect {
namespace {

constexpr ClosedRange<double> kColourRange{0, 1}, kLightRange{0, 1000}, kPlaceRange{-1e6, 1e6};
constexpr int kMostSurfaces = 65535;

Eigen::Vector3d vector_of(const std::vector<double>& numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

std::optional<Eigen::Vector3d> read_vector(TableReader& reader, std::string_view key,
                                           ClosedRange<double> range) {
  std::optional<std::vector<double>> numbers;
  reader.read(key, 3, range, numbers);
  return numbers ? std::optional(vector_of(*numbers)) : std::nullopt;
}

// Keys of a configuration's [segmentation] that say something of a frame and nothing of an index:
// one table serves both files.
void pass_over_frame_keys(TableReader& reader) {
  std::optional<bool> one_blob;
  std::optional<std::array<int, 4>> region;
  reader.read("one_blob", one_blob);
  reader.read("region_of_interest", {0, 1 << 20}, region);
}

}  // namespace

ProjectTables::ProjectTables(TableReader& reader, std::string file, std::string prefix)
    : file_(std::move(file)), prefix_(std::move(prefix)) {
  for (const Option& option : compile_option_table())
    if (tables_.empty() || tables_.back().name != option.text.table)
      tables_.push_back({option.text.table, reader.table(option.text.table)});
  surfaces_ = reader.tables("surface");
}

std::optional<Error> ProjectTables::read(CompileSettings& settings) const {
  for (const Named& named : tables_) {
    if (named.table == nullptr) continue;
    if (auto error = read_table(named, settings)) return error;
  }
  return read_surfaces(settings);
}

std::optional<Error> ProjectTables::read_table(const Named& named,
                                               CompileSettings& settings) const {
  TableReader reader(*named.table, file_, prefix_ + std::string(named.name));
  for (const Option& option : compile_option_table()) {
    if (option.text.table != named.name) continue;
    const auto value = read_value(reader, option);
    if (value && option.project_wide && !prefix_.empty())
      reader.fail(option.text.key, "holds for the whole project; move it out of the object");
    if (value) option.set(settings, *value);
  }
  std::vector<const toml::table*> lamps;
  if (named.name == "light") lamps = reader.tables("point");
  const toml::table* part_colours = named.name == "mesh" ? reader.table("colours") : nullptr;
  if (named.name == "segmentation") pass_over_frame_keys(reader);
  if (auto error = reader.finish()) return error;
  if (auto error = read_part_colours(part_colours, settings.mesh)) return error;
  return read_lamps(lamps, settings.light);
}

std::optional<Error> ProjectTables::read_lamps(const std::vector<const toml::table*>& tables,
                                               LightSettings& light) const {
  std::vector<LampSettings> lamps;
  for (const toml::table* table : tables) {
    TableReader reader(*table, file_, prefix_ + "light.point");
    LampSettings lamp;
    const auto position = read_vector(reader, "position", kPlaceRange);
    reader.require("position");
    lamp.colour = read_vector(reader, "colour", kLightRange).value_or(lamp.colour);
    std::optional<bool> shadows;
    reader.read("shadows", shadows);
    if (auto error = reader.finish()) return error;
    lamp.position = *position;
    lamp.shadows = shadows.value_or(lamp.shadows);
    lamps.push_back(lamp);
  }
  if (!lamps.empty()) light.lamps = std::move(lamps);
  return std::nullopt;
}

std::optional<Error> ProjectTables::read_surfaces(CompileSettings& settings) const {
  for (const toml::table* table : surfaces_) {
    TableReader reader(*table, file_, prefix_ + "surface");
    SurfaceSettings surface;
    surface.place = fmt::format("{}:{}", file_, table->source().begin.line);
    reader.read("index", {0, kMostSurfaces}, surface.index);
    surface.colour = read_vector(reader, "colour", kColourRange);
    surface.diffuse = read_vector(reader, "diffuse", kColourRange);
    surface.ambient = read_vector(reader, "ambient", kColourRange);
    if (surface.index && surface.colour)
      reader.fail("colour", "and index are given; leave one of them out");
    if (auto error = reader.finish()) return error;
    if (!surface.index && !surface.colour)
      return Error{surface.place + ": [[surface]] has neither index nor colour; give one of them"};
    if (!surface.diffuse && !surface.ambient)
      return Error{surface.place + ": [[surface]] has no new colour; give diffuse or ambient"};
    settings.surfaces.push_back(std::move(surface));
  }
  return std::nullopt;
}

std::optional<Error> ProjectTables::read_part_colours(const toml::table* table,
                                                      MeshSettings& mesh) const {
  if (table == nullptr) return std::nullopt;
  TableReader colour_reader(*table, file_, prefix_ + "mesh.colours");
  for (const auto& [key, node] : *table) {
    const auto colour = read_vector(colour_reader, key.str(), kColourRange);
    if (colour) mesh.colours[std::string(key.str())] = *colour;
  }
  return colour_reader.finish();
}

std::uint32_t ProjectTables::line_of(std::string_view table, std::string_view key) const {
  for (const Named& named : tables_) {
    if (named.name != table || named.table == nullptr) continue;
    const toml::node* node = named.table->get(key);
    return node == nullptr ? 0 : node->source().begin.line;
  }
  return 0;
}

}  // namespace aspect
