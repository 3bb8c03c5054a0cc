#include "tools/eval/reliability_svg.h"

#include <fmt/format.h>

#include <iterator>

namespace aspect {
namespace {

constexpr double kLeft_px = 70, kTop_px = 60, kSide_px = 400;

constexpr const char* kHead =
    R"svg(<svg xmlns="http://www.w3.org/2000/svg" width="500" height="520"
 font-family="sans-serif" font-size="12" text-anchor="middle">
<rect width="500" height="520" fill="white"/>
<text x="270" y="24" font-size="14">{}</text>
<text x="270" y="505">mean probability</text>
<text x="20" y="260" transform="rotate(-90 20 260)">share right</text>
<text x="48" y="52">views</text>
<rect x="70" y="60" width="400" height="400" fill="none" stroke="black"/>
<line x1="70" y1="460" x2="470" y2="60" stroke="grey" stroke-dasharray="4 4"/>
)svg";

double x_px(double probability) {
  return kLeft_px + kSide_px * probability;
}

double y_px(double share) {
  return kTop_px + kSide_px * (1 - share);
}

std::string title(const Reliability& reliability) {
  const auto error = reliability.expected_calibration_error();
  if (!error) return "no view was judged";
  return fmt::format("{} views judged, expected calibration error {:.3f}", reliability.judged(),
                     *error);
}

}  // namespace

std::string reliability_svg(const Reliability& reliability) {
  std::string svg = fmt::format(kHead, title(reliability));
  const auto out = std::back_inserter(svg);
  for (int tick = 0; tick <= 10; tick += 2) {
    const double value = tick / 10.0;
    fmt::format_to(out, "<text x=\"{:.1f}\" y=\"478\">{:.1f}</text>\n", x_px(value), value);
    fmt::format_to(out, "<text x=\"52\" y=\"{:.1f}\">{:.1f}</text>\n", y_px(value) + 4, value);
  }
  for (std::size_t k = 0; k < kReliabilityBins; ++k) {
    const ReliabilityBin& bin = reliability.bins[k];
    if (bin.count == 0) continue;
    const double middle = (static_cast<double>(k) + 0.5) / static_cast<double>(kReliabilityBins);
    fmt::format_to(out, "<text x=\"{:.1f}\" y=\"52\">{}</text>\n", x_px(middle), bin.count);
    fmt::format_to(out, "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"5\" fill=\"steelblue\"/>\n",
                   x_px(bin.mean_probability), y_px(bin.right_share));
  }
  return svg + "</svg>\n";
}

}  // namespace aspect
