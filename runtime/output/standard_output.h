// Lines to standard output, whoever reads it how slowly.
#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "runtime/base/result.h"
#include "runtime/output/descriptor.h"
#include "runtime/output/line_ring.h"
#include "runtime/output/output_counters.h"

namespace aspect {

// The lines that it is too slow for are lost whole. Never waits, but for a disk where it is a file.
class StandardOutput {
 public:
  [[nodiscard]] static Result<std::unique_ptr<StandardOutput>> open(const LineRing& ring,
                                                                    OutputCounters& counters);

  // Writes what is accepted at once.
  void write_on();
  bool behind() const { return !closed_ && (sent_ < size_ || next_ < ring_.published()); }
  // To wait for until it can be written to; -1 once its reader is gone.
  int descriptor() const { return closed_ ? -1 : target_; }

 private:
  StandardOutput(const LineRing& ring, OutputCounters& counters)
      : ring_(ring), counters_(counters), next_(ring.published()) {}
  bool take_line();
  bool write_piece();
  void close();

  const LineRing& ring_;
  OutputCounters& counters_;
  Descriptor own_;
  int target_ = -1;
  bool closed_ = false;
  std::uint64_t next_;
  std::array<char, LineRing::kMaxLineBytes> line_{};  // the one that is being written
  std::size_t size_ = 0, sent_ = 0;
};

}  // namespace aspect
