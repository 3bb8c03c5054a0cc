// Something that hands lines on, in a thread of its own.
#pragma once

#include "runtime/output/output_thread.h"

namespace aspect {

class LineOutput {
 public:
  LineOutput() = default;
  LineOutput(const LineOutput&) = delete;
  LineOutput& operator=(const LineOutput&) = delete;
  virtual ~LineOutput() = default;
  // Is woken after every line, and asked to stop before the output is destroyed.
  virtual OutputThread& thread() = 0;
};

}  // namespace aspect
