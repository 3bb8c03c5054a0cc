#include "runtime/service/daemon_log.h"

#include <fmt/format.h>
#include <unistd.h>

namespace aspect {

void log_line(std::string_view text) {
  std::string line = fmt::format("aspectd: {}\n", text);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  line.back() = '\n';
  static_cast<void>(!write(STDERR_FILENO, line.data(), line.size()));
}

std::string describe(const CameraPlan& plan) {
  std::string text =
      fmt::format("{}: {} ({}), {}{} {} x {}", plan.node, plan.card, plan.bus, plan.fourcc,
                  plan.multiplanar ? " in several planes" : "", plan.width_px, plan.height_px);
  if (plan.decoded) text += ", decoded";
  if (plan.rate_hz > 0) text += fmt::format(" at {:.4g} Hz", plan.rate_hz);
  for (const std::string& control : plan.controls) text += ", " + control;
  return text;
}

}  // namespace aspect
