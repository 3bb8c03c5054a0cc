#include "runtime/workbench/workbench_desk.h"

namespace aspect {

std::unique_ptr<Workbench> make_workbench(const WorkbenchParts&) {
  return nullptr;
}

std::unique_ptr<Workbench> make_camera_workbench(V4l2Calls*) {
  return nullptr;
}

}  // namespace aspect
