#include "runtime/output/gpio_line.h"

#include <gpiod.h>

#include "runtime/output/descriptor.h"

namespace aspect {
namespace {

class RequestedLine final : public GpioLine {
 public:
  explicit RequestedLine(gpiod_chip* chip) : chip_(chip) {}
  ~RequestedLine() override {
    if (line_ != nullptr) ::gpiod_line_set_value(line_, 0);
    ::gpiod_chip_close(chip_);
  }
  bool request(unsigned number) {
    gpiod_line* line = ::gpiod_chip_get_line(chip_, number);
    if (line == nullptr || ::gpiod_line_request_output(line, "aspectd", 0) != 0) return false;
    line_ = line;
    return true;
  }
  bool set(bool high) override { return ::gpiod_line_set_value(line_, high ? 1 : 0) == 0; }

 private:
  gpiod_chip* chip_;
  gpiod_line* line_ = nullptr;  // the chip's
};

}  // namespace

std::optional<Error> check_gpio() {
  return std::nullopt;
}

Result<std::unique_ptr<GpioLine>> open_gpio_line(const std::string& chip, int line) {
  gpiod_chip* const opened = ::gpiod_chip_open(chip.c_str());
  if (opened == nullptr)
    return Error{chip + ": no GPIO chip that can be opened: " + system_error() +
                 "; gpiodetect lists those there are"};
  auto requested = std::make_unique<RequestedLine>(opened);
  if (!requested->request(static_cast<unsigned>(line)))
    return Error{chip + " line " + std::to_string(line) + ": cannot be had as an output: " +
                 system_error() + "; gpioinfo tells who uses it"};
  return std::unique_ptr<GpioLine>(std::move(requested));
}

}  // namespace aspect
