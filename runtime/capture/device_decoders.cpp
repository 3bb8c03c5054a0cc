#include "runtime/capture/decoders.h"
#include "runtime/capture/pnm_picture.h"

namespace aspect {

void silence_decoders() {}

bool read_picture(const std::filesystem::path& file, SensorKind sensor, CapturedFrame& frame) {
  return read_pnm(file, sensor, frame);
}

}  // namespace aspect
