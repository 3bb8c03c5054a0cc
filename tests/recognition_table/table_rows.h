// recognition_table.csv: how well sets of frames are recognised, at the least.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/base/result.h"

namespace aspect {

// What is measured of a set, and what a row demands of it.
struct SetFigures {
  std::size_t frames = 0;
  std::size_t things = 0;      // objects to be named, and frames in which nothing is to be named
  std::size_t right = 0;       // of the things
  std::size_t false_ones = 0;  // things named where no such object is
  std::size_t within_20 = 0;   // objects whose view is within 20 degrees
  double median_deg = 0;       // of the views' errors; 0 where there are no objects
  double time_ratio = 0;       // of the median frame, to reading every byte of one
};

struct TableRow {
  std::string frames, indexes;  // a folder with frames and truth; one whose scenes are compiled
  int level = 4;                // at which they are
  SetFigures limits;
};

// Errors name file and line.
Result<std::vector<TableRow>> read_table(const std::filesystem::path& file);

// With the head that explains the columns.
std::string table_text(const std::vector<TableRow>& rows);

// One line for every limit that does not hold.
std::vector<std::string> broken_limits(const SetFigures& limits, const SetFigures& reached);

// Limits that these figures hold with something to spare: figures move a little with every change
// of the code, and times by the machine.
SetFigures limits_from(const SetFigures& reached);

}  // namespace aspect
