#include "runtime/output/live_page.h"

namespace aspect {

std::optional<Error> check_http() {
  return Error{"http: not in this build; build with cpp-httplib (ASPECT_HTTP), or leave it out"};
}

Result<std::unique_ptr<LivePage>> open_live_page(const HttpOutput&, const LineRing&,
                                                 const OutputCounters&, PageDesk*) {
  return *check_http();
}

}  // namespace aspect
