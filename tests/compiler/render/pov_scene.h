// Scenes in the language of POV-Ray: an outside renderer to hold ours against.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "compiler/render/camera.h"
#include "compiler/render/renderer.h"
#include "compiler/scene/scene.h"

namespace aspect {

// What POV-Ray cannot say is left out or taken for granted: a highlight's colour is grey, glass has
// no diffuse colour and closed shapes, no ambient colour has a part where diffuse has none, maps
// are on rectangles of diffuse colour 1 1 1, spots have no border between full light and none. Maps
// are written to `folder`.
std::string pov_scene(const Scene& scene, const Camera& camera,
                      const std::filesystem::path& folder);

struct PovPicture {
  int width_px = 0;
  int height_px = 0;
  std::vector<std::uint8_t> rgb;
};

bool povray_is_installed();

// Runs POV-Ray in `folder`; nothing where it fails. `options` are added to its command line.
std::optional<PovPicture> pov_picture(const Scene& scene, const Camera& camera,
                                      const std::filesystem::path& folder,
                                      const std::string& options = {});

}  // namespace aspect
