#include "runtime/capture/camera_decoder.h"

#ifdef ASPECT_V4LCONVERT
#include <libv4l-plugin.h>
#include <libv4lconvert.h>

#include <cerrno>
#include <limits>
#endif

namespace aspect {

#ifdef ASPECT_V4LCONVERT

struct CameraDecoder::Library {
  v4lconvert_data* data = nullptr;
  v4l2_format source{}, target{};
};

namespace {

// What the library asks of the device goes the way of all our calls.
int forward_ioctl(void* calls, int descriptor, unsigned long request, void* argument) {
  errno = static_cast<V4l2Calls*>(calls)->ioctl(descriptor, request, argument);
  return errno == 0 ? 0 : -1;
}

libv4l_dev_ops forwarding() {
  libv4l_dev_ops operations{};
  operations.ioctl = forward_ioctl;
  return operations;
}

const libv4l_dev_ops kForward = forwarding();

}  // namespace

bool CameraDecoder::available() {
  return true;
}

bool CameraDecoder::open(V4l2Calls& calls, int descriptor, const StreamFormat& format) {
  close();
  library_ = std::make_unique<Library>();
  v4l2_format& source = library_->source;
  source.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
  source.fmt.pix = format.picture;
  v4l2_format& target = library_->target;
  target = source;
  target.fmt.pix.pixelformat = V4L2_PIX_FMT_RGB24;
  target.fmt.pix.bytesperline = 3 * source.fmt.pix.width;
  target.fmt.pix.sizeimage = target.fmt.pix.bytesperline * source.fmt.pix.height;
  pixels_.resize(target.fmt.pix.sizeimage);
  library_->data = v4lconvert_create_with_dev_ops(descriptor, &calls, &kForward);
  return library_->data != nullptr;
}

void CameraDecoder::close() noexcept {
  if (library_ && library_->data) v4lconvert_destroy(library_->data);
  library_.reset();
}

bool CameraDecoder::decode(std::span<const std::uint8_t> bytes, Frame& frame) noexcept {
  if (!library_ || bytes.size() > std::numeric_limits<int>::max()) return false;
  const v4l2_pix_format& picture = library_->target.fmt.pix;
  // It does not write to its source.
  const int written = v4lconvert_convert(
      library_->data, &library_->source, &library_->target, const_cast<std::uint8_t*>(bytes.data()),
      static_cast<int>(bytes.size()), pixels_.data(), static_cast<int>(pixels_.size()));
  if (written < 0 || static_cast<std::uint32_t>(written) < picture.sizeimage) return false;
  frame = {pixels_.data(), static_cast<int>(picture.width), static_cast<int>(picture.height),
           static_cast<std::ptrdiff_t>(picture.bytesperline), PixelFormat::rgb8};
  return true;
}

#else

struct CameraDecoder::Library {};

bool CameraDecoder::available() {
  return false;
}
bool CameraDecoder::open(V4l2Calls&, int, const StreamFormat&) {
  return false;
}
void CameraDecoder::close() noexcept {}
bool CameraDecoder::decode(std::span<const std::uint8_t>, Frame&) noexcept {
  return false;
}

#endif

CameraDecoder::CameraDecoder() = default;
CameraDecoder::~CameraDecoder() {
  close();
}

}  // namespace aspect
