// A V4L2 node, single- or multi-planar, for capture or output, of a format that needs one buffer a
// frame: enough to feed vivid's loop and to look at what comes out of it. Shares no code with the
// runtime's camera, whose oracle it is.
#pragma once

#include <linux/videodev2.h>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace aspect {

enum class Direction { capture, output };

class VideoNode {
 public:
  VideoNode(std::string path, Direction direction)
      : path_(std::move(path)), direction_(direction) {}
  ~VideoNode() { close(); }
  VideoNode(const VideoNode&) = delete;
  VideoNode& operator=(const VideoNode&) = delete;

  // All of these: 0, or the errno of what went wrong. what() says which call it was.
  int open();
  void close();
  void move_to(const std::string& path);         // closes it, too
  int select_hdmi();                             // the node's first HDMI input or output
  int set_timings(int width_px, int height_px);  // 59.94 or 60 Hz of CEA-861
  int set_format(std::uint32_t fourcc, int width_px, int height_px);  // exactly, without gaps
  int set_control(const std::string& name, int value);  // as v4l2-ctl writes it, or 0x and its id
  int start(int buffers);  // maps them and starts; those for capture are queued
  void stop();
  int put(const std::uint8_t* frame);  // queues a copy, when a buffer is free
  int drain(int left);                 // until so many buffers are still queued
  // Waits for a frame, copies it.
  int take(std::vector<std::uint8_t>& frame, std::uint32_t& sequence, bool& damaged);

  bool is_open() const { return descriptor_ >= 0; }
  const std::string& path() const { return path_; }
  const std::string& what() const { return what_; }
  std::size_t frame_bytes() const { return frame_bytes_; }

 private:
  struct Buffer {
    std::uint8_t* data;
    std::size_t bytes;
  };
  int call(unsigned long request, void* argument, const char* name);
  int wait_until_ready(short events);
  int map(int buffers);
  int queue(std::uint32_t index);
  int dequeue(v4l2_buffer& buffer, v4l2_plane* planes);

  std::string path_, what_;
  Direction direction_;
  int descriptor_ = -1;
  bool multiplanar_ = false;
  std::uint32_t type_ = 0;
  std::size_t frame_bytes_ = 0;
  std::vector<Buffer> buffers_;
  std::vector<std::uint32_t> free_;
  int queued_ = 0;
};

// "YUYV" as V4L2 counts it; 0 where it is not four characters.
std::uint32_t fourcc_of(const std::string& name);

}  // namespace aspect
