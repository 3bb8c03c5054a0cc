#include "compiler/scene/bob_parser.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "compiler/scene/picture_fit.h"
#include "compiler/scene/scene_bounds.h"
#include "runtime/base/nearest_word.h"

namespace aspect {

BobParser::BobParser(BobWords& words, const std::optional<Eigen::Vector3d>& missing_colour)
    : words_(words),
      warnings_(scene_.warnings),
      lost_(missing_colour, scene_.missing_colours),
      numbers_(words, lost_),
      transforms_(words, numbers_),
      shapes_(words, numbers_, warnings_, transforms_),
      studio_reader_(words, numbers_, warnings_, transforms_),
      surface_reader_(words, numbers_, warnings_, lost_, transforms_) {}

Scene BobParser::parse() {
  while (words_.peek().kind != BobWord::Kind::kEnd) statement(words_.take());
  transforms_.finish();
  for (Light& light : scene_.lights) light.casts_shadows = light.casts_shadows && shadows_;
  warn_where_it_leaves_the_picture();
  scene_.source = words_.source();
  return std::move(scene_);
}

void BobParser::statement(const BobWord& word) {
  if (auto shape = shapes_.read(word)) return primitive(word, std::move(*shape));
  if (word.text == "transform") return transforms_.push(word);
  if (word.text == "transform_pop") return transforms_.pop(word);
  if (word.text == "studio") return studio(word);
  if (word.text == "light") return light(word);
  if (word.text != "surface") unknown_statement(word);
  surface_ = surface_reader_.read(word);
  surface_is_listed_ = false;
}

void BobParser::unknown_statement(const BobWord& word) const {
  if (word.text == "}") words_.fail(word, "'}' closes nothing; remove it");
  std::vector<std::string_view> known(statement_names().begin(), statement_names().end());
  const auto macros = words_.macro_names();
  known.insert(known.end(), macros.begin(), macros.end());
  words_.fail(word, fmt::format("unknown word {}; the nearest known one is '{}'", quoted(word),
                                nearest_word(word.text, known)));
}

void BobParser::studio(const BobWord& word) {
  if (studio_word_) {
    warnings_.add(words_, word,
                  fmt::format("a second studio, the one at {} no longer holds; write one",
                              words_.locate(*studio_word_)));
  }
  if (!transforms_.empty()) {
    words_.fail(word, "studio inside a transform; write it before the transform");
  }
  studio_word_ = word;
  const BobStudio read = studio_reader_.studio(word);
  scene_.studio = read.studio;
  shadows_ = read.shadows;
}

void BobParser::light(const BobWord& word) {
  if (scene_.lights.size() == kMaxLights) {
    words_.fail(word, fmt::format("more than {} lights; write fewer", kMaxLights));
  }
  scene_.lights.push_back(studio_reader_.light(word));
}

void BobParser::primitive(const BobWord& word, BobShapes::Shape shape) {
  if (scene_.primitives.size() == kMaxPrimitives) {
    words_.fail(word, fmt::format("more than {} primitives; write fewer", kMaxPrimitives));
  }
  // Listed with its first primitive, so that unused surfaces take no room.
  if (!surface_is_listed_) scene_.surfaces.push_back(surface_);
  surface_is_listed_ = true;
  scene_.primitives.push_back({std::move(shape), static_cast<int>(scene_.surfaces.size()) - 1});
  primitive_words_.push_back(word);
}

void BobParser::warn_where_it_leaves_the_picture() {
  const Eigen::Vector3d& at = scene_.studio.at;
  double radius = 0;
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < scene_.primitives.size(); ++i) {
    const double distance = farthest_distance(scene_.primitives[i], at);
    if (distance <= radius) continue;
    radius = distance;
    farthest = i;
  }
  const double fitting = fitting_radius(scene_.studio);
  if (radius <= fitting) return;
  // Scaling is about the origin, so an object seen off its centre has less room.
  const double room = fitting - at.norm();
  // Rounded down: the scale it names must fit.
  const double scale = std::floor(room / bounding_radius(scene_) * 1e6) / 1e6;
  const std::string advice =
      scale > 0 ? fmt::format("scale the whole object by {:g}", scale)
                : std::string("centre it at the origin, set at 0 0 0 and scale it down");
  warnings_.add(words_, primitive_words_[farthest],
                fmt::format("{} {:g}: its radius is {:.4g}, {:.4g} fits; {}", kLeavesPicture,
                            kCompileDistance, radius, fitting, advice));
}

}  // namespace aspect
