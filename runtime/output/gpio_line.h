// One output line of a GPIO chip.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "runtime/base/result.h"

namespace aspect {

// Low from the start, and again at its end.
class GpioLine {
 public:
  GpioLine() = default;
  GpioLine(const GpioLine&) = delete;
  GpioLine& operator=(const GpioLine&) = delete;
  virtual ~GpioLine() = default;
  virtual bool set(bool high) = 0;
};

[[nodiscard]] Result<std::unique_ptr<GpioLine>> open_gpio_line(const std::string& chip, int line);

// An error if this build has no GPIO lines.
[[nodiscard]] std::optional<Error> check_gpio();

}  // namespace aspect
