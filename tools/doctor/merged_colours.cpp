#include "tools/doctor/merged_colours.h"

#include <fmt/format.h>

#include <array>

#include "compiler/aspects/colour_separation.h"
#include "compiler/aspects/observer.h"
#include "compiler/scene/colour_merging.h"
#include "tools/draw/contact_sheet.h"
#include "tools/draw/frame_canvas.h"

namespace aspect {
namespace {

using Eigen::Vector3d;

std::string words_of(const Vector3d& colour, double share) {
  return fmt::format("{:.2g} {:.2g} {:.2g} on {:.1f} %", colour.x(), colour.y(), colour.z(),
                     100 * share);
}

}  // namespace

Finding merging_finding(const ColouredMesh& mesh, std::size_t count, const VisionParameters& vision,
                        const std::string& file) {
  constexpr std::size_t kMostListed = 8;
  const MeshColourCount before = count_colours(mesh);
  const ColourClusters after = cluster_colours(before.colours, count);
  double whole = 0, changed = 0;
  std::size_t changed_colours = 0;
  for (std::size_t k = 0; k < before.colours.size(); ++k) {
    const auto& [colour, area] = before.colours[k];
    whole += area;
    if (colour_separation(colour, after.colours[after.cluster_of[k]], vision) < 1) continue;
    changed += area;
    ++changed_colours;
  }
  std::vector<std::string> listed;
  for (std::size_t k = 0; k < std::min(kMostListed, after.colours.size()); ++k)
    listed.push_back(words_of(after.colours[k], after.shares[k]));
  if (after.colours.size() > kMostListed) listed.push_back("and so on");
  return {
      "colours",
      "merged_colours",
      Severity::note,
      fmt::format("{} colours are {} now, and {:.1f} % of the surface has one that can be told "
                  "from its own: {}",
                  before.colours.size(), after.colours.size(),
                  whole > 0 ? 100 * changed / whole : 0, fmt::join(listed, ", ")),
      fmt::format("take more where parts run together, fewer where they fall to crumbs; aspectc "
                  "{} --merge-colours {} compiles it like this",
                  file, count),
      changed_colours,
      {},
      false};
}

cv::Mat merging_picture(const Scene& before, const Scene& after) {
  const std::array<Vector3d, 3> directions = {Vector3d(1, 0.7, 0.5), Vector3d(-1, 0.5, 0.4),
                                              Vector3d(-0.2, -1, -0.6)};
  std::vector<SheetPicture> pictures;
  for (const Vector3d& direction : directions)
    for (const Scene* scene : {&before, &after}) {
      const Result<Renderer> renderer = Renderer::create(*scene);
      Observer observer(renderer.value(), scene->studio, VisionParameters{});
      observer.observe(direction.normalized());
      pictures.push_back({recorded_picture(observer.frame()).clone(),
                          fmt::format("{} colours", scene->surfaces.size())});
    }
  return contact_sheet(pictures, 2);
}

}  // namespace aspect
