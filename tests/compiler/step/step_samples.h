// STEP files as OpenCASCADE writes them. Its headers are in the source alone.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

namespace aspect {

enum class StepSchema { ap203, ap214, ap242 };

// 10 x 20 x 30 with a corner at the origin; its faces x = 0, x = 10, y = 0 and so on have the names
// of kBoxFaces and, displayed, their colours.
struct BoxFace {
  std::string name;
  Eigen::Vector3d colour{0, 0, 0};
};
std::vector<BoxFace> box_faces();
// `unit` is what the numbers count.
void write_step_box(const std::filesystem::path& file, StepSchema schema,
                    const std::string& unit = "MM");

// The same without any colour or name of faces; and with a colour of its first `coloured` faces.
void write_plain_step(const std::filesystem::path& file, int coloured = 0);

// A product "bodies" of two boxes: "left" is red, its first face yellow; "right" has no colour of
// its own, and the product is blue.
void write_step_bodies(const std::filesystem::path& file);

// A product "peg", a box of 2 x 4 x 6 from the origin, green, its first face white, placed twice in
// "outer": turned by 90 degrees about z and moved by 100 along x; and moved by 50 along y in an
// instance that is red.
void write_step_assembly(const std::filesystem::path& file);

// About the origin a sphere of radius 10; a cylinder of radius 5 and height 20 about z that starts
// at z = 20; red and green.
void write_curved_step(const std::filesystem::path& file);

// A plate with so many holes, a colour for every face.
void write_many_faced_step(const std::filesystem::path& file, int holes);

}  // namespace aspect
