#include "compiler/scene/bob_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "compiler/scene/bob_sources.h"
#include "compiler/scene/texture_map.h"

namespace aspect {

Surface BobSurfaceReader::read(const BobWord& statement) {
  Surface surface;
  bool no_antialias = false, no_shadow = false, shine_is_colored = false;
  BobBlock fields = block(statement);
  fields.color("diffuse", surface.diffuse);
  fields.color("ambient", surface.ambient);
  fields.color("specular", surface.specular);
  fields.color("transparent", surface.transparent);
  fields.number_within("ior", surface.ior, 0.1, 10);
  fields.field("shine", [&](const BobWord& word) { read_shine(word, surface, shine_is_colored); });
  fields.number_within("fuzz", surface.fuzz, 0, 10);
  fields.flag("no_antialias", no_antialias);
  fields.flag("no_shadow", no_shadow);
  fields.field("texture", [&](const BobWord& word) { surface.texture = read_texture(word); });
  stand_in_.reset();
  fields.read();
  if (stand_in_) {
    surface.diffuse = surface.ambient = *stand_in_;
    surface.texture = nullptr;
  } else if (!fields.has("ambient")) {
    surface.ambient = surface.diffuse;
  }
  if (!shine_is_colored && fields.has("specular")) surface.shine_color = surface.specular;
  surface.antialias = !no_antialias;
  surface.casts_shadow = !no_shadow;
  return surface;
}

bool BobSurfaceReader::color_follows() const {
  const BobWord& next = words_.peek();
  return next.kind == BobWord::Kind::kNumber || next.text == "(" || is_operator(next);
}

void BobSurfaceReader::read_shine(const BobWord& word, Surface& surface, bool& is_colored) {
  constexpr double kMaxShine = 1e6;
  surface.shine = numbers_.component();
  if (!(surface.shine >= 0 && surface.shine <= kMaxShine)) {
    words_.fail(word, fmt::format("shine {:g}; write an exponent within 0 .. {:g}, then a colour",
                                  surface.shine, kMaxShine));
  }
  is_colored = color_follows();
  if (is_colored) surface.shine_color = read_color(words_, numbers_, warnings_, word);
}

std::shared_ptr<const Texture> BobSurfaceReader::read_texture(const BobWord& statement) {
  auto texture = std::make_shared<Texture>();
  Eigen::Affine3d steps = Eigen::Affine3d::Identity();
  BobBlock fields = block(statement);
  fields.field("checker", [&](const BobWord& word) { texture->pattern = read_checker(word); });
  fields.field("map", [&](const BobWord& word) { texture->pattern = read_map(word); });
  for (const std::string_view step : {"scale", "translate", "rotate"}) {
    fields.repeated(step,
                    [&](const BobWord& word) { steps = transforms_.read_step(word) * steps; });
  }
  fields.read();
  if (fields.has("checker") && fields.has("map")) {
    words_.fail(statement, "a texture of both checker and map; write one of them");
  }
  if (!fields.has("map")) fields.require("checker", "checker or map \"file.png\"");
  texture->frame_from_object = transforms_.scene_from_written().inverse();
  texture->pattern_from_frame = steps.inverse();
  if (!texture->frame_from_object.matrix().allFinite() ||
      !texture->pattern_from_frame.matrix().allFinite()) {
    words_.fail(statement,
                "the texture's steps are too large or too small to compute with; scale less");
  }
  return texture;
}

Checker BobSurfaceReader::read_checker(const BobWord& word) {
  constexpr std::array<std::string_view, 5> kFields = {"checker", "map", "scale", "translate",
                                                       "rotate"};
  Checker checker;
  const BobWord& next = words_.peek();
  const bool is_lost = next.kind == BobWord::Kind::kName &&
                       std::find(kFields.begin(), kFields.end(), next.text) == kFields.end();
  if (!color_follows() && !is_lost) return checker;
  for (Eigen::Vector3d& color : checker.colors)
    color = read_color(words_, numbers_, warnings_, word);
  return checker;
}

ImageMap BobSurfaceReader::lost_map(const BobWord& word, const std::filesystem::path& path,
                                    const std::string& fault) {
  const std::size_t end = fault.find("; ");
  stand_in_ =
      lost_.stand_in(words_, word, fmt::format("{}: {}", path.string(), fault.substr(0, end)),
                     end == std::string::npos ? "write it anew" : fault.substr(end + 2));
  words_.add_to_source(fmt::format(" [{} {} {}]", stand_in_->x(), stand_in_->y(), stand_in_->z()));
  return {};
}

ImageMap BobSurfaceReader::read_map(const BobWord& word) {
  const BobWord name = words_.take();
  if (name.kind != BobWord::Kind::kQuoted || name.text.size() == 2) {
    words_.fail(name, fmt::format("{} in place of a file; write map \"file.png\"", quoted(name)));
  }
  const auto path = words_.path_named(name.text.substr(1, name.text.size() - 2), name);
  std::shared_ptr<const TextureMap>& map = maps_[path.string()];
  if (map == nullptr) {
    const Result<std::string> bytes = load_text(path, BobSources::kMaxBytes);
    if (!bytes.ok()) return lost_map(word, path, bytes.error());
    Result<TextureMap> decoded = decode_png(bytes.value(), kMaxMapPixels - map_pixels_);
    if (!decoded.ok()) return lost_map(word, path, decoded.error());
    map = std::make_shared<TextureMap>(std::move(decoded).value());
    map_pixels_ += map->rgb.size() / 3;
  }
  words_.add_to_source(fmt::format(" [{:016x}]", digest_of(*map)));
  return {map};
}

}  // namespace aspect
