#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>

#include "tests/runtime/capture/fake_kernel.h"

namespace aspect {
namespace {

template <std::size_t kSize>
void put(unsigned char (&field)[kSize], const std::string& text) {
  std::memcpy(field, text.data(), std::min(kSize, text.size()));
}

std::uint32_t row_bytes(std::uint32_t fourcc, std::uint32_t width) {
  switch (fourcc) {
    case V4L2_PIX_FMT_RGB24:
    case V4L2_PIX_FMT_BGR24:
      return 3 * width;
    case V4L2_PIX_FMT_YUYV:
    case V4L2_PIX_FMT_UYVY:
    case V4L2_PIX_FMT_YVYU:
    case V4L2_PIX_FMT_Z16:
      return 2 * width;
    default:
      return width;
  }
}

struct Picture {
  std::uint32_t fourcc, width, height;
};
Picture picture_of(const v4l2_format& format, bool multi) {
  if (multi)
    return {format.fmt.pix_mp.pixelformat, format.fmt.pix_mp.width, format.fmt.pix_mp.height};
  return {format.fmt.pix.pixelformat, format.fmt.pix.width, format.fmt.pix.height};
}

const FakeFormat* find(const FakeCamera& camera, std::uint32_t fourcc) {
  const auto found = std::ranges::find(camera.formats, fourcc, &FakeFormat::fourcc);
  return found == camera.formats.end() ? nullptr : &*found;
}

int enumerate_format(FakeCamera& camera, v4l2_fmtdesc& answer) {
  if (answer.index >= camera.formats.size()) return EINVAL;
  answer.pixelformat = camera.formats[answer.index].fourcc;
  return 0;
}

int enumerate_size(FakeCamera& camera, v4l2_frmsizeenum& answer) {
  const FakeFormat* format = find(camera, answer.pixel_format);
  if (!format) return EINVAL;
  if (format->range) {
    answer.type = V4L2_FRMSIZE_TYPE_STEPWISE;
    answer.stepwise = *format->range;
    return answer.index == 0 ? 0 : EINVAL;
  }
  if (answer.index >= format->sizes.size()) return EINVAL;
  answer.type = V4L2_FRMSIZE_TYPE_DISCRETE;
  answer.discrete = {format->sizes[answer.index][0], format->sizes[answer.index][1]};
  return 0;
}

int enumerate_interval(FakeCamera& camera, v4l2_frmivalenum& answer) {
  const FakeFormat* format = find(camera, answer.pixel_format);
  if (!format || answer.index > 0) return EINVAL;
  answer.type = V4L2_FRMIVAL_TYPE_DISCRETE;
  answer.discrete = {1000, static_cast<std::uint32_t>(std::lround(1000 * format->rate_max_hz))};
  return 0;
}

// As drivers do: what they do not have silently becomes something else.
void adjust(const FakeCamera& camera, v4l2_format& format) {
  const Picture asked = picture_of(format, camera.multiplanar());
  const FakeFormat* found = find(camera, asked.fourcc);
  if (!found) found = &camera.formats.front();
  std::array<std::uint32_t, 2> size = {asked.width, asked.height};
  if (!found->range && std::ranges::find(found->sizes, size) == found->sizes.end())
    size = found->sizes.front();
  const std::uint32_t stride = row_bytes(found->fourcc, size[0]) + camera.gap_bytes;
  const bool two = found->fourcc == V4L2_PIX_FMT_NV12M || found->fourcc == V4L2_PIX_FMT_NV21M;
  const bool half_more = found->fourcc == V4L2_PIX_FMT_NV12 || found->fourcc == V4L2_PIX_FMT_NV21;
  const std::uint32_t bytes = stride * (half_more ? size[1] / 2 * 3 : size[1]);
  const std::uint32_t type = format.type;
  format = {};
  format.type = type;
  if (camera.multiplanar()) {
    v4l2_pix_format_mplane& answer = format.fmt.pix_mp;
    answer.width = size[0];
    answer.height = size[1];
    answer.pixelformat = found->fourcc;
    answer.field = V4L2_FIELD_NONE;
    answer.num_planes = two ? 2 : 1;
    answer.plane_fmt[0].bytesperline = answer.plane_fmt[1].bytesperline = stride;
    answer.plane_fmt[0].sizeimage = bytes;
    answer.plane_fmt[1].sizeimage = bytes / 2;
    answer.colorspace = camera.colorspace;
    answer.ycbcr_enc = static_cast<std::uint8_t>(camera.encoding);
    answer.quantization = static_cast<std::uint8_t>(camera.quantization);
  } else {
    v4l2_pix_format& answer = format.fmt.pix;
    answer.width = size[0];
    answer.height = size[1];
    answer.pixelformat = found->fourcc;
    answer.field = V4L2_FIELD_NONE;
    answer.bytesperline = stride;
    answer.sizeimage = bytes;
    answer.colorspace = camera.colorspace;
    answer.ycbcr_enc = camera.encoding;
    answer.quantization = camera.quantization;
  }
  if (camera.spoil_format) camera.spoil_format(format);
}

int set_format(FakeCamera& camera, v4l2_format& format) {
  if (camera.taken || !camera.buffers.empty()) return EBUSY;
  const v4l2_format asked = format;
  adjust(camera, format);
  camera.format = format;
  if (camera.lies) format = asked;
  return 0;
}

int parameters(FakeCamera& camera, v4l2_streamparm& answer, bool set) {
  v4l2_captureparm& capture = answer.parm.capture;
  if (set && !camera.rate_fixed)
    camera.rate_hz =
        static_cast<double>(capture.timeperframe.denominator) / capture.timeperframe.numerator;
  capture.capability = V4L2_CAP_TIMEPERFRAME;
  capture.timeperframe = {1000, static_cast<std::uint32_t>(std::lround(1000 * camera.rate_hz))};
  return 0;
}

int request_buffers(FakeCamera& camera, v4l2_requestbuffers& request) {
  if (camera.taken && request.count > 0) return EBUSY;
  camera.buffers.clear();
  camera.queued.clear();
  camera.done.clear();
  if (request.count == 0) return 0;
  if (camera.granted_buffers > 0) request.count = camera.granted_buffers;
  camera.buffers.resize(std::min(request.count, 32U));
  for (FakeCamera::Buffer& buffer : camera.buffers)
    for (std::uint32_t k = 0; k < camera.planes(); ++k)
      buffer.memory[k].resize(camera.plane_bytes(k) + camera.data_offset);
  camera.queued.reserve(64);
  camera.done.reserve(64);
  return 0;
}

int query_buffer(FakeCamera& camera, v4l2_buffer& answer) {
  if (answer.index >= camera.buffers.size()) return EINVAL;
  const auto& memory = camera.buffers[answer.index].memory;
  if (camera.multiplanar()) {
    for (std::uint32_t k = 0; k < camera.planes(); ++k) {
      answer.m.planes[k].length = static_cast<std::uint32_t>(memory[k].size());
      answer.m.planes[k].m.mem_offset = answer.index << 16U | k << 12U;
    }
    answer.length = camera.planes();
  } else {
    answer.length = static_cast<std::uint32_t>(memory[0].size());
    answer.m.offset = answer.index << 16U;
  }
  if (camera.spoil_query) camera.spoil_query(answer);
  return 0;
}

int queue_buffer(FakeCamera& camera, const v4l2_buffer& buffer) {
  if (camera.broken) return EIO;
  if (buffer.index >= camera.buffers.size() || camera.buffers[buffer.index].queued) return EINVAL;
  camera.buffers[buffer.index].queued = true;
  camera.queued.push_back(buffer.index);
  return 0;
}

int dequeue_buffer(FakeCamera& camera, v4l2_buffer& answer) {
  if (camera.broken) return EIO;
  if (!camera.streaming) return EINVAL;
  if (camera.done.empty()) return EAGAIN;
  const std::uint32_t index = camera.done.front();
  camera.done.erase(camera.done.begin());
  FakeCamera::Buffer& buffer = camera.buffers[index];
  buffer.queued = false;
  v4l2_plane* planes = answer.m.planes;
  const std::uint32_t used = buffer.done.bytesused;
  answer = buffer.done;
  answer.index = index;
  if (camera.multiplanar()) {
    answer.m.planes = planes;
    answer.bytesused = 0;
    for (std::uint32_t k = 0; k < camera.planes(); ++k) {
      planes[k].bytesused = camera.data_offset + (k == 0 ? used : camera.plane_bytes(k));
      planes[k].data_offset = camera.data_offset;
      planes[k].length = static_cast<std::uint32_t>(buffer.memory[k].size());
    }
  }
  if (camera.spoil_buffer) camera.spoil_buffer(answer);
  return 0;
}

int stream(FakeCamera& camera, bool on) {
  camera.streaming = on;
  if (on) return 0;
  camera.broken = false;
  camera.queued.clear();
  camera.done.clear();
  for (FakeCamera::Buffer& buffer : camera.buffers) buffer.queued = false;
  return 0;
}

int capability(const FakeCamera& camera, v4l2_capability& answer) {
  put(answer.driver, camera.driver);
  put(answer.card, camera.card);
  put(answer.bus_info, camera.bus);
  answer.device_caps = camera.abilities;
  // Of all nodes of the unit together.
  answer.capabilities = camera.abilities | V4L2_CAP_DEVICE_CAPS | V4L2_CAP_VIDEO_OUTPUT;
  return 0;
}

}  // namespace

std::uint32_t FakeCamera::planes() const {
  return multiplanar() ? format.fmt.pix_mp.num_planes : 1;
}

std::uint32_t FakeCamera::plane_bytes(std::uint32_t plane) const {
  return multiplanar() ? format.fmt.pix_mp.plane_fmt[plane].sizeimage : format.fmt.pix.sizeimage;
}

void fake_frame(FakeCamera& camera, V4l2Calls::Time time) {
  const auto period = std::chrono::duration<double>(1 / camera.rate_hz);
  camera.next_frame += std::chrono::duration_cast<std::chrono::nanoseconds>(period);
  if (camera.broken || camera.silent || camera.disconnected || camera.unplugged) return;
  const std::uint32_t sequence = camera.sequence++;
  ++camera.produced;
  if (camera.lose_next > 0) {
    --camera.lose_next;
    return;
  }
  if (camera.queued.empty()) return;
  const std::uint32_t index = camera.queued.front();
  camera.queued.erase(camera.queued.begin());
  FakeCamera::Buffer& buffer = camera.buffers[index];
  buffer.memory[0][camera.data_offset] = static_cast<std::uint8_t>(sequence);
  buffer.done = {};
  buffer.done.sequence = sequence;
  buffer.done.bytesused = camera.plane_bytes(0);
  buffer.done.flags = camera.stamp_flags;
  if (camera.flag_next > 0) {
    --camera.flag_next;
    buffer.done.flags |= V4L2_BUF_FLAG_ERROR;
  }
  if (camera.shorten_next > 0) {
    --camera.shorten_next;
    buffer.done.bytesused -= 2 * camera.gap_bytes + 2;
  }
  const auto since = std::chrono::duration_cast<std::chrono::microseconds>(time.time_since_epoch());
  buffer.done.timestamp.tv_sec = static_cast<long>(since.count() / 1'000'000);
  buffer.done.timestamp.tv_usec = static_cast<long>(since.count() % 1'000'000);
  camera.done.push_back(index);
}

int fake_ioctl(FakeCamera& camera, unsigned long request, void* argument) {
  switch (request) {
    case VIDIOC_QUERYCAP:
      return capability(camera, *static_cast<v4l2_capability*>(argument));
    case VIDIOC_ENUM_FMT:
      return enumerate_format(camera, *static_cast<v4l2_fmtdesc*>(argument));
    case VIDIOC_ENUM_FRAMESIZES:
      return enumerate_size(camera, *static_cast<v4l2_frmsizeenum*>(argument));
    case VIDIOC_ENUM_FRAMEINTERVALS:
      return enumerate_interval(camera, *static_cast<v4l2_frmivalenum*>(argument));
    case VIDIOC_TRY_FMT:
      adjust(camera, *static_cast<v4l2_format*>(argument));
      return 0;
    case VIDIOC_S_FMT:
      return set_format(camera, *static_cast<v4l2_format*>(argument));
    case VIDIOC_G_FMT:
      *static_cast<v4l2_format*>(argument) = camera.format;
      return 0;
    case VIDIOC_G_PARM:
    case VIDIOC_S_PARM:
      return parameters(camera, *static_cast<v4l2_streamparm*>(argument), request == VIDIOC_S_PARM);
    case VIDIOC_REQBUFS:
      return request_buffers(camera, *static_cast<v4l2_requestbuffers*>(argument));
    case VIDIOC_QUERYBUF:
      return query_buffer(camera, *static_cast<v4l2_buffer*>(argument));
    case VIDIOC_QBUF:
      return queue_buffer(camera, *static_cast<v4l2_buffer*>(argument));
    case VIDIOC_DQBUF:
      return dequeue_buffer(camera, *static_cast<v4l2_buffer*>(argument));
    case VIDIOC_STREAMON:
    case VIDIOC_STREAMOFF:
      return stream(camera, request == VIDIOC_STREAMON);
    default:
      return fake_control_ioctl(camera, request, argument);
  }
}

}  // namespace aspect
