// A recogniser opened as a C program does, and frames for it.
#pragma once

#include <array>
#include <catch2/catch.hpp>
#include <memory>
#include <vector>

#include "runtime/c_interface/aspect.h"
#include "tests/runtime/recognition/rendered_views.h"

namespace aspect {

struct Closed {
  void operator()(aspect_recogniser* recogniser) const { aspect_close(recogniser); }
};
using Opened = std::unique_ptr<aspect_recogniser, Closed>;

inline const std::vector<std::uint8_t>& cube_bytes() {
  static const std::vector<std::uint8_t> bytes = model_index_bytes("cube", 3);
  return bytes;
}
inline const std::vector<std::uint8_t>& l_shape_bytes() {
  static const std::vector<std::uint8_t> bytes = model_index_bytes("l_shape", 3);
  return bytes;
}

inline Opened open(const char* configuration = nullptr) {
  const std::array<aspect_source, 2> sources = {
      {{"cube", cube_bytes().data(), cube_bytes().size()},
       {"l_shape", l_shape_bytes().data(), l_shape_bytes().size()}}};
  char message[ASPECT_MESSAGE_BYTES];
  Opened opened(aspect_open(sources.data(), sources.size(), nullptr, configuration, message));
  INFO(message);
  REQUIRE(opened);
  return opened;
}

inline aspect_frame plain(const OwnedFrame& frame) {
  aspect_frame plain{};
  plain.data = frame.rgb.data();
  plain.width_px = frame.width_px;
  plain.height_px = frame.height_px;
  return plain;
}

inline OwnedFrame frame_of(const char* model) {
  return ModelCamera(model).view(Eigen::Vector3d(1, 0.6, 0.4).normalized(), 0.3);
}

inline aspect_recognition recognised(const Opened& opened, const aspect_frame& frame) {
  aspect_recognition seen;
  REQUIRE(aspect_recognise(opened.get(), &frame, &seen) == ASPECT_OK);
  return seen;
}

}  // namespace aspect
