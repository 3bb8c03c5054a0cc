#include "tools/report/report_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/vision/vision_parameters.h"
#include "tools/report/svg_figure.h"

namespace aspect {
namespace {

std::string number_text(double value) {
  std::string digits = fmt::format("{:.0f}", value);
  for (int place = static_cast<int>(digits.size()) - 3; place > 0; place -= 3)
    digits.insert(static_cast<std::size_t>(place), "\u202f");
  return digits;
}

std::string percent_text(double share) {
  return share > 0 && share < 0.0005 ? fmt::format("{:.1g} %", 100 * share)
                                     : fmt::format("{:.1f} %", 100 * share);
}

std::string row(std::string_view name, std::string_view value) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>", escaped(name), escaped(value));
}

std::string listed(const std::string& rows) {
  return "<dl>" + rows + "</dl>";
}

std::string note(std::string_view text) {
  return fmt::format("<p class=\"note\">{}</p>", escaped(text));
}

std::string share_text(const Share& share) {
  return fmt::format("{} ({:.1f} to {:.1f})", percent_text(share.share), 100 * share.low,
                     100 * share.high);
}

std::string accuracy_rows(const Accuracy& accuracy) {
  return row("right aspect first", share_text(accuracy.rank_1)) +
         row("among the first 5", share_text(accuracy.rank_5)) +
         row("among the first 10", share_text(accuracy.rank_10)) +
         row("view within 20 degrees", share_text(accuracy.within_20_deg));
}

std::string colour_chip(const Eigen::Vector3d& colour) {
  const auto level = [](double value) {
    return static_cast<int>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
  };
  return fmt::format("<i class=\"chip\" style=\"background:rgb({} {} {})\"></i>", level(colour.x()),
                     level(colour.y()), level(colour.z()));
}

std::string face_text(const Face& face) {
  std::string text = colour_chip(face.colour);
  if (!face.name.empty()) return text + escaped(face.name);
  constexpr std::size_t kMost = 4;
  text += face.primitives.size() == 1 ? "surface " : "surfaces ";
  for (std::size_t k = 0; k < std::min(kMost, face.primitives.size()); ++k)
    text += (k == 0 ? "" : ", ") + std::to_string(face.primitives[k]);
  if (face.primitives.size() > kMost)
    text += fmt::format(" and {} more", face.primitives.size() - kMost);
  return text;
}

std::string faces_text(const std::vector<Face>& faces) {
  std::string text;
  for (const Face& face : faces)
    text += fmt::format("<span class=\"face\">{}</span>", face_text(face));
  return text;
}

std::string direction_text(const Eigen::Vector3d& v) {
  return fmt::format("({:+.2f} {:+.2f} {:+.2f})", v.x(), v.y(), v.z());
}

std::string aspect_link(std::int32_t aspect) {
  return fmt::format("<button class=\"link\" data-aspect=\"{0}\">aspect {0}</button>", aspect);
}

constexpr const char* kCoverageHead =
    "<table><thead><tr><th>level</th><th>triangles</th><th>views</th><th>match calls</th>"
    "<th>aspects</th><th>area</th></tr></thead><tbody>";

std::string coverage_row(int level, double patches, double views, double matches, double aspects,
                         double area) {
  return fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
                     level, number_text(patches), number_text(views), number_text(matches),
                     number_text(aspects), percent_text(area));
}

std::string own_rows(const ReportContents& contents) {
  std::string rows;
  for (const LevelCoverage& level : contents.levels)
    rows += coverage_row(level.level, static_cast<double>(level.patches),
                         static_cast<double>(level.views), static_cast<double>(level.match_calls),
                         static_cast<double>(level.clusters), level.area_fraction);
  const CompileStatistics& s = contents.model.index.statistics;
  if (s.clusters.area_assigned > s.clusters.area_fraction)
    rows += fmt::format(
        "<tr><td>{}</td><td colspan=\"3\">with the patches on borders divided, {} more views</td>"
        "<td>{}</td><td>{}</td></tr>",
        s.level, number_text(static_cast<double>(s.subdivision.border_views)),
        number_text(static_cast<double>(s.clusters.clusters)),
        percent_text(s.clusters.area_assigned));
  return rows;
}

std::string thesis_part(const std::vector<ThesisRow>& thesis) {
  std::string html;
  const ThesisRow* before = nullptr;
  for (const ThesisRow& r : thesis) {
    if (before == nullptr || r.threshold != before->threshold ||
        r.cluster_threshold != before->cluster_threshold)
      html += fmt::format(
          "<tr class=\"group\"><td colspan=\"6\">thresholds {:.7g} to split, {:.7g} to "
          "cluster</td></tr>",
          r.threshold, r.cluster_threshold);
    html += coverage_row(r.level, r.patches, r.views, r.match_calls, r.clusters, r.area_fraction);
    before = &r;
  }
  return html;
}

}  // namespace

