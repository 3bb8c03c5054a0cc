// A page for browsers: the live picture with what was recognised in it, counts, the last line.
#pragma once

#include <memory>
#include <optional>

#include "runtime/base/result.h"
#include "runtime/output/line_ring.h"
#include "runtime/output/output_counters.h"
#include "runtime/output/output_settings.h"
#include "runtime/vision/frame.h"

namespace aspect {

// Serves /, /picture.bmp and /line. Takes as many readers as it has threads, and each for a second
// at most.
class LivePage {
 public:
  LivePage() = default;
  LivePage(const LivePage&) = delete;
  LivePage& operator=(const LivePage&) = delete;
  virtual ~LivePage() = default;
  virtual bool wants_picture() const noexcept = 0;
  virtual void show_picture(const Frame& frame) noexcept = 0;
  virtual int port() const = 0;
};

[[nodiscard]] Result<std::unique_ptr<LivePage>> open_live_page(const HttpOutput& settings,
                                                               const LineRing& ring,
                                                               const OutputCounters& counters);

// An error if this build has no page.
[[nodiscard]] std::optional<Error> check_http();

}  // namespace aspect
