// Where lines go: standard output, a file, sockets and what else is configured. The frame loop
// hands a line over and goes on; whoever reads too slowly loses its connection, never the loop's
// time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "runtime/base/result.h"
#include "runtime/output/output_settings.h"
#include "runtime/output/page_desk.h"

namespace aspect {

// What a trigger needs to know of one object seen in a frame.
struct SeenName {
  std::string_view object;
  double score = 0;
};

struct OutputCounts {
  std::uint64_t lines = 0;
  std::uint64_t readers = 0;            // connected now
  std::uint64_t readers_dropped = 0;    // because they were too slow
  std::uint64_t readers_refused = 0;    // because there were 16 already
  std::uint64_t lines_lost = 0;         // of outputs that cannot be dropped: file, standard output,
                                        // MQTT; and lines that were none or too long
  bool standard_output_closed = false;  // its reader is gone
};

class Outputs {
 public:
  static constexpr std::size_t kMaxLineBytes = 32U << 10U;

  // What can be known of the settings without touching anything: addresses, programs, folders,
  // what this build has.
  [[nodiscard]] static std::optional<Error> check(const OutputSettings& settings);

  // Opens everything, takes all memory and starts the threads that write, at ordinary priority.
  // One line where something cannot be had, or is not in this build. Two with the same socket, port
  // or file cannot be open at once. `desk` stands behind the page and outlives it; null: the page
  // shows lines only.
  [[nodiscard]] static Result<std::unique_ptr<Outputs>> open(const OutputSettings& settings,
                                                             PageDesk* desk = nullptr);
  // Writes what can be written at once, up to a second, and closes.
  ~Outputs();

  // Never waits, never allocates; a line of at most kMaxLineBytes with its end. From one thread.
  void publish(std::string_view line) noexcept;

  // Which objects the frame shows, for triggers: every frame, also if there are none. Same thread,
  // same promise.
  void report_seen(std::span<const SeenName> seen) noexcept;

  [[nodiscard]] OutputCounts counts() const noexcept;
  // Where readers connect to; 0: there is no such output.
  [[nodiscard]] int tcp_port() const;
  [[nodiscard]] int http_port() const;
  // Of the page, with its token; empty: there is none.
  [[nodiscard]] std::string http_address() const;

 private:
  Outputs();
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace aspect
