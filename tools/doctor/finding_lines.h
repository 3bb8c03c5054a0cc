// What people read of a diagnosis: findings of one kind are one line, and numbered, so that
// pictures can point at them.
#pragma once

#include <string>
#include <vector>

#include "tools/doctor/diagnosis.h"

namespace aspect {

struct FindingLine {
  std::string label;  // "2"; "2.1" where each finding has a line
  std::string_view group, code;
  Severity severity = Severity::note;
  std::string text;  // what is wrong, how often, where the worst is
  std::string cure;
  std::vector<std::size_t> findings;  // into Diagnosis::findings, the worst first
};

// In the order of the findings; kinds where they first appear. `all`: a line for each finding and
// each example that it sums up.
std::vector<FindingLine> finding_lines(const Diagnosis& diagnosis, bool all = false);

// By finding: the number of its kind, from 1.
std::vector<std::size_t> kind_numbers(const Diagnosis& diagnosis);

}  // namespace aspect
