// Which view becomes an index's golden frame: one that the runtime recognises without doubt.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "compiler/aspects/clusters.h"
#include "compiler/index/class_model.h"
#include "runtime/recognition/class_index.h"

namespace aspect {

// Bytes of an index that a golden frame may take: this, or an eighth of a small budget.
inline constexpr std::size_t kMostGoldenBytes = 3 * 1024;

// Bytes that it adds to an index, at most.
std::size_t golden_bytes(const GoldenFrame& golden);

// The typical views of the largest classes, the widest of them first, each as a small picture and
// as a full one, that take no more bytes than they may; class_id is the view's, the rest of the
// answer is missing. Rendered again: eight views, on all threads. Same result for any number of
// them.
std::vector<GoldenFrame> golden_candidates(const Workshop& workshop, const Subdivision& subdivision,
                                           std::span<const Cluster> clusters,
                                           std::span<const ClassDescription> classes);

// Of those with at least three contours, as far as there are any, and whose contours the index all
// matches with the right class, no other class scoring more: the one of the fewest bytes among
// those whose lead is at least three quarters of the largest. With its answer. Nothing where none
// is.
std::optional<GoldenFrame> choose_golden_frame(const ClassIndex& index,
                                               std::span<const GoldenFrame> candidates);

}  // namespace aspect
