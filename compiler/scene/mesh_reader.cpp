#include "compiler/scene/mesh_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "compiler/scene/assimp_mesh.h"
#include "compiler/scene/bob_sources.h"
#include "compiler/scene/dxf_mesh.h"
#include "compiler/scene/gltf_mesh.h"
#include "compiler/scene/isolated_reader.h"
#include "compiler/scene/mesh_text.h"
#include "compiler/scene/obj_mesh.h"
#include "compiler/scene/off_mesh.h"
#include "compiler/scene/ply_mesh.h"
#include "compiler/scene/scene_reader.h"
#include "compiler/scene/step_mesh.h"
#include "compiler/scene/stl_mesh.h"
#include "compiler/scene/threemf_mesh.h"

namespace aspect {
namespace {

constexpr std::uintmax_t kMaxBytes = std::uintmax_t{1} << 30;

bool is_step(std::string_view extension) {
  return extension == ".step" || extension == ".stp";
}

bool is_gltf(std::string_view extension) {
  return extension == ".gltf" || extension == ".glb";
}

// Nothing where the format is left to Assimp.
std::optional<ColouredMesh> parsed(std::string_view bytes, const std::filesystem::path& file,
                                   const Eigen::Vector3d& stand_in) {
  const std::string extension = lower_extension(file);
  if (extension == ".obj") return parse_obj(bytes, file, stand_in);
  if (is_gltf(extension)) return parse_gltf(bytes, file, stand_in);
  if (extension == ".off") return parse_off(bytes, stand_in);
  if (extension == ".dxf") return parse_dxf(bytes);
  if (extension == ".stl") return parse_binary_stl(bytes);
  if (extension == ".3mf") return parse_threemf(bytes, stand_in);
  if (extension == ".ply") return parse_ply(bytes, file, stand_in);
  return std::nullopt;
}

template <typename Value>
Result<Value> guarded(const std::string& name, const std::function<Result<Value>()>& make) {
  try {
    return make();
  } catch (const MeshError& error) {
    const std::string& file = error.file().empty() ? name : error.file();
    if (error.line() == 0) return Error{fmt::format("{}: {}", file, error.what())};
    return Error{fmt::format("{}:{}: {}", file, error.line(), error.what())};
  } catch (const std::bad_alloc&) {
    return Error{fmt::format("{}: needs more memory than there is; simplify the model", name)};
  }
}

Result<Scene> scene_from(const std::filesystem::path& file, const MeshColours& colours,
                         const std::function<ColouredMesh()>& read) {
  const std::string name = file.string();
  return guarded<Scene>(name, [&]() -> Result<Scene> {
    Result<Scene> made = scene_of_mesh(read(), colours);
    if (!made) return Error{fmt::format("{}: {}", name, made.error())};
    Scene scene = std::move(made).value();
    scene.name = file.stem().string();
    scene.file = name;
    for (std::string& warning : scene.warnings) warning = fmt::format("{}: {}", name, warning);
    for (MissingColour& missing : scene.missing_colours)
      if (missing.file.empty()) missing.file = name;
    if (!scene.missing_colours.empty() && !colours.missing)
      return Error{refusal_of(scene.missing_colours.front())};
    return scene;
  });
}

std::string load(const std::filesystem::path& file) {
  std::error_code unknown;
  if (std::filesystem::is_regular_file(file, unknown) &&
      std::filesystem::file_size(file, unknown) > kMaxBytes)
    throw MeshError(fmt::format("larger than {} MiB; simplify the model", kMaxBytes >> 20));
  Result<std::string> bytes = load_text(file, kMaxBytes);
  if (!bytes) throw MeshError(bytes.error());
  if (bytes.value().empty()) throw MeshError("is empty; export it again");
  return std::move(bytes).value();
}

// Pictures are decoded by libraries that a hostile one may break.
bool shows_pictures(std::string_view bytes, const std::filesystem::path& file) {
  const std::string extension = lower_extension(file);
  return extension == ".obj" || is_gltf(extension) ||
         (extension == ".ply" && names_textures(bytes));
}

ColouredMesh read_triangles(const std::filesystem::path& file, const Eigen::Vector3d& stand_in,
                            double chord_error) {
  const std::string bytes = load(file);
  if (is_step(lower_extension(file)))
    return read_isolated([&] { return read_step(file, {stand_in, chord_error}); });
  if (shows_pictures(bytes, file))
    return read_isolated([&] { return *parsed(bytes, file, stand_in); });
  if (std::optional<ColouredMesh> mesh = parsed(bytes, file, stand_in)) return std::move(*mesh);
  return read_isolated([&] { return read_with_assimp(file, stand_in); });
}

}  // namespace

Result<Scene> read_mesh(const std::filesystem::path& file, const MeshColours& colours,
                        double chord_error) {
  Result<Scene> scene = scene_from(file, colours, [&] {
    return read_triangles(file, colours.missing.value_or(kUncoloured), chord_error);
  });
  if (!scene) return scene;
  scene.value().files.push_back(file.string());
  if (is_step(lower_extension(file))) scene.value().chord_error = chord_error;
  return scene;
}

Result<ColouredMesh> read_coloured_mesh(const std::filesystem::path& file,
                                        const Eigen::Vector3d& stand_in, double chord_error) {
  return guarded<ColouredMesh>(file.string(), [&]() -> Result<ColouredMesh> {
    return read_triangles(file, stand_in, chord_error);
  });
}

Result<Scene> parse_mesh(std::string_view bytes, const std::filesystem::path& name,
                         const MeshColours& colours) {
  return scene_from(name, colours, [&] {
    if (std::optional<ColouredMesh> mesh =
            parsed(bytes, name, colours.missing.value_or(kUncoloured)))
      return std::move(*mesh);
    throw MeshError("this format is read from files alone");
  });
}

}  // namespace aspect
