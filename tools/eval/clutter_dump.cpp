#include "tools/eval/clutter_dump.h"

#include <fmt/format.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <system_error>

#include "tools/aspectc/commands/whole_file.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

constexpr const char* kColumns =
    "file,object,r00,r01,r02,r10,r11,r12,r20,r21,r22,tx,ty,tz,vx,vy,vz,x,y,w,h,visible\n";

std::string truth_row(const std::string& file, const std::string& object, const Scene& scene,
                      const ClutteredFrame& frame) {
  if (!frame.has_object) return file + std::string(21, ',') + "\n";
  const Camera& camera = frame.camera;
  const Eigen::Matrix3d& r = camera.camera_from_object;
  const Eigen::Vector3d t = -r * scene.source_from_object(camera.position_object);
  const Eigen::Vector3d v = (camera.position_object - scene.studio.at).normalized();
  std::string row = file + "," + object;
  for (int k = 0; k < 9; ++k) row += fmt::format(",{:.9f}", r(k / 3, k % 3));
  for (const Eigen::Vector3d& three : {t, v})
    row += fmt::format(",{:.9f},{:.9f},{:.9f}", three.x(), three.y(), three.z());
  return row + fmt::format(",{},{},{},{},{:.4f}\n", frame.box.x, frame.box.y, frame.box.width,
                           frame.box.height, frame.visible);
}

}  // namespace

Result<ClutterDump> ClutterDump::create(const fs::path& folder) {
  std::error_code code;
  fs::create_directories(folder, code);
  if (code || !fs::is_directory(folder, code))
    return Error{folder.native() + ": cannot be made a folder; give another one"};
  ClutterDump dump;
  dump.folder_ = folder;
  dump.truth_ = kColumns;
  return dump;
}

std::optional<Error> ClutterDump::add(const std::string& object, std::size_t number,
                                      const Scene& scene, const ClutteredFrame& frame) {
  const std::string name = fmt::format("{}_{:06}.png", object, number);
  truth_ += truth_row(name, object, scene, frame);
  const cv::Mat rgb(frame.height_px, frame.width_px, CV_8UC3,
                    const_cast<std::uint8_t*>(frame.rgb.data()));
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  std::vector<std::uint8_t> png;
  if (!cv::imencode(".png", bgr, png)) return Error{name + ": cannot be made a PNG file"};
  const auto done = write_whole_file(folder_ / name, png);
  return done ? std::nullopt : std::optional(Error{done.error()});
}

std::optional<Error> ClutterDump::finish() const {
  const auto done = write_whole_text(folder_ / "truth.csv", truth_);
  return done ? std::nullopt : std::optional(Error{done.error()});
}

}  // namespace aspect
