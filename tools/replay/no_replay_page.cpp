// A device writes no pages.
#include "tools/replay/replay_page.h"

namespace aspect {

Result<std::unique_ptr<ReplayPage>> create_replay_page(const ReplayOptions& options,
                                                       std::span<const ClassIndex>,
                                                       const RecogniserParameters&) {
  if (options.page_folder)
    return Error{"--html: pages are written on workstations only; leave it out"};
  return std::unique_ptr<ReplayPage>();
}

}  // namespace aspect
