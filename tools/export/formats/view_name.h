// The name of a view in the thesis's files: its direction, as in blockcyl+0.222-0.842+0.491.sgm
// (A.2.2), in .det (A.2.7) and in .index (A.2.11).
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace aspect {

using Direction3 = std::array<double, 3>;

std::string view_name(const Direction3& direction, int decimals = 3);

// One for each, no two alike. Views on the borders between aspects lie closer than the thesis's,
// and three decimals may not tell them apart: those that share a name have as many decimals more as
// that takes. Equal directions have the same name.
std::vector<std::string> view_names(std::span<const Direction3> directions);

// Nothing where it is not the name of a view.
std::optional<Direction3> direction_of_view_name(std::string_view name);

// A direction that a file gives, rounded to three decimals or more, is a point of the unit sphere.
bool is_on_sphere(const Direction3& direction);

}  // namespace aspect
