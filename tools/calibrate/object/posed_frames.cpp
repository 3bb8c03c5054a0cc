#include "tools/calibrate/object/posed_frames.h"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "compiler/scene/scene_extent.h"
#include "runtime/capture/recorded_frames.h"
#include "runtime/recognition/sized_recogniser.h"
#include "runtime/service/configuration.h"
#include "runtime/service/index_set.h"
#include "tools/draw/frame_canvas.h"

namespace aspect {
namespace {

constexpr std::size_t kMostFrames = 500;  // they are kept

// Files keep coordinates as floats.
bool has_extent(const ClassIndex& index, const Scene& scene) {
  constexpr double kSame = 1e-3;
  if (index.extent.diameter <= 0) return true;
  const SceneExtent extent = scene_extent(scene);
  for (int axis = 0; axis < 3; ++axis) {
    const auto place = static_cast<std::size_t>(axis);
    if (std::abs(extent.least[axis] - index.extent.least[place]) > kSame * extent.diameter ||
        std::abs(extent.most[axis] - index.extent.most[place]) > kSame * extent.diameter)
      return false;
  }
  return true;
}

Frame frame_of(const cv::Mat& picture) {
  return {picture.data, picture.cols, picture.rows, static_cast<std::ptrdiff_t>(picture.step),
          PixelFormat::bgr8};
}

// Null where nothing is sure enough.
const SeenObject* surest(const Recognition& recognition) {
  constexpr float kSure = 0.8F;
  const SeenObject* best = nullptr;
  for (const SeenObject& object : recognition.objects) {
    const Judgement& judgement = object.judgement;
    if (judgement.verdict != Verdict::match || judgement.rival_count > 0 ||
        judgement.probability < kSure || object.hypotheses.front().pose == nullptr)
      continue;
    if (best == nullptr || judgement.probability > best->judgement.probability) best = &object;
  }
  return best;
}

std::optional<PosedFrame> find_with(SizedRecogniser& recogniser, const std::string& name,
                                    const cv::Mat& picture) {
  recogniser.make_room(picture.cols, picture.rows);
  const Recognition recognition = recogniser.recognise(frame_of(picture));
  const SeenObject* object = surest(recognition);
  if (object == nullptr) return std::nullopt;
  const RefinedPose& refined = object->hypotheses.front().pose->refined;
  PosedFrame posed{name, 0, picture, refined.pose, recogniser.cameras().front(), 0, 0};
  posed.probability = static_cast<double>(object->judgement.probability);
  posed.reprojection_px = static_cast<double>(refined.reprojection_px);
  return posed;
}

cv::Mat smaller(const cv::Mat& picture) {
  constexpr double kSide_px = 320;
  const double scale = std::min(1.0, kSide_px / std::max(picture.cols, picture.rows));
  cv::Mat small;
  cv::resize(picture, small, {}, scale, scale, cv::INTER_AREA);
  return small;
}

}  // namespace

Result<KnownObject> known_object(const std::filesystem::path& index,
                                 const std::filesystem::path& configuration, const Scene& scene) {
  KnownObject object;
  IndexSet set;
  load_indexes(index, set);
  if (!set.failures.empty()) return Error{set.failures.front()};
  for (ClassIndex& one : set.indexes)
    if (set.indexes.size() == 1 || one.object == scene.name)
      object.indexes.push_back(std::move(one));
  if (object.indexes.size() != 1)
    return Error{fmt::format("{}: has no object {}; compile the scene, and give its index",
                             index.native(), scene.name)};
  const ClassIndex& found = object.indexes.front();
  if (!has_extent(found, scene))
    return Error{fmt::format("{}: {} has another size than the scene {}; compile the scene again",
                             index.native(), found.object, scene.name)};
  if (found.vision.sensor != SensorKind::colour)
    return Error{index.native() + ": is of a sensor that sees no colours; give a colour index"};
  if (found.model.empty())
    return Error{index.native() + ": has no model, so that no pose is found; compile it again"};
  object.parameters.vision = found.vision;
  if (!configuration.empty()) {
    const Result<Configuration> read = read_configuration(configuration);
    if (!read) return Error{read.error()};
    read.value().apply(object.parameters);
  }
  object.parameters.tracking.on = false;
  object.parameters.time_limit = {};
  object.parameters.poses = true;
  object.parameters.ranking = RecogniserParameters::Ranking::views;
  return object;
}

Result<FoundFrames> find_object(const KnownObject& object,
                                const std::vector<std::filesystem::path>& paths) {
  RecordedFrames frames(paths);
  SizedRecogniser recogniser(object.indexes, object.parameters);
  FoundFrames found;
  CapturedFrame frame;
  for (FrameStatus status; (status = frames.next(frame)) != FrameStatus::end;) {
    if (status == FrameStatus::failed) return Error{frame.error};
    if (found.names.size() == kMostFrames)
      return Error{
          fmt::format("{}: more than {} frames; fewer say as much", frame.name, kMostFrames)};
    const cv::Mat picture = picture_of(frame.view());
    found.names.push_back(frame.name);
    found.pictures.push_back(smaller(picture));
    if (auto posed = find_with(recogniser, frame.name, picture)) {
      posed->number = frame.sequence;
      found.posed.push_back(std::move(*posed));
    } else {
      found.not_found.push_back(frame.name);
    }
  }
  return found;
}

std::optional<PosedFrame> find_in_picture(const KnownObject& object, const std::string& name,
                                          const cv::Mat& picture) {
  SizedRecogniser recogniser(object.indexes, object.parameters);
  return find_with(recogniser, name, picture);
}

}  // namespace aspect
