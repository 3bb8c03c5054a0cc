// What of a drawing does not become part of the object.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "compiler/scene/dxf_layers.h"

namespace aspect {

class DxfOmissions {
 public:
  // An entity of a kind that is not read.
  void count_kind(const std::string& kind);
  // One that is not to be seen, and its layer.
  void count_hidden(DxfHiding why, const std::string& layer);

  // A line for each of the two; none where there is nothing to say.
  std::vector<std::string> lines() const;

 private:
  std::map<std::string, std::size_t> kinds_;
  std::array<std::size_t, 5> hidden_{};  // by DxfHiding
  std::set<std::string> hidden_layers_;
};

}  // namespace aspect
