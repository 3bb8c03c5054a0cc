// A view of a model as the thesis's files tell it. A store keeps a view's graph, free of scale and
// place; chain codes, places in the picture and colours come from rendering the view again.
#pragma once

#include <string>
#include <vector>

#include "compiler/aspects/observer.h"
#include "tools/export/formats/chain_file.h"
#include "tools/export/formats/graph_file.h"

namespace aspect {

struct DescribedContour {
  AttributeVector attributes{};
  ContourChain chain;
};

// Of the view that the observer has just seen, in the order of ObservedView's contours.
std::vector<DescribedContour> described_contours(const Observer& observer);

// Nodes are the view's contours, A for the first one, arcs its relations.
RelationalGraph graph_of(const ObservedView& view, const std::vector<DescribedContour>& contours);

// The same to the last bit: as long as the picture is rendered as it was.
bool looks_the_same(const ObservedView& a, const ObservedView& b);

}  // namespace aspect
