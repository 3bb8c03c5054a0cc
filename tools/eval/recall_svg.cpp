#include "tools/eval/recall_svg.h"

#include <fmt/format.h>

#include <array>
#include <iterator>

#include "tools/eval/wilson_interval.h"

namespace aspect {
namespace {

constexpr double kLeft_px = 70, kTop_px = 60, kSide_px = 400;
constexpr double kMostHidden = kHiddenRanges.back().to;
constexpr std::array kColours = {"steelblue", "darkorange", "seagreen", "firebrick", "purple"};

constexpr const char* kHead =
    R"svg(<svg xmlns="http://www.w3.org/2000/svg" width="500" height="520"
 font-family="sans-serif" font-size="12" text-anchor="middle">
<rect width="500" height="520" fill="white"/>
<text x="270" y="24" font-size="14">{} frames in clutter an object</text>
<text x="270" y="505">share hidden</text>
<text x="20" y="260" transform="rotate(-90 20 260)">recall</text>
<rect x="70" y="60" width="400" height="400" fill="none" stroke="black"/>
)svg";

double x_px(double hidden) {
  return kLeft_px + kSide_px * hidden / kMostHidden;
}

double y_px(double share) {
  return kTop_px + kSide_px * (1 - share);
}

// File names may hold anything.
std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    if (c == '<')
      safe += "&lt;";
    else if (c == '&')
      safe += "&amp;";
    else
      safe += c;
  }
  return safe;
}

std::string curve(const ObjectClutter& object, const char* colour, double shift_px) {
  std::string marks, line;
  for (std::size_t k = 0; k < kHiddenRanges.size(); ++k) {
    const Recall& recall = object.by_hidden[k];
    if (recall.frames == 0) continue;
    const Share share = share_of(recall.found, recall.frames);
    const double x = x_px((kHiddenRanges[k].from + kHiddenRanges[k].to) / 2) + shift_px;
    line += fmt::format("{:.1f},{:.1f} ", x, y_px(share.share));
    marks += fmt::format(
        "<line x1=\"{0:.1f}\" y1=\"{1:.1f}\" x2=\"{0:.1f}\" y2=\"{2:.1f}\" stroke=\"{3}\"/>\n"
        "<circle cx=\"{0:.1f}\" cy=\"{4:.1f}\" r=\"4\" fill=\"{3}\"/>\n",
        x, y_px(share.low), y_px(share.high), colour, y_px(share.share));
  }
  return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\"/>\n{}", line, colour,
                     marks);
}

}  // namespace

std::string recall_svg(const ClutterEvaluation& evaluation) {
  std::string svg = fmt::format(kHead, evaluation.settings.views);
  const auto out = std::back_inserter(svg);
  for (int tick = 0; tick <= 10; tick += 2)
    fmt::format_to(out, "<text x=\"52\" y=\"{:.1f}\">{:.1f}</text>\n", y_px(tick / 10.0) + 4,
                   tick / 10.0);
  fmt::format_to(out, "<text x=\"{:.1f}\" y=\"478\">0.0</text>\n", x_px(0));
  for (const HiddenRange& range : kHiddenRanges)
    fmt::format_to(out, "<text x=\"{:.1f}\" y=\"478\">{:.1f}</text>\n", x_px(range.to), range.to);
  for (std::size_t k = 0; k < evaluation.objects.size(); ++k) {
    const char* colour = kColours[k % kColours.size()];
    // Beside each other where they are of one height.
    svg += curve(evaluation.objects[k], colour, 6 * static_cast<double>(k % kColours.size()));
    fmt::format_to(out, "<text x=\"460\" y=\"{}\" text-anchor=\"end\" fill=\"{}\">{}</text>\n",
                   80 + 16 * k, colour, escaped(evaluation.objects[k].object));
  }
  return svg + "</svg>\n";
}

}  // namespace aspect
