#include "tools/report/aspect_figures.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace aspect {
namespace {

struct Node {
  std::string name;
  Eigen::Vector2d at{0, 0};
  double radius = 0;
  std::string colour;
  bool is_dark = false;
};

constexpr double kGraphWidth = 360, kGraphHeight = 280;

// Nodes that would cover each other are pushed apart.
void push_apart(std::vector<Node>& nodes) {
  constexpr int kRounds = 60;
  constexpr double kApart = 5;
  for (int round = 0; round < kRounds; ++round) {
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        Eigen::Vector2d way = nodes[i].at - nodes[k].at;
        const double distance = way.norm();
        const double least = nodes[i].radius + nodes[k].radius + kApart;
        if (distance >= least) continue;
        // Of two in one place one goes to the right.
        way = distance < 1e-6 ? Eigen::Vector2d(1, 0) : Eigen::Vector2d(way / distance);
        nodes[i].at += (least - distance) / 2 * way;
        nodes[k].at -= (least - distance) / 2 * way;
      }
    }
    for (Node& node : nodes) {
      node.at.x() = std::clamp(node.at.x(), node.radius + 2, kGraphWidth - node.radius - 2);
      node.at.y() = std::clamp(node.at.y(), node.radius + 2, kGraphHeight - node.radius - 2);
    }
  }
}

std::vector<Node> nodes_of(const ObservedView& view, const std::vector<std::uint8_t>& names) {
  std::vector<Node> nodes;
  Eigen::AlignedBox2d box;
  const auto place = [&](std::size_t k) {
    return Eigen::Vector2f(view.contours[k].feature.position.x, view.contours[k].feature.position.y)
        .cast<double>()
        .eval();
  };
  for (std::size_t k = 0; k < names.size(); ++k) box.extend(place(k));
  const Eigen::Vector2d field(kGraphWidth - 70, kGraphHeight - 70);
  const Eigen::Vector2d sides = box.isEmpty() ? Eigen::Vector2d(1, 1) : box.sizes().cwiseMax(0.3);
  const double scale = field.cwiseQuotient(sides).minCoeff();
  for (std::size_t k = 0; k < names.size(); ++k) {
    const ContourFeature& feature = view.contours[k].feature;
    const auto& share = feature.share;
    const float luminance = 0.3F * share[0] + 0.6F * share[1] + 0.1F * share[2];
    nodes.push_back(
        {contour_letters(names[k]),
         Eigen::Vector2d(kGraphWidth / 2, kGraphHeight / 2) + scale * (place(k) - box.center()),
         std::clamp(34 * std::sqrt(static_cast<double>(feature.area)), 11.0, 30.0),
         colour_of_shares(share), luminance / std::max({share[0], share[1], share[2]}) < 0.45F});
  }
  push_apart(nodes);
  return nodes;
}

const char* look_of(Relation::Kind kind) {
  switch (kind) {
    case Relation::Kind::inside:
    case Relation::Kind::outside:
      return "class=\"inside\" stroke=\"#1a7f4b\" stroke-width=\"2.6\"";
    case Relation::Kind::superimposed:
      return "class=\"over\" stroke=\"#1b5e9c\" stroke-width=\"1.6\" stroke-dasharray=\"5 3\"";
    case Relation::Kind::apart:
      break;
  }
  return "class=\"apart\" stroke=\"#69707a\" stroke-width=\".8\" stroke-opacity=\".4\"";
}

std::string relations_drawn(const ObservedView& view, const std::vector<Node>& nodes) {
  // Each pair once; what says more than that they are apart is drawn over the others.
  std::map<std::pair<std::size_t, std::size_t>, Relation::Kind> kinds;
  for (const Relation& relation : view.relations) {
    if (relation.from >= nodes.size() || relation.to >= nodes.size()) continue;
    const std::pair<std::size_t, std::size_t> pair = std::minmax(relation.from, relation.to);
    const auto [found, is_new] = kinds.try_emplace(pair, relation.kind);
    if (!is_new && found->second == Relation::Kind::apart) found->second = relation.kind;
  }
  std::map<Relation::Kind, std::string> lines;  // those that are apart lie behind the others
  for (const auto& [pair, kind] : kinds) {
    const Node &a = nodes[pair.first], &b = nodes[pair.second];
    lines[kind] += fmt::format(
        "<line data-between=\"{} {}\" x1=\"{:.0f}\" y1=\"{:.0f}\" x2=\"{:.0f}\" y2=\"{:.0f}\"/>",
        a.name, b.name, a.at.x(), a.at.y(), b.at.x(), b.at.y());
  }
  std::string drawn;
  for (const auto& [kind, own] : lines) drawn += fmt::format("<g {}>{}</g>", look_of(kind), own);
  return drawn;
}

// Relative, in whole pixels.
std::string path_of(const std::vector<std::array<int, 2>>& outline) {
  std::string path;
  std::array<int, 2> at{0, 0};
  for (const auto& point : outline) {
    fmt::format_to(std::back_inserter(path), "{}{} {}", path.empty() ? "m" : " ", point[0] - at[0],
                   point[1] - at[1]);
    at = point;
  }
  return path + "z";
}

}  // namespace

