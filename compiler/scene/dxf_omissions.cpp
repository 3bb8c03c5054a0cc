#include "compiler/scene/dxf_omissions.h"

#include <fmt/format.h>

#include "compiler/scene/mesh_text.h"

namespace aspect {
namespace {

constexpr std::size_t kMostNamed = 12;  // kinds or layers in a line

std::string list_of(const std::vector<std::string>& all) {
  const std::vector<std::string> named(
      all.begin(), all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), kMostNamed)));
  std::string list = fmt::format("{}", fmt::join(named, ", "));
  if (all.size() > named.size()) list += fmt::format(" and {} more", all.size() - named.size());
  return list;
}

}  // namespace

void DxfOmissions::count_kind(const std::string& kind) {
  ++kinds_[kind];
}

void DxfOmissions::count_hidden(DxfHiding why, const std::string& layer) {
  ++hidden_[static_cast<std::size_t>(why)];
  if (why == DxfHiding::layer_off || why == DxfHiding::layer_frozen) hidden_layers_.insert(layer);
}

std::vector<std::string> DxfOmissions::lines() const {
  std::vector<std::string> lines, parts;
  for (const auto& [kind, count] : kinds_)
    parts.push_back(fmt::format("{} {}", count, shown(kind)));
  if (!parts.empty())
    lines.push_back(fmt::format(
        "left out: {}; export what of it should be seen as a mesh or as 3DFACEs", list_of(parts)));
  const auto count = [&](DxfHiding why) { return hidden_[static_cast<std::size_t>(why)]; };
  parts.clear();
  if (const std::size_t off = count(DxfHiding::layer_off); off > 0)
    parts.push_back(fmt::format("{} on layers that are off", off));
  if (const std::size_t frozen = count(DxfHiding::layer_frozen); frozen > 0)
    parts.push_back(fmt::format("{} on frozen layers", frozen));
  if (!hidden_layers_.empty()) {
    std::vector<std::string> names;
    for (const std::string& layer : hidden_layers_) names.push_back(shown(layer));
    parts.back() += fmt::format(" ({})", list_of(names));
  }
  if (const std::size_t invisible = count(DxfHiding::invisible); invisible > 0)
    parts.push_back(fmt::format("{} invisible", invisible));
  if (const std::size_t paper = count(DxfHiding::paper_space); paper > 0)
    parts.push_back(fmt::format("{} in paper space", paper));
  if (!parts.empty())
    lines.push_back(
        fmt::format("not to be seen in the drawing, and left out: {}", fmt::join(parts, ", ")));
  return lines;
}

}  // namespace aspect