std::string coverage_table(const ReportContents& contents) {
  const CompileStatistics& s = contents.model.index.statistics;
  std::string html = fmt::format(
      "<div><h3>This model</h3>{}<tr class=\"group\"><td colspan=\"6\">thresholds {:.7g} to split, "
      "{:.7g} to cluster</td></tr>{}</tbody></table></div>",
      kCoverageHead, s.threshold, s.cluster_threshold, own_rows(contents));
  if (contents.thesis.empty()) return "<div class=\"tables\">" + html + "</div>";
  return fmt::format(
      "<div class=\"tables\">{}<div><h3>The thesis&rsquo;s</h3>{}{}</tbody></table></div></div>{}",
      html, kCoverageHead, thesis_part(contents.thesis),
      note("P. Boros, Object Recognition: Modelling and the Interface to a Control Strategy for "
           "Matching, Tables 4.2 to 4.10 and 4.12. Thresholds are in the units of its own matcher: "
           "compare the number of aspects and the area, not the threshold."));
}

std::string accuracy_list(const Explanation& e) {
  return listed(accuracy_rows(e.accuracy) +
                row("another aspect, but near", fmt::format("{} views", e.neighbour_views)) +
                row("wrong by more than 20 degrees", fmt::format("{} views", e.wrong_views))) +
         note(fmt::format("{} random views of the object alone, answered by the index; modulo "
                          "symmetry, with 95 % intervals.",
                          e.views));
}

std::string confusion_list(const ReportContents& contents) {
  const Explanation& e = contents.explanation;
  if (e.confusions.empty() && e.face_confusions.empty())
    return note("No aspect was taken for one far away.");
  constexpr std::size_t kMost = 20;
  std::string html = "<ul>";
  for (std::size_t k = 0; k < std::min(kMost, e.confusions.size()); ++k) {
    const AspectConfusion& c = e.confusions[k];
    html += fmt::format(
        "<li><div>{} taken for {}: {} {}, from {} as if from {}<details><summary>surfaces that "
        "were "
        "matched</summary>{}<div class=\"faint\">taken for</div>{}</details></div></li>",
        aspect_link(c.aspect), aspect_link(c.taken_for), c.views, c.views == 1 ? "view" : "views",
        direction_text(c.seen_from), direction_text(c.believed_from), faces_text(c.faces),
        faces_text(c.faces_believed));
  }
  html += "</ul>";
  if (e.confusions.size() > kMost)
    html += note(fmt::format("{} more", e.confusions.size() - kMost));
  if (e.face_confusions.empty()) return html;
  html += "<h3>Surfaces mistaken for each other</h3><ul>";
  for (std::size_t k = 0; k < std::min(kMost, e.face_confusions.size()); ++k) {
    const FaceConfusion& c = e.face_confusions[k];
    html += fmt::format(
        "<li><div>{} and {}<small>{} {}, {:.1f} steps of colour apart</small></div></li>",
        face_text(e.faces[c.face]), face_text(e.faces[c.taken_for]), c.views,
        c.views == 1 ? "view" : "views", c.separation);
  }
  return html + "</ul>";
}

std::string blind_spot_list(const Explanation& e) {
  std::string html = listed(row("no aspect of the index covers", percent_text(e.blind_share)));
  if (e.blind_spots.empty()) return html;
  html += "<ul>";
  for (const Spot& spot : e.blind_spots)
    html += fmt::format(
        "<li><div><button class=\"link\" data-from=\"{:.4f} {:.4f} {:.4f}\">{} within {:.0f}&deg; "
        "of "
        "{}</button><small>{}</small></div></li>",
        spot.centre.x(), spot.centre.y(), spot.centre.z(), percent_text(spot.share),
        spot.radius_deg, direction_text(spot.centre), escaped(spot.reason));
  return html + "</ul>";
}

