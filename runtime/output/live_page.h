// A page for browsers: what the camera sees, what was recognised in it, and the workbench beside
// it. This is its server; what it shows and does comes from a PageDesk.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "runtime/base/result.h"
#include "runtime/output/line_ring.h"
#include "runtime/output/output_counters.h"
#include "runtime/output/output_settings.h"
#include "runtime/output/page_desk.h"

namespace aspect {

// Serves the page's files, GET /line, and of the desk GET /state, GET /view and POST /act/NAME.
// Takes as many readers as it has threads, each for some seconds at most; who may do what is in
// page_guard.h.
class LivePage {
 public:
  LivePage() = default;
  LivePage(const LivePage&) = delete;
  LivePage& operator=(const LivePage&) = delete;
  virtual ~LivePage() = default;
  virtual int port() const = 0;
  // With the token that lets one change something, in the fragment: browsers do not send that.
  virtual std::string address() const = 0;
};

// `desk` outlives the page; null: there are lines only.
[[nodiscard]] Result<std::unique_ptr<LivePage>> open_live_page(const HttpOutput& settings,
                                                               const LineRing& ring,
                                                               const OutputCounters& counters,
                                                               PageDesk* desk);

// An error if this build has no page.
[[nodiscard]] std::optional<Error> check_http();

}  // namespace aspect