std::string colour_of_shares(const std::array<float, 3>& share) {
  const float most = std::max({share[0], share[1], share[2], 1e-6F});
  const auto level = [&](float value) {
    return static_cast<int>(std::lround(235 * std::clamp(value / most, 0.0F, 1.0F)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", level(share[0]), level(share[1]), level(share[2]));
}

SvgFigure view_figure(const SeenView& view) {
  SvgFigure figure{static_cast<double>(view.width_px),
                   static_cast<double>(view.height_px),
                   fmt::format("view from {:.2f} {:.2f} {:.2f}", view.direction.x(),
                               view.direction.y(), view.direction.z()),
                   {}};
  figure.body = svg_picture(0, 0, figure.width, figure.height, view.png);
  // What all have in common is said once: a page has some ten thousand of them.
  std::string outlines, names;
  for (const SeenContour& contour : view.contours) {
    outlines += fmt::format("<path class=\"contour\" data-contour=\"{}\" d=\"{}\"/>", contour.name,
                            path_of(contour.outline));
    names += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\">{}</text>",
                         static_cast<double>(contour.label[0]),
                         static_cast<double>(contour.label[1]), contour.name);
  }
  // About as large on paper whatever the picture's size is.
  const double size = std::clamp(figure.height / 14, 9.0, 20.0);
  figure.body += fmt::format(
      "<g fill=\"white\" fill-opacity=\"0\" stroke=\"white\" stroke-width=\"1.5\" "
      "stroke-linejoin=\"round\" transform=\"translate(.5 .5)\">{}</g><g font-size=\"{:.3g}\" "
      "font-weight=\"600\" text-anchor=\"middle\" fill=\"white\" stroke=\"black\" "
      "stroke-width=\"{:.2g}\" paint-order=\"stroke\" pointer-events=\"none\" "
      "transform=\"translate(.5 {:.3g})\">{}</g>",
      outlines, size, size / 5, 0.35 * size + 0.5, names);
  return figure;
}

SvgFigure graph_figure(const ReportContents& contents, std::size_t aspect) {
  const Cluster& cluster = contents.model.clusters[aspect];
  const ClusterView& typical = cluster.views[contents.model.classes[aspect].typical_view];
  const ObservedView& view = contents.model.subdivision.views[number(typical.vertex)];
  const std::vector<Node> nodes = nodes_of(view, typical.names);
  SvgFigure figure{kGraphWidth,
                   kGraphHeight,
                   fmt::format("attributed relational graph of aspect {}", aspect),
                   {}};
  figure.body = relations_drawn(view, nodes);
  figure.body +=
      "<g stroke=\"#1b1f24\" font-size=\"12\" font-weight=\"600\" text-anchor=\"middle\">";
  for (const Node& node : nodes)
    figure.body += fmt::format(
        "<g class=\"node\" data-contour=\"{0}\"><circle cx=\"{1:.0f}\" cy=\"{2:.0f}\" "
        "r=\"{3:.0f}\" "
        "fill=\"{4}\"/><text stroke=\"none\" x=\"{1:.0f}\" y=\"{5:.0f}\" "
        "fill=\"{6}\">{0}</text></g>",
        node.name, node.at.x(), node.at.y(), node.radius, node.colour, node.at.y() + 4,
        node.is_dark ? "#fff" : "#1b1f24");
  figure.body += "</g>";
  return figure;
}

SvgFigure graph_key_figure() {
  SvgFigure figure{kGraphWidth, 20, "what the lines of a graph mean", {}};
  const auto key = [&](double x, Relation::Kind kind, const char* words) {
    figure.body += fmt::format("<g {3}><line x1=\"{0}\" y1=\"{1}\" x2=\"{2}\" y2=\"{1}\"/></g>", x,
                               10, x + 22, look_of(kind)) +
                   svg_text(x + 27, 14, words, {11, "start", true});
  };
  key(8, Relation::Kind::inside, "one inside the other");
  key(160, Relation::Kind::superimposed, "superimposed");
  key(276, Relation::Kind::apart, "apart");
  return figure;
}

SvgFigure aspect_figure(const ReportContents& contents, std::size_t aspect) {
  constexpr double kSide = 220, kGap = 12, kHead = 30;
  const std::vector<SeenView>& views = contents.views[aspect];
  constexpr std::size_t kColumns = 4;
  const std::size_t columns = std::min(kColumns, std::max<std::size_t>(views.size(), 1));
  const std::size_t rows = (views.size() + kColumns - 1) / kColumns;
  const double below = kHead + static_cast<double>(rows) * (kSide + kGap);
  SvgFigure figure{std::max(static_cast<double>(columns) * (kSide + kGap), kGraphWidth) + kGap,
                   below + kGraphHeight + 20 + kGap,
                   fmt::format("Aspect {} of {}: {:.2f} % of the sphere, {} contours", aspect,
                               contents.model.index.statistics.object, 100 * contents.areas[aspect],
                               contents.model.clusters[aspect].contour_count),
                   {}};
  figure.body = svg_text(kGap, 20, figure.title, {14, "start", false, true});
  for (std::size_t k = 0; k < views.size(); ++k) {
    const double scale = kSide / std::max(views[k].width_px, views[k].height_px);
    figure.body +=
        placed(view_figure(views[k]), kGap + static_cast<double>(k % kColumns) * (kSide + kGap),
               kHead + static_cast<double>(k / kColumns) * (kSide + kGap),
               scale * views[k].width_px, scale * views[k].height_px);
  }
  figure.body += placed(graph_figure(contents, aspect), kGap, below, kGraphWidth, kGraphHeight);
  figure.body += placed(graph_key_figure(), kGap, below + kGraphHeight, kGraphWidth, 20);
  return figure;
}

}  // namespace aspect
