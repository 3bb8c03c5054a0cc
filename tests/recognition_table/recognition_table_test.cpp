// Holds what the programs make of sets of frames against the numbers of a table.
// usage: recognition_table_test TABLE.csv DATA SHARED WORK ASPECTC REPLAY [--refresh]
//   DATA, SHARED  folders that the table's data/ and shared/ stand for; rows of a folder that is
//   not
//                 there are passed over, with a line that says so; made/ is made in WORK
//   --refresh     writes the table anew, from what is reached
#include <fmt/format.h>

#include <fstream>
#include <map>
#include <span>

#include "tests/recognition_table/frame_set.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

constexpr int kBoards = 20;

class Sets {
 public:
  Sets(fs::path data, fs::path shared, fs::path work, SetPrograms programs)
      : roots_{{"data", data}, {"shared", shared}, {"made", work / "made"}},
        symmetries_(data / "rendered/symmetries.csv"),
        work_(work),
        programs_(std::move(programs)) {
    make_boards(roots_["made"] / "boards", kBoards);
  }

  // A name is ROOT/FOLDER.
  std::optional<fs::path> folder(const std::string& name) const {
    const auto root = roots_.find(name.substr(0, name.find('/')));
    if (root == roots_.end() || !fs::exists(root->second)) return std::nullopt;
    return root->second / name.substr(name.find('/') + 1);
  }

  Result<SetFigures> measure(const TableRow& row) const {
    const fs::path indexes_work = work_ / fs::path(row.indexes).filename();
    const auto indexes = compiled_scenes(programs_, *folder(row.indexes), row.level, indexes_work);
    if (!indexes) return Error{indexes.error()};
    const fs::path work =
        row.frames == row.indexes
            ? indexes_work
            : work_ / fs::path(row.frames + "-by-" + indexes_work.filename().native());
    return measured_set(programs_, *folder(row.frames), indexes.value(), symmetries_, work);
  }

 private:
  std::map<std::string, fs::path> roots_;
  fs::path symmetries_, work_;
  SetPrograms programs_;
};

std::string figures_text(const SetFigures& figures) {
  return fmt::format(
      "{} of {} right, {} falsely named, {} views within 20 degrees, median {:.2f} degrees, {:.1f} "
      "times reading every byte",
      figures.right, figures.things, figures.false_ones, figures.within_20, figures.median_deg,
      figures.time_ratio);
}

int check_table(const fs::path& file, const Sets& sets, bool refresh) {
  auto table = read_table(file);
  if (!table) return fmt::print(stderr, "{}\n", table.error()), 1;
  int failures = 0, measured = 0;
  for (TableRow& row : table.value()) {
    const std::string name = fmt::format("{} with the indexes of {}", row.frames, row.indexes);
    if (!sets.folder(row.frames) || !sets.folder(row.indexes)) {
      fmt::print("{}: passed over, the folder is not there\n", name);
      continue;
    }
    const auto reached = sets.measure(row);
    if (!reached) {
      fmt::print(stderr, "{}: {}\n", name, reached.error());
      ++failures;
      continue;
    }
    ++measured;
    fmt::print("{}: {}\n", name, figures_text(reached.value()));
    if (refresh) {
      row.limits = limits_from(reached.value());
      continue;
    }
    for (const std::string& limit : broken_limits(row.limits, reached.value())) {
      fmt::print(stderr, "{}: {}\n", name, limit);
      ++failures;
    }
  }
  if (refresh && failures == 0) std::ofstream(file) << table_text(table.value());
  if (measured == 0) fmt::print(stderr, "{}: not one row was measured\n", file.native());
  return failures == 0 && measured > 0 ? 0 : 1;
}

}  // namespace
}  // namespace aspect

int main(int argc, char** argv) {
  const std::span<char*> words(argv, static_cast<std::size_t>(argc));
  if (argc < 7) {
    fmt::print(stderr, "usage: see the head of recognition_table_test.cpp\n");
    return 2;
  }
  const auto path = [&](std::size_t k) { return std::filesystem::absolute(words[k]); };
  const aspect::Sets sets(path(2), path(3), path(4), {path(5), path(6)});
  return aspect::check_table(words[1], sets, argc > 7 && std::string(words[7]) == "--refresh");
}
