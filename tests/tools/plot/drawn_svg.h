// A plot as another program reads it: read_svg.py, which tells the keys.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace aspect {

// Throws where it is no XML.
nlohmann::json drawn_svg(const std::string& svg);

}  // namespace aspect
