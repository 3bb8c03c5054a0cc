// The project that `aspectc init` writes.
#pragma once

#include <string>

#include "compiler/scene/scene.h"

namespace aspect {

// Every key of a project in TOML, explained and commented out, with the value that it has without
// being given; so the project compiles to what the bare scene compiles to. `scene_file` is what
// the project calls the scene.
std::string init_text(const std::string& scene_file, const Scene& scene);

}  // namespace aspect
