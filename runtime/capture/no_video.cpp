#include "runtime/capture/decoders.h"

namespace aspect {
namespace {

class NoVideo : public FrameSource {
 public:
  explicit NoVideo(std::filesystem::path file) : file_(std::move(file)) {}

  [[nodiscard]] FrameStatus next(CapturedFrame& frame) override {
    if (told_) return FrameStatus::end;
    told_ = true;
    frame.name = file_.native();
    frame.error = file_.native() +
                  ": a video, which is read only where libopencv-videoio-dev was found; give raw "
                  "frames, NAME.WIDTHxHEIGHT.FOURCC";
    return FrameStatus::failed;
  }

 private:
  std::filesystem::path file_;
  bool told_ = false;
};

}  // namespace

std::unique_ptr<FrameSource> open_video(const std::filesystem::path& file) {
  return std::make_unique<NoVideo>(file);
}

}  // namespace aspect
