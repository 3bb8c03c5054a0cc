#include "compiler/step/step_colours.h"

#include <Quantity_Color.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_GraphNode.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <cmath>

namespace aspect {
namespace {

// OpenCASCADE keeps light in floats; five digits are those of the file again.
double channel(double value) {
  return std::round(value * 1e5) / 1e5;
}

}  // namespace

StepColour colour_of(const TDF_Label& label) {
  for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen}) {
    TDF_Label found;
    Quantity_Color colour;
    if (!XCAFDoc_ColorTool::GetColor(label, type, found)) continue;
    const Handle(XCAFDoc_ColorTool) tool = XCAFDoc_DocumentTool::ColorTool(label);
    if (!tool->GetColor(found, colour)) continue;
    double red = 0, green = 0, blue = 0;
    colour.Values(red, green, blue, Quantity_TOC_sRGB);
    return Eigen::Vector3d(channel(red), channel(green), channel(blue));
  }
  return std::nullopt;
}

StepColour instance_colour(const TDF_LabelSequence& path) {
  for (int first = 1; first < path.Length(); ++first) {
    TDF_LabelSequence inner;
    for (int k = first; k <= path.Length(); ++k) inner.Append(path.Value(k));
    Handle(XCAFDoc_GraphNode) override_node;
    if (!XCAFDoc_ShapeTool::FindSHUO(inner, override_node)) continue;
    if (StepColour colour = colour_of(override_node->Label())) return colour;
  }
  return path.IsEmpty() ? std::nullopt : colour_of(path.Last());
}

}  // namespace aspect
