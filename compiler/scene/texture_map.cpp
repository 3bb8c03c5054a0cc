#include "compiler/scene/texture_map.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <string>

namespace aspect {
namespace {

// What libpng's callbacks work on.
struct PngInput {
  std::string_view left;
  std::string fault;
};

void read_bytes(png_structp png, png_bytep bytes, png_size_t count) {
  auto& left = static_cast<PngInput*>(png_get_io_ptr(png))->left;
  if (count > left.size()) png_error(png, "it ends too early");
  std::memcpy(bytes, left.data(), count);
  left.remove_prefix(count);
}

[[noreturn]] void fail(png_structp png, png_const_charp message) {
  static_cast<PngInput*>(png_get_error_ptr(png))->fault = message;
  png_longjmp(png, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

// Frees what libpng holds, however the reading ends.
struct PngReader {
  explicit PngReader(PngInput& input)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &input, fail, ignore_warning)),
        info(png != nullptr ? png_create_info_struct(png) : nullptr) {
    if (png != nullptr) png_set_read_fn(png, &input, read_bytes);
  }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }

  png_structp png;
  png_infop info;
};

// False where libpng gives up. It leaves by longjmp(), so nothing here may need a destructor.
bool read_size(const PngReader& reader) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_read_info(reader.png, reader.info);
  png_set_expand(reader.png);
  png_set_strip_16(reader.png);
  png_set_strip_alpha(reader.png);
  png_set_gray_to_rgb(reader.png);
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);
  return true;
}

bool read_rows(const PngReader& reader, png_bytepp rows) {
  if (setjmp(png_jmpbuf(reader.png)) != 0) return false;
  png_read_image(reader.png, rows);
  return true;
}

}  // namespace

Result<TextureMap> decode_png(std::string_view bytes, std::size_t max_pixels) {
  PngInput input{bytes, {}};
  const PngReader reader(input);
  if (reader.info == nullptr) return Error{"no memory for a picture; write a smaller one"};
  if (!read_size(reader)) return Error{fmt::format("no PNG picture ({}); write one", input.fault)};
  const std::size_t width = png_get_image_width(reader.png, reader.info);
  const std::size_t height = png_get_image_height(reader.png, reader.info);
  if (width * height > max_pixels)
    return Error{fmt::format("{} x {} pixels, {} are left for maps; write a smaller picture", width,
                             height, max_pixels)};
  if (png_get_rowbytes(reader.png, reader.info) != 3 * width)
    return Error{"a PNG picture of an unknown kind; write one of 8 bits a colour"};

  TextureMap map;
  map.width_px = static_cast<int>(width);
  map.height_px = static_cast<int>(height);
  map.rgb.resize(3 * width * height);
  std::vector<png_bytep> rows(height);
  for (std::size_t y = 0; y < height; ++y) rows[y] = &map.rgb[3 * width * y];
  if (!read_rows(reader, rows.data()))
    return Error{fmt::format("a damaged PNG picture ({}); write it anew", input.fault)};
  return map;
}

// FNV-1a, 64 bits.
std::uint64_t digest_of(const TextureMap& map) {
  std::uint64_t digest = 14695981039346656037u;
  const auto add = [&](std::uint64_t value) { digest = (digest ^ value) * 1099511628211u; };
  add(static_cast<std::uint64_t>(map.width_px));
  add(static_cast<std::uint64_t>(map.height_px));
  for (const std::uint8_t byte : map.rgb) add(byte);
  return digest;
}

}  // namespace aspect
