#include "runtime/workbench/toml_edit.h"

#include <catch2/catch.hpp>
#include <vector>

namespace aspect {
namespace {

using Catch::Matchers::Contains;

constexpr const char* kSegmentation = "segmentation";

TomlEdit value(const std::string& key, const std::string& text) {
  return {kSegmentation, key, text, false};
}
TomlEdit without(const std::string& key) {
  return {kSegmentation, key, std::nullopt, false};
}

std::string edited(const std::string& text, const std::vector<TomlEdit>& edits) {
  const auto result = edited_toml(text, "a.toml", edits);
  if (!result) FAIL(result.error());
  return result.value();
}

}  // namespace

TEST_CASE("a value is changed where it stands, and nothing else is") {
  const std::string before =
      "# Größe: ähnlich\r\nindexes = [ \"a.aspect\", ] # mine\r\n\r\n"
      "[segmentation]\t# regions\r\n  chroma_step =   8 # measured, ü\r\n"
      "region_of_interest = [0, 1,\r\n  2, 3] # table\r\nsmooth=true\r\n[recognition]\r\ntop = 3";
  const std::string after =
      "# Größe: ähnlich\r\nindexes = [ \"a.aspect\", ] # mine\r\n\r\n"
      "[segmentation]\t# regions\r\n  chroma_step =   12 # measured, ü\r\n"
      "region_of_interest = [4, 5, 6, 7] # table\r\nsmooth=false\r\n[recognition]\r\ntop = 3";
  CHECK(edited(before, {value("chroma_step", "12"), value("region_of_interest", "[4, 5, 6, 7]"),
                        value("smooth", "false")}) == after);
  CHECK(edited(before, {}) == before);
}

TEST_CASE("a character of several bytes before a value on its line does not shift it") {
  CHECK(edited("segmentation = { \"größe\" = 1, chroma_step = 8 } # ä",
               {value("chroma_step", "9")}) ==
        "segmentation = { \"größe\" = 1, chroma_step = 9 } # ä");
}

TEST_CASE("a new key comes after the others of its table, or before them") {
  const std::string before = "[segmentation]\nchroma_step = 8\n# end\n\n[output]\nstdout = true\n";
  CHECK(edited(before, {value("area_min_px", "9")}) ==
        "[segmentation]\nchroma_step = 8\narea_min_px = 9\n# end\n\n[output]\nstdout = true\n");
  CHECK(edited("[camera]\nrate = 15\n[camera.controls]\ngain = 3\n",
               {{"camera.controls", "auto_exposure", "1", true},
                {"camera.controls", "exposure", "9", false}}) ==
        "[camera]\nrate = 15\n[camera.controls]\nauto_exposure = 1\ngain = 3\nexposure = 9\n");
  CHECK(edited("[segmentation]", {value("smooth", "true")}) == "[segmentation]\nsmooth = true\n");
  CHECK(edited("segmentation = {}", {value("smooth", "true")}) ==
        "segmentation = { smooth = true }");
  CHECK(edited("segmentation = {noise_steps = 2}", {value("smooth", "true")}) ==
        "segmentation = { smooth = true,noise_steps = 2}");
}

TEST_CASE("a missing table is added at the end") {
  CHECK(edited("", {value("smooth", "true"), value("noise_steps", "2")}) ==
        "[segmentation]\nsmooth = true\nnoise_steps = 2\n");
  CHECK(edited("top = 1", {value("smooth", "true")}) ==
        "top = 1\n\n[segmentation]\nsmooth = true\n");
  CHECK(edited("[camera]\nrate = 15\n", {{"camera.controls", "gain", "5", false}}) ==
        "[camera]\nrate = 15\n\n[camera.controls]\ngain = 5\n");
}

TEST_CASE("a key is taken out with its line") {
  CHECK(edited("[segmentation]\nregion_of_interest = [1,\n 2, 3, 4] # here\nsmooth = true\n",
               {without("region_of_interest")}) == "[segmentation]\nsmooth = true\n");
  CHECK(edited("[segmentation]\nsmooth = true\n", {without("noise_steps")}) ==
        "[segmentation]\nsmooth = true\n");
  CHECK(edited("top = 1\n", {without("smooth")}) == "top = 1\n");
}

TEST_CASE("what cannot be changed without harm is refused with the lines to write") {
  for (const std::string& before :
       {std::string("segmentation = { region_of_interest = [1, 2, 3, 4], smooth = true }"),
        std::string("segmentation.region_of_interest = [1, 2, 3, 4]")}) {
    const auto result = edited_toml(
        before, "a.toml", std::vector{without("region_of_interest"), value("noise_steps", "2")});
    if (result.ok()) {
      CHECK(result.value().find("region_of_interest") == std::string::npos);
      continue;
    }
    CHECK_THAT(result.error(), Contains("a.toml: ") && Contains("[segmentation] noise_steps = 2"));
  }
  CHECK_FALSE(edited_toml("[segmentation", "a.toml", std::vector{value("smooth", "true")}).ok());
  CHECK_FALSE(edited_toml("segmentation = 3", "a.toml", std::vector{value("smooth", "true")}).ok());
}

}  // namespace aspect
