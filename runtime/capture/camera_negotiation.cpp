#include "runtime/capture/camera_negotiation.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>

#include "runtime/capture/v4l2_text.h"

namespace aspect {
namespace {

// A driver that never stops counting up is not listened to for ever.
constexpr std::uint32_t kMaxFormats = 256, kMaxSizes = 512, kMaxIntervals = 256;

std::string size_text(std::int64_t width_px, std::int64_t height_px) {
  return std::to_string(width_px) + " x " + std::to_string(height_px) + " px";
}

std::string rate_text(double rate_hz) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", rate_hz);
  return text;
}

double rate_of(const v4l2_fract& interval) {
  if (interval.numerator == 0 || interval.denominator == 0) return 0;
  return static_cast<double>(interval.denominator) / interval.numerator;
}

v4l2_format format_of(const FoundCamera& camera, const FormatOffer& offer) {
  v4l2_format format{};
  format.type = camera.buffer_type;
  const auto fill = [&](auto& picture) {
    picture.width = static_cast<std::uint32_t>(offer.width_px);
    picture.height = static_cast<std::uint32_t>(offer.height_px);
    picture.pixelformat = offer.format.fourcc;
    picture.field = V4L2_FIELD_NONE;
  };
  if (camera.multiplanar())
    fill(format.fmt.pix_mp);
  else
    fill(format.fmt.pix);
  return format;
}

// Of a camera that does not list its sizes.
void try_size(V4l2Calls& calls, const FoundCamera& camera, FormatOffer& offer) {
  v4l2_format format = format_of(camera, offer);
  const v4l2_pix_format& single = format.fmt.pix;
  const v4l2_pix_format_mplane& multi = format.fmt.pix_mp;
  if (calls.ioctl(camera.descriptor, VIDIOC_TRY_FMT, &format) != 0) return;
  const std::uint32_t tried_width = camera.multiplanar() ? multi.width : single.width;
  const std::uint32_t tried_height = camera.multiplanar() ? multi.height : single.height;
  if (tried_width > INT16_MAX || tried_height > INT16_MAX) return;
  offer.width_px = static_cast<int>(tried_width);
  offer.height_px = static_cast<int>(tried_height);
}

void consider_size(std::uint32_t width_px, std::uint32_t height_px, const CameraSettings& settings,
                   FormatOffer& offer, bool& any) {
  if (width_px == 0 || height_px == 0 || width_px > INT16_MAX || height_px > INT16_MAX) return;
  const std::int64_t distance = size_distance(width_px, height_px, settings);
  if (any && distance >= size_distance(offer.width_px, offer.height_px, settings)) return;
  offer.width_px = static_cast<int>(width_px);
  offer.height_px = static_cast<int>(height_px);
  any = true;
}

void find_size(V4l2Calls& calls, const FoundCamera& camera, const CameraSettings& settings,
               FormatOffer& offer) {
  bool any = false;
  for (std::uint32_t k = 0; k < kMaxSizes; ++k) {
    v4l2_frmsizeenum answer{};
    answer.index = k;
    answer.pixel_format = offer.format.fourcc;
    if (calls.ioctl(camera.descriptor, VIDIOC_ENUM_FRAMESIZES, &answer) != 0) break;
    if (answer.type == V4L2_FRMSIZE_TYPE_DISCRETE) {
      consider_size(answer.discrete.width, answer.discrete.height, settings, offer, any);
      continue;
    }
    const v4l2_frmsize_stepwise& range = answer.stepwise;
    const auto width =
        nearest_step(range.min_width, range.max_width, range.step_width, settings.width_px);
    const auto height =
        nearest_step(range.min_height, range.max_height, range.step_height, settings.height_px);
    if (width && height) consider_size(*width, *height, settings, offer, any);
    break;
  }
  if (any) return;
  offer.width_px = settings.width_px;
  offer.height_px = settings.height_px;
  try_size(calls, camera, offer);
}

double find_rate(V4l2Calls& calls, const FoundCamera& camera, const FormatOffer& offer) {
  double most_hz = 0;
  for (std::uint32_t k = 0; k < kMaxIntervals; ++k) {
    v4l2_frmivalenum answer{};
    answer.index = k;
    answer.pixel_format = offer.format.fourcc;
    answer.width = static_cast<std::uint32_t>(offer.width_px);
    answer.height = static_cast<std::uint32_t>(offer.height_px);
    if (calls.ioctl(camera.descriptor, VIDIOC_ENUM_FRAMEINTERVALS, &answer) != 0) break;
    const bool discrete = answer.type == V4L2_FRMIVAL_TYPE_DISCRETE;
    most_hz = std::max(most_hz, rate_of(discrete ? answer.discrete : answer.stepwise.min));
    if (!discrete) break;
  }
  return most_hz;
}

CameraFault set_format(V4l2Calls& calls, const FoundCamera& camera, const FormatOffer& offer,
                       v4l2_format& agreed) {
  agreed = format_of(camera, offer);
  if (camera.multiplanar())
    agreed.fmt.pix_mp.num_planes = static_cast<std::uint8_t>(offer.format.planes);
  const int error = calls.ioctl(camera.descriptor, VIDIOC_S_FMT, &agreed);
  if (error != 0) return call_fault("VIDIOC_S_FMT", error);
  // Drivers answer with what they were asked for and do another thing.
  v4l2_format real{};
  real.type = camera.buffer_type;
  if (calls.ioctl(camera.descriptor, VIDIOC_G_FMT, &real) == 0) agreed = real;
  agreed.type = camera.buffer_type;
  return {};
}

void set_rate(V4l2Calls& calls, const FoundCamera& camera, const CameraSettings& settings,
              double& rate_hz, std::vector<std::string>& warnings) {
  v4l2_streamparm parameters{};
  parameters.type = camera.buffer_type;
  v4l2_captureparm& capture = parameters.parm.capture;
  const bool answers = calls.ioctl(camera.descriptor, VIDIOC_G_PARM, &parameters) == 0;
  const bool adjustable = answers && (capture.capability & V4L2_CAP_TIMEPERFRAME) != 0;
  rate_hz = answers ? rate_of(capture.timeperframe) : 0;
  if (!settings.rate_hz) return;
  const double wanted_hz = *settings.rate_hz;
  if (adjustable && wanted_hz > 0 && wanted_hz < 1e6) {
    parameters = {};
    parameters.type = camera.buffer_type;
    capture.timeperframe.numerator = 1000;
    capture.timeperframe.denominator =
        std::max(1U, static_cast<std::uint32_t>(std::lround(1000 * wanted_hz)));
    if (calls.ioctl(camera.descriptor, VIDIOC_S_PARM, &parameters) == 0)
      rate_hz = rate_of(capture.timeperframe);
  }
  if (rate_hz == 0)
    warnings.push_back("the camera does not say its rate; " + rate_text(wanted_hz) +
                       " frames a second were asked for");
  else if (std::abs(rate_hz - wanted_hz) > 0.01 * wanted_hz)
    warnings.push_back("the rate is " + rate_text(rate_hz) + " frames a second, not " +
                       rate_text(wanted_hz));
}

void compare(const CameraSettings& settings, const v4l2_pix_format& picture,
             const StreamFormat& stream, std::vector<std::string>& warnings) {
  const std::uint32_t asked = fourcc_of(settings.format);
  if (!settings.format.empty() && asked != stream.format.fourcc)
    warnings.push_back("the format is " + fourcc_text(stream.format.fourcc) + ", not " +
                       v4l2_text(settings.format.data(), settings.format.size()) +
                       ", which the camera does not have or which cannot be read");
  if (stream.width_px != settings.width_px || stream.height_px != settings.height_px)
    warnings.push_back("the size is " + size_text(stream.width_px, stream.height_px) + ", not " +
                       size_text(settings.width_px, settings.height_px));
  if (picture.field != V4L2_FIELD_NONE && picture.field != V4L2_FIELD_ANY)
    warnings.push_back("frames are interlaced: what moves is torn");
  const bool rgb =
      stream.format.pixels == PixelFormat::rgb8 || stream.format.pixels == PixelFormat::bgr8;
  if (rgb && !stream.format.decoded && picture.quantization == V4L2_QUANTIZATION_LIM_RANGE)
    warnings.push_back("colours are of limited range and look flat");
}

}  // namespace

