// A build without cpp-httplib has no page.
#include "tools/replay/serve.h"

namespace aspect {

bool serve(const ReplayOptions&, Configuration, std::span<const ClassIndex>,
           const RecogniserParameters&, Console& console) {
  console.fail("--serve: no page is in this build; build with cpp-httplib (ASPECT_HTTP)");
  return false;
}

}  // namespace aspect
