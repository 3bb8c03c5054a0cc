#include "tools/aspectd/check.h"

#include <cstdio>

#include "runtime/base/planned_memory.h"
#include "runtime/capture/camera.h"
#include "runtime/output/outputs.h"
#include "runtime/service/daemon_log.h"
#include "runtime/service/runtime_setup.h"
#include "tools/aspectd/check_report.h"

namespace aspect {
namespace {

std::size_t memory_of(const RuntimeSetup& setup, int width_px, int height_px) {
  Arena counting;
  Recogniser recogniser;
  recogniser.prepare(counting, setup.indexes, setup.parameters, width_px, height_px);
  return counting.used_bytes();
}

void add_camera(const CameraSettings& settings, CheckReport& report) {
  Camera camera(settings);
  const Result<CameraPlan> plan = camera.check();
  report.width_px = settings.width_px;
  report.height_px = settings.height_px;
  if (!plan) return report.errors.push_back(plan.error());
  report.camera = plan.value();
  report.width_px = plan.value().width_px;
  report.height_px = plan.value().height_px;
  report.warnings.insert(report.warnings.end(), plan.value().warnings.begin(),
                         plan.value().warnings.end());
}

CheckReport report_of(const RuntimeSetup& setup) {
  CheckReport report;
  report.warnings = setup.warnings;
  add_camera(setup.configuration.capture, report);
  for (const ClassIndex& index : setup.indexes)
    report.indexes.push_back({index.object, index.classes.size(), index.key_views.size()});
  report.region_of_interest = setup.parameters.vision.region_of_interest;
  report.memory_bytes = memory_of(setup, report.width_px, report.height_px);
  report.outputs = setup.configuration.output;
  if (const auto error = Outputs::check(report.outputs)) report.errors.push_back(error->message);
  return report;
}

}  // namespace

bool check(const std::filesystem::path& file, bool json) {
  const Result<std::unique_ptr<RuntimeSetup>> setup = load_setup(file);
  if (!setup) {
    log_line(setup.error());
    return false;
  }
  const CheckReport report = report_of(*setup.value());
  for (const std::string& warning : report.warnings) log_line("warning: " + warning);
  for (const std::string& error : report.errors) log_line(error);
  std::fputs((json ? check_json(report) : check_text(report)).c_str(), stdout);
  return report.errors.empty();
}

}  // namespace aspect