std::string cure_list(const Explanation& e) {
  if (e.crowded)
    return note(
        fmt::format("Of {} colours, {} of the surface is in ones that touch others too like them; "
                    "--merge-colours {} would show nearly all of it as it is.",
                    e.crowded->colours, percent_text(e.crowded->share), e.crowded->enough));
  if (e.cure.changes.empty())
    return note(e.face_confusions.empty()
                    ? "Nothing to cure."
                    : "None by colour; the surfaces that are mistaken differ in colour already.");
  std::string html = "<ul>";
  for (const ColourChange& change : e.cure.changes)
    html += fmt::format(
        "<li><div>paint {} {}{}<small>{:.1f} steps from every other surface</small></div></li>",
        face_text(e.faces[change.face]), colour_chip(change.colour), escaped(change.colour_name),
        change.separation);
  html += "</ul>" + listed(row("wrong views before", std::to_string(e.cure.wrong_before)) +
                           row("wrong views after", std::to_string(e.cure.wrong_after)) +
                           row("of those wrong before, right after", std::to_string(e.cure.cured)) +
                           accuracy_rows(e.cure.after));
  return html + note(fmt::format("Tried with a model of level {}.", e.cure.level));
}

std::string symmetry_list(const ReportContents& contents) {
  if (contents.axes.empty()) return note("None: no rotation leaves all views as they are.");
  std::string html = "<ul>";
  for (const ObjectAxis& axis : contents.axes)
    html += fmt::format(
        "<li><div><button class=\"link\" data-from=\"{:.4f} {:.4f} "
        "{:.4f}\">{}</button><small>about "
        "{}</small></div></li>",
        axis.direction.x(), axis.direction.y(), axis.direction.z(),
        axis.fold == 0
            ? std::string("round: the same at any angle")
            : fmt::format("{}-fold: the same after 1/{} of a turn", axis.fold, axis.fold),
        direction_text(axis.direction));
  return html + "</ul>";
}

std::string budget_list(const ReportContents& contents) {
  const CompileStatistics& s = contents.model.index.statistics;
  const IndexWithoutBudget& all = contents.without_budget;
  const auto kib = [](std::size_t bytes) {
    return fmt::format("{:.1f} KiB", static_cast<double>(bytes) / 1024);
  };
  const std::size_t aspects_out = contents.aspects() - s.index.classes;
  const double area_out = s.clusters.area_assigned - s.index.area_assigned;
  std::string html = listed(
      row("budget, --max-index-kib", kib(contents.recipe.options.max_index_bytes)) +
      row("index", kib(s.index.bytes)) +
      row("aspects kept", fmt::format("{} of {}", s.index.classes, contents.aspects())) +
      row("left out", fmt::format("{} of the sphere", percent_text(std::max(area_out, 0.0)))) +
      row("key views kept", fmt::format("{} of {}", s.index.key_views, all.key_views)) +
      row("apart by at least", fmt::format("{:.1f}\u00b0", s.index.key_view_spacing_deg)) +
      row("golden frame", s.index.golden_frame_bytes > 0
                              ? fmt::format("{} bytes", s.index.golden_frame_bytes)
                              : std::string("none")) +
      row("all of it would take", kib(all.bytes)));
  const auto enough_kib = (all.bytes + 1023) / 1024;
  if (aspects_out == 0 && s.index.key_views >= all.key_views)
    return html + note("The budget left nothing out.");
  return html + note(fmt::format("{}--max-index-kib {} would keep everything.",
                                 aspects_out > 0 ? "Aspects that are left out are pale on the "
                                                   "sphere, and never named by the device. "
                                                 : "",
                                 enough_kib));
}

std::string statistics_list(const ReportContents& contents) {
  const CompileStatistics& s = contents.model.index.statistics;
  const SubdivisionStatistics& sub = s.subdivision;
  const auto count = [](std::size_t value) { return number_text(static_cast<double>(value)); };
  std::string rows =
      row("sensor", std::string(name_of(s.sensor))) +
      row("level", fmt::format("{} to {}", contents.recipe.options.min_level, s.level)) +
      row("triangles of the sphere", count(sub.patches)) +
      row("views at their corners", count(sub.views)) +
      row("views on borders", count(sub.border_views)) +
      row("match calls", count(sub.match_calls)) +
      row("matches cut short", count(sub.matches_gave_up)) +
      row("contour types", count(s.index.contour_types)) +
      row("aspects", count(contents.aspects())) +
      row("surfaces", count(contents.recipe.scene.primitives.size())) +
      row("store", fmt::format("{:.1f} MiB, {} views, {} matches",
                               static_cast<double>(contents.store_bytes) / 1048576,
                               count(contents.store.views), count(contents.store.matches))) +
      row("compiler", contents.store.key.compiler) + row("scene", contents.store.key.scene_hash);
  std::string runs;
  for (const FinishedRun& run : contents.store.runs)
    runs +=
        fmt::format("<li><div>level {} from {}, threshold {:.7g}<small>{} views</small></div></li>",
                    run.level, run.min_level, run.threshold, count(run.views));
  return listed(rows) + "<h3>Complete in the store</h3><ul>" + runs + "</ul>";
}

}  // namespace aspect
