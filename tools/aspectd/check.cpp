#include "tools/aspectd/check.h"

#include <fmt/format.h>
#include <cstdio>

#include "runtime/base/planned_memory.h"
#include "runtime/capture/camera.h"
#include "runtime/output/outputs.h"
#include "runtime/service/daemon_log.h"
#include "runtime/service/runtime_setup.h"

namespace aspect {
namespace {

void print_line(const std::string& text) {
  std::puts(text.c_str());
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) log_line("warning: " + warning);
}

void print_recognition(const RuntimeSetup& setup, int width_px, int height_px) {
  for (std::size_t k = 0; k < setup.indexes.size(); ++k) {
    const ClassIndex& index = setup.indexes[k];
    print_line(fmt::format("index: {}, {} classes, {} key views", index.object,
                           index.classes.size(), index.key_views.size()));
  }
  if (const Box& part = setup.parameters.vision.region_of_interest; !part.empty())
    print_line(fmt::format("region of interest: {} x {} at {}, {}", part.width, part.height, part.x,
                           part.y));
  Arena counting;
  Recogniser recogniser;
  recogniser.prepare(counting, setup.indexes, setup.parameters, width_px, height_px);
  print_line(fmt::format("memory: {:.1f} MiB for frames of {} x {}",
                         static_cast<double>(counting.used_bytes()) / (1 << 20), width_px,
                         height_px));
}

void print_outputs(const OutputSettings& output) {
  if (output.standard_output) print_line("output: standard output");
  if (output.file)
    print_line(fmt::format("output: {}, at most {} bytes, then {} older ones",
                           output.file->path.native(), output.file->max_bytes, output.file->keep));
  if (output.unix_socket) print_line("output: socket " + output.unix_socket->native());
  if (output.tcp)
    print_line(fmt::format("output: TCP {} port {}", output.tcp->address, output.tcp->port));
  if (output.mqtt)
    print_line(fmt::format("output: MQTT {} port {}, topic {}", output.mqtt->host,
                           output.mqtt->port, output.mqtt->topic));
  if (output.http)
    print_line(fmt::format("output: http://{}:{}/", output.http->address, output.http->port));
  for (const TriggerOutput& trigger : output.triggers)
    print_line(fmt::format("trigger: {} from score {}", trigger.object, trigger.score_min));
}

bool print_error(const std::string& message) {
  log_line(message);
  return false;
}

}  // namespace

bool check(const std::filesystem::path& file) {
  const Result<std::unique_ptr<RuntimeSetup>> setup = load_setup(file);
  if (!setup) return print_error(setup.error());
  print_warnings(setup.value()->warnings);
  const Configuration& configuration = setup.value()->configuration;
  Camera camera(configuration.capture);
  const Result<CameraPlan> plan = camera.check();
  bool right = true;
  if (plan) {
    print_line("camera: " + describe(plan.value()));
    print_warnings(plan.value().warnings);
    print_recognition(*setup.value(), plan.value().width_px, plan.value().height_px);
  } else {
    right = print_error(plan.error());
    print_recognition(*setup.value(), configuration.capture.width_px,
                      configuration.capture.height_px);
  }
  print_outputs(configuration.output);
  if (const auto error = Outputs::check(configuration.output)) right = print_error(error->message);
  return right;
}

}  // namespace aspect
