#include "tools/doctor/finding_lines.h"

#include <catch2/catch.hpp>

namespace aspect {
namespace {

using Catch::Matchers::Contains;

Finding finding(std::string_view code, const std::string& message, std::size_t count) {
  return {"colours", code, Severity::warning, message, "cure of it", count, {count}, false};
}

Diagnosis diagnosis() {
  return {"part",
          9,
          {finding("inseparable_colours", "pale", 5), finding("dark_surface", "night", 1),
           finding("inseparable_colours", "rose", 50), finding("inseparable_colours", "pink", 20)}};
}

std::vector<std::string> labels_of(const std::vector<FindingLine>& lines) {
  std::vector<std::string> labels;
  for (const FindingLine& line : lines) labels.push_back(line.label);
  return labels;
}

}  // namespace

TEST_CASE("Findings of one kind are one line with their number and the worst two of them") {
  const auto lines = finding_lines(diagnosis());
  REQUIRE(lines.size() == 2);
  CHECK(labels_of(lines) == std::vector<std::string>{"1", "2"});
  CHECK_THAT(lines[0].text, Contains("3 pairs of colours that touch") &&
                                Contains("worst: rose [at 50], and pink [at 20]") &&
                                !Contains("pale"));
  CHECK(lines[0].findings == std::vector<std::size_t>{2, 3, 0});
  CHECK(lines[0].cure == "cure of it");
  CHECK(lines[1].text == "night [at 1]");
  CHECK(kind_numbers(diagnosis()) == std::vector<std::size_t>{1, 2, 1, 1});
}

TEST_CASE("All of them are a line each, and so are the examples that one sums up") {
  Diagnosis sick = diagnosis();
  sick.findings[1].examples = {{"black", 9, {3}}, {"tar", 2, {4}}};
  CHECK_THAT(finding_lines(sick)[1].text, Contains("night [at 1]; worst: black [at 3], and tar"));
  const auto lines = finding_lines(sick, true);
  CHECK(labels_of(lines) == std::vector<std::string>{"1.1", "1.2", "1.3", "2", "2.1", "2.2"});
  CHECK(lines[0].text == "rose [at 50]");
  CHECK(lines[4].text == "black [at 3]");
}

TEST_CASE("The same fault in different earnest is two lines") {
  Diagnosis sick = diagnosis();
  sick.findings[0].severity = Severity::note;
  CHECK(finding_lines(sick).size() == 3);
  CHECK(finding_lines({"part", 0, {}}).empty());
}

}  // namespace aspect
