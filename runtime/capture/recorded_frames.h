// Frames from files: pictures, raw frames, folders of them, videos.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/capture/frame_source.h"
#include "runtime/vision/sensor_kind.h"

namespace aspect {

// Frames come in the order of the paths, those of a folder in the order of their names (byte by
// byte; only files that end like a picture or raw frames; not its subfolders). Colours of every
// kind become BGR of 8 bits a channel, or grey for a grey sensor; what is transparent is black,
// hence background, whatever colour lies under it; a photograph is turned as its EXIF data say.
// Range and surface frames are read as they are; videos hold colours only. A frame keeps within the
// limits of vision_limits.h. A path, a picture or a video that is no good is one failed frame, and
// the rest goes on. Not for several threads at once, not even for several sources: see
// StderrCapture.
class RecordedFrames : public FrameSource {
 public:
  // Looks the paths up, but opens nothing. Silences OpenCV's and FFmpeg's logs.
  explicit RecordedFrames(std::span<const std::filesystem::path> paths,
                          SensorKind sensor = SensorKind::colour);
  ~RecordedFrames() override;

  [[nodiscard]] FrameStatus next(CapturedFrame& frame) override;

  // How many frames there will be, failed ones counted; none where a video is among them.
  std::optional<std::size_t> count() const;

 private:
  enum class Kind { picture, raw, video, unusable };
  struct Item {
    Kind kind;
    std::filesystem::path path;
    std::string error;       // of what is unusable
    std::size_t frames = 1;  // not of videos
  };
  void add(const std::filesystem::path& path);
  void add_folder(const std::filesystem::path& folder);
  FrameStatus next_of_open(CapturedFrame& frame);
  FrameStatus open_item(const Item& item, CapturedFrame& frame);

  SensorKind sensor_;
  std::vector<Item> items_;
  std::size_t next_item_ = 0;
  std::uint64_t sequence_ = 0;
  std::unique_ptr<FrameSource> open_;  // a file of several frames
};

}  // namespace aspect
