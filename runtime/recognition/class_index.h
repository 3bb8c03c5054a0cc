// A class index in memory: what the compiler says of one object, checked and unpacked once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/recognition/golden_frame.h"
#include "runtime/recognition/object_model.h"
#include "runtime/recognition/sphere_map.h"
#include "runtime/vision/feature.h"
#include "runtime/vision/vision_parameters.h"

namespace aspect {

// 3: with a model of the object, and with any sensor.
inline constexpr std::uint32_t kIndexFormatVersion = 3;
inline constexpr std::size_t kMaxIndexBytes = 16U << 20U;
inline constexpr std::size_t kMaxClassContours = 48;
inline constexpr std::size_t kMaxClasses = 65536;  // a hypothesis names its class in 16 bits

using Vector3 = std::array<float, 3>;

// Ranges into the flat arrays of ClassIndex.
struct IndexRange {
  std::uint32_t first = 0, count = 0;
};

struct TypeScore {
  std::uint16_t type = 0;
  float score = 1;
};

// A contour of a class (thesis 3.4.4): the types that it was seen as over the aspect.
struct ClassContour {
  IndexRange types;     // into type_scores
  IndexRange surfaces;  // into surfaces
  std::array<float, 3> share{};
  Vector3 centre_object{};
};

struct KeyView {
  Vector3 direction{};  // unit vector from the object's centre to the camera
  IndexRange contours;  // into key_contours
};

struct KeyContour {
  ContourFeature feature;
  std::uint16_t name = 0;  // its contour of the class
};

struct AspectClass {
  IndexRange contours;   // into class_contours; a contour's place is its name
  IndexRange key_views;  // into key_views
  Vector3 view{};        // towards its most typical view
  float area_fraction = 0;
  std::uint32_t view_count = 0;
};

// How far the object reaches, in scene units; all 0 where the index does not say.
struct ObjectExtent {
  std::array<double, 3> least{}, most{};  // corners of its box
  double diameter = 0;                    // largest distance between two points of its surface
  std::array<double, 3> centre{};         // that views look at and symmetries turn about
};

// How likely it is that the object is there where its drawn model agrees with the picture by a:
// 1 / (1 + exp(slope * (even - a))), measured by the compiler.
struct Calibration {
  float slope = 120;
  float even = 0.965F;  // as likely as not
};

struct ClassIndex {
  std::string object;
  VisionParameters vision;  // as compiled with
  float field_of_view_deg = 0;
  int width_px = 0, height_px = 0;
  int level = 0;
  double threshold = 0, cluster_threshold = 0;
  std::string scoring;  // none, views, area
  std::size_t file_bytes = 0;
  std::vector<TypeAttributes> types;
  std::vector<AspectClass> classes;
  std::vector<ClassContour> class_contours;
  std::vector<TypeScore> type_scores;
  std::vector<std::uint16_t> surfaces;
  // What the model's file calls those that it has a name for; by surface.
  std::vector<std::pair<std::uint16_t, std::string>> surface_names;
  std::vector<KeyView> key_views;
  std::vector<KeyContour> key_contours;
  SphereMap sphere_map;  // which class is seen from where
  // Rotations of the object that no view of it betrays, w x y z, without the identity; and the unit
  // axes about which any angle does, which combine with them.
  std::vector<std::array<float, 4>> symmetries;
  std::vector<Vector3> symmetry_axes;
  ObjectExtent extent;
  ObjectModel model;  // empty: there is none, and no pose
  Calibration calibration;
  std::optional<GoldenFrame> golden;  // for self_test.h

  template <typename T>
  static std::span<const T> part(const std::vector<T>& all, IndexRange range) {
    return std::span(all).subspan(range.first, range.count);
  }
};

// Checks everything (identifier, FlatBuffers structure, version, checksum, every reference and
// range, every number finite) before anything is used. Errors name the file.
Result<ClassIndex> load_index(const std::filesystem::path& file);
Result<ClassIndex> parse_index(std::span<const std::byte> bytes, const std::string& name);

// A file of at most kMaxIndexBytes, aligned as FlatBuffers needs it: as its largest scalar.
struct IndexFileBytes {
  std::vector<std::uint64_t> words;
  std::size_t size = 0;

  std::span<const std::byte> bytes() const { return std::as_bytes(std::span(words)).first(size); }
};
Result<IndexFileBytes> read_index_bytes(const std::filesystem::path& file);

// FNV-1a of an index file's bytes with the eight of its checksum field taken as zero.
std::uint64_t index_checksum(std::span<const std::byte> bytes, std::size_t checksum_offset);

}  // namespace aspect
