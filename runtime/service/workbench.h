// Who stands at the page's workbench, as the loop knows it: somebody who looks at frames and turns
// knobs. What it is made of is in runtime/workbench; the loop never waits for it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/capture/camera.h"
#include "runtime/output/page_desk.h"
#include "runtime/recognition/recogniser.h"
#include "runtime/service/configuration.h"

namespace aspect {

// What the loop works with; none of it is kept.
struct WorkbenchSetup {
  const Configuration& configuration;
  std::filesystem::path file;  // that the configuration is from; empty: there is none to write
  std::span<const ClassIndex> indexes;
  const RecogniserParameters& parameters;
  // Why a text would be no good in the file's place, as --check says.
  std::function<std::optional<Error>(const std::string& text)> check;
};

class Workbench : public PageDesk {
 public:
  // ---- between two frames, from the loop's thread: no waiting, no allocation
  // Somebody looks, or records.
  virtual bool wants_frame() const noexcept = 0;
  // `line` is the number of the line that will belong to it.
  virtual void show(const Frame& frame, const Recognition& recognition,
                    std::span<const CameraModel> cameras, std::uint64_t line) noexcept = 0;
  // True: regions are to be cut so from now on.
  virtual bool take_vision(VisionParameters& vision) noexcept = 0;
  // True: the camera's controls are these now; they were set already.
  virtual bool take_controls(std::vector<CameraControl>& controls) noexcept = 0;

  // ---- whenever something else has changed, from the same thread
  // Loaded, or loaded anew: what was changed and not written is forgotten.
  virtual void use(const WorkbenchSetup& setup) = 0;
  // The camera streams as planned; null: it does not.
  virtual void use_camera(const CameraPlan* plan) = 0;
};

// Null: this build has none.
using MakeWorkbench = std::unique_ptr<Workbench> (*)(V4l2Calls* calls);

}  // namespace aspect
