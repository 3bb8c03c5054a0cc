#include "runtime/capture/camera_formats.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <tuple>

#include "runtime/capture/v4l2_text.h"
#include "runtime/vision/vision_limits.h"

namespace aspect {
namespace {

struct Row {
  std::uint32_t fourcc;
  PixelFormat pixels;
  int planes = 1;
};

// The cheapest first.
constexpr Row kOurs[] = {
    {V4L2_PIX_FMT_GREY, PixelFormat::grey8},
    {V4L2_PIX_FMT_YUYV, PixelFormat::yuyv8},
    {V4L2_PIX_FMT_UYVY, PixelFormat::uyvy8},
    {V4L2_PIX_FMT_NV12, PixelFormat::nv12},
    {V4L2_PIX_FMT_NV21, PixelFormat::nv21},
    {V4L2_PIX_FMT_NV12M, PixelFormat::nv12, 2},
    {V4L2_PIX_FMT_NV21M, PixelFormat::nv21, 2},
    {V4L2_PIX_FMT_RGB24, PixelFormat::rgb8},
    {V4L2_PIX_FMT_BGR24, PixelFormat::bgr8},
    {V4L2_PIX_FMT_Z16, PixelFormat::depth16},
    {V4L2_PIX_FMT_SRGGB8, PixelFormat::bayer_rggb8},
    {V4L2_PIX_FMT_SGRBG8, PixelFormat::bayer_grbg8},
    {V4L2_PIX_FMT_SGBRG8, PixelFormat::bayer_gbrg8},
    {V4L2_PIX_FMT_SBGGR8, PixelFormat::bayer_bggr8},
};

// What libv4lconvert turns into RGB: rearranged, then compressed, then the private formats of old
// webcams.
constexpr std::uint32_t kDecoded[] = {
    V4L2_PIX_FMT_YVYU,    V4L2_PIX_FMT_NV16,       V4L2_PIX_FMT_NV61,
    V4L2_PIX_FMT_YUV420,  V4L2_PIX_FMT_YVU420,     V4L2_PIX_FMT_RGB565,
    V4L2_PIX_FMT_BGR32,   V4L2_PIX_FMT_RGB32,      V4L2_PIX_FMT_XBGR32,
    V4L2_PIX_FMT_XRGB32,  V4L2_PIX_FMT_ABGR32,     V4L2_PIX_FMT_ARGB32,
    V4L2_PIX_FMT_MJPEG,   V4L2_PIX_FMT_JPEG,       V4L2_PIX_FMT_PJPG,
    V4L2_PIX_FMT_M420,    V4L2_PIX_FMT_HM12,       V4L2_PIX_FMT_SPCA501,
    V4L2_PIX_FMT_SPCA505, V4L2_PIX_FMT_SPCA508,    V4L2_PIX_FMT_SPCA561,
    V4L2_PIX_FMT_SN9C10X, V4L2_PIX_FMT_SN9C2028,   V4L2_PIX_FMT_SN9C20X_I420,
    V4L2_PIX_FMT_PAC207,  V4L2_PIX_FMT_MR97310A,   V4L2_PIX_FMT_JL2005BCD,
    V4L2_PIX_FMT_SQ905C,  V4L2_PIX_FMT_OV511,      V4L2_PIX_FMT_OV518,
    V4L2_PIX_FMT_STV0680, V4L2_PIX_FMT_CIT_YYVYUY, V4L2_PIX_FMT_KONICA420,
    V4L2_PIX_FMT_SE401,   V4L2_PIX_FMT_CPIA1,
};

constexpr std::uint32_t kMaxStride_bytes = 1U << 20U;

v4l2_pix_format as_single(const v4l2_pix_format_mplane& pieces) {
  v4l2_pix_format picture{};
  picture.width = pieces.width;
  picture.height = pieces.height;
  picture.pixelformat = pieces.pixelformat;
  picture.field = pieces.field;
  picture.bytesperline = pieces.plane_fmt[0].bytesperline;
  picture.sizeimage = pieces.plane_fmt[0].sizeimage;
  picture.colorspace = pieces.colorspace;
  picture.ycbcr_enc = pieces.ycbcr_enc;
  picture.quantization = pieces.quantization;
  return picture;
}

std::uint32_t row_bytes(const StreamFormat& stream) {
  return static_cast<std::uint32_t>(stream.width_px * bytes_per_pixel(stream.format.pixels));
}

// Some drivers say 0 for rows without gaps.
std::optional<std::string> take_stride(std::uint32_t given, const StreamFormat& stream,
                                       std::uint32_t& stride_bytes) {
  const bool torn = stream.format.pixels == PixelFormat::depth16 && given % 2 != 0;
  if (given != 0 && (given < row_bytes(stream) || given > kMaxStride_bytes || torn))
    return "the driver makes rows of " + std::to_string(given) + " bytes for " +
           std::to_string(stream.width_px) + " px; choose another format";
  stride_bytes = given == 0 ? row_bytes(stream) : given;
  return std::nullopt;
}

}  // namespace

std::optional<CameraFormat> camera_format(std::uint32_t fourcc, SensorKind sensor, bool decoder) {
  int cost = 0;
  for (const Row& row : kOurs) {
    if (row.fourcc == fourcc && gives(sensor, row.pixels))
      return CameraFormat{fourcc, row.pixels, row.planes, false, cost};
    ++cost;
  }
  if (!decoder || sensor != SensorKind::colour) return std::nullopt;
  for (const std::uint32_t decoded : kDecoded) {
    if (decoded == fourcc) return CameraFormat{fourcc, PixelFormat::rgb8, 1, true, cost};
    ++cost;
  }
  return std::nullopt;
}

std::int64_t size_distance(std::int64_t width_px, std::int64_t height_px,
                           const CameraSettings& settings) {
  return std::abs(width_px - settings.width_px) + std::abs(height_px - settings.height_px);
}

std::size_t best_offer(std::span<const FormatOffer> offers, const CameraSettings& settings) {
  const std::uint32_t asked = fourcc_of(settings.format);
  // Cameras give 29.97 where 30 is meant.
  const double sufficient_hz = settings.rate_hz.value_or(0) * 0.95;
  const auto rank = [&](const FormatOffer& offer) {
    const bool slow = offer.rate_max_hz > 0 && offer.rate_max_hz < sufficient_hz;
    return std::tuple(offer.format.fourcc != asked,
                      size_distance(offer.width_px, offer.height_px, settings), slow,
                      offer.format.cost);
  };
  const auto best = std::ranges::min_element(offers, {}, rank);
  return static_cast<std::size_t>(best - offers.begin());
}

std::optional<std::uint32_t> nearest_step(std::uint32_t least, std::uint32_t most,
                                          std::uint32_t step, int wanted) {
  if (least > most) return std::nullopt;
  const std::uint64_t every = std::max(step, 1U);
  const std::uint64_t inside =
      std::clamp<std::uint64_t>(static_cast<std::uint64_t>(std::max(wanted, 0)), least, most);
  std::uint64_t nearest = least + (inside - least + every / 2) / every * every;
  if (nearest > most) nearest -= every;
  return static_cast<std::uint32_t>(nearest);
}

YuvCoding yuv_coding(std::uint32_t colorspace, std::uint32_t encoding, std::uint32_t quantization) {
  if (encoding == V4L2_YCBCR_ENC_DEFAULT) encoding = V4L2_MAP_YCBCR_ENC_DEFAULT(colorspace);
  if (quantization == V4L2_QUANTIZATION_DEFAULT)
    quantization = V4L2_MAP_QUANTIZATION_DEFAULT(false, colorspace, encoding);
  YuvCoding coding;
  coding.full_range = quantization == V4L2_QUANTIZATION_FULL_RANGE;
  switch (encoding) {
    case V4L2_YCBCR_ENC_709:
    case V4L2_YCBCR_ENC_XV709:
    case V4L2_YCBCR_ENC_SMPTE240M:  // within 0.01 of it
      coding.matrix = YuvMatrix::bt709;
      break;
    case V4L2_YCBCR_ENC_BT2020:
    case V4L2_YCBCR_ENC_BT2020_CONST_LUM:
      coding.matrix = YuvMatrix::bt2020;
      break;
    default:
      coding.matrix = YuvMatrix::bt601;
  }
  return coding;
}

std::optional<std::string> take_format(const v4l2_format& agreed, const CameraFormat& format,
                                       StreamFormat& stream) {
  stream.format = format;
  stream.buffer_type = static_cast<v4l2_buf_type>(agreed.type);
  const v4l2_pix_format_mplane& pieces = agreed.fmt.pix_mp;
  const int planes = stream.multiplanar() ? pieces.num_planes : 1;
  if (planes != format.planes)
    return "the driver spreads " + fourcc_text(format.fourcc) + " over " + std::to_string(planes) +
           " pieces of memory, not " + std::to_string(format.planes) + "; choose another format";
  stream.picture = stream.multiplanar() ? as_single(pieces) : agreed.fmt.pix;

  const v4l2_pix_format& picture = stream.picture;
  const std::uint32_t width = picture.width, height = picture.height;
  if (width < kMinFrameSide_px || height < kMinFrameSide_px || width > kMaxFrameSide_px ||
      height > kMaxFrameSide_px || width * height > kMaxFramePixels)
    return "the driver makes frames of " + std::to_string(width) + " x " + std::to_string(height) +
           " px, which cannot be looked at; ask for another size";
  stream.width_px = static_cast<int>(has_even_width(format.pixels) ? width & ~1U : width);
  stream.height_px = static_cast<int>(has_even_height(format.pixels) ? height & ~1U : height);
  stream.yuv = yuv_coding(picture.colorspace, picture.ycbcr_enc, picture.quantization);
  if (format.decoded) return std::nullopt;
  const std::uint32_t second =
      planes == 2 ? pieces.plane_fmt[1].bytesperline : picture.bytesperline;
  if (auto complaint = take_stride(picture.bytesperline, stream, stream.stride_bytes[0]))
    return complaint;
  return take_stride(second, stream, stream.stride_bytes[1]);
}

std::uint64_t frame_bytes(const StreamFormat& stream, int plane) {
  if (stream.format.decoded) return 0;
  const PixelFormat pixels = stream.format.pixels;
  const auto rows = static_cast<std::uint64_t>(stream.height_px);
  const std::uint64_t stride = stream.stride_bytes[0], chroma_stride = stream.stride_bytes[1];
  const std::uint64_t chroma = (rows / 2 - 1) * chroma_stride + row_bytes(stream);
  if (plane == 1) return chroma;
  if (has_chroma_plane(pixels) && stream.format.planes == 1)
    return stream.picture.height * stride + chroma;
  return (rows - 1) * stride + row_bytes(stream);
}

}  // namespace aspect
