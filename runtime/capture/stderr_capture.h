// What libraries print on their own, caught instead of shown: libjpeg, libpng and FFmpeg write to
// standard error past every logging interface, and say only there that a picture is damaged.
#pragma once

#include <string>

namespace aspect {

// Standard error goes into memory for as long as this lives. The descriptor belongs to the whole
// process: what other threads write meanwhile is swallowed, and two captures must not overlap
// other than nested.
class StderrCapture {
 public:
  StderrCapture();
  ~StderrCapture();
  StderrCapture(const StderrCapture&) = delete;
  StderrCapture& operator=(const StderrCapture&) = delete;

  // Ends the capture. The first 4 KiB of what was written.
  std::string finish();

 private:
  int saved_ = -1;
  int memory_ = -1;
};

}  // namespace aspect
