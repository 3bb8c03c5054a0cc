// A graph and all that it points to as one string of bytes, to compare whole graphs by.
#pragma once

#include <string>
#include <type_traits>

#include "runtime/vision/view_graph.h"

namespace aspect {

class GraphBytes {
 public:
  explicit GraphBytes(const ViewGraph& graph) {
    for (const Contour& contour : graph.contours) add_contour(contour);
    for (const Relation& r : graph.relations) add(r.from, r.to, r.direction, r.kind);
    for (const Blob& blob : graph.blobs) {
      add(blob.first_contour, blob.contour_count, blob.first_relation, blob.relation_count);
      add(blob.box, blob.centre_px, blob.area_px);
    }
    add(graph.contours.size(), graph.relations.size(), graph.blobs.size(), graph.dropped_regions);
  }
  friend bool operator==(const GraphBytes&, const GraphBytes&) = default;

 private:
  void add_contour(const Contour& c) {
    add(c.region, c.blob, c.inside, c.external, c.shape, c.mean_rgb, c.centre_px, c.area_px);
    add(c.thickness_px, c.moments, c.box, c.start_x, c.start_y, c.chain.size());
    bytes_.append(reinterpret_cast<const char*>(c.chain.data()), c.chain.size());
  }

  // Field by field: the padding between them is not part of the graph.
  template <typename... Fields>
  void add(const Fields&... fields) {
    (bytes_.append(reinterpret_cast<const char*>(&fields), sizeof fields), ...);
  }

  std::string bytes_;
};

}  // namespace aspect
