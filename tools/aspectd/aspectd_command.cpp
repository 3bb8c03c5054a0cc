#include "tools/aspectd/aspectd_command.h"

namespace aspect {
namespace {

constexpr const char* kNotes =
    R"(The configuration is TOML; whatever is left out has a default, but for indexes:
  indexes           ["NAME.aspect", ...]: files, from the configuration's folder on
  [camera]          device = "/dev/video0", "bus:PLACE" or "serial:NUMBER"; width, height, rate,
                    format = "YUYV"; stall_ms (silence after which it is started anew);
                    fx, fy, cx, cy (its lens, in pixels), k1, k2, p1, p2, k3
  [camera.controls]  NAME = NUMBER, ... as v4l2-ctl --list-ctrls names them, set in this order
  [segmentation]    region_of_interest = [x, y, width, height]; area_min_px, intensity_min and the
                    others that an index was compiled with
  [recognition]     top, score_min, ranking = "views" or "classes", matching, shortlist_slack,
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
  [output.http]     port, address: a page with what the camera sees
  [[output.trigger]]
                    object, score_min, frames, and command = ["/PROGRAM", ...] (it finds
                    ASPECT_OBJECT and ASPECT_SEEN in its environment) or gpio_chip and gpio_line
  [process]         lock_memory, realtime_priority, cpus = [3]

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
  command.notes = kNotes;
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
