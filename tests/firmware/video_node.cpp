#include "video_node.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>
#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>

// Not in front of videodev2.h: it needs its types.
#include <linux/v4l2-dv-timings.h>

namespace aspect {
namespace {

constexpr int kTimeoutMs = 5000;

// "Loop Video" as v4l2-ctl writes it: loop_video.
std::string control_name(const char* kernel_name) {
  std::string name;
  for (const char* c = kernel_name; *c != '\0'; ++c) {
    if (std::isalnum(static_cast<unsigned char>(*c)) != 0)
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(*c)));
    else if (!name.empty() && name.back() != '_')
      name += '_';
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  return name;
}

// Of so many pixels without gaps; 0: not one of the formats that the tests use.
std::size_t bytes_of(std::uint32_t fourcc, std::size_t pixels) {
  switch (fourcc) {
    case V4L2_PIX_FMT_GREY:
      return pixels;
    case V4L2_PIX_FMT_NV12:
      return pixels * 3 / 2;
    case V4L2_PIX_FMT_YUYV:
      return pixels * 2;
    case V4L2_PIX_FMT_RGB24:
      return pixels * 3;
    default:
      return 0;
  }
}

}  // namespace

std::uint32_t fourcc_of(const std::string& name) {
  if (name.size() != 4) return 0;
  return v4l2_fourcc(static_cast<std::uint32_t>(name[0]), static_cast<std::uint32_t>(name[1]),
                     static_cast<std::uint32_t>(name[2]), static_cast<std::uint32_t>(name[3]));
}

int VideoNode::call(unsigned long request, void* argument, const char* name) {
  int result = 0;
  do {
    result = ioctl(descriptor_, request, argument);
  } while (result < 0 && errno == EINTR);
  if (result >= 0) return 0;
  what_ = path_ + ": " + name + ": " + std::strerror(errno);
  return errno;
}

int VideoNode::open() {
  close();
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (descriptor_ < 0) {
    what_ = path_ + ": open: " + std::strerror(errno);
    return errno;
  }
  v4l2_capability capability{};
  if (const int error = call(VIDIOC_QUERYCAP, &capability, "QUERYCAP")) return error;
  const std::uint32_t can = capability.device_caps;
  multiplanar_ = (can & (V4L2_CAP_VIDEO_CAPTURE_MPLANE | V4L2_CAP_VIDEO_OUTPUT_MPLANE)) != 0;
  if (direction_ == Direction::capture)
    type_ = multiplanar_ ? V4L2_BUF_TYPE_VIDEO_CAPTURE_MPLANE : V4L2_BUF_TYPE_VIDEO_CAPTURE;
  else
    type_ = multiplanar_ ? V4L2_BUF_TYPE_VIDEO_OUTPUT_MPLANE : V4L2_BUF_TYPE_VIDEO_OUTPUT;
  return 0;
}

void VideoNode::close() {
  if (descriptor_ < 0) return;
  stop();
  ::close(descriptor_);
  descriptor_ = -1;
}

void VideoNode::move_to(const std::string& path) {
  close();
  path_ = path;
}

int VideoNode::select_hdmi() {
  const bool capture = direction_ == Direction::capture;
  for (std::uint32_t index = 0;; ++index) {
    v4l2_input input{};
    v4l2_output output{};
    input.index = output.index = index;
    const int error = capture ? call(VIDIOC_ENUMINPUT, &input, "no HDMI: ENUMINPUT")
                              : call(VIDIOC_ENUMOUTPUT, &output, "no HDMI: ENUMOUTPUT");
    if (error != 0) return error;
    const std::uint32_t can = capture ? input.capabilities : output.capabilities;
    if ((can & V4L2_IN_CAP_DV_TIMINGS) == 0) continue;
    return capture ? call(VIDIOC_S_INPUT, &index, "S_INPUT")
                   : call(VIDIOC_S_OUTPUT, &index, "S_OUTPUT");
  }
}

int VideoNode::set_timings(int width_px, int height_px) {
  v4l2_dv_timings vga = V4L2_DV_BT_CEA_640X480P59_94;
  v4l2_dv_timings hd = V4L2_DV_BT_CEA_1280X720P60;
  if (width_px > 1280 || height_px > 720) {
    what_ = path_ + ": no timings of that size";
    return EINVAL;
  }
  const bool small = width_px <= 640 && height_px <= 480;
  return call(VIDIOC_S_DV_TIMINGS, small ? &vga : &hd, "S_DV_TIMINGS");
}

