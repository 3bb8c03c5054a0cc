// Binary PNM pictures, PPM (P6) and PGM (P5) of 8 bits a channel, without any library.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "runtime/capture/frame_source.h"
#include "runtime/vision/sensor_kind.h"

namespace aspect {

// Fills in size, pixels and, where that fails, the error. A colour sensor takes PPM, and PGM as
// pictures without colours; a grey sensor takes PGM.
[[nodiscard]] bool read_pnm(const std::filesystem::path& file, SensorKind sensor,
                            CapturedFrame& frame);

// The same of a file's bytes; returns what is wrong with them.
[[nodiscard]] std::optional<std::string> parse_pnm(std::span<const std::uint8_t> bytes,
                                                   SensorKind sensor, CapturedFrame& frame);

}  // namespace aspect
