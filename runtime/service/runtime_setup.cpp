#include "runtime/service/runtime_setup.h"

#include <algorithm>

#include "runtime/output/outputs.h"
#include "runtime/recognition/self_test.h"
#include "runtime/service/index_set.h"

namespace aspect {
namespace {

bool has_object(const std::vector<ClassIndex>& indexes, const std::string& object) {
  return std::any_of(indexes.begin(), indexes.end(),
                     [&](const ClassIndex& index) { return index.object == object; });
}

Result<std::unique_ptr<RuntimeSetup>> setup_of(Result<Configuration> configuration,
                                               const std::filesystem::path& file) {
  if (!configuration) return Error{configuration.error()};
  auto setup = std::make_unique<RuntimeSetup>();
  setup->configuration = std::move(configuration).value();
  if (setup->configuration.indexes.empty())
    return Error{file.native() + ": names no indexes; add indexes = [\"NAME.aspect\"]"};
  IndexSet set = load_indexes(setup->configuration.indexes);
  if (!set.failures.empty()) return Error{set.failures.front()};
  setup->indexes = std::move(set.indexes);
  setup->warnings = std::move(set.warnings);
  if (auto error = self_test(setup->indexes)) return *error;

  for (const TriggerOutput& trigger : setup->configuration.output.triggers)
    if (!has_object(setup->indexes, trigger.object))
      return Error{file.native() + ": a trigger waits for " + trigger.object +
                   ", which no index has; mend its name, or add its index"};

  const SensorKind sensor = setup->indexes.front().vision.sensor;
  if (sensor == SensorKind::surface)
    return Error{
        set.files.front().native() +
        ": compiled for pictures of surface numbers, which no camera gives; replay recorded "
        "frames instead"};
  setup->configuration.capture.sensor = sensor;
  setup->parameters.vision = setup->indexes.front().vision;
  setup->configuration.apply(setup->parameters);
  return setup;
}

}  // namespace

Result<std::unique_ptr<RuntimeSetup>> load_setup(const std::filesystem::path& file) {
  return setup_of(read_configuration(file), file);
}

std::optional<Error> check_setup(const std::string& text, const std::filesystem::path& file) {
  const auto setup = setup_of(parse_configuration(text, file.native()), file);
  if (!setup) return Error{setup.error()};
  return Outputs::check(setup.value()->configuration.output);
}

}  // namespace aspect
