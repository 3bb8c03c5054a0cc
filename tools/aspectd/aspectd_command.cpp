#include "tools/aspectd/aspectd_command.h"

#include <fmt/format.h>
#include <algorithm>

#include "runtime/base/two_sentences.h"
#include "runtime/capture/control_words.h"
#include "runtime/service/segmentation_values.h"

namespace aspect {
namespace {

// Widths of what is listed under a table's name.
constexpr std::size_t kIndent = 20, kWidth = 100;

// "KEY range: words" from the indent on, in lines of that width.
std::string listed(const std::string& text) {
  std::string lines, line(kIndent, ' ');
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const bool is_first = line.find_first_not_of(' ') == std::string::npos;
    if (!is_first && line.size() + 1 + word.size() > kWidth) {
      lines += line + "\n";
      line = std::string(kIndent + 2, ' ') + word;
    } else {
      line += (is_first ? "" : " ") + word;
    }
    begin = end + 1;
  }
  return lines + line + "\n";
}

std::string segmentation_list() {
  std::string lines = listed(fmt::format("region_of_interest = [x, y, width, height]: {}",
                                         two_sentences(kRegionMeaning, kRegionAdvice)));
  for (const SegmentationValue& value : segmentation_values()) {
    const bool is_truth =
        std::holds_alternative<std::optional<bool> SegmentationOverrides::*>(value.member);
    const std::string range =
        is_truth ? "true or false" : fmt::format("{} to {}", value.least, value.most);
    const std::string unit = value.unit.empty() ? "" : " " + std::string(value.unit);
    lines += listed(fmt::format("{}, {}{}: {}", value.key, range, unit,
                                two_sentences(value.meaning, value.advice)));
  }
  return lines;
}

std::string control_list() {
  std::string lines;
  for (const ControlWords& control : control_words())
    lines +=
        listed(fmt::format("{}: {}", control.name, two_sentences(control.meaning, control.advice)));
  return lines;
}

constexpr const char* kNotesBegin =
    R"(The configuration is TOML; whatever is left out has a default, but for indexes:
  indexes           ["NAME.aspect", ...]: files, from the configuration's folder on
  [camera]          device = "/dev/video0", "bus:PLACE" or "serial:NUMBER"; width, height, rate,
                    format = "YUYV"; stall_ms (silence after which it is started anew);
                    fx, fy, cx, cy (its lens, in pixels), k1, k2, p1, p2, k3
  [camera.controls]  NAME = NUMBER, ... as v4l2-ctl --list-ctrls names them, set in this order; a
                    camera has some of these and others of its own:
)";

constexpr const char* kNotesSegmentation =
    R"(  [segmentation]    what is left out is as the index was compiled
)";

constexpr const char* kNotesEnd =
    R"(  [recognition]     top, score_min, ranking = "views" or "classes", matching, shortlist_slack,
                    min_confidence (probability from which an object is a match),
                    anywhere = true (look for objects before any background as well as alone),
                    track = true (follow objects from frame to frame: each has a number, and costs
                    a fraction), search_every = 10 (frames; then new ones are looked for),
                    time_limit_ms = 30 (the best answer within so long of each frame, but for
                    seeing its regions; a line's left_undone counts what there was no time for)
  [output]          stdout = true; and one table for each of
  [output.file]     path, max_mib, keep (older files kept)
  [output.socket]   path
  [output.tcp]      port, address
  [output.mqtt]     host, port, topic, client, user, password_file
  [output.http]     port, address: a page with what the camera sees, and sliders for what is under
                    [segmentation] and [camera.controls]; record: folder for frames that it records
  [[output.trigger]]
                    object, score_min, frames, and command = ["/PROGRAM", ...] (it finds
                    ASPECT_OBJECT and ASPECT_SEEN in its environment) or gpio_chip and gpio_line
  [process]         lock_memory, realtime_priority, cpus = [3]

Where there is a page, its address is printed at the start, with a token without which nothing can
be changed. What is changed there holds from the next frame on, and is gone with a restart or a
reload unless it was written to the configuration, which the page does when it is told to: comments
stay, and what the file was before is kept as FILE.toml.1.

A frame's line is aspect-replay's, with "capture": time_s, latency_ms, and how many frames before it
were late, lost and damaged. Another state is a line with "state": streaming, absent, busy,
no_signal, stalled, failed, damaged, reloaded, reload_failed; and one on standard error.

SIGHUP reads the configuration and the indexes anew; if they are no good the old ones go on.
SIGTERM and SIGINT end it.

Keys of --check --json:
  right             whether nothing is wrong; then the exit code is 0
  camera            node, driver, card, bus, format, width, height, rate_hz (0: it does not say),
                    decoded, controls (as read back); null where there is none
  indexes           object, classes, key_views
  region_of_interest  x, y, width, height; only where there is one
  memory            bytes, and width and height of the frames that need them
  outputs           kind (stdout, file, socket, tcp, mqtt, http) and its settings
  triggers          object, score_min
  warnings, errors  lines, which are on standard error as well

Exit code: 0 ended or everything is right, 1 something is wrong (one line on standard error), 2
wrong usage.

Examples:
  aspectd --config aspectd.toml --check
  aspectd --config aspectd.toml)";

}  // namespace

CommandText aspectd_command() {
  CommandText command;
  command.name = "aspectd";
  command.summary =
      "Recognises objects in what a camera sees: one JSON object a line for each frame.";
  command.version = ASPECT_VERSION;
  command.section = 8;
  command.notes =
      kNotesBegin + control_list() + kNotesSegmentation + segmentation_list() + kNotesEnd;
  const auto add = [&command](std::vector<std::string> names, const char* value,
                              const char* meaning, bool required = false) {
    command.options.push_back({std::move(names), value, meaning, "Options", required});
  };
  add({"--config"}, "FILE.toml",
      "indexes, camera, recognition and outputs; firmware_configs/ has examples", true);
  add({"--check"}, "",
      "validate everything against the camera present, print what will be used, and end");
  add({"--json"}, "", "print that as one JSON object; only with --check");
  add({"-h", "--help"}, "", "print this and end");
  add({"--version"}, "", "print the version and end");
  return command;
}

}  // namespace aspect
