// Holds that a frame whose time is over after any number of steps shows no object that it does not
// show without a limit, and shows some before all steps are done.
// usage: limited_frames_test INDEXES SET...
//   INDEXES  folder with NAME.aspect
//   SET      folder with camera.toml and frames/
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <span>
#include <vector>

#include "runtime/capture/recorded_frames.h"
#include "runtime/recognition/sized_recogniser.h"
#include "runtime/service/configuration.h"
#include "runtime/service/index_set.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::nanoseconds kLimit = std::chrono::hours(1);
constexpr long kCutsOfFrame = 12, kAllSteps = 1'000'000'000;

// Goes on whenever it is asked. The first answer is the start.
long asked = 0, granted = kAllSteps;
Deadline::Time steps_clock() {
  return Deadline::Time(asked++ > granted ? kLimit : std::chrono::nanoseconds(0));
}

struct ShownObject {
  std::uint16_t index = 0;
  Box box;
};

std::vector<ShownObject> shown(const Recognition& recognition) {
  std::vector<ShownObject> objects;
  for (const SeenObject& object : recognition.objects)
    if (object.judgement.verdict == Verdict::match)
      objects.push_back({object.hypotheses.front().index, object.box});
  return objects;
}

bool is_same(const ShownObject& a, const ShownObject& b) {
  const int width =
                std::min(a.box.x + a.box.width, b.box.x + b.box.width) - std::max(a.box.x, b.box.x),
            height = std::min(a.box.y + a.box.height, b.box.y + b.box.height) -
                     std::max(a.box.y, b.box.y);
  return a.index == b.index && width > 0 && height > 0 &&
         3 * width * height >
             a.box.width * a.box.height + b.box.width * b.box.height - width * height;
}

struct Counts {
  int frames = 0, found = 0, possible = 0, wrong = 0, unsaid = 0;
};

void cut_everywhere(const CapturedFrame& frame, const IndexSet& set, SizedRecogniser& limited,
                    SizedRecogniser& free, Counts& counts) {
  const std::vector<ShownObject> all = shown(free.recognise(frame.view()));
  asked = 0;
  granted = kAllSteps;
  if (limited.recognise(frame.view()).left_undone.any()) ++counts.unsaid;
  const long last = asked - 1;
  ++counts.frames;
  for (long steps = 0; steps < last; steps += 1 + last / kCutsOfFrame) {
    asked = 0;
    granted = steps;
    const Recognition recognition = limited.recognise(frame.view());
    if (!recognition.left_undone.any()) ++counts.unsaid;
    counts.possible += static_cast<int>(all.size());
    for (const ShownObject& object : shown(recognition)) {
      ++counts.found;
      if (std::any_of(all.begin(), all.end(),
                      [&](const ShownObject& other) { return is_same(object, other); }))
        continue;
      ++counts.wrong;
      fmt::print(stderr, "{}: after {} of {} steps {}, which is not there without a limit\n",
                 frame.name, steps, last, set.indexes[object.index].object);
    }
  }
}

Counts cut_set(const fs::path& folder, const IndexSet& set) {
  RecogniserParameters parameters;
  parameters.vision = set.indexes.front().vision;
  const Result<Configuration> configuration = read_configuration(folder / "camera.toml");
  if (!configuration) return fmt::print(stderr, "{}\n", configuration.error()), Counts{};
  configuration.value().apply(parameters);
  SizedRecogniser free(set.indexes, parameters);
  parameters.time_limit = kLimit;
  parameters.clock = steps_clock;
  SizedRecogniser limited(set.indexes, parameters);
  const std::vector<fs::path> paths{folder / "frames"};
  RecordedFrames frames(paths);
  Counts counts;
  for (CapturedFrame frame; frames.next(frame) == FrameStatus::frame;) {
    free.make_room(frame.width_px, frame.height_px);
    limited.make_room(frame.width_px, frame.height_px);
    cut_everywhere(frame, set, limited, free, counts);
  }
  return counts;
}

int check_sets(const fs::path& indexes, std::span<char*> folders) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(indexes))
    if (entry.path().extension() == ".aspect") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  const IndexSet set = load_indexes(files);
  if (set.indexes.empty()) return fmt::print(stderr, "{}: no index\n", indexes.native()), 1;
  int failures = 0, found = 0;
  for (const char* folder : folders) {
    const Counts counts = cut_set(folder, set);
    fmt::print("{}: {} frames, {} of {} objects found, {} wrong, {} not said\n", folder,
               counts.frames, counts.found, counts.possible, counts.wrong, counts.unsaid);
    if (counts.frames == 0 || counts.wrong + counts.unsaid > 0) ++failures;
    found += counts.found;
  }
  return failures > 0 || found == 0 ? 1 : 0;
}

}  // namespace
}  // namespace aspect

int main(int argc, char** argv) {
  return argc < 3 ? 2
                  : aspect::check_sets(argv[1],
                                       std::span(argv, static_cast<std::size_t>(argc)).subspan(2));
}
