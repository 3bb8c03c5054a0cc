// Recorded frames over and over on the page that aspectd has for its camera.
#pragma once

#include <span>

#include "runtime/recognition/class_index.h"
#include "runtime/recognition/recogniser.h"
#include "tools/replay/console.h"
#include "tools/replay/replay_options.h"

namespace aspect {

// Until SIGINT or SIGTERM. False: there is no page, or no frame to be had; the console has said so.
bool serve(const ReplayOptions& options, Configuration configuration,
           std::span<const ClassIndex> indexes, const RecogniserParameters& parameters,
           Console& console);

}  // namespace aspect
