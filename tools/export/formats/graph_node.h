// A node of a graph as the thesis's files write it (A.2.2, A.2.7): a contour of a view with its
// attributes (3.2.2).
//
//   [A[@id=cftsrv;ext:sqr:aa(5770):mm(19501,153,16,0):cg(255,377):cr(63,158,255)]]
//
// Its contour id; who found it (cftsrv: the feature server; na in files made of other files); ext
// or int for an external contour or the border of a hole; its shape; area, moments, centre of
// gravity and colour. What the appendix leaves open is answered by its own example, of which it
// gives graph (A.2.2) and chain codes (A.2.4), and was checked against them:
// - aa is the number of pixels of the region.
// - cg is the mean of the contour's pixels, cut to whole pixels. y points up: it is 0 in the last
//   row of the picture.
// - mm are Hu's first four moment invariants of the contour's pixels, not of the region: the
//   example's ratios mm2 / mm1^2 and mm3 / mm4 come out to the last digit. What they are divided by
//   could not be told but nearly: here every mu_pq is divided by the number of pixels and the
//   square of the contour's length (straight steps 1, diagonal ones sqrt 2), those of third order
//   as well, as the example's two contours are in that proportion; and all are in millionths. So
//   every rectangle has mm1 = 20833, but mm3 and mm4 grow with the contour in the picture. Of the
//   example mm1 comes out 2 to 3 % and mm2 5 % too large, mm3 and mm4 12 % too small.
// - cr is the mean colour, 0 to 255 a channel. The example's brightest channel is always 255, as
//   its pictures were brightened before; here it is the colour in the picture.
// - The shapes seen in the examples are cir, sqr and tri. Contours that are none of them are oth.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "runtime/vision/view_graph.h"
#include "tools/export/formats/text_lines.h"

namespace aspect {

// Area, four moments, centre x and y, red, green, blue: the attribute vector of A.2.8.
inline constexpr std::size_t kAttributes = 10;
using AttributeVector = std::array<std::int64_t, kAttributes>;

struct GraphNode {
  std::string name;  // A to Z, then AA, AB and so on
  std::string finder = "na";
  bool external = true;
  ShapeClass shape = ShapeClass::other;
  AttributeVector attributes{};

  bool operator==(const GraphNode&) const = default;
};

// The place of a name, from 0 for A; names have up to four letters.
std::size_t place_of_name(std::string_view name);
std::string name_of_place(std::size_t place);

void append_node(const GraphNode& node, std::string& text);
GraphNode read_node(TextLines& lines);

}  // namespace aspect
