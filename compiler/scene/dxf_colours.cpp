#include "compiler/scene/dxf_colours.h"

#include <cstdlib>

#include "compiler/scene/aci_palette.h"

namespace aspect {
namespace {

constexpr int kByBlock = 0, kByLayer = 256, kNone = -1;

Eigen::Vector3d true_colour(int rgb) {
  return Eigen::Vector3d(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255) / 255.0;
}

}  // namespace

void DxfLayers::add(const DxfRecord& layer) {
  const int rgb = layer.whole(420, kNone);
  // A layer that is off has a negative number.
  colours_[std::string(layer.text(2))] =
      rgb >= 0 ? true_colour(rgb) : aci_colour(std::abs(layer.whole(62, 7)));
}

std::string DxfLayers::layer_of(const DxfRecord& entity, const DxfOwner& owner) {
  const std::string_view own = entity.text(8);
  return own.empty() || own == "0" ? owner.layer : std::string(own);
}

Eigen::Vector3d DxfLayers::colour_of(const DxfRecord& entity, const DxfOwner& owner) const {
  if (const int rgb = entity.whole(420, kNone); rgb >= 0) return true_colour(rgb);
  const int number = entity.whole(62, kByLayer);
  if (number == kByBlock) return owner.colour;
  if (number > 0 && number < kByLayer) return aci_colour(number);
  const auto layer = colours_.find(layer_of(entity, owner));
  return layer != colours_.end() ? layer->second : aci_colour(7);
}

}  // namespace aspect