int VideoNode::set_format(std::uint32_t fourcc, int width_px, int height_px) {
  v4l2_format wanted{};
  wanted.type = type_;
  const auto width = static_cast<std::uint32_t>(width_px);
  const auto height = static_cast<std::uint32_t>(height_px);
  v4l2_format present = wanted;
  if (const int error = call(VIDIOC_G_FMT, &present, "G_FMT")) return error;
  // What is there already need not be set, which nobody may while another process streams.
  const bool there = present.fmt.pix.pixelformat == fourcc && present.fmt.pix.width == width &&
                     present.fmt.pix.height == height;
  if (there && !multiplanar_) {
    wanted = present;
  } else {
    wanted.fmt.pix.width = width;
    wanted.fmt.pix.height = height;
    if (multiplanar_) {
      wanted.fmt.pix_mp.pixelformat = fourcc;
      wanted.fmt.pix_mp.field = V4L2_FIELD_NONE;
    } else {
      wanted.fmt.pix.pixelformat = fourcc;
      wanted.fmt.pix.field = V4L2_FIELD_NONE;
    }
    const int error = call(VIDIOC_S_FMT, &wanted, "S_FMT");
    const bool same = multiplanar_ && present.fmt.pix_mp.pixelformat == fourcc &&
                      present.fmt.pix_mp.width == width && present.fmt.pix_mp.height == height;
    if (error == EBUSY && same)
      wanted = present;
    else if (error != 0)
      return error;
  }
  const std::size_t row_bytes =
      multiplanar_ ? wanted.fmt.pix_mp.plane_fmt[0].bytesperline : wanted.fmt.pix.bytesperline;
  frame_bytes_ = bytes_of(fourcc, width * static_cast<std::size_t>(height));
  if (wanted.fmt.pix.width == width && wanted.fmt.pix.height == height && frame_bytes_ > 0 &&
      row_bytes == bytes_of(fourcc == V4L2_PIX_FMT_NV12 ? V4L2_PIX_FMT_GREY : fourcc, width) &&
      (!multiplanar_ || wanted.fmt.pix_mp.num_planes == 1))
    return 0;
  what_ = path_ + ": S_FMT: gives another size, rows with gaps or several buffers";
  return EINVAL;
}

int VideoNode::set_control(const std::string& name, int value) {
  v4l2_queryctrl query{};
  const bool by_id = name.compare(0, 2, "0x") == 0;
  std::uint32_t id =
      by_id ? static_cast<std::uint32_t>(std::strtoul(name.c_str(), nullptr, 16)) : 0;
  query.id = V4L2_CTRL_FLAG_NEXT_CTRL;
  while (id == 0 && ioctl(descriptor_, VIDIOC_QUERYCTRL, &query) == 0) {
    if (control_name(reinterpret_cast<const char*>(query.name)) == name) id = query.id;
    query.id |= V4L2_CTRL_FLAG_NEXT_CTRL;
  }
  if (id == 0) {
    what_ = path_ + ": there is no control " + name;
    return EINVAL;
  }
  v4l2_ext_control control{};
  control.id = id;
  control.value = value;
  v4l2_ext_controls controls{};
  controls.count = 1;
  controls.controls = &control;
  return call(VIDIOC_S_EXT_CTRLS, &controls, name.c_str());
}

int VideoNode::map(int buffers) {
  v4l2_requestbuffers request{};
  request.count = static_cast<std::uint32_t>(buffers);
  request.type = type_;
  request.memory = V4L2_MEMORY_MMAP;
  if (const int error = call(VIDIOC_REQBUFS, &request, "REQBUFS")) return error;
  for (std::uint32_t i = 0; i < request.count; ++i) {
    v4l2_plane planes[VIDEO_MAX_PLANES]{};
    v4l2_buffer buffer{};
    buffer.index = i;
    buffer.type = type_;
    buffer.memory = V4L2_MEMORY_MMAP;
    buffer.m.planes = planes;
    buffer.length = VIDEO_MAX_PLANES;
    if (!multiplanar_) buffer.m.planes = nullptr;
    if (const int error = call(VIDIOC_QUERYBUF, &buffer, "QUERYBUF")) return error;
    const std::size_t bytes = multiplanar_ ? planes[0].length : buffer.length;
    const auto offset = multiplanar_ ? planes[0].m.mem_offset : buffer.m.offset;
    void* data = mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor_,
                      static_cast<off_t>(offset));
    if (data == MAP_FAILED) {
      what_ = path_ + ": mmap: " + std::strerror(errno);
      return errno;
    }
    buffers_.push_back({static_cast<std::uint8_t*>(data), bytes});
    free_.push_back(i);
  }
  return 0;
}

