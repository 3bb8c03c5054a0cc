#include "runtime/recognition/self_test.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>

#include "runtime/base/planned_memory.h"

namespace aspect {
namespace {

// A name comes from a file.
std::string one_line(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; }, '?');
  return name;
}

std::string answer_text(unsigned class_id, int matched, int regions, double score) {
  std::array<char, 96> text;
  const int length =
      std::snprintf(text.data(), text.size(), "class %u with %d of %d contours at %.4f", class_id,
                    matched, regions, score);
  return {text.data(), static_cast<std::size_t>(length)};
}

std::string answer_text(const Hypothesis& h, int regions) {
  return answer_text(h.class_id, h.matched, regions, h.score);
}

std::string found_text(const GoldenAnswer& answer) {
  if (answer.regions == 0) return "nothing";
  if (!answer.best) return "nothing known in " + std::to_string(answer.regions) + " contours";
  const bool own_leads = answer.own && answer.own->score >= answer.rival_score;
  return answer_text(own_leads ? *answer.own : *answer.best, answer.regions);
}

// Prepares the recogniser and returns room for the picture; none where the arena only counts.
std::span<std::uint8_t> take_memory(const ClassIndex& index, const GoldenFrame& golden,
                                    Arena& arena, Recogniser& recogniser) {
  RecogniserParameters parameters;
  parameters.vision = index.vision;
  parameters.vision.one_blob = true;
  parameters.top = kMaxHypotheses;
  recogniser.prepare(arena, {&index, 1}, parameters, golden.width_px, golden.height_px);
  return arena.take<std::uint8_t>(golden_picture_bytes(golden, index.vision.sensor));
}

std::size_t memory_bytes(const ClassIndex& index, const GoldenFrame& golden) {
  Arena counting;
  const auto recogniser = std::make_unique<Recogniser>();
  take_memory(index, golden, counting, *recogniser);
  return counting.used_bytes();
}

Hypothesis without_contours(Hypothesis hypothesis) {
  hypothesis.contours = {};
  return hypothesis;
}

}  // namespace

bool is_expected(const GoldenAnswer& answer, const GoldenFrame& golden) {
  const double score = static_cast<double>(golden.score);
  return answer.own && answer.regions == golden.regions && answer.own->matched == golden.matched &&
         std::abs(answer.own->score - score) <= kGoldenScoreTolerance &&
         answer.rival_score <= score + kGoldenScoreTolerance;
}

namespace {

std::string head_of(const ClassIndex& index) {
  return one_line(index.object) + ": self test: ";
}

SelfTestResult judge(const ClassIndex& index, const GoldenAnswer& answer) {
  using Outcome = SelfTestResult::Outcome;
  const GoldenFrame& golden = *index.golden;
  const std::string expected = answer_text(golden.class_id, golden.matched, golden.regions,
                                           static_cast<double>(golden.score));
  if (is_expected(answer, golden)) return {Outcome::passed, head_of(index) + "passed, " + expected};
  return {Outcome::failed,
          head_of(index) + "failed, the golden frame is " + expected + ", but " +
              found_text(answer) +
              " was found; index or program is damaged or of another version: copy both again, or "
              "compile the scene again with this version of aspectc"};
}

}  // namespace

GoldenAnswer golden_answer(const ClassIndex& index, const GoldenFrame& golden, Arena& arena) {
  const auto recogniser = std::make_unique<Recogniser>();
  const Frame frame = decode_golden_frame(golden, index.vision.sensor,
                                          take_memory(index, golden, arena, *recogniser));
  const Recognition recognition = recogniser->recognise(frame);
  GoldenAnswer answer;
  if (recognition.objects.empty()) return answer;
  const SeenObject& object = recognition.objects.front();
  answer.regions = object.regions;
  for (const Hypothesis& hypothesis : object.hypotheses) {
    if (!answer.best) answer.best = without_contours(hypothesis);
    if (hypothesis.class_id == golden.class_id)
      answer.own = without_contours(hypothesis);
    else
      answer.rival_score = std::max(answer.rival_score, hypothesis.score);
  }
  return answer;
}

GoldenAnswer golden_answer(const ClassIndex& index, const GoldenFrame& golden) {
  PlannedMemory memory;
  std::span<std::byte> bytes;
  memory.plan([&](Arena& arena) { bytes = arena.take<std::byte>(memory_bytes(index, golden)); });
  Arena arena(bytes);
  return golden_answer(index, golden, arena);
}

SelfTestResult self_test(const ClassIndex& index) {
  if (!index.golden)
    return {SelfTestResult::Outcome::absent,
            head_of(index) + "the index has no golden frame; only its checksum was tested"};
  return judge(index, golden_answer(index, *index.golden));
}

std::optional<Error> self_test(std::span<const ClassIndex> indexes) {
  PlannedMemory memory;
  std::span<std::byte> bytes;
  const std::size_t count = self_test_bytes(indexes);
  memory.plan([&](Arena& arena) { bytes = arena.take<std::byte>(count); });
  return self_test(indexes, bytes);
}

std::size_t self_test_bytes(std::span<const ClassIndex> indexes) {
  std::size_t most = 0;
  for (const ClassIndex& index : indexes)
    if (index.golden) most = std::max(most, memory_bytes(index, *index.golden));
  return most;
}

std::optional<Error> self_test(std::span<const ClassIndex> indexes, std::span<std::byte> memory) {
  for (const ClassIndex& index : indexes) {
    if (!index.golden) continue;
    Arena arena(memory);
    SelfTestResult result = judge(index, golden_answer(index, *index.golden, arena));
    if (result.outcome == SelfTestResult::Outcome::failed) return Error{std::move(result.line)};
  }
  return std::nullopt;
}

}  // namespace aspect
