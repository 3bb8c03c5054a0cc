#include "tools/report/report_run.h"

#include <system_error>

#include "compiler/store/store.h"
#include "tools/aspectc/commands/whole_file.h"
#include "tools/command_line/terminal_colour.h"
#include "tools/report/report_lines.h"
#include "tools/report/report_page.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

Result<Done> make_folder(const fs::path& folder) {
  if (folder.empty()) return Done{};
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure)
    return Error{folder.string() + ": cannot be made (" + failure.message() +
                 "); name another --figures"};
  return Done{};
}

Result<Done> write_figures(const ReportContents& contents, const fs::path& folder) {
  if (folder.empty()) return Done{};
  for (const auto& [name, svg] : report_figures(contents))
    if (Result<Done> done = write_whole_text(folder / name, svg); !done) return done;
  return Done{};
}

Result<Done> report_store(const ReportOptions& options) {
  // Before what takes time.
  if (Result<Done> good = check_writable(options.output); !good) return good;
  if (Result<Done> made = make_folder(options.figures); !made) return made;
  const Result<ReportContents> contents = gather(options.input, options.settings);
  if (!contents) return Error{contents.error()};
  if (Result<Done> done = write_figures(contents.value(), options.figures); !done) return done;
  return write_whole_text(options.output, report_page(contents.value()));
}

// One branch a kind of input.
Result<Done> report(const ReportOptions& options) {
  std::error_code unknown;
  if (!fs::exists(options.input, unknown))
    return Error{
        options.input.string() +
        ": is not there; give the store of a finished compilation, or lines of aspect-replay"};
  if (holds_lines(options.input)) return report_lines(options);
  if (is_store(options.input)) return report_store(options);
  return Error{options.input.string() +
               ": is no store of aspectc and not named as lines of aspect-replay are (.ndjson); "
               "compile the scene and give the store beside the index"};
}

}  // namespace

int run_report(const ReportOptions& options) {
  const Result<Done> done = report(options);
  if (done.ok()) return 0;
  print_failure("aspect-report", done.error());
  return 1;
}

}  // namespace aspect
