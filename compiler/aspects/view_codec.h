// Views and matches as the bytes that a store keeps.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "compiler/matching/graph_match.h"
#include "compiler/matching/observed_view.h"

namespace aspect {

std::vector<std::byte> encode_view(const ObservedView& view);

// Nothing where the bytes are not those of a view.
std::optional<ObservedView> decode_view(const Eigen::Vector3d& direction,
                                        std::span<const std::byte> bytes);

std::vector<std::byte> encode_mapping(const GraphMatch& match);
GraphMatch decode_match(double cost, std::span<const std::byte> mapping);

}  // namespace aspect
