// Reader of coloured meshes: OBJ with MTL, PLY, glTF and GLB, STL, OFF, 3DS, DXF, 3MF, STEP.
#pragma once

#include <filesystem>
#include <string_view>

#include "compiler/scene/coloured_mesh.h"
#include "compiler/scene/mesh_scene.h"
#include "compiler/scene/scene.h"
#include "compiler/scene/step_mesh.h"
#include "runtime/base/result.h"

namespace aspect {

// Reads a mesh file by its extension and makes the scene of it that scene_of_mesh() describes.
// Channels are 0..1 as displayed (colour_meaning.h): a picture shows 255 * colour. A colour that
// the file names and that is not found is an error, unless `colours` has one for it. Errors are one
// line `file: what is wrong; what to do`, with the line behind the file's name where the format has
// lines. Files of more than 1 GiB or 5 million triangles are refused; whatever breaks Assimp or
// OpenCASCADE breaks a process of its own. `chord_error`: see StepReading.
Result<Scene> read_mesh(const std::filesystem::path& file, const MeshColours& colours = {},
                        double chord_error = kDefaultChordError);

// The triangles of a mesh file as they are, in its coordinates: for those who judge the file.
// `stand_in` has the faces whose colour is not found. Errors as above.
Result<ColouredMesh> read_coloured_mesh(const std::filesystem::path& file,
                                        const Eigen::Vector3d& stand_in = kUncoloured,
                                        double chord_error = kDefaultChordError);

// A scene from bytes in memory, for formats that this library reads itself: .obj, .gltf and .ply
// (with the files that they name), .glb, .off, .stl (binary), .dxf, .3mf. `name` stands for the
// file in messages.
Result<Scene> parse_mesh(std::string_view bytes, const std::filesystem::path& name,
                         const MeshColours& colours = {});

}  // namespace aspect
