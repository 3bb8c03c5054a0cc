// The whole line is tried first. If it does not fit, the mildest cut that does is looked for by
// bisection: first fewer hypotheses an object down to one each, then fewer objects. An object is
// never left without its best hypothesis, since that would read as "nothing known".
#include "runtime/service/recognition_json.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "runtime/service/json_text.h"

namespace aspect {
namespace {

struct Cut {
  std::size_t objects = 0;     // at most so many
  std::size_t hypotheses = 0;  // at most so many each
};

struct Cuts {
  std::size_t objects = 0, longest = 0;
  explicit Cuts(std::span<const SeenObject> seen) : objects(seen.size()) {
    for (const SeenObject& object : seen) longest = std::max(longest, object.hypotheses.size());
  }
  std::size_t hypothesis_steps() const { return longest > 1 ? longest - 1 : 0; }
  std::size_t count() const { return hypothesis_steps() + objects + 1; }
  // Cut 0 leaves all, each next one is shorter, the last one leaves no object.
  Cut at(std::size_t step) const {
    if (step <= hypothesis_steps()) return {objects, longest - step};
    return {objects - (step - hypothesis_steps()), 1};
  }
};

double milliseconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

template <typename Value>
void put(JsonText& json, std::string_view key, Value value) {
  json.key(key);
  json.value(value);
}

void put_stages(JsonText& json, const StageTimes& stages) {
  json.key("stages_ms");
  json.begin_object();
  put(json, "convert", milliseconds(stages.convert));
  put(json, "enhance", milliseconds(stages.enhance));
  put(json, "segment", milliseconds(stages.segment));
  put(json, "features", milliseconds(stages.features));
  put(json, "match", milliseconds(stages.match));
  put(json, "pose", milliseconds(stages.pose));
  json.end_object();
}

void put_capture(JsonText& json, const CaptureLabel& capture) {
  json.key("capture");
  json.begin_object();
  put(json, "time_s", capture.time_s);
  put(json, "latency_ms", milliseconds(capture.latency));
  put(json, "late", static_cast<std::int64_t>(capture.late));
  put(json, "lost", static_cast<std::int64_t>(capture.lost));
  put(json, "damaged", static_cast<std::int64_t>(capture.damaged));
  json.end_object();
}

template <typename Numbers>
void put_numbers(JsonText& json, std::string_view key, const Numbers& numbers) {
  json.key(key);
  json.begin_array();
  for (const auto number : numbers) json.value(static_cast<double>(number));
  json.end_array();
}

void put_pose(JsonText& json, const RefinedPose& refined) {
  const Rotation& q = refined.pose.rotation;
  json.key("pose");
  json.begin_object();
  put_numbers(json, "quaternion", std::array{q.w, q.x, q.y, q.z});
  put_numbers(json, "translation", refined.pose.translation);
  put(json, "reprojection_px", static_cast<double>(refined.reprojection_px));
  put_numbers(json, "covariance", refined.covariance);
  json.end_object();
}

void put_hypothesis(JsonText& json, const Hypothesis& hypothesis,
                    std::span<const ClassIndex> indexes) {
  ASPECT_DCHECK(hypothesis.index < indexes.size());
  json.begin_object();
  put(json, "object", std::string_view(indexes[hypothesis.index].object));
  put(json, "class", std::int64_t{hypothesis.class_id});
  put(json, "score", hypothesis.score);
  put(json, "matched", std::int64_t{hypothesis.matched});
  put(json, "unmatched", std::int64_t{hypothesis.unmatched});
  json.key("view");
  json.begin_array();
  for (const float component : hypothesis.view) json.value(component);
  json.end_array();
  if (hypothesis.pose != nullptr) put_pose(json, hypothesis.pose->refined);
  json.key("contours");
  json.begin_array();
  for (const ContourMatch& match : hypothesis.contours) {
    char name[4];
    json.begin_array();
    json.value(std::int64_t{match.contour});
    json.value(contour_name(match.name, name));
    json.end_array();
  }
  json.end_array();
  json.end_object();
}

void put_judgement(JsonText& json, const Judgement& judgement, std::size_t hypotheses) {
  if (judgement.verdict == Verdict::none) return;
  put(json, "verdict", name_of(judgement.verdict));
  put(json, "probability", static_cast<double>(judgement.probability));
  if (judgement.rival_count == 0) return;
  json.key("rivals");
  json.begin_array();
  for (const std::uint8_t place : judgement.rival_places())
    if (place < hypotheses) json.value(std::int64_t{place});
  json.end_array();
}

void put_object(JsonText& json, const SeenObject& object, std::size_t hypotheses,
                std::span<const ClassIndex> indexes, const std::string* explanation) {
  json.begin_object();
  json.key("box");
  json.begin_array();
  for (const int edge : {object.box.x, object.box.y, object.box.width, object.box.height})
    json.value(std::int64_t{edge});
  json.end_array();
  put(json, "regions", std::int64_t{object.regions});
  if (object.track > 0) put(json, "track", std::int64_t{object.track});
  put_judgement(json, object.judgement, hypotheses);
  json.key("hypotheses");
  json.begin_array();
  for (const Hypothesis& hypothesis : object.hypotheses.first(hypotheses)) {
    if (!json.fits()) return;
    put_hypothesis(json, hypothesis, indexes);
  }
  json.end_array();
  if (explanation != nullptr) {
    json.key("explanation");
    json.json_value(*explanation);
  }
  json.end_object();
}

void put_left_undone(JsonText& json, const LeftUndone& left) {
  if (!left.any()) return;
  json.key("left_undone");
  json.begin_object();
  for (const auto& [key, count] :
       {std::pair{"objects", left.objects}, std::pair{"indexes", left.indexes},
        std::pair{"starts", left.starts}, std::pair{"tracks", left.tracks},
        std::pair{"searches", left.searches}})
    if (count > 0) put(json, key, std::int64_t{count});
  json.end_object();
}

// Length of the line, 0 where it does not fit.
std::size_t write_cut(const FrameLabel& frame, const Recognition& recognition,
                      std::span<const ClassIndex> indexes,
                      std::span<const std::string> explanations, Cut cut, std::span<char> out) {
  JsonText json(out);
  json.begin_object();
  put(json, "frame", frame.name);
  put(json, "sequence", static_cast<std::int64_t>(frame.sequence));
  put(json, "width", std::int64_t{frame.width_px});
  put(json, "height", std::int64_t{frame.height_px});
  put(json, "elapsed_ms", milliseconds(recognition.elapsed));
  put_stages(json, recognition.stages);
  if (frame.capture) put_capture(json, *frame.capture);
  json.key("objects");
  json.begin_array();
  std::size_t written = 0, all = 0;
  for (std::size_t k = 0; k < recognition.objects.size(); ++k) {
    const SeenObject& object = recognition.objects[k];
    all += object.hypotheses.size();
    if (k >= cut.objects || !json.fits()) continue;
    const std::size_t hypotheses = std::min(object.hypotheses.size(), cut.hypotheses);
    put_object(json, object, hypotheses, indexes,
               k < explanations.size() ? &explanations[k] : nullptr);
    written += hypotheses;
  }
  json.end_array();
  const std::size_t objects_cut = recognition.objects.size() - cut.objects;
  if (written < all) put(json, "hypotheses_cut", static_cast<std::int64_t>(all - written));
  if (objects_cut > 0) put(json, "objects_cut", static_cast<std::int64_t>(objects_cut));
  put_left_undone(json, recognition.left_undone);
  json.end_object();
  json.end_line();
  return json.fits() ? json.size() : 0;
}

}  // namespace

std::size_t write_recognition_json(const FrameLabel& frame, const Recognition& recognition,
                                   std::span<const ClassIndex> indexes, std::span<char> out,
                                   std::span<const std::string> explanations) noexcept {
  const Cuts cuts(recognition.objects);
  const auto write = [&](std::size_t step) {
    return write_cut(frame, recognition, indexes, explanations, cuts.at(step), out);
  };
  if (const std::size_t length = write(0)) return length;
  std::size_t too_long = 0, fitting = cuts.count();
  while (fitting - too_long > 1) {
    const std::size_t middle = (too_long + fitting) / 2;
    (write(middle) > 0 ? fitting : too_long) = middle;
  }
  return fitting < cuts.count() ? write(fitting) : 0;
}

std::string_view contour_name(std::uint16_t place, std::span<char, 4> buffer) {
  // Digits run from A = 1 to Z = 26; the largest place has the four letters CRXP.
  std::size_t begin = buffer.size();
  for (unsigned rest = place + 1U; rest > 0; rest = (rest - 1) / 26)
    buffer[--begin] = static_cast<char>('A' + (rest - 1) % 26);
  return {buffer.data() + begin, buffer.size() - begin};
}

}  // namespace aspect
