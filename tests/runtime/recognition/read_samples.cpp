// Where there is no compiler half.
#include "tests/runtime/recognition/kept_sample.h"

namespace aspect {

std::vector<std::uint8_t> model_index_bytes(const std::string& name, int level) {
  return kept_sample(name + std::to_string(level));
}

std::vector<std::uint8_t> small_index_bytes() {
  return kept_sample("small");
}

class ModelCamera::Maker {};

ModelCamera::ModelCamera(const std::string& name) : name_(name) {}
ModelCamera::~ModelCamera() = default;
ModelCamera::ModelCamera(ModelCamera&& other) noexcept = default;

OwnedFrame ModelCamera::view(const Eigen::Vector3d& direction, double roll_rad) {
  return kept_view(view_name(name_, direction, roll_rad));
}

}  // namespace aspect
