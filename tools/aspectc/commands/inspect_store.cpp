#include "tools/aspectc/commands/inspect_store.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

#include "compiler/store/store.h"
#include "tools/aspectc/commands/command_failure.h"

namespace aspect {
namespace {

using Json = nlohmann::ordered_json;

Json store_json(const StoreContents& contents, std::uintmax_t bytes) {
  Json json{{"object", contents.key.object},
            {"scene_hash", contents.key.scene_hash},
            {"options", contents.key.options},
            {"compiler", contents.key.compiler},
            {"bytes", bytes},
            {"views", contents.views},
            {"matches", contents.matches},
            {"runs", Json::array()}};
  for (const FinishedRun& run : contents.runs)
    json["runs"].push_back({{"level", run.level},
                            {"min_level", run.min_level},
                            {"threshold", run.threshold},
                            {"views", run.views}});
  return json;
}

void print_store(const StoreContents& contents, std::uintmax_t bytes) {
  fmt::print("object {}, scene {}, made by aspectc {}, {:.1f} KiB\n", contents.key.object,
             contents.key.scene_hash, contents.key.compiler, static_cast<double>(bytes) / 1024);
  fmt::print("{} views, {} matches\n", contents.views, contents.matches);
  fmt::print("options: {}\n", contents.key.options);
  if (contents.runs.empty()) fmt::print("no level is complete yet\n");
  for (const FinishedRun& run : contents.runs)
    fmt::print("complete: --level {} --min-level {} --threshold {}, {} views\n", run.level,
               run.min_level, run.threshold, run.views);
}

}  // namespace

int run_inspect_store(const std::filesystem::path& file, bool as_json) {
  const Result<Store> store = Store::open_existing(file);
  const Result<StoreContents> contents =
      store ? store.value().contents() : Result<StoreContents>(Error{store.error()});
  if (!contents) return fail(contents.error());
  std::error_code unknown;
  const std::uintmax_t bytes = std::filesystem::file_size(file, unknown);
  if (as_json)
    fmt::print("{}\n", store_json(contents.value(), bytes).dump(2));
  else
    print_store(contents.value(), bytes);
  return 0;
}

}  // namespace aspect
