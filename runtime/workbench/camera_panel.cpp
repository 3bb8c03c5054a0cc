#include "runtime/workbench/camera_panel.h"

#include <algorithm>
#include <cstring>

#include "runtime/capture/camera_controls.h"

namespace aspect {
namespace {

constexpr std::chrono::seconds kAge{1};

class OpenNode {
 public:
  OpenNode(V4l2Calls& calls, const std::string& node)
      : calls_(calls), descriptor_(node.empty() ? -1 : calls.open(node.c_str())) {}
  ~OpenNode() {
    if (descriptor_ >= 0) calls_.close(descriptor_);
  }
  OpenNode(const OpenNode&) = delete;
  OpenNode& operator=(const OpenNode&) = delete;

  explicit operator bool() const { return descriptor_ >= 0; }
  int descriptor() const { return descriptor_; }

 private:
  V4l2Calls& calls_;
  int descriptor_;
};

}  // namespace

void CameraPanel::use(const std::string& node) {
  const std::lock_guard lock(mutex_);
  node_ = node;
  controls_.clear();
  listed_ = {};
}

std::vector<AdjustableControl> CameraPanel::controls() {
  const std::lock_guard lock(mutex_);
  if (listed_ != Clock::time_point{} && Clock::now() - listed_ < kAge) return controls_;
  controls_.clear();
  if (const OpenNode node(calls_, node_); node)
    controls_ = list_adjustable(calls_, node.descriptor());
  listed_ = Clock::now();
  return controls_;
}

Result<CameraPanel::Set> CameraPanel::set(const CameraControl& wanted) {
  const std::lock_guard lock(mutex_);
  const OpenNode node(calls_, node_);
  if (!node) return Error{"the camera cannot be opened now; wait until it streams"};
  const auto before = list_adjustable(calls_, node.descriptor());
  const auto known = std::ranges::find(before, wanted.name, &AdjustableControl::name);
  if (known == before.end())
    return Error{"the camera has no such control; its list is on the page"};
  using Kind = AdjustableControl::Kind;
  Set set{wanted,
          known->kind == Kind::truth || known->kind == Kind::menu,
          known->kind == Kind::button,
          {}};
  std::vector<std::string> values;
  const std::vector<CameraControl> one = {wanted};
  if (const CameraFault fault = set_controls(calls_, node.descriptor(), one, values, set.warnings))
    return Error{std::string(fault.text())};
  controls_ = list_adjustable(calls_, node.descriptor());
  listed_ = Clock::now();
  const auto now = std::ranges::find(controls_, wanted.name, &AdjustableControl::name);
  if (now != controls_.end() && !set.is_button) set.control.value = now->value;
  return set;
}

}  // namespace aspect
