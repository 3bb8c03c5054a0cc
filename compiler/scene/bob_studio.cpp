#include "compiler/scene/bob_studio.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "compiler/scene/picture_fit.h"
#include "runtime/base/nearest_word.h"

namespace aspect {
namespace {

// A picture of this many pixels a side still fits in memory once a thread.
constexpr double kMaxResolution = 4096;
constexpr double kMaxAspect = 100;
constexpr int kMaxSamples = 4096;
constexpr int kMaxDepth = 100;
constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;

constexpr std::array<std::string_view, 4> kAntialias = {"none", "quick", "corners", "adaptive"};
constexpr std::array<std::string_view, 3> kProjections = {"perspective", "orthogonal", "flat"};

}  // namespace

void BobStudioReader::read_resolution(const BobWord& word, Studio& studio) {
  const double width = numbers_.component();
  const double height = numbers_.component();
  for (const double side : {width, height}) {
    if (side == std::floor(side) && side >= 1 && side <= kMaxResolution) continue;
    words_.fail(word, fmt::format("resolution {:g} {:g}; write whole numbers within 1 .. {:g}",
                                  width, height, kMaxResolution));
  }
  studio.width_px = static_cast<int>(width);
  studio.height_px = static_cast<int>(height);
}

// Both parallel projections show a picture of a given width: `flat W` names it, `orthogonal` may;
// otherwise it is what `angle` shows at the compile distance.
void BobStudioReader::read_projection(Studio& studio) {
  const BobWord word = words_.take();
  if (std::find(kProjections.begin(), kProjections.end(), word.text) == kProjections.end()) {
    words_.fail(word, fmt::format("unknown word {} behind project; the nearest known one is '{}'",
                                  quoted(word), nearest_word(word.text, kProjections)));
  }
  if (word.text == "perspective") return;
  studio.projection = Projection::kOrthogonal;
  const BobWord& next = words_.peek();
  const bool number_follows =
      next.kind == BobWord::Kind::kNumber || next.text == "(" || is_operator(next);
  if (word.text == "orthogonal" && !number_follows) return;
  studio.width = numbers_.number();
  if (studio.width > 0) return;
  words_.fail(word, fmt::format("project {} {:g}; write the picture's width, more than 0",
                                word.text, studio.width));
}

void BobStudioReader::add_optics(BobBlock& fields, Studio& studio) {
  fields.number_within("threshold", studio.threshold, 0, 255);
  fields.whole_number("samples", studio.samples, 1, kMaxSamples);
  fields.flag("jitter", studio.jitter);
  fields.whole_number("depth", studio.depth, 0, kMaxDepth);
  fields.number_within("haze", studio.haze, 0, 1);
  fields.number_within("aperture", studio.aperture, 0, BobNumbers::kMaxNumber);
  fields.number_within("focal_length", studio.focal_length, 0, BobNumbers::kMaxNumber);
}

BobStudio BobStudioReader::studio(const BobWord& statement) {
  BobStudio result;
  Studio& studio = result.studio;
  bool no_shadows = false, no_exponential = false;
  std::size_t antialias = 0;
  BobBlock fields = block(statement);
  fields.without_effect("from", [this](const BobWord&) { numbers_.vector(); });
  fields.vector("at", studio.at);
  fields.vector("up", studio.up);
  fields.number("angle", studio.angle_deg);
  fields.field("resolution", [&](const BobWord& word) { read_resolution(word, studio); });
  fields.number("aspect", studio.aspect);
  fields.color("ambient", studio.ambient);
  fields.color("background", studio.background);
  fields.word("antialias", antialias, kAntialias);
  fields.field("project", [&](const BobWord&) { read_projection(studio); });
  fields.flag("no_shadows", no_shadows);
  fields.flag("no_exp_trans", no_exponential);
  // Light gathered behind glass: shadows here have no brighter middle.
  fields.without_effect("caustics", [](const BobWord&) {});
  add_optics(fields, studio);
  fields.read();
  result.shadows = !no_shadows;
  studio.antialias = static_cast<Antialias>(antialias);
  studio.exponential_transparency = !no_exponential;
  check_view(fields, studio, statement);
  return result;
}

void BobStudioReader::check_view(const BobBlock& fields, Studio& studio,
                                 const BobWord& statement) const {
  if (studio.up.norm() < 1e-9) {
    words_.fail(statement, "up has no length; write a direction such as 0 0 1");
  }
  if (!(studio.angle_deg >= 0.1 && studio.angle_deg <= 179)) {
    words_.fail(statement,
                fmt::format("angle {:g}; write degrees within 0.1 .. 179", studio.angle_deg));
  }
  if (!fields.has("aspect")) {
    studio.aspect = static_cast<double>(studio.width_px) / studio.height_px;
  } else if (!(studio.aspect >= 1 / kMaxAspect && studio.aspect <= kMaxAspect)) {
    words_.fail(statement, fmt::format("aspect {:g}; write picture width / height, within {:g} .. "
                                       "{:g}",
                                       studio.aspect, 1 / kMaxAspect, kMaxAspect));
  }
  if (studio.width == 0)
    studio.width = 2 * kCompileDistance * std::tan(studio.angle_deg / 2 * kRadiansPerDegree);
}

}  // namespace aspect
