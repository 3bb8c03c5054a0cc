// Standard output and the sockets: one thread, which never waits for any of them.
#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "runtime/output/line_output.h"
#include "runtime/output/listener.h"
#include "runtime/output/output_settings.h"
#include "runtime/output/output_thread.h"
#include "runtime/output/standard_output.h"
#include "runtime/output/stream_readers.h"

namespace aspect {

class StreamOutput final : public LineOutput {
 public:
  [[nodiscard]] static Result<std::unique_ptr<StreamOutput>> open(const OutputSettings& settings,
                                                                  const LineRing& ring,
                                                                  OutputCounters& counters);
  OutputThread& thread() override { return thread_; }
  int tcp_port() const { return tcp_ ? bound_port(tcp_.get()) : 0; }

 private:
  StreamOutput(const LineRing& ring, OutputCounters& counters) : readers_(ring, counters) {}
  std::optional<Error> open_all(const OutputSettings& settings, const LineRing& ring,
                                OutputCounters& counters);
  void run();
  void wait();
  void accept_readers(int listener);

  std::unique_ptr<StandardOutput> standard_output_;
  UnixListener unix_;
  Descriptor tcp_;
  StreamReaders readers_;
  std::chrono::steady_clock::time_point accepts_from_{};
  OutputThread thread_;  // last: it ends before what it uses
};

}  // namespace aspect
