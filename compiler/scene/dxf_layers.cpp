#include "compiler/scene/dxf_layers.h"

#include <cstdlib>

#include "compiler/scene/aci_palette.h"
#include "compiler/scene/dxf_names.h"

namespace aspect {
namespace {

constexpr int kByBlock = 0, kByLayer = 256, kNone = -1;

Eigen::Vector3d true_colour(int rgb) {
  return Eigen::Vector3d(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255) / 255.0;
}

}  // namespace

void DxfLayers::add(const DxfRecord& layer) {
  const int rgb = layer.whole(420, kNone), number = layer.whole(62, 7);
  Layer added{std::string(layer.text(2)), {}};
  added.colour = rgb >= 0 ? true_colour(rgb) : aci_colour(std::abs(number));
  added.off = number < 0;
  added.frozen = (layer.whole(70, 0) & 1) != 0;
  layers_[dxf_key(added.name)] = added;
}

const DxfLayers::Layer* DxfLayers::find(const std::string& name) const {
  const auto found = layers_.find(dxf_key(name));
  return found != layers_.end() ? &found->second : nullptr;
}

std::string DxfLayers::layer_of(const DxfRecord& entity, const DxfOwner& owner) const {
  const std::string_view own = entity.text(8);
  if (own.empty() || own == "0") return owner.layer;
  const Layer* layer = find(std::string(own));
  return layer != nullptr ? layer->name : std::string(own);
}

Eigen::Vector3d DxfLayers::colour_of(const DxfRecord& entity, const DxfOwner& owner) const {
  if (const int rgb = entity.whole(420, kNone); rgb >= 0) return true_colour(rgb);
  const int number = entity.whole(62, kByLayer);
  if (number == kByBlock) return owner.colour;
  if (number > 0 && number < kByLayer) return aci_colour(number);
  const Layer* layer = find(layer_of(entity, owner));
  return layer != nullptr ? layer->colour : aci_colour(7);
}

DxfHiding DxfLayers::hiding_of(const DxfRecord& entity, const DxfOwner& owner) const {
  if (entity.whole(67, 0) == 1) return DxfHiding::paper_space;
  if (entity.whole(60, 0) == 1) return DxfHiding::invisible;
  const Layer* layer = find(layer_of(entity, owner));
  if (layer == nullptr) return DxfHiding::none;
  if (layer->frozen) return DxfHiding::layer_frozen;
  return layer->off && entity.kind != "INSERT" ? DxfHiding::layer_off : DxfHiding::none;
}

}  // namespace aspect
