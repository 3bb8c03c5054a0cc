#include "tests/tools/plot/drawn_svg.h"

#include <stdexcept>

#include "tests/child_program.h"
#include "tests/temporary_folder.h"

namespace aspect {

nlohmann::json drawn_svg(const std::string& svg) {
  const TemporaryFolder folder;
  folder.write("plot.svg", svg);
  const Outcome outcome = run_shell(
      folder.path(), "python3 '" ASPECT_SOURCE_DIR "/tests/tools/plot/read_svg.py' plot.svg");
  if (outcome.exit_code != 0) throw std::runtime_error(outcome.err);
  return nlohmann::json::parse(outcome.out);
}

}  // namespace aspect
