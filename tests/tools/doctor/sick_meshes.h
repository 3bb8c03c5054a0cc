// Meshes with known diseases, made here.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "compiler/scene/coloured_mesh.h"
#include "tools/doctor/finding.h"

namespace aspect {

// A closed cuboid of 12 triangles wound outwards, 2 a face in the order -x +x -y +y -z +z, each
// face in a colour of its own unless one is given.
void add_cuboid(ColouredMesh& mesh, const Eigen::Vector3d& least, const Eigen::Vector3d& most);
void add_cuboid(ColouredMesh& mesh, const Eigen::Vector3d& least, const Eigen::Vector3d& most,
                const Eigen::Vector3d& colour);
ColouredMesh cuboid(const Eigen::Vector3d& least, const Eigen::Vector3d& most);

// 320 triangles on a sphere of radius 1, dented by chance, wound outwards.
ColouredMesh dented_ball(unsigned seed);

// 6240 triangles on an ellipsoid with a cap at either end, in five paints of a fifth of the surface
// or so each, shaded as by one lamp and with the noise of a camera: some 1500 colours. A triangle's
// part is its paint.
ColouredMesh shaded_ball();
const std::vector<Eigen::Vector3d>& ball_paints();

// Edges that one triangle alone has, by the most plain way there is.
std::size_t plain_open_edges(const ColouredMesh& mesh);

void erase_triangle(ColouredMesh& mesh, std::size_t triangle);
void repeat_triangle(ColouredMesh& mesh, std::size_t triangle);

std::string obj_text(const ColouredMesh& mesh);  // without colours

// Sorted; notes included.
std::vector<std::string> codes_of(const std::vector<Finding>& findings);
const Finding& finding_of(const std::vector<Finding>& findings, const std::string& code);

}  // namespace aspect
