// Where there is a compiler half.
#include <cmath>

#include "compiler/render/renderer.h"
#include "tests/compiler/aspects/compiled_model.h"
#include "tests/runtime/recognition/kept_sample.h"

namespace aspect {

std::vector<std::uint8_t> model_index_bytes(const std::string& name, int level) {
  const std::string sample = name + std::to_string(level);
  if (is_sample_fresh(sample, model_file(name))) return kept_sample(sample);
  const std::vector<std::uint8_t> bytes =
      index_bytes_of(model_scene(name), options_of_level(level));
  keep_sample(sample, bytes);
  return bytes;
}

std::vector<std::uint8_t> small_index_bytes() {
  CompileOptions options = options_of_level(3);
  options.max_index_bytes = 12 * 1024;
  const std::vector<std::uint8_t> bytes = index_bytes_of(small_model_scene("cube"), options);
  keep_sample("small", bytes);
  return bytes;
}

class ModelCamera::Maker {
 public:
  explicit Maker(const Scene& scene)
      : studio_(scene.studio), renderer_(Renderer::create(scene).value()) {}

  OwnedFrame view(const Eigen::Vector3d& direction, double roll_rad) {
    Camera camera = camera_at(studio_, direction);
    const Eigen::Vector3d x = camera.camera_from_object.row(0);
    const Eigen::Vector3d y = camera.camera_from_object.row(1);
    const double c = std::cos(roll_rad), s = std::sin(roll_rad);
    camera.camera_from_object.row(0) = c * x - s * y;
    camera.camera_from_object.row(1) = s * x + c * y;
    renderer_.render(camera, picture_);
    return {picture_.width_px, picture_.height_px, picture_.rgb};
  }

 private:
  Studio studio_;
  Renderer renderer_;
  Picture picture_;
};

ModelCamera::ModelCamera(const std::string& name)
    : name_(name), maker_(std::make_unique<Maker>(model_scene(name))) {}
ModelCamera::~ModelCamera() = default;
ModelCamera::ModelCamera(ModelCamera&& other) noexcept = default;

OwnedFrame ModelCamera::view(const Eigen::Vector3d& direction, double roll_rad) {
  OwnedFrame frame = maker_->view(direction, roll_rad);
  keep_view(view_name(name_, direction, roll_rad), frame);
  return frame;
}

}  // namespace aspect
