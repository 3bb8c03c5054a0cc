#include "compiler/index/index_writer.h"

#include <algorithm>

#include "compiler/index/golden_choice.h"
#include "compiler/index/index_arrays.h"
#include "compiler/index/index_budget.h"
#include "compiler/index/index_bytes.h"
#include "runtime/recognition/class_index.h"

namespace aspect {
namespace {

// The most bytes that a candidate takes.
std::size_t golden_reserve(std::span<const GoldenFrame> candidates) {
  std::size_t most = 0;
  for (const GoldenFrame& golden : candidates) most = std::max(most, golden_bytes(golden));
  return most;
}

// One of the candidates that the index written without it answers rightly.
std::optional<GoldenFrame> golden_frame(const IndexContents& contents,
                                        const std::vector<std::uint8_t>& bytes) {
  if (contents.golden_candidates.empty()) return std::nullopt;
  const Result<ClassIndex> index =
      parse_index(std::as_bytes(std::span(bytes)), contents.scene.name);
  if (!index) return std::nullopt;
  return choose_golden_frame(index.value(), contents.golden_candidates);
}

}  // namespace

WrittenIndex write_index(const IndexContents& contents) {
  const auto bytes_of = [&](const IndexSelection& selection) {
    return index_bytes(contents, pack_arrays(contents, selection), selection.map, std::nullopt)
        .size();
  };
  const IndexSelection selection = select_within(
      contents, contents.options.max_index_bytes - golden_reserve(contents.golden_candidates),
      bytes_of);
  const IndexArrays arrays = pack_arrays(contents, selection);
  WrittenIndex written{index_bytes(contents, arrays, selection.map, std::nullopt), {}};
  IndexStatistics& s = written.statistics;
  if (const auto golden = golden_frame(contents, written.bytes)) {
    const std::size_t bytes_without = written.bytes.size();
    written.bytes = index_bytes(contents, arrays, selection.map, golden);
    s.golden_frame_bytes = written.bytes.size() - bytes_without;
  }
  s.classes = selection.class_count;
  s.key_views = arrays.key_views.size();
  s.key_view_spacing_deg = selection.key_view_spacing_deg;
  s.contour_types = contents.types.size();
  s.bytes = written.bytes.size();
  for (const Cluster& cluster : contents.clusters.first(selection.class_count)) {
    s.area_fraction += cluster.area_fraction;
    s.area_assigned += cluster.area_assigned;
  }
  return written;
}

}  // namespace aspect
