#include "tests/recognition_table/frame_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <random>
#include <set>

#include "tests/child_program.h"
#include "tests/recognition_table/frame_times.h"
#include "tools/score/scoring.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

// What a program complains of, as one line.
Error complaint(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  std::replace(text.begin(), text.end(), '\n', ';');
  return Error{text};
}

std::optional<fs::path> configuration_of(const fs::path& folder) {
  for (const char* name : {"camera.toml", "segmentation.toml"})
    if (fs::exists(folder / name)) return folder / name;
  return std::nullopt;
}

// Truth without the objects that no index is of.
std::vector<TrueFrame> truth_of_known(std::vector<TrueFrame> truth,
                                      const std::vector<fs::path>& indexes) {
  std::set<std::string> known;
  for (const fs::path& index : indexes) known.insert(index.stem().native());
  for (TrueFrame& frame : truth)
    std::erase_if(frame.objects,
                  [&](const TrueObject& object) { return !known.contains(object.object); });
  return truth;
}

SetFigures figures_of(const Score& score, std::span<const TrueFrame> truth) {
  SetFigures figures;
  figures.frames = score.frames.size();
  figures.things = score.all.objects;
  figures.right = score.all.right;
  figures.false_ones = score.falsely_named;
  if (score.all.objects > 0) figures.median_deg = score.all.median_deg;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const ScoredFrame& frame = score.frames[k];
    for (const ScoredObject& object : frame.objects)
      figures.within_20 += object.counts && object.error_deg <= 20 ? 1U : 0U;
    if (!truth[k].objects.empty()) continue;
    ++figures.things;
    figures.right += frame.objects.empty() ? 1U : 0U;
  }
  return figures;
}

}  // namespace

Result<std::vector<fs::path>> compiled_scenes(const SetPrograms& programs, const fs::path& scenes,
                                              int level, const fs::path& work) {
  fs::create_directories(work);
  std::vector<fs::path> indexes;
  for (const auto& entry : fs::directory_iterator(scenes)) {
    if (entry.path().extension() != ".b") continue;
    const fs::path index = work / entry.path().filename().replace_extension(".aspect");
    const auto is_older = [&](const fs::path& than) {
      return fs::last_write_time(index) < fs::last_write_time(than);
    };
    indexes.push_back(index);
    if (fs::exists(index) && !is_older(programs.aspectc) && !is_older(entry.path())) continue;
    const Outcome outcome =
        ChildProgram(programs.aspectc, work,
                     {entry.path().native(), "-o", index.native(), "--level", std::to_string(level),
                      "--no-store", "--progress", "never"})
            .wait();
    if (outcome.exit_code != 0) return complaint(outcome.err);
  }
  std::sort(indexes.begin(), indexes.end());
  if (indexes.empty()) return Error{scenes.native() + ": has no scene, NAME.b"};
  return indexes;
}

Result<SetFigures> measured_set(const SetPrograms& programs, const fs::path& folder,
                                const std::vector<fs::path>& indexes,
                                const std::optional<fs::path>& symmetries, const fs::path& work) {
  fs::create_directories(work);
  auto truth = read_truth(folder / "truth.csv");
  if (!truth) return Error{truth.error()};
  KnownRotations rotations;
  if (symmetries) {
    auto known = KnownRotations::read(*symmetries);
    if (!known) return Error{known.error()};
    rotations = std::move(known).value();
  }
  std::vector<std::string> arguments;
  for (const fs::path& index : indexes) arguments.insert(arguments.end(), {"--index", index});
  const std::optional<fs::path> configuration = configuration_of(folder);
  if (configuration) arguments.insert(arguments.end(), {"--config", *configuration});
  arguments.push_back(folder / "frames");
  const Outcome outcome = ChildProgram(programs.replay, work, arguments).wait();
  if (outcome.exit_code != 0) return complaint(outcome.err);
  std::ofstream(work / "seen.ndjson") << outcome.out;
  const auto results = parse_results(outcome.out, (work / "seen.ndjson").native());
  if (!results) return Error{results.error()};

  const std::vector<TrueFrame> known = truth_of_known(std::move(truth).value(), indexes);
  const Score score = score_results(known, folder, results.value(), rotations);
  if (score.missing > 0)
    return Error{
        fmt::format("{}: {} frames of the truth are missing", folder.native(), score.missing)};
  SetFigures figures = figures_of(score, known);
  const Result<double> ratio = time_ratio(folder / "frames", configuration, indexes);
  if (!ratio) return Error{ratio.error()};
  figures.time_ratio = ratio.value();
  return figures;
}

void make_boards(const fs::path& folder, int count) {
  constexpr int kSide_px = 400;
  fs::create_directories(folder / "frames");
  std::ofstream truth(folder / "truth.csv");
  truth << "file,object,vx,vy,vz,x,y,w,h,visible\n";
  std::mt19937 random(2026);
  const auto below = [&](int limit) {
    return static_cast<int>(random() % static_cast<unsigned>(limit));
  };
  for (int k = 0; k < count; ++k) {
    const std::string name = fmt::format("frames/{:03}.ppm", k);
    truth << name << ",,,,,,,,,\n";
    const int columns = 2 + below(3), rows = 2 + below(3), field_px = 40 + below(40);
    const int left = 10 + below(60), top = 10 + below(60);
    std::vector<std::uint8_t> rgb(3 * kSide_px * kSide_px);
    for (int field = 0; field < columns * rows; ++field) {
      const std::array<int, 3> colour = {30 + below(220), 30 + below(220), 200 + below(50)};
      for (int y = 0; y < field_px; ++y)
        for (int x = 0; x < field_px; ++x) {
          const int column = left + field % columns * field_px + x;
          const int row = top + field / columns * field_px + y;
          for (std::size_t c = 0; c < 3; ++c)
            rgb[3 * static_cast<std::size_t>(row * kSide_px + column) + c] =
                static_cast<std::uint8_t>(colour[(c + static_cast<std::size_t>(field)) % 3]);
        }
    }
    std::ofstream file(folder / name, std::ios::binary);
    file << "P6\n" << kSide_px << ' ' << kSide_px << "\n255\n";
    file.write(reinterpret_cast<const char*>(rgb.data()), static_cast<std::streamsize>(rgb.size()));
  }
}

}  // namespace aspect
