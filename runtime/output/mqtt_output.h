// Lines as messages to an MQTT broker.
#pragma once

#include <memory>
#include <optional>

#include "runtime/base/result.h"
#include "runtime/output/line_output.h"
#include "runtime/output/line_ring.h"
#include "runtime/output/output_counters.h"
#include "runtime/output/output_settings.h"

namespace aspect {

// Also where the broker cannot be reached yet: it is tried again and again, and what the ring still
// has then is sent.
[[nodiscard]] Result<std::unique_ptr<LineOutput>> open_mqtt_output(const MqttOutput& settings,
                                                                   const LineRing& ring,
                                                                   OutputCounters& counters);

// An error if this build has no MQTT.
[[nodiscard]] std::optional<Error> check_mqtt();

}  // namespace aspect
