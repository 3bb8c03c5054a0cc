#include "runtime/python_interface/array_frame.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace py = pybind11;

namespace aspect {
namespace {

struct NamedFormat {
  std::string_view name;
  aspect_format format;
  py::ssize_t channels;  // 1: the array has two dimensions
  py::ssize_t item_bytes = 1;
};

constexpr std::array<NamedFormat, 18> kFormats = {{{"bgr", ASPECT_BGR8, 3},
                                                   {"rgb", ASPECT_RGB8, 3},
                                                   {"bgrx", ASPECT_BGRX8, 4},
                                                   {"rgbx", ASPECT_RGBX8, 4},
                                                   {"bgra", ASPECT_BGRX8, 4},
                                                   {"rgba", ASPECT_RGBX8, 4},
                                                   {"grey", ASPECT_GREY8, 1},
                                                   {"gray", ASPECT_GREY8, 1},
                                                   {"depth", ASPECT_DEPTH16, 1, 2},
                                                   {"label", ASPECT_LABEL16, 1, 2},
                                                   {"yuyv", ASPECT_YUYV8, 2},
                                                   {"uyvy", ASPECT_UYVY8, 2},
                                                   {"nv12", ASPECT_NV12, 1},
                                                   {"nv21", ASPECT_NV21, 1},
                                                   {"bayer_rggb", ASPECT_BAYER_RGGB8, 1},
                                                   {"bayer_grbg", ASPECT_BAYER_GRBG8, 1},
                                                   {"bayer_gbrg", ASPECT_BAYER_GBRG8, 1},
                                                   {"bayer_bggr", ASPECT_BAYER_BGGR8, 1}}};

const NamedFormat& format_named(std::string_view name) {
  const auto* const found =
      std::find_if(kFormats.begin(), kFormats.end(),
                   [&](const NamedFormat& format) { return format.name == name; });
  if (found != kFormats.end()) return *found;
  std::string names;
  for (const NamedFormat& format : kFormats)
    names += (names.empty() ? "" : ", ") + std::string(format.name);
  throw py::value_error("format " + std::string(name) + " is none; it is one of " + names);
}

std::string text_of(const py::array& pixels) {
  std::string shape;
  for (py::ssize_t k = 0; k < pixels.ndim(); ++k)
    shape += (k > 0 ? " x " : "") + std::to_string(pixels.shape(k));
  return shape + " of " + std::string(py::str(pixels.dtype()));
}

std::string usual_format(const py::array& pixels, const std::string& colour_format) {
  const py::ssize_t item_bytes = pixels.itemsize();
  if (pixels.ndim() == 2 && item_bytes == 1) return "grey";
  if (pixels.ndim() == 2 && item_bytes == 2) return "depth";
  if (pixels.ndim() == 3 && pixels.shape(2) == 3) return colour_format;
  if (pixels.ndim() == 3 && pixels.shape(2) == 4) return colour_format.substr(0, 3) + "x";
  throw py::value_error("the array is " + text_of(pixels) +
                        "; give H x W x 3 of uint8, or name its format");
}

aspect_format swapped(aspect_format format) {
  return format == ASPECT_RGB8 ? ASPECT_BGR8 : ASPECT_RGB8;
}

}  // namespace

aspect_frame array_frame(const py::array& pixels, const std::string& format,
                         const std::string& colour_format) {
  const char kind = pixels.dtype().kind();
  if (kind != 'u' || pixels.itemsize() > 2)
    throw py::type_error("the array is " + text_of(pixels) +
                         "; frames are of uint8, depths and surface numbers of uint16");
  const NamedFormat& named =
      format_named(format.empty() ? usual_format(pixels, colour_format) : format);
  const bool is_flat = named.channels == 1;
  if (pixels.itemsize() != named.item_bytes || pixels.ndim() != (is_flat ? 2 : 3) ||
      (!is_flat && pixels.shape(2) != named.channels))
    throw py::value_error("the array is " + text_of(pixels) + "; a frame in " +
                          std::string(named.name) + " is H x W" +
                          (is_flat ? "" : " x " + std::to_string(named.channels)) + " of uint" +
                          std::to_string(8 * named.item_bytes));
  aspect_frame frame{};
  frame.format = named.format;
  frame.data = pixels.data();
  const py::ssize_t planes_height = pixels.shape(0);
  const bool has_chroma = named.format == ASPECT_NV12 || named.format == ASPECT_NV21;
  const py::ssize_t height = has_chroma ? planes_height * 2 / 3 : planes_height;
  constexpr py::ssize_t kMost = 1 << 20;  // refused by its size later on
  frame.width_px = static_cast<int>(std::min(pixels.shape(1), kMost));
  frame.height_px = static_cast<int>(std::min(height, kMost));
  frame.stride_bytes = pixels.strides(0);
  if (has_chroma && (planes_height % 3 != 0 || frame.stride_bytes < 0))
    throw py::value_error("a frame in " + std::string(named.name) +
                          " has its chroma in half as many rows below it: 3 H / 2 x W");
  const py::ssize_t pixel_bytes = named.channels * named.item_bytes;
  bool in_place = pixels.shape(1) == 1 || pixels.strides(1) == pixel_bytes;
  if (!is_flat && pixels.strides(2) != named.item_bytes) {
    // array[..., ::-1] is the other of rgb and bgr.
    in_place = in_place && named.channels == 3 && pixels.strides(2) == -1;
    frame.data = static_cast<const std::uint8_t*>(frame.data) - 2;
    frame.format = swapped(frame.format);
  }
  if (!in_place)
    throw py::value_error(
        "the pixels of a row do not lie one behind the other; give numpy.ascontiguousarray(array)");
  // A single row has any stride.
  if (height == 1) frame.stride_bytes = 0;
  return frame;
}

}  // namespace aspect
