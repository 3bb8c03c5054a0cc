#include "runtime/output/mqtt_output.h"

namespace aspect {

std::optional<Error> check_mqtt() {
  return Error{"mqtt: not in this build; build with libmosquitto (ASPECT_MQTT), or leave it out"};
}

Result<std::unique_ptr<LineOutput>> open_mqtt_output(const MqttOutput&, const LineRing&,
                                                     OutputCounters&) {
  return *check_mqtt();
}

}  // namespace aspect
