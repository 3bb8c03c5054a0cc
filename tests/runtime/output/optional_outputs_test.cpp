#include <catch2/catch.hpp>

#include "runtime/output/gpio_line.h"
#include "runtime/output/live_page.h"
#include "runtime/output/mqtt_output.h"
#include "runtime/output/outputs.h"

namespace aspect {

TEST_CASE("what is not in this build is refused in one line, what is in it is not") {
  const auto refused = [](const OutputSettings& settings) {
    const auto error = Outputs::check(settings);
    if (error) CHECK_THAT(error->message, Catch::Matchers::Contains("not in this build; build"));
    return error.has_value();
  };
  CHECK(refused({.mqtt = MqttOutput{}}) == check_mqtt().has_value());
  CHECK(refused({.http = HttpOutput{}}) == check_http().has_value());
  const TriggerOutput line{.object = "cube", .command = {}, .gpio_chip = "c", .gpio_line = 1};
  CHECK(refused({.triggers = {line}}) == check_gpio().has_value());
}

}  // namespace aspect
