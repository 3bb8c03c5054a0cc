// A frame as a model's colours: which of them each region is, under the light of the moment.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/recognition/hidden_part.h"
#include "runtime/recognition/object_model.h"
#include "runtime/vision/planes.h"
#include "runtime/vision/segment.h"
#include "runtime/vision/vision_limits.h"

namespace aspect {

// How the light's colour changes shares: observed r g b are these times the object's, up to a
// common factor.
struct LightGain {
  std::array<float, 3> rgb{1, 1, 1};
};

float squared_distance(const std::array<float, 3>& a, const std::array<float, 3>& b);

// Of a region's mean colour, 0 to 255.
std::array<float, 3> share_of(const std::array<float, 3>& rgb);

// The place of the share that is nearest; shares.size() where none is near enough to be named.
std::size_t nearest_share(std::span<const std::array<float, 3>> shares,
                          const std::array<float, 3>& share);

std::array<float, 3> lit(const std::array<float, 3>& share, const LightGain& light);

class SeenColours {
 public:
  // No colour of the model: something else.
  static constexpr ColourClass kOther = 255;

  // Of pixels: hidden, or beside the part of the picture that was looked at.
  static constexpr ColourClass kUnknown = 254;

  // For `look`: regions of all blobs count.
  static constexpr int kAllBlobs = -1;

  // Regions outside of the blob count as background; beside what was looked at nothing is known.
  void look(const RegionMap& regions, const Planes& colours, int blob, const ObjectModel& model,
            const LightGain& light);

  // Without regions: each pixel is the colour that is nearest to its own. Only `known` was looked
  // at; what is dark there need not be in `colours`. `hidden` stands before the object, null:
  // nothing does.
  void look_at_pixels(const Planes& colours, const Box& known, const HiddenPart* hidden,
                      const ObjectModel& model, const LightGain& light);

  // By something that is known to stand before the object.
  bool is_hidden(float x_px, float y_px) const {
    return hidden_ != nullptr && hidden_->hides(x_px, y_px);
  }
  bool has_regions() const { return regions_ != nullptr; }

  // Of the pixel that holds a point.
  ColourClass at(float x_px, float y_px) const;

  // The label of its region, 0: none.
  std::uint16_t label_at(float x_px, float y_px) const;
  float area_px(std::uint16_t label) const {
    return static_cast<float>(regions_->regions[label - 1U].sums.area);
  }
  ColourClass of_label(std::uint16_t label) const { return class_of_label_[label]; }

  // By the pixel's own colour, not its region's.
  ColourClass at_pixel(float x_px, float y_px) const;

  // Mean of the four pixels around a point, by their distance; black outside of what was seen.
  std::array<float, 3> rgb(float x_px, float y_px) const;

 private:
  void expect(const ObjectModel& model, const LightGain& light);
  ColourClass nearest_to(const std::array<float, 3>& rgb) const;
  ColourClass named(const std::array<float, 3>& rgb) const;

  const RegionMap* regions_ = nullptr;
  bool knows_all_ = true;  // no place is unknown
  const Planes* colours_ = nullptr;
  Box known_;
  const HiddenPart* hidden_ = nullptr;
  // Shares under the light: all red ones, then green, then blue.
  std::array<std::array<float, kMaxModelColours>, 3> expected_;
  std::size_t colour_count_ = 0;
  std::array<ColourClass, kMaxRegions + 1> class_of_label_{};
};

}  // namespace aspect
