#include "runtime/output/gpio_line.h"

namespace aspect {

std::optional<Error> check_gpio() {
  return Error{"gpio: not in this build; build with libgpiod (ASPECT_GPIO), or leave it out"};
}

Result<std::unique_ptr<GpioLine>> open_gpio_line(const std::string&, int) {
  return *check_gpio();
}

}  // namespace aspect
