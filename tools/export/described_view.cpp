#include "tools/export/described_view.h"

#include <cmath>

#include "compiler/aspects/view_codec.h"

namespace aspect {
namespace {

ContourChain chain_of(const Contour& contour, int height_px) {
  ContourChain chain{contour.start_x, height_px - 1 - contour.start_y, {}};
  // Without the last step. Ours go round with the clock, the letters against it.
  for (std::size_t k = 0; k + 1 < contour.chain.size(); ++k)
    chain.steps += static_cast<char>('A' + (8 - contour.chain[k]) % 8);
  return chain;
}

DescribedContour described(const Contour& contour, int height_px) {
  DescribedContour out;
  out.chain = chain_of(contour, height_px);
  out.attributes = attributes_of(out.chain);
  out.attributes[0] = std::lround(contour.area_px);
  for (std::size_t channel = 0; channel < 3; ++channel)
    out.attributes[7 + channel] = std::lround(contour.mean_rgb[channel]);
  return out;
}

// Ours: 0 to the right, on with the clock; a compass's is 0 up.
GraphArc arc_of(const Relation& relation) {
  constexpr char kKinds[] = {' ', 's', 'i', 'o'};  // by Relation::Kind
  return {relation.from, relation.to, (relation.direction + 4) % 16,
          kKinds[static_cast<std::size_t>(relation.kind)]};
}

}  // namespace

std::vector<DescribedContour> described_contours(const Observer& observer) {
  std::vector<DescribedContour> contours;
  for (const bool external : {true, false})
    for (const Contour& contour : observer.graph().contours)
      if (contour.external == external)
        contours.push_back(described(contour, observer.frame().height_px));
  return contours;
}

RelationalGraph graph_of(const ObservedView& view, const std::vector<DescribedContour>& contours) {
  RelationalGraph graph;
  for (std::size_t i = 0; i < contours.size(); ++i)
    graph.nodes.push_back({name_of_place(i), "cftsrv", view.contours[i].external,
                           view.contours[i].shape, contours[i].attributes});
  for (const Relation& relation : view.relations) graph.arcs.push_back(arc_of(relation));
  return graph;
}

bool looks_the_same(const ObservedView& a, const ObservedView& b) {
  return encode_view(a) == encode_view(b);
}

}  // namespace aspect
