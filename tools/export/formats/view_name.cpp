#include "tools/export/formats/view_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_map>

namespace aspect {

std::string view_name(const Direction3& direction, int decimals) {
  return fmt::format("{:+.{}f}{:+.{}f}{:+.{}f}", direction[0], decimals, direction[1], decimals,
                     direction[2], decimals);
}

std::vector<std::string> view_names(std::span<const Direction3> directions) {
  constexpr int kLeastDecimals = 3, kMostDecimals = 17;
  std::vector<std::string> names(directions.size());
  std::vector<std::size_t> open(directions.size());
  for (std::size_t i = 0; i < open.size(); ++i) open[i] = i;
  for (int decimals = kLeastDecimals; !open.empty() && decimals <= kMostDecimals; ++decimals) {
    std::unordered_map<std::string, std::size_t> count;
    for (const std::size_t i : open) ++count[names[i] = view_name(directions[i], decimals)];
    std::erase_if(open, [&](std::size_t i) { return count[names[i]] == 1; });
  }
  return names;
}

std::optional<Direction3> direction_of_view_name(std::string_view name) {
  Direction3 direction{};
  for (double& coordinate : direction) {
    if (name.empty() || (name.front() != '+' && name.front() != '-')) return std::nullopt;
    const bool negative = name.front() == '-';
    name.remove_prefix(1);
    const std::size_t end = std::min(name.find_first_not_of("0123456789."), name.size());
    const auto parsed = std::from_chars(name.data(), name.data() + end, coordinate);
    if (parsed.ec != std::errc() || parsed.ptr != name.data() + end) return std::nullopt;
    if (negative) coordinate = -coordinate;
    name.remove_prefix(end);
  }
  if (!name.empty() || !is_on_sphere(direction)) return std::nullopt;
  return direction;
}

bool is_on_sphere(const Direction3& direction) {
  constexpr double kRounding = 0.002;
  const double squares =
      direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2];
  return std::abs(squares - 1) < 2 * kRounding;
}

}  // namespace aspect
