// Those who are connected to a socket and get every line from then on.
#pragma once

#include <poll.h>
#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>

#include "runtime/output/descriptor.h"
#include "runtime/output/line_ring.h"
#include "runtime/output/output_counters.h"

namespace aspect {

// A reader that stays behind by more than the ring holds is disconnected: it never gets a line
// with a gap before it or a piece missing. What readers send is thrown away.
class StreamReaders {
 public:
  static constexpr std::size_t kMost = 16;

  StreamReaders(const LineRing& ring, OutputCounters& counters)
      : ring_(ring), counters_(counters) {}

  // From the next line on; refused if there are too many.
  void add(Descriptor socket);
  // What to wait for, in the order of the readers.
  std::span<pollfd> waits();
  // After waiting, and whenever there are new lines.
  void serve();
  bool behind() const;

 private:
  struct Reader {
    Descriptor socket;
    std::uint64_t line = 0;  // the one that is being sent or comes next
    std::size_t sent = 0;    // of it
    bool silent = false;     // has closed its own direction
  };
  enum class Outcome : std::uint8_t { stays, left, too_slow };

  Outcome receive(Reader& reader);
  Outcome send(Reader& reader);
  void count_dropped();
  void remove(std::size_t k);

  const LineRing& ring_;
  OutputCounters& counters_;
  std::array<Reader, kMost> readers_;
  std::array<pollfd, kMost> waits_{};
  std::size_t count_ = 0;
  std::chrono::steady_clock::time_point warns_from_{};
  std::array<char, LineRing::kMaxLineBytes> line_{};
};

}  // namespace aspect
