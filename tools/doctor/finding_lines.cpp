#include "tools/doctor/finding_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace aspect {
namespace {

constexpr std::size_t kWorst = 2;  // examples in a line

struct KindWords {
  std::string_view code, words;
};
// Of kinds that may be found several times.
constexpr std::array<KindWords, 4> kKinds = {
    {{"inseparable_colours", "pairs of colours that touch and count as one region"},
     {"merged_by_shading", "pairs of colours whose border merges in the lamps' light"},
     {"dark_surface", "colours so dark that they count as background"},
     {"missing_colour", "colours that are named and not there"}}};

std::string_view words_of(std::string_view code) {
  const auto* found = std::find_if(kKinds.begin(), kKinds.end(),
                                   [&](const KindWords& kind) { return kind.code == code; });
  return found == kKinds.end() ? std::string_view("findings") : found->words;
}

std::string places(std::span<const std::size_t> where, bool more) {
  if (where.empty()) return {};
  return fmt::format(" [at {}{}]", fmt::join(where, ", "), more ? ", ..." : "");
}

std::string text_of(const Finding& finding) {
  const bool more =
      finding.where.size() < finding.count && finding.where.size() == Finding::kMostPlaces;
  std::string text = finding.message + places(finding.where, more);
  if (!finding.names.empty()) text += fmt::format(" ({})", fmt::join(finding.names, ", "));
  return text;
}

std::string text_of(const FindingExample& example) {
  return example.message + places(example.where, false);
}

// With some of what it sums up.
std::string summed_text(const Finding& finding) {
  std::string text = text_of(finding);
  for (std::size_t k = 0; k < std::min(kWorst, finding.examples.size()); ++k)
    text += (k == 0 ? "; worst: " : ", and ") + text_of(finding.examples[k]);
  return text;
}

std::string summed_text(const Diagnosis& diagnosis, const FindingLine& line) {
  if (line.findings.size() == 1) return summed_text(diagnosis.findings[line.findings.front()]);
  std::string text = fmt::format("{} {}", line.findings.size(), words_of(line.code));
  for (std::size_t k = 0; k < std::min(kWorst, line.findings.size()); ++k)
    text += (k == 0 ? "; worst: " : ", and ") + text_of(diagnosis.findings[line.findings[k]]);
  return text;
}

// One a kind, with its findings.
std::vector<FindingLine> kinds_of(const Diagnosis& diagnosis) {
  std::vector<FindingLine> kinds;
  for (std::size_t k = 0; k < diagnosis.findings.size(); ++k) {
    const Finding& finding = diagnosis.findings[k];
    const auto same = std::find_if(kinds.begin(), kinds.end(), [&](const FindingLine& kind) {
      return kind.code == finding.code && kind.severity == finding.severity;
    });
    const bool is_new = same == kinds.end();
    FindingLine& kind = is_new ? kinds.emplace_back() : *same;
    if (is_new) {
      kind.label = fmt::to_string(kinds.size());
      kind.group = finding.group;
      kind.code = finding.code;
      kind.severity = finding.severity;
      kind.cure = finding.cure;
    }
    kind.findings.push_back(k);
  }
  for (FindingLine& kind : kinds)
    std::stable_sort(kind.findings.begin(), kind.findings.end(), [&](std::size_t a, std::size_t b) {
      return diagnosis.findings[a].count > diagnosis.findings[b].count;
    });
  return kinds;
}

void add_each(const Diagnosis& diagnosis, const FindingLine& kind,
              std::vector<FindingLine>& lines) {
  for (std::size_t k = 0; k < kind.findings.size(); ++k) {
    const Finding& finding = diagnosis.findings[kind.findings[k]];
    FindingLine line = kind;
    line.findings = {kind.findings[k]};
    line.text = text_of(finding);
    line.cure = finding.cure;
    if (kind.findings.size() > 1) line.label += fmt::format(".{}", k + 1);
    lines.push_back(line);
    for (std::size_t e = 0; e < finding.examples.size(); ++e) {
      FindingLine& example = lines.emplace_back(line);
      example.label += fmt::format(".{}", e + 1);
      example.text = text_of(finding.examples[e]);
      example.findings.clear();  // it has no marks of its own
    }
  }
}

}  // namespace

std::vector<FindingLine> finding_lines(const Diagnosis& diagnosis, bool all) {
  std::vector<FindingLine> kinds = kinds_of(diagnosis), lines;
  for (FindingLine& kind : kinds) {
    if (all)
      add_each(diagnosis, kind, lines);
    else
      kind.text = summed_text(diagnosis, kind);
  }
  return all ? lines : kinds;
}

std::vector<std::size_t> kind_numbers(const Diagnosis& diagnosis) {
  std::vector<std::size_t> numbers(diagnosis.findings.size(), 0);
  const std::vector<FindingLine> kinds = kinds_of(diagnosis);
  for (std::size_t k = 0; k < kinds.size(); ++k)
    for (const std::size_t finding : kinds[k].findings) numbers[finding] = k + 1;
  return numbers;
}

}  // namespace aspect
