#include "tools/replay/explanation_json.h"

#include <cmath>

#include "runtime/service/json_text.h"
#include "runtime/service/recognition_json.h"

namespace aspect {
namespace {

// Three decimals say all there is to say.
double rounded(double number) {
  return std::round(1000 * number) / 1000;
}

template <typename Value>
void put(JsonText& json, std::string_view key, Value value) {
  json.key(key);
  json.value(value);
}

void put_rounded(JsonText& json, std::string_view key, float number) {
  put(json, key, rounded(static_cast<double>(number)));
}

void put_colour(JsonText& json, std::string_view key, const ColourShare& share) {
  json.key(key);
  json.begin_array();
  for (const float part : share) json.value(rounded(static_cast<double>(part)));
  json.end_array();
}

void put_surfaces(JsonText& json, std::span<const std::uint16_t> surfaces) {
  json.key("surfaces");
  json.begin_array();
  for (const std::uint16_t surface : surfaces) json.value(std::int64_t{surface});
  json.end_array();
}

void put_name(JsonText& json, std::uint16_t place) {
  char name[4];
  put(json, "name", contour_name(place, name));
}

void put_contours(JsonText& json, std::span<const ExplainedContour> contours) {
  json.key("contours");
  json.begin_array();
  for (const ExplainedContour& contour : contours) {
    json.begin_object();
    put(json, "contour", std::int64_t{contour.contour});
    put_name(json, contour.name);
    put_surfaces(json, contour.surfaces);
    put_colour(json, "colour", contour.colour);
    json.end_object();
  }
  json.end_array();
}

void put_missing(JsonText& json, std::span<const MissingPart> parts) {
  json.key("missing");
  json.begin_array();
  for (const MissingPart& part : parts) {
    json.begin_object();
    if (part.name) {
      put_name(json, *part.name);
      put_surfaces(json, part.surfaces);
    }
    put_colour(json, "colour", part.colour);
    if (part.area_px) put_rounded(json, "area_px", *part.area_px);
    if (part.covered) put_rounded(json, "covered", *part.covered);
    json.end_object();
  }
  json.end_array();
}

void put_contradicting(JsonText& json, std::span<const Contradiction> contradicting) {
  json.key("contradicts");
  json.begin_array();
  for (const Contradiction& contradiction : contradicting) {
    json.begin_object();
    put(json, "contour", std::int64_t{contradiction.contour});
    put_colour(json, "colour", contradiction.colour);
    if (contradiction.drawn) put_colour(json, "drawn", *contradiction.drawn);
    put_rounded(json, "area_px", contradiction.area_px);
    json.end_object();
  }
  json.end_array();
}

void put_seen(JsonText& json, const SeenExplanation& seen) {
  put_contours(json, seen.contours);
  put_missing(json, seen.missing);
  put_contradicting(json, seen.contradicting);
}

// `object`: where it is known without a hypothesis.
void put_rival(JsonText& json, const RivalExplanation& rival, std::span<const ClassIndex> indexes,
               const std::string* object = nullptr) {
  json.begin_object();
  if (object != nullptr) put(json, "object", std::string_view(*object));
  put(json, "reason", std::string_view(rival.reason));
  put(json, "chosen", rival.chosen);
  put(json, "on_shortlist", rival.on_shortlist);
  if (rival.least_cost) {
    put_rounded(json, "least_cost", *rival.least_cost);
  } else {
    put(json, "matched", std::int64_t{rival.matched});
    put(json, "needed", std::int64_t{rival.needed});
  }
  if (rival.hypothesis) {
    if (object == nullptr)
      put(json, "object", std::string_view(indexes[rival.hypothesis->index].object));
    put(json, "class", std::int64_t{rival.hypothesis->class_id});
    if (rival.rank > 0) put(json, "rank", std::int64_t{rival.rank});
    put(json, "score", rival.hypothesis->score);
    if (rival.agreement) put_rounded(json, "agreement", *rival.agreement);
    put_seen(json, rival.seen);
  }
  json.end_object();
}

void put_others(JsonText& json, const ExplainedRivals& rivals,
                std::span<const ClassIndex> indexes) {
  json.key("others");
  json.begin_array();
  for (const auto& [index, rival] : rivals.others)
    put_rival(json, rival, indexes, &indexes[index].object);
  json.end_array();
}

}  // namespace

std::string explanation_json(const SeenExplanation& seen, const ExplainedRivals& rivals,
                             std::span<const ClassIndex> indexes) {
  std::string text(std::size_t{16} << 10U, '\0');
  for (;;) {
    JsonText json(text);
    json.begin_object();
    put_seen(json, seen);
    if (rivals.expected) {
      json.key("expected");
      put_rival(json, *rivals.expected, indexes);
    }
    if (!rivals.others.empty()) put_others(json, rivals, indexes);
    json.end_object();
    if (json.fits()) {
      text.resize(json.size());
      return text;
    }
    text.resize(2 * text.size());
  }
}

}  // namespace aspect