int VideoNode::start(int buffers) {
  if (const int error = map(buffers)) return error;
  while (direction_ == Direction::capture && !free_.empty()) {
    if (const int error = queue(free_.back())) return error;
    free_.pop_back();
  }
  int type = static_cast<int>(type_);
  return call(VIDIOC_STREAMON, &type, "STREAMON");
}

void VideoNode::stop() {
  if (descriptor_ < 0) return;
  int type = static_cast<int>(type_);
  call(VIDIOC_STREAMOFF, &type, "STREAMOFF");
  for (const Buffer& buffer : buffers_) munmap(buffer.data, buffer.bytes);
  buffers_.clear();
  free_.clear();
  queued_ = 0;
  v4l2_requestbuffers request{};
  request.type = type_;
  request.memory = V4L2_MEMORY_MMAP;
  call(VIDIOC_REQBUFS, &request, "REQBUFS");
}

int VideoNode::wait_until_ready(short events) {
  pollfd node{descriptor_, events, 0};
  int ready = 0;
  do {
    ready = poll(&node, 1, kTimeoutMs);
  } while (ready < 0 && errno == EINTR);
  if (ready > 0) return 0;
  what_ = path_ + ": poll: nothing for 5 s";
  return ETIMEDOUT;
}

int VideoNode::queue(std::uint32_t index) {
  v4l2_plane planes[VIDEO_MAX_PLANES]{};
  v4l2_buffer buffer{};
  buffer.index = index;
  buffer.type = type_;
  buffer.memory = V4L2_MEMORY_MMAP;
  buffer.field = V4L2_FIELD_NONE;
  buffer.bytesused = static_cast<std::uint32_t>(frame_bytes_);
  if (multiplanar_) {
    planes[0].bytesused = buffer.bytesused;
    buffer.m.planes = planes;
    buffer.length = 1;
  }
  const int error = call(VIDIOC_QBUF, &buffer, "QBUF");
  if (error == 0) ++queued_;
  return error;
}

int VideoNode::dequeue(v4l2_buffer& buffer, v4l2_plane* planes) {
  const auto ready = static_cast<short>(direction_ == Direction::capture ? POLLIN : POLLOUT);
  if (const int error = wait_until_ready(ready)) return error;
  buffer = {};
  buffer.type = type_;
  buffer.memory = V4L2_MEMORY_MMAP;
  if (multiplanar_) {
    buffer.m.planes = planes;
    buffer.length = VIDEO_MAX_PLANES;
  }
  const int error = call(VIDIOC_DQBUF, &buffer, "DQBUF");
  if (error == 0) --queued_;
  return error;
}

int VideoNode::put(const std::uint8_t* frame) {
  if (free_.empty())
    if (const int error = drain(queued_ - 1)) return error;
  const std::uint32_t index = free_.back();
  if (buffers_[index].bytes < frame_bytes_) return ENOBUFS;
  std::copy_n(frame, frame_bytes_, buffers_[index].data);
  const int error = queue(index);
  if (error == 0) free_.pop_back();
  return error;
}

int VideoNode::drain(int left) {
  while (queued_ > left) {
    v4l2_plane planes[VIDEO_MAX_PLANES]{};
    v4l2_buffer buffer{};
    if (const int error = dequeue(buffer, planes)) return error;
    free_.push_back(buffer.index);
  }
  return 0;
}

int VideoNode::take(std::vector<std::uint8_t>& frame, std::uint32_t& sequence, bool& damaged) {
  v4l2_plane planes[VIDEO_MAX_PLANES]{};
  v4l2_buffer buffer{};
  if (const int error = dequeue(buffer, planes)) return error;
  // In a multi-planar buffer the picture may begin behind something else; vivid's does for YUYV.
  const std::size_t begin = multiplanar_ ? planes[0].data_offset : 0;
  const std::size_t used = multiplanar_ ? planes[0].bytesused : buffer.bytesused;
  const Buffer& memory = buffers_[buffer.index];
  const std::size_t end = std::min(used, memory.bytes);
  frame.assign(memory.data + std::min(begin, end), memory.data + end);
  sequence = buffer.sequence;
  damaged = (buffer.flags & V4L2_BUF_FLAG_ERROR) != 0;
  return queue(buffer.index);
}

}  // namespace aspect
