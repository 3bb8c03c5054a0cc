#include <fmt/format.h>

#include "runtime/service/daemon_log.h"
#include "tools/aspectd/check_report.h"

namespace aspect {
namespace {

void add_outputs(const OutputSettings& output, std::string& text) {
  if (output.standard_output) text += "output: standard output\n";
  if (output.file)
    text += fmt::format("output: {}, at most {} bytes, then {} older ones\n",
                        output.file->path.native(), output.file->max_bytes, output.file->keep);
  if (output.unix_socket) text += fmt::format("output: socket {}\n", output.unix_socket->native());
  if (output.tcp)
    text += fmt::format("output: TCP {} port {}\n", output.tcp->address, output.tcp->port);
  if (output.mqtt)
    text += fmt::format("output: MQTT {} port {}, topic {}\n", output.mqtt->host, output.mqtt->port,
                        output.mqtt->topic);
  if (output.http)
    text += fmt::format("output: http://{}:{}/\n", output.http->address, output.http->port);
  for (const TriggerOutput& trigger : output.triggers)
    text += fmt::format("trigger: {} from score {}\n", trigger.object, trigger.score_min);
}

}  // namespace

std::string check_text(const CheckReport& report) {
  std::string text;
  if (report.camera) text += fmt::format("camera: {}\n", describe(*report.camera));
  for (const CheckedIndex& index : report.indexes)
    text += fmt::format("index: {}, {} classes, {} key views\n", index.object, index.classes,
                        index.key_views);
  if (const Box& part = report.region_of_interest; !part.empty())
    text += fmt::format("region of interest: {} x {} at {}, {}\n", part.width, part.height, part.x,
                        part.y);
  text += fmt::format("memory: {:.1f} MiB for frames of {} x {}\n",
                      static_cast<double>(report.memory_bytes) / (1 << 20), report.width_px,
                      report.height_px);
  add_outputs(report.outputs, text);
  return text;
}

}  // namespace aspect
