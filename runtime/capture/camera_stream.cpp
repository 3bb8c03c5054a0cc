// The frame handed out stays with us until the next call, so that the driver has three of four
// buffers while it is looked at. What waits is dequeued until there is no more; all but the newest
// go back at once. Nothing in a v4l2_buffer is believed before it was held against what was mapped.
#include "runtime/capture/camera_stream.h"

#include <cerrno>

namespace aspect {
namespace {

// A counter that jumps further was set anew, or is none.
constexpr std::uint32_t kMaxLost = 1'000'000;
// A time stamp that is older, or in the future, is none.
constexpr std::chrono::seconds kMaxAge{10};

}  // namespace

CameraFault CameraStream::map_buffer(std::uint32_t index) {
  std::array<v4l2_plane, VIDEO_MAX_PLANES> planes{};
  v4l2_buffer answer{};
  answer.type = format_.buffer_type;
  answer.memory = V4L2_MEMORY_MMAP;
  answer.index = index;
  if (format_.multiplanar()) {
    answer.m.planes = planes.data();
    answer.length = static_cast<std::uint32_t>(planes.size());
  }
  if (const int error = calls_.ioctl(descriptor_, VIDIOC_QUERYBUF, &answer); error != 0)
    return call_fault("VIDIOC_QUERYBUF", error);
  for (int k = 0; k < format_.format.planes; ++k) {
    const auto place = static_cast<std::size_t>(k);
    const std::uint32_t bytes = format_.multiplanar() ? planes[place].length : answer.length;
    const std::uint32_t offset =
        format_.multiplanar() ? planes[place].m.mem_offset : answer.m.offset;
    if (bytes == 0 || bytes < frame_bytes(format_, k))
      return camera_fault(CameraState::failed,
                          "the driver's buffers of %u bytes are too small for a frame of %d x %d",
                          bytes, format_.width_px, format_.height_px);
    std::uint8_t* memory = calls_.map(descriptor_, bytes, offset);
    if (!memory)
      return camera_fault(CameraState::failed, "a buffer of %u bytes cannot be mapped", bytes);
    buffers_[index].planes[place] = {memory, bytes};
  }
  return {};
}

CameraFault CameraStream::queue(std::uint32_t index) noexcept {
  std::array<v4l2_plane, VIDEO_MAX_PLANES> planes{};
  v4l2_buffer buffer{};
  buffer.type = format_.buffer_type;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.index = index;
  if (format_.multiplanar()) {
    buffer.m.planes = planes.data();
    buffer.length = static_cast<std::uint32_t>(format_.format.planes);
  }
  const int error = calls_.ioctl(descriptor_, VIDIOC_QBUF, &buffer);
  if (error != 0) return call_fault("VIDIOC_QBUF", error);
  buffers_[index].queued = true;
  return {};
}

CameraFault CameraStream::prepare(int descriptor, const StreamFormat& format) {
  stop();
  format_ = format;
  descriptor_ = descriptor;
  sequence_.reset();
  newest_ = taken_ = -1;
  late_ = lost_ = step_ = 0;

  v4l2_requestbuffers request{};
  request.count = kBuffers;
  request.type = format_.buffer_type;
  request.memory = V4L2_MEMORY_MMAP;
  if (const int error = calls_.ioctl(descriptor_, VIDIOC_REQBUFS, &request); error != 0)
    return call_fault("VIDIOC_REQBUFS", error);
  if (request.count < 2 || request.count > buffers_.size())
    return camera_fault(CameraState::failed, "the driver gives %u buffers instead of %u",
                        request.count, kBuffers);
  buffer_count_ = request.count;
  for (std::uint32_t k = 0; k < buffer_count_; ++k)
    if (CameraFault fault = map_buffer(k)) return fault;
  for (std::uint32_t k = 0; k < buffer_count_; ++k)
    if (CameraFault fault = queue(k)) return fault;
  return {};
}

CameraFault CameraStream::start() noexcept {
  int type = format_.buffer_type;
  const int error = calls_.ioctl(descriptor_, VIDIOC_STREAMON, &type);
  return error == 0 ? CameraFault{} : call_fault("VIDIOC_STREAMON", error);
}

void CameraStream::stop() noexcept {
  if (descriptor_ < 0) return;
  // Of a camera that is gone both fail, and closing it is enough.
  int type = format_.buffer_type;
  static_cast<void>(calls_.ioctl(descriptor_, VIDIOC_STREAMOFF, &type));
  for (Buffer& buffer : buffers_) {
    for (const Plane& plane : buffer.planes)
      if (plane.memory) calls_.unmap(plane.memory, plane.bytes);
    buffer = {};
  }
  v4l2_requestbuffers request{};
  request.type = format_.buffer_type;
  request.memory = V4L2_MEMORY_MMAP;
  static_cast<void>(calls_.ioctl(descriptor_, VIDIOC_REQBUFS, &request));
  descriptor_ = -1;
  buffer_count_ = 0;
  newest_ = taken_ = -1;
}

// Why the frame is no good; null and the place of its bytes where it is.
const char* CameraStream::damage_of(const v4l2_buffer& answer, std::span<const v4l2_plane> planes,
                                    Buffer& buffer) const noexcept {
  if ((answer.flags & V4L2_BUF_FLAG_ERROR) != 0) return "the driver flags the frame as damaged";
  for (int k = 0; k < format_.format.planes; ++k) {
    const auto place = static_cast<std::size_t>(k);
    const bool multi = format_.multiplanar();
    const std::uint32_t begin = multi ? planes[place].data_offset : 0;
    const std::uint32_t end = multi ? planes[place].bytesused : answer.bytesused;
    if (end > buffer.planes[place].bytes || begin > end)
      return "the driver claims more bytes than the buffer has";
    if (end == begin) return "the frame is empty";
    if (end - begin < frame_bytes(format_, k)) return "the frame is too short";
    if (begin % 2 != 0 && format_.format.pixels == PixelFormat::depth16)
      return "the frame begins within a pixel";
    buffer.begin[place] = begin;
    buffer.end[place] = end;
  }
  return nullptr;
}

// Counts modulo 2^32, as the driver does.
void CameraStream::count(std::uint32_t sequence) noexcept {
  const std::uint32_t step = sequence_ ? sequence - *sequence_ : 1;
  sequence_ = sequence;
  const bool plausible = step >= 1 && step <= kMaxLost;
  step_ += plausible ? step : 1;
  lost_ += plausible ? step - 1 : 0;
}

std::chrono::steady_clock::time_point CameraStream::capture_time(
    const v4l2_buffer& answer) noexcept {
  const auto now = calls_.now();
  if ((answer.flags & V4L2_BUF_FLAG_TIMESTAMP_MASK) != V4L2_BUF_FLAG_TIMESTAMP_MONOTONIC)
    return now;
  const std::int64_t seconds = answer.timestamp.tv_sec, part = answer.timestamp.tv_usec;
  constexpr std::int64_t kManySeconds = std::int64_t{1} << 32U;  // their nanoseconds fit
  if (seconds < 0 || seconds > kManySeconds || part < 0 || part >= 1'000'000) return now;
  const std::chrono::steady_clock::time_point stamped(std::chrono::seconds(seconds) +
                                                      std::chrono::microseconds(part));
  return stamped > now || now - stamped > kMaxAge ? now : stamped;
}

CameraFault CameraStream::drain(const char*& damage) noexcept {
  constexpr std::uint32_t kMaxTurns = 4 * VIDEO_MAX_FRAME;  // should it never say that it is empty
  damage = nullptr;
  for (std::uint32_t turn = 0; turn < kMaxTurns; ++turn) {
    std::array<v4l2_plane, VIDEO_MAX_PLANES> planes{};
    v4l2_buffer answer{};
    answer.type = format_.buffer_type;
    answer.memory = V4L2_MEMORY_MMAP;
    if (format_.multiplanar()) {
      answer.m.planes = planes.data();
      answer.length = static_cast<std::uint32_t>(planes.size());
    }
    const int error = calls_.ioctl(descriptor_, VIDIOC_DQBUF, &answer);
    if (error == EAGAIN) return {};
    if (error != 0) return call_fault("VIDIOC_DQBUF", error);
    if (answer.index >= buffer_count_ || !buffers_[answer.index].queued)
      return camera_fault(CameraState::failed, "the driver hands out buffer %u, which it has not",
                          answer.index);
    Buffer& buffer = buffers_[answer.index];
    buffer.queued = false;
    count(answer.sequence);
    damage = damage_of(answer, planes, buffer);
    if (damage) return queue(answer.index);
    buffer.captured = capture_time(answer);
    const int older = newest_;
    newest_ = static_cast<int>(answer.index);
    if (older < 0) continue;
    ++late_;
    if (CameraFault fault = queue(static_cast<std::uint32_t>(older))) return fault;
  }
  return {};
}

StreamFrame CameraStream::take() noexcept {
  const Buffer& buffer = buffers_[static_cast<std::size_t>(newest_)];
  taken_ = newest_;
  newest_ = -1;
  StreamFrame result;
  const std::uint8_t* first = buffer.planes[0].memory + buffer.begin[0];
  result.bytes = {first, buffer.end[0] - buffer.begin[0]};
  Frame& frame = result.frame;
  frame = {first, format_.width_px, format_.height_px,
           static_cast<std::ptrdiff_t>(format_.stride_bytes[0]), format_.format.pixels};
  frame.yuv = format_.yuv;
  if (frame.format == PixelFormat::nv12 || frame.format == PixelFormat::nv21) {
    frame.chroma_stride_bytes = static_cast<std::ptrdiff_t>(format_.stride_bytes[1]);
    frame.chroma = format_.format.planes == 2
                       ? buffer.planes[1].memory + buffer.begin[1]
                       : first + std::size_t{format_.picture.height} * format_.stride_bytes[0];
  }
  result.late = late_;
  result.lost = lost_;
  result.step = step_;
  result.captured = buffer.captured;
  late_ = lost_ = step_ = 0;
  return result;
}

CameraFault CameraStream::release() noexcept {
  if (taken_ < 0) return {};
  const auto index = static_cast<std::uint32_t>(taken_);
  taken_ = -1;
  return queue(index);
}

}  // namespace aspect
