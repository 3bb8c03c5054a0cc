// The doctor's words, for people and for scripts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/doctor/diagnosis.h"
#include "tools/doctor/repair.h"

namespace aspect {

struct FixReport {
  std::string output;
  std::vector<std::string> done;
  std::vector<ColourMove> moves;
  Diagnosis left;  // of what was written, read again
};

struct DoctorReport {
  std::string file;
  std::vector<Diagnosis> objects;
  struct Shown {
    std::string file, what;  // "as it is on the left, in merged colours on the right"
  };
  std::vector<Shown> pictures;
  std::optional<FixReport> fix;

  bool is_healthy() const;
};

// With the severities in colour for a terminal; `all`: a line for each finding, and not for each
// kind.
std::string report_text(const DoctorReport& report, bool colours = false, bool all = false);
std::string report_json(const DoctorReport& report);

}  // namespace aspect
