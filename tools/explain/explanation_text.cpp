#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/command_line/terminal_colour.h"
#include "tools/explain/explanation.h"

namespace aspect {
namespace {

constexpr std::size_t kMostListed = 8;

std::string place(const Eigen::Vector3d& d) {
  return fmt::format("({:+.2f} {:+.2f} {:+.2f})", d.x(), d.y(), d.z());
}

std::string colour(const Eigen::Vector3d& c) {
  return fmt::format("{:.2f} {:.2f} {:.2f}", c.x(), c.y(), c.z());
}

std::string name(const Face& face) {
  const auto& p = face.primitives;
  const std::string number =
      p.size() == 1
          ? fmt::format("surface {}", p.front())
          : fmt::format(
                "surfaces {}",
                fmt::join(p.begin(),
                          p.begin() + static_cast<std::ptrdiff_t>(std::min(p.size(), kMostListed)),
                          ","));
  const std::string in_file = face.name.empty() ? "" : fmt::format(" '{}'", face.name);
  return fmt::format("{}{}{} [{}]", number, p.size() > kMostListed ? ",..." : "", in_file,
                     colour(face.colour));
}

std::string names(const std::vector<Face>& faces) {
  std::vector<std::string> all;
  for (const Face& face : faces) all.push_back(name(face));
  return fmt::format("{}", fmt::join(all, ", "));
}

std::string percent(const Share& s) {
  return fmt::format("{:5.1f} % ({:.1f} to {:.1f})", 100 * s.share, 100 * s.low, 100 * s.high);
}

void add_accuracy(const Accuracy& a, std::string& text) {
  text += fmt::format("  right aspect first      {}\n", percent(a.rank_1));
  text += fmt::format("  among the first 5       {}\n", percent(a.rank_5));
  text += fmt::format("  among the first 10      {}\n", percent(a.rank_10));
  text += fmt::format("  view within 20 degrees  {}\n", percent(a.within_20_deg));
}

void add_symmetries(const Explanation& e, std::string& text) {
  for (const auto& a : e.symmetry_axes)
    text += fmt::format("symmetry: round about ({:.3f} {:.3f} {:.3f})\n", a[0], a[1], a[2]);
  for (const auto& q : e.symmetries) {
    const float sine = std::hypot(q[1], q[2], q[3]);
    text += fmt::format("symmetry: {:.1f} degrees about ({:.3f} {:.3f} {:.3f})\n",
                        2 * std::atan2(sine, q[0]) * 180 / std::numbers::pi_v<float>, q[1] / sine,
                        q[2] / sine, q[3] / sine);
  }
  if (e.symmetries.empty() && e.symmetry_axes.empty()) text += "symmetry: none\n";
}

void add_spots(const std::vector<Spot>& spots, const char* what, std::string& text) {
  constexpr double kLeastListed = 0.0005;  // rounds to 0.1 %
  for (const Spot& spot : spots)
    if (spot.share >= kLeastListed)
      text += fmt::format("  {:.1f} % {}, {:.0f} degrees about {}{}{}\n", 100 * spot.share, what,
                          spot.radius_deg, place(spot.centre), spot.reason.empty() ? "" : ": ",
                          spot.reason);
}

void add_confusions(const Explanation& e, std::string& text) {
  for (std::size_t k = 0; k < std::min(kMostListed, e.confusions.size()); ++k) {
    const AspectConfusion& c = e.confusions[k];
    text += fmt::format("  aspect {} taken for {}: {} views, from {} as if from {}\n", c.aspect,
                        c.taken_for, c.views, place(c.seen_from), place(c.believed_from));
    text += fmt::format("    {}\n    taken for {}\n", names(c.faces), names(c.faces_believed));
  }
  for (std::size_t k = 0; k < std::min(kMostListed, e.face_confusions.size()); ++k) {
    const FaceConfusion& c = e.face_confusions[k];
    text += fmt::format("  {} and {} are mistaken in {} views, {:.1f} steps of colour apart\n",
                        name(e.faces[c.face]), name(e.faces[c.taken_for]), c.views, c.separation);
  }
}

void add_backgrounds(const Explanation& e, std::string& text) {
  if (!e.backgrounds) return;
  const BackgroundColours& backgrounds = *e.backgrounds;
  text += fmt::format(
      "colours in {} pictures of {}: share of the pixels, of the pictures with a region of it\n",
      backgrounds.pictures, backgrounds.folder);
  for (const BackgroundColour& c : backgrounds.colours) {
    text += fmt::format("  {:10}  {:5.1f} %  {:5.1f} %  {}\n", name_of(c.commonness),
                        100 * c.presence.pixels, 100 * c.presence.pictures, name(c.face));
    if (!c.better) continue;
    const PaletteColour& paint = c.better->paint;
    text += fmt::format(
        "    better: {} [{}], {}, {:.1f} % and {:.1f} %, {:.1f} steps from every other colour\n",
        paint.name, colour(paint.colour), name_of(paint.commonness), 100 * paint.presence.pixels,
        100 * paint.presence.pictures, c.better->separation);
  }
  std::size_t better = 0, common = 0;
  for (const BackgroundColour& c : backgrounds.colours) {
    better += c.better ? 1U : 0U;
    common += c.commonness == Commonness::common ? 1U : 0U;
  }
  if (e.crowded || better == common) return;
  text += better == kMostBetterPaints
              ? "  change these first, then ask again for the other common ones\n"
              : "  for the other common ones no paint is less common and far from the others\n";
}

void add_cure(const Explanation& e, bool colours, std::string& text) {
  const std::string title = toned("cure:", Tone::good, colours);
  const Cure& cure = e.cure;
  if (e.crowded) {
    text += fmt::format(
        "{} merge the mesh's {} colours, since {:.0f} % of it is in ones that touch others too "
        "like them: aspectc {} --merge-colours {} --store NEW.store; aspectc doctor shows it so\n",
        title, e.crowded->colours, 100 * e.crowded->share, e.scene_file, e.crowded->enough);
    return;
  }
  if (cure.changes.empty()) {
    if (e.wrong_views > 0)
      text += "cure: none by colour; the surfaces that are mistaken differ in colour already\n";
    return;
  }
  for (const ColourChange& change : cure.changes)
    text += fmt::format("{} paint {} {} [{}], {:.1f} steps from every other surface\n", title,
                        name(e.faces[change.face]), change.colour_name, colour(change.colour),
                        change.separation);
  if (e.merged_colours)
    text += fmt::format(
        "  of the mesh in {} colours: a [[surface]] of that colour, and merge_colours = {} under "
        "[mesh], in a project\n",
        *e.merged_colours, *e.merged_colours);
  text += fmt::format(
      "  tried at level {}: {} of the {} wrong views are right then; wrong views {} before, {} "
      "after\n",
      cure.level, cure.cured, cure.wrong_before, cure.wrong_before, cure.wrong_after);
  add_accuracy(cure.after, text);
}

}  // namespace

std::string explanation_text(const Explanation& e, bool colours) {
  std::string text = fmt::format("{}: {} aspects, {} random views\n", e.object, e.aspects, e.views);
  add_symmetries(e, text);
  text += "accuracy to expect, modulo symmetry (95 % interval):\n";
  add_accuracy(e.accuracy, text);
  text += fmt::format("another aspect but nearly the same view: {} views\n", e.neighbour_views);
  text += fmt::format("no aspect covers {:.1f} % of the sphere\n", 100 * e.blind_share);
  add_spots(e.blind_spots, "blind", text);
  text += fmt::format("wrong by more than 20 degrees: {}\n",
                      toned(fmt::format("{} views", e.wrong_views),
                            e.wrong_views == 0 ? Tone::good : Tone::bad, colours));
  add_spots(e.failing_spots, "of the views wrong", text);
  add_confusions(e, text);
  add_backgrounds(e, text);
  add_cure(e, colours, text);
  return text;
}

}  // namespace aspect
