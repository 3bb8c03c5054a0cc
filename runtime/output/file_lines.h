// Lines to a file, by a thread of its own: a disk may keep a write waiting for seconds.
#pragma once

#include <array>
#include <memory>

#include "runtime/output/line_output.h"
#include "runtime/output/line_ring.h"
#include "runtime/output/output_counters.h"
#include "runtime/output/output_thread.h"
#include "runtime/output/rotated_file.h"

namespace aspect {

class FileLines final : public LineOutput {
 public:
  [[nodiscard]] static Result<std::unique_ptr<FileLines>> open(const FileOutput& settings,
                                                               const LineRing& ring,
                                                               OutputCounters& counters);
  OutputThread& thread() override { return thread_; }

 private:
  FileLines(RotatedFile file, const LineRing& ring, OutputCounters& counters)
      : file_(std::move(file)), ring_(ring), counters_(counters), next_(ring.published()) {}
  void run();
  // False when there is nothing more to be done now.
  bool write_next();

  RotatedFile file_;
  const LineRing& ring_;
  OutputCounters& counters_;
  std::uint64_t next_;
  bool failing_ = false;
  std::array<char, LineRing::kMaxLineBytes> line_{};
  OutputThread thread_;  // last: it ends before what it uses
};

}  // namespace aspect
