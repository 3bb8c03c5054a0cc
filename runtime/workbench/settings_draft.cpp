#include "runtime/workbench/settings_draft.h"

#include <fmt/format.h>
#include <toml++/toml.h>
#include <algorithm>

#include "runtime/service/segmentation_table.h"
#include "runtime/service/segmentation_values.h"

namespace aspect {
namespace {

using Json = nlohmann::json;

constexpr const char* kRegion = "region_of_interest";

std::string literal_number(const Json& value) {
  return value.is_number() || value.is_boolean() ? value.dump() : "\"?\"";
}

// As TOML has it; what no key takes becomes a text.
std::string literal(const Json& value) {
  if (!value.is_array()) return literal_number(value);
  std::string text;
  for (const Json& element : value) text += (text.empty() ? "" : ", ") + literal_number(element);
  return "[" + text + "]";
}

void insert(toml::table& table, const std::string& key, const std::string& text) {
  const toml::table parsed = toml::parse("value = " + text);
  table.insert_or_assign(key, *parsed.get("value"));
}

template <typename Number>
std::string text_of(const Number& number) {
  return fmt::format("{}", number);
}

toml::table table_of(const SegmentationOverrides& overrides) {
  toml::table table;
  for (const SegmentationValue& value : segmentation_values())
    std::visit(
        [&](auto member) {
          if (const auto& set = overrides.*member)
            insert(table, std::string(value.key), text_of(*set));
        },
        value.member);
  if (const auto& box = overrides.region_of_interest)
    insert(table, kRegion,
           fmt::format("[{}, {}, {}, {}]", box->x, box->y, box->width, box->height));
  return table;
}

bool is_same(const toml::table& file, const std::string& key, const Json& value) {
  const toml::node* const node = file.get(key);
  if (node == nullptr) return false;
  if (value.is_number() && node->is_number()) return node->value<double>() == value.get<double>();
  if (value.is_boolean() && node->is_boolean()) return node->value<bool>() == value.get<bool>();
  return false;
}

// Of a table that is in no file, so that no place in it is worth telling.
Error without_place(const Error& error) {
  const std::size_t begin = error.message.find('[');
  return {begin == std::string::npos ? error.message : error.message.substr(begin)};
}

// Null: without the key.
std::optional<Error> put_value(toml::table& table, const std::string& key, const Json& value,
                               SegmentationOverrides& overrides) {
  try {
    if (value.is_null())
      table.erase(key);
    else
      insert(table, key, literal(value));
  } catch (const toml::parse_error&) {
    return Error{"[segmentation] " + key + " is too large for the file; give a smaller one"};
  }
  const auto error = read_segmentation(table, "page", overrides);
  return error ? std::optional(without_place(*error)) : std::nullopt;
}

}  // namespace

void SettingsDraft::start(const Configuration& configuration, const VisionParameters& otherwise) {
  of_file_ = configuration.segmentation;
  controls_of_file_ = configuration.capture.controls;
  otherwise_ = values_ = otherwise;
  of_file_.apply(values_);
  changes_.clear();
  controls_.clear();
  faults_.clear();
}

std::optional<Error> SettingsDraft::change(const Json& values) {
  constexpr std::size_t kMostKeys = 64;
  if (!values.is_object() || values.size() > kMostKeys)
    return Error{"values must be one object of numbers by key"};
  for (const auto& [key, value] : values.items())
    if (key != kRegion && find_segmentation_value(key) == nullptr)
      return Error{"[segmentation] has no such key; see aspectd --help"};
  const toml::table file = table_of(of_file_);
  for (const auto& [key, value] : values.items()) {
    changes_[key] = value;
    // What is as in the file again is no change.
    if (value.is_null() ? !file.contains(key) : is_same(file, key, value)) changes_.erase(key);
  }
  read();
  for (const auto& [key, error] : faults_)
    if (values.contains(key)) return error;
  return std::nullopt;
}

// What is no good is left as it was, and the others hold.
void SettingsDraft::read() {
  faults_.clear();
  toml::table table = table_of(of_file_);
  SegmentationOverrides good = of_file_;
  for (const auto& [key, value] : changes_) {
    toml::table tried = table;
    SegmentationOverrides overrides;
    if (auto error = put_value(tried, key, value, overrides)) {
      faults_.emplace(key, std::move(*error));
      continue;
    }
    table = std::move(tried);
    good = overrides;
  }
  values_ = otherwise_;
  good.apply(values_);
}

void SettingsDraft::forget_values() {
  changes_.clear();
  read();
}

void SettingsDraft::change_control(const CameraControl& control, bool is_automatic) {
  const auto found = std::ranges::find_if(
      controls_, [&](const auto& changed) { return changed.control.name == control.name; });
  if (found == controls_.end())
    controls_.push_back({control, is_automatic});
  else
    found->control = control;
}

std::vector<CameraControl> SettingsDraft::controls() const {
  std::vector<CameraControl> all = controls_of_file_;
  for (const auto& [control, is_automatic] : controls_) {
    const auto found = std::ranges::find(all, control.name, &CameraControl::name);
    if (found != all.end())
      found->value = control.value;
    else
      all.insert(is_automatic ? all.begin() : all.end(), control);
  }
  return all;
}

std::vector<TomlEdit> SettingsDraft::edits() const {
  std::vector<TomlEdit> edits;
  for (const auto& [key, value] : changes_)
    edits.push_back({"segmentation", key,
                     value.is_null() ? std::nullopt : std::optional(literal(value)), false});
  for (const auto& [control, is_automatic] : controls_)
    edits.push_back({"camera.controls", control.name, fmt::to_string(control.value), is_automatic});
  return edits;
}

}  // namespace aspect
