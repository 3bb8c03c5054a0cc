#include "runtime/workbench/state_text.h"

#include <fmt/format.h>

#include "runtime/base/two_sentences.h"
#include "runtime/capture/control_words.h"
#include "runtime/service/segmentation_values.h"

namespace aspect {
namespace {

using Json = nlohmann::json;

const char* kind_of(const SegmentationValue& value) {
  constexpr std::array kKinds = {"whole", "number", "truth"};
  return kKinds[value.member.index()];
}

// Floats as short as they are in the file.
Json shown(float number) {
  return std::stod(fmt::to_string(number));
}
template <typename Value>
Json shown(Value value) {
  return value;
}

Json value_of(const SegmentationValue& value, const SegmentationOverrides& all) {
  return std::visit([&](auto member) { return shown(*(all.*member)); }, value.member);
}

Json values_of(const SettingsDraft& draft) {
  const SegmentationOverrides now = segmentation_of(draft.values()),
                              otherwise = segmentation_of(draft.otherwise());
  Json all = Json::array();
  for (const SegmentationValue& value : segmentation_values()) {
    const auto changed = draft.changes().find(std::string(value.key));
    const bool is_changed = changed != draft.changes().end();
    // What is no good is shown as well: it is to be mended.
    const bool as_typed = draft.is_fault(std::string(value.key));
    all.push_back({{"key", value.key},
                   {"unit", value.unit},
                   {"words", two_sentences(value.meaning, value.advice)},
                   {"kind", kind_of(value)},
                   {"least", value.least},
                   {"most", value.most},
                   {"value", as_typed ? changed->second : value_of(value, now)},
                   {"otherwise", value_of(value, otherwise)},
                   {"changed", is_changed},
                   {"of_range", value.of_range}});
  }
  return all;
}

Json controls_of(const std::vector<AdjustableControl>& controls) {
  constexpr std::array kKinds = {"number", "truth", "menu", "button"};
  Json all = Json::array();
  for (const AdjustableControl& control : controls) {
    const ControlWords* const words = find_control_words(control.name);
    Json items = Json::array();
    for (const ControlItem& item : control.items)
      items.push_back({{"value", item.value}, {"name", item.name}});
    all.push_back({{"name", control.name},
                   {"words", words != nullptr
                                 ? two_sentences(words->meaning, words->advice)
                                 : std::string("The camera's own; its manual says what it does.")},
                   {"kind", kKinds[static_cast<std::size_t>(control.kind)]},
                   {"least", control.least},
                   {"most", control.most},
                   {"step", control.step},
                   {"usual", control.usual},
                   {"value", control.value},
                   {"inactive", control.inactive},
                   {"fixed", control.fixed},
                   {"items", items}});
  }
  return all;
}

Json region_of(const Box& box) {
  if (box.empty()) return nullptr;
  return {box.x, box.y, box.width, box.height};
}

}  // namespace

std::string state_text(const BenchState& state) {
  Json models = Json::array();
  for (const ModelColours& model : state.models)
    models.push_back({{"object", model.object}, {"colours", model.shares}});
  const std::string name = state.file.filename().string(), folder = state.record.string();
  const Error* const fault = state.draft.fault();
  const Json all = {{"settings", state.settings},
                    {"sensor", kSensorNames[static_cast<std::size_t>(state.sensor)]},
                    {"file", name.empty() ? Json() : Json(name)},
                    {"record", folder.empty() ? Json() : Json(folder)},
                    {"changed", state.draft.is_changed()},
                    {"fault", fault != nullptr ? Json(fault->message) : Json()},
                    {"values", values_of(state.draft)},
                    {"region", region_of(state.draft.values().region_of_interest)},
                    {"region_words", two_sentences(kRegionMeaning, kRegionAdvice)},
                    {"controls", controls_of(state.controls)},
                    {"models", models},
                    {"camera", state.play == nullptr},
                    {"streaming", state.has_camera},
                    {"paused", state.play != nullptr && state.play->paused.load()}};
  // Names from files need not be UTF-8.
  return all.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace aspect
