// What the numbers of a colour mean, format by format. Everything behind the readers has colours as
// displayed, in parts of 1: a picture shows 255 * colour.
#pragma once

#include <array>
#include <string_view>

namespace aspect {

enum class ColourMeaning {
  displayed,  // taken as it is
  light,      // in proportion to light: encoded as sRGB (srgb.h)
  xyz,        // CIE XYZ: brought to sRGB
};

struct ColourSource {
  std::string_view format, place;
  ColourMeaning meaning;
  std::string_view full;    // the number that is 1
  std::string_view source;  // that says so
};

// STL's and PLY's have no specification but what programs do; MTL's speaks of reflectivity, and
// viewers show it as it is.
inline constexpr std::array<ColourSource, 20> kColourSources = {{
    {"b", "surface", ColourMeaning::displayed, "1", "Vivid's pictures, 255 * colour"},
    {"obj", "Kd of MTL", ColourMeaning::displayed, "1", "Wavefront MTL 1995; MeshLab"},
    {"obj", "Kd xyz of MTL", ColourMeaning::xyz, "1", "Wavefront MTL 1995"},
    {"obj", "vertex", ColourMeaning::displayed, "1, or 255 where one is above 1", "MeshLab"},
    {"any", "picture", ColourMeaning::displayed, "255", "PNG and JPEG are sRGB; glTF 3.9.2 too"},
    {"gltf", "baseColorFactor", ColourMeaning::light, "1", "glTF 2.0, 3.9.2"},
    {"gltf", "COLOR_0", ColourMeaning::light, "1, 255 or 65535 by type", "glTF 2.0, 3.9.2"},
    {"gltf", "diffuseFactor", ColourMeaning::light, "1", "KHR_materials_pbrSpecularGlossiness"},
    {"ply", "whole", ColourMeaning::displayed, "255 or 65535 by type", "MeshLab"},
    {"ply", "float", ColourMeaning::displayed, "1", "MeshLab"},
    {"stl", "VisCAM", ColourMeaning::displayed, "31", "VisCAM and SolidView: bit 15 set, b g r"},
    {"stl", "Magics", ColourMeaning::displayed, "31; 255 in COLOR=", "Magics: bit 15 clear, r g b"},
    {"off", "whole", ColourMeaning::displayed, "255", "Geomview's OFF"},
    {"off", "float", ColourMeaning::displayed, "1", "Geomview's OFF"},
    {"3ds", "COLOR_24", ColourMeaning::displayed, "255", "Autodesk 3D Studio File Toolkit"},
    {"3mf", "displaycolor", ColourMeaning::displayed, "255", "3MF core 1.3: sRGB"},
    {"3mf", "colorgroup", ColourMeaning::displayed, "255", "3MF materials 1.2: sRGB"},
    {"step", "COLOUR_RGB", ColourMeaning::displayed, "1", "ISO 10303-46; OpenCASCADE 7.6"},
    {"dxf", "index (62)", ColourMeaning::displayed, "255", "AutoCAD's colour index"},
    {"dxf", "true colour (420)", ColourMeaning::displayed, "255", "DXF Reference, group 420"},
}};

}  // namespace aspect
