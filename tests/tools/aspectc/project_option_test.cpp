// Every entry of the option table, by key and by flag.
#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>
#include <set>

#include "tools/aspectc/options/option_flags.h"
#include "tools/aspectc/options/option_text.h"
#include "tools/aspectc/options/settings_check.h"
#include "tools/aspectc/project/project_file.h"

namespace aspect {
namespace {

using Catch::Contains;
using Catch::StartsWith;

// One that is neither the default nor at an end of the range.
OptionValue other_value(const Option& option) {
  const auto now = option.get({});
  if (std::holds_alternative<TruthForm>(option.form)) return !std::get<bool>(*now);
  if (const auto* form = std::get_if<WholeForm>(&option.form)) {
    const int step = now && std::get<int>(*now) == form->range.most ? -1 : 1;
    return now ? std::get<int>(*now) + step : form->range.least + 1;
  }
  if (const auto* form = std::get_if<NumbersForm>(&option.form)) {
    std::vector<double> numbers;
    for (std::size_t k = 0; k < form->count; ++k)
      numbers.push_back(0.5 + static_cast<double>(k) / 4);
    return numbers;
  }
  if (std::holds_alternative<WordForm>(option.form)) return std::get<int>(*now) == 0 ? 1 : 0;
  if (!now) return 2.5;
  return std::get<double>(*now) == 0 ? 0.5 : std::get<double>(*now) * 0.75;
}

// Some members are single precision.
bool is_same(const std::optional<OptionValue>& got, const OptionValue& wanted) {
  const auto* number = std::get_if<double>(&wanted);
  if (!got || number == nullptr) return got == wanted;
  return static_cast<float>(std::get<double>(*got)) == static_cast<float>(*number);
}

// Raised with the patches' threshold, so that no contradiction comes between.
CompileSettings by_key(const Option& option, const std::string& value) {
  const std::string text = "scene = \"a.b\"\n[" + std::string(option.text.table) + "]\n" +
                           std::string(option.text.key) + " = " + value + "\n";
  const std::string twin = option.text.key == "fx"                              ? "fy = 9\n"
                           : option.text.key == "fy" || option.text.key == "cx" ? "fx = 9\n"
                           : option.text.key == "cy"                            ? "fx = 9\n"
                                                                                : "";
  const std::string third = option.text.key == "cx" || option.text.key == "cy" ? "fy = 9\n" : "";
  const Result<Project> project = parse_project(text + twin + third, "p.toml");
  INFO(text);
  if (!project) FAIL(project.error());
  return project.value().objects.front().settings;
}

CompileSettings by_flag(const std::vector<std::string>& words) {
  CLI::App app;
  std::vector<GivenFlag> given;
  add_option_flags(app, given);
  std::vector<std::string> reversed(words.rbegin(), words.rend());
  app.parse(reversed);
  CompileSettings settings;
  for (const GivenFlag& flag : given) flag.option->set(settings, flag.value);
  return settings;
}

std::string flag_text(const Option& option, const OptionValue& value) {
  std::string text;
  for (const char c : toml_text(option, value))
    if (std::string("[]\" ").find(c) == std::string::npos) text += c;
  return text;
}

std::string error_of(const std::string& text) {
  const Result<Project> project = parse_project(text, "p.toml");
  return project ? "" : project.error();
}

}  // namespace

TEST_CASE("every key of a project and every flag changes its own option and no other") {
  for (const Option& option : compile_option_table()) {
    const OptionValue value = other_value(option);
    INFO(key_name(option) << " = " << toml_text(option, value));
    REQUIRE(option.get({}) != value);
    const CompileSettings keyed = by_key(option, toml_text(option, value));
    CHECK(is_same(option.get(keyed), value));
    const CompileSettings flagged = by_flag({flag_name(option), flag_text(option, value)});
    CHECK(is_same(option.get(flagged), value));
    if (option.text.key == "sensor") continue;  // the rest of the segmentation follows it
    for (const Option& other : compile_option_table())
      if (&other != &option) CHECK(other.get(flagged) == other.get({}));
  }
}

TEST_CASE("the table names every member that it should, spot-checked by hand") {
  const CompileSettings s = by_flag(
      {"--level",     "7",          "--stop-area",       "0.95",    "--match-limit-ms", "20",
       "--relations", "tree",       "--relations-count", "9",       "--max-index-kib",  "33",
       "--scoring",   "area",       "--small-cluster",   "0.01",    "--share-scale",    "0.07",
       "--ambient",   "1,0.5,0.25", "--distance",        "0.8,1.25"});
  CHECK(s.options.level == 7);
  CHECK(s.options.stop_area == 0.95);
  CHECK(s.options.match_limit_ms == 20);
  CHECK(s.options.vision.relation_choice == RelationChoice::tree);
  CHECK(s.options.vision.relations_max == 9);
  CHECK(s.options.max_index_bytes == 33 * 1024);
  CHECK(s.options.scoring == Scoring::area);
  CHECK(s.options.small_cluster_fraction == 0.01);
  CHECK(s.options.match_scales.share == 0.07);
  CHECK(s.light.ambient == std::vector{1.0, 0.5, 0.25});
  CHECK(s.camera.distance == std::vector{0.8, 1.25});
}

TEST_CASE("keys and flags are there once each, and every option says what it means") {
  std::set<std::string> keys, flags;
  for (const Option& option : compile_option_table()) {
    INFO(key_name(option));
    CHECK(keys.insert(key_name(option)).second);
    CHECK(flags.insert(flag_name(option)).second);
    CHECK(option.text.meaning.size() > 10);
    CHECK(option.text.meaning.back() != '.');
  }
  CHECK(keys.size() > 35);
}

TEST_CASE(
    "a value of the wrong kind or out of range is refused with its line, by key and by flag") {
  for (const Option& option : compile_option_table()) {
    const std::string head = "scene = \"a.b\"\n\n[" + std::string(option.text.table) + "]\n" +
                             std::string(option.text.key) + " = ";
    INFO(key_name(option));
    for (const char* bad : {"nan", "-1e9", "1e99", "\"xyz\"", "[]", "[1]", "{}", "1979-05-27"}) {
      INFO(bad);
      CHECK_THAT(error_of(head + bad + "\n"),
                 StartsWith("p.toml:4: " + key_name(option)) && Contains("must be"));
    }
    for (const char* bad : {"nan", "inf", "-1e9", "1e99", "", "1 2", "1,2,3,4"})
      CHECK_THROWS_AS(by_flag({flag_name(option), bad}), CLI::ParseError);
  }
}

TEST_CASE("a key that is mistyped is an error with its line and the nearest key") {
  for (const Option& option : compile_option_table()) {
    const std::string key(option.text.key);
    const std::string text =
        "scene = \"a.b\"\n[" + std::string(option.text.table) + "]\n# x\n" + key + "q = 1\n";
    const std::string error = error_of(text);
    INFO(error);
    CHECK_THAT(error, StartsWith("p.toml:4: ") && Contains(key + "q is not known here"));
    if (key.size() > 3) CHECK_THAT(error, Contains("did you mean " + key + "?"));
  }
  CHECK_THAT(error_of("scene = \"a.b\"\n[subdivsion]\nlevel = 3\n"),
             StartsWith("p.toml:2: subdivsion is not known here; did you mean subdivision?"));
}

TEST_CASE("options that contradict each other are refused, with the line of one of them") {
  CHECK_THAT(
      error_of("scene = \"a.b\"\n[classes]\ncluster_threshold = 5\n"),
      StartsWith("p.toml:3: [classes] cluster_threshold 5 is below [subdivision] threshold"));
  CHECK_THAT(error_of("scene = \"a.b\"\n[subdivision]\nlevel = 3\nthreshold = 5e9\n"),
             StartsWith("p.toml:4: "));
  CHECK_THAT(error_of("scene = \"a.b\"\n[camera]\nfx = 500\n"),
             StartsWith("p.toml:3: [camera] fy is missing"));
  CHECK_THAT(error_of("scene = \"a.b\"\n[camera]\n\ncy = 5\n"),
             StartsWith("p.toml:4: [camera] fx is missing"));
  CHECK_THAT(error_of("scene = \"a.b\"\n[camera]\nfx = 9\nfy = 9\nfield_of_view_deg = 50\n"),
             StartsWith("p.toml:5: [camera] field_of_view_deg does not go with"));
  CHECK_THAT(error_of("scene = \"a.b\"\n[camera]\ndistance = [2, 1]\n"),
             StartsWith("p.toml:3: [camera] distance goes from 2 to 1"));
}

}  // namespace aspect
