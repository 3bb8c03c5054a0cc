#include "compiler/scene/gltf_accessor.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "compiler/scene/coloured_mesh.h"

namespace aspect {
namespace {

using Json = GltfFile::Json;

static_assert(std::endian::native == std::endian::little, "as the buffers of glTF are");

enum class Component : std::size_t {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126
};

std::size_t bytes_of(Component component) {
  switch (component) {
    case Component::int8:
    case Component::uint8:
      return 1;
    case Component::int16:
    case Component::uint16:
      return 2;
    default:
      return 4;
  }
}

template <typename Value>
double value_at(const char* bytes) {
  Value value{};
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

double number_at(const char* bytes, Component component, bool normalised) {
  const double value = component == Component::int8     ? value_at<std::int8_t>(bytes)
                       : component == Component::uint8  ? value_at<std::uint8_t>(bytes)
                       : component == Component::int16  ? value_at<std::int16_t>(bytes)
                       : component == Component::uint16 ? value_at<std::uint16_t>(bytes)
                       : component == Component::uint32 ? value_at<std::uint32_t>(bytes)
                                                        : value_at<float>(bytes);
  if (!normalised) return value;
  switch (component) {
    case Component::int8:
      return std::max(value / 127, -1.0);
    case Component::uint8:
      return value / 255;
    case Component::int16:
      return std::max(value / 32767, -1.0);
    case Component::uint16:
      return value / 65535;
    default:
      return value;
  }
}

// Where numbers lie in a buffer view.
struct Layout {
  Component component = Component::float32;
  std::size_t width = 1;
  std::size_t offset = 0, stride = 0;  // bytes
  bool normalised = false;
};

Component component_of(const Json& json, std::string_view what) {
  const std::size_t number = whole_member(json, "componentType").value_or(0);
  constexpr std::array<std::size_t, 6> kKnown = {5120, 5121, 5122, 5123, 5125, 5126};
  if (std::find(kKnown.begin(), kKnown.end(), number) == kKnown.end())
    throw MeshError(fmt::format("{} has no known componentType; export it again", what));
  return static_cast<Component>(number);
}

std::size_t width_of(const Json& accessor, std::string_view what) {
  const std::string type = text_member(accessor, "type");
  for (const auto& [name, width] : {std::pair{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}})
    if (type == name) return static_cast<std::size_t>(width);
  throw MeshError(fmt::format("{} is neither scalar nor vector; export it again", what));
}

std::vector<double> numbers_in(std::string_view bytes, const Layout& layout, std::size_t count,
                               std::string_view what) {
  const std::size_t element = bytes_of(layout.component) * layout.width;
  const std::size_t stride = layout.stride == 0 ? element : layout.stride;
  const bool fits =
      count == 0 || (layout.offset <= bytes.size() && element <= bytes.size() - layout.offset &&
                     (count - 1) <= (bytes.size() - layout.offset - element) / stride);
  if (!fits)
    throw MeshError(fmt::format("{} is larger than its bufferView; export it again", what));
  std::vector<double> values;
  values.reserve(count * layout.width);
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t c = 0; c < layout.width; ++c)
      values.push_back(
          number_at(bytes.data() + layout.offset + k * stride + c * bytes_of(layout.component),
                    layout.component, layout.normalised));
  return values;
}

// Some elements of an accessor, replaced.
void replace_sparse(GltfFile& gltf, const Json& sparse, const Layout& layout, std::string_view what,
                    GltfNumbers& numbers) {
  const std::size_t count = whole_member(sparse, "count").value_or(0);
  const Json *indices = object_member(&sparse, "indices"),
             *values = object_member(&sparse, "values");
  if (count > numbers.count || indices == nullptr || values == nullptr)
    throw MeshError(fmt::format("{} is sparse and broken; export it again", what));
  const auto read = [&](const Json& json, Component component, std::size_t width) {
    const Layout own{component, width, whole_member(json, "byteOffset").value_or(0), 0,
                     width == 1 && &json == indices ? false : layout.normalised};
    return numbers_in(gltf.buffer_view(whole_member(json, "bufferView").value_or(SIZE_MAX)), own,
                      count, what);
  };
  const std::vector<double> places = read(*indices, component_of(*indices, what), 1);
  const std::vector<double> replaced = read(*values, layout.component, layout.width);
  for (std::size_t k = 0; k < count; ++k) {
    if (!(places[k] >= 0 && places[k] < static_cast<double>(numbers.count)))
      throw MeshError(fmt::format("{} is sparse and broken; export it again", what));
    std::copy_n(&replaced[k * layout.width], layout.width,
                &numbers.values[static_cast<std::size_t>(places[k]) * layout.width]);
  }
}

}  // namespace

GltfNumbers read_accessor(GltfFile& gltf, std::size_t index, std::string_view what,
                          std::size_t most) {
  const Json& accessor = gltf.at("accessors", index, what);
  const auto normalised = accessor.find("normalized");
  Layout layout{component_of(accessor, what), width_of(accessor, what),
                whole_member(accessor, "byteOffset").value_or(0), 0,
                normalised != accessor.end() && *normalised == true};
  GltfNumbers numbers;
  numbers.count = whole_member(accessor, "count").value_or(0);
  numbers.width = layout.width;
  if (numbers.count > most)
    throw MeshError(fmt::format("{} has {} elements, at most {} are read; simplify the model", what,
                                numbers.count, most));
  if (const auto view = whole_member(accessor, "bufferView")) {
    layout.stride = whole_member(gltf.at("bufferViews", *view, what), "byteStride").value_or(0);
    numbers.values = numbers_in(gltf.buffer_view(*view), layout, numbers.count, what);
  } else {
    numbers.values.assign(numbers.count * layout.width, 0);
  }
  if (const Json* sparse = object_member(&accessor, "sparse"))
    replace_sparse(gltf, *sparse, layout, what, numbers);
  return numbers;
}

}  // namespace aspect