CameraFault list_offers(V4l2Calls& calls, const FoundCamera& camera, const CameraSettings& settings,
                        bool decoder, std::vector<FormatOffer>& offers, std::string& all) {
  for (std::uint32_t k = 0; k < kMaxFormats; ++k) {
    v4l2_fmtdesc answer{};
    answer.index = k;
    answer.type = camera.buffer_type;
    const int error = calls.ioctl(camera.descriptor, VIDIOC_ENUM_FMT, &answer);
    if (error == ENODEV || error == EIO) return call_fault("VIDIOC_ENUM_FMT", error);
    if (error != 0) break;
    all.append(1, ' ').append(fourcc_text(answer.pixelformat));
    auto format = camera_format(answer.pixelformat, settings.sensor, decoder);
    if (!format || (format->planes > 1 && !camera.multiplanar())) continue;
    FormatOffer offer{*format};
    find_size(calls, camera, settings, offer);
    if (settings.rate_hz) offer.rate_max_hz = find_rate(calls, camera, offer);
    offers.push_back(offer);
  }
  if (!offers.empty()) return {};
  const std::string_view sensor = name_of(settings.sensor);
  return camera_fault(
      CameraState::failed, "the camera has no format that gives %.*s frames here; it has%.120s",
      static_cast<int>(sensor.size()), sensor.data(), all.empty() ? " none" : all.c_str());
}

CameraFault negotiate_format(V4l2Calls& calls, const FoundCamera& camera,
                             const CameraSettings& settings, bool decoder, StreamFormat& stream,
                             double& rate_hz, std::vector<std::string>& warnings) {
  std::vector<FormatOffer> offers;
  std::string all;
  if (CameraFault fault = list_offers(calls, camera, settings, decoder, offers, all)) return fault;
  v4l2_format agreed;
  if (CameraFault fault = set_format(calls, camera, offers[best_offer(offers, settings)], agreed))
    return fault;

  const std::uint32_t fourcc =
      camera.multiplanar() ? agreed.fmt.pix_mp.pixelformat : agreed.fmt.pix.pixelformat;
  const auto format = camera_format(fourcc, settings.sensor, decoder);
  if (!format)
    return camera_fault(CameraState::failed,
                        "the driver insists on %s, which cannot be read; choose another format",
                        fourcc_text(fourcc).c_str());
  if (const auto complaint = take_format(agreed, *format, stream))
    return camera_fault(CameraState::failed, "%s", complaint->c_str());
  switch (stream.picture.field) {
    case V4L2_FIELD_TOP:
    case V4L2_FIELD_BOTTOM:
    case V4L2_FIELD_ALTERNATE:
    case V4L2_FIELD_SEQ_TB:
    case V4L2_FIELD_SEQ_BT:
      return camera_fault(CameraState::failed,
                          "the driver gives single fields instead of frames; choose another size");
    default:
      break;
  }
  set_rate(calls, camera, settings, rate_hz, warnings);
  compare(settings, stream.picture, stream, warnings);
  return {};
}

}  // namespace aspect
