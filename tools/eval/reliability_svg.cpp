#include "tools/eval/reliability_svg.h"

#include <fmt/format.h>

#include "tools/plot/svg_plot.h"

namespace aspect {
namespace {

std::string title(const Reliability& reliability) {
  const auto error = reliability.expected_calibration_error();
  if (!error) return "No view was judged";
  return fmt::format("{} views judged, expected calibration error {:.3f}", reliability.judged(),
                     *error);
}

}  // namespace

std::string reliability_svg(const Reliability& reliability) {
  SvgPage page(504, 540, title(reliability));
  const PlotBox box{kAxisLeft_px + 12, 76, 400, 400};
  PlotPanel panel(page, box, {"mean probability of a bin's views", 0, 1},
                  {"share of them that is right", 0, 1});
  page.text({box.left - 8, box.top - 10}, "views", {PlotAnchor::end, 12, "#555555"});
  page.line(panel.at(0, 0), panel.at(1, 1), {"#777777", 1.2, "5 4"});
  for (std::size_t k = 0; k < kReliabilityBins; ++k) {
    const ReliabilityBin& bin = reliability.bins[k];
    if (bin.count == 0) continue;
    const double middle = (static_cast<double>(k) + 0.5) / static_cast<double>(kReliabilityBins);
    page.text({panel.at(middle, 1).x, box.top - 10}, fmt::to_string(bin.count),
              {PlotAnchor::middle, 12});
    page.mark(panel.at(bin.mean_probability, bin.right_share), 0,
              fmt::format("{} views, believed {:.3f}, right {:.3f}", bin.count,
                          bin.mean_probability, bin.right_share));
  }
  return page.document();
}

}  // namespace aspect
