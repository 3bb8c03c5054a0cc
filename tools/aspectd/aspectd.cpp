// aspectd: the deployed camera runtime.
#include <getopt.h>
#include <unistd.h>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>

#include "runtime/base/standard_streams.h"
#include "runtime/service/daemon.h"
#include "runtime/service/daemon_log.h"
#include "tools/aspectd/check.h"

namespace {

constexpr const char* kHelp =
    R"(Recognises objects in what a camera sees: one JSON object a line for each frame.
usage: aspectd --config FILE.toml [--check]

  --config FILE.toml  indexes, camera, recognition and outputs; firmware_configs/ has examples
  --check             validate everything against the camera present, print what will be used, exit
  --version           print the version
  --help              print this

The configuration is TOML; whatever is left out has a default, but for indexes.
  indexes = ["NAME.aspect", ...]  files, from the configuration's folder on
  [camera]          device = "/dev/video0", "bus:PLACE" or "serial:NUMBER"; width, height, rate,
                    format = "YUYV"; stall_ms (silence after which it is started anew);
                    fx, fy, cx, cy (its lens, in pixels), k1, k2, p1, p2, k3
  [camera.controls] NAME = NUMBER, ... as v4l2-ctl --list-ctrls names them, set in this order
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
  [[output.trigger]] object, score_min, frames, and command = ["/PROGRAM", ...] (it finds
                    ASPECT_OBJECT and ASPECT_SEEN in its environment) or gpio_chip and gpio_line
  [process]         lock_memory, realtime_priority, cpus = [3]

A frame's line is aspect-replay's, with "capture": time_s, latency_ms, and how many frames before it
were late, lost and damaged. Another state is a line with "state": streaming, absent, busy,
no_signal, stalled, failed, damaged, reloaded, reload_failed; and one on standard error.

SIGHUP reads the configuration and the indexes anew; if they are no good the old ones go on.
SIGTERM and SIGINT end it.

Exit code: 0 ended or everything is right, 1 something is wrong (one line on standard error), 2
wrong usage.
)";

constexpr int kFailed = 1, kWrongUsage = 2;

struct Options {
  std::string configuration;
  bool check = false;
};

int complain() {
  std::fputs("aspectd: give --config FILE.toml, and --check if you like; --help tells more\n",
             stderr);
  return kWrongUsage;
}

// What to do, or the exit code after help, version or a complaint have been printed.
std::optional<int> parse(int argc, char** argv, Options& options) {
  constexpr option kOptions[] = {{"config", required_argument, nullptr, 'c'},
                                 {"check", no_argument, nullptr, 'k'},
                                 {"version", no_argument, nullptr, 'v'},
                                 {"help", no_argument, nullptr, 'h'},
                                 {}};
  opterr = 0;
  for (int found = 0; (found = getopt_long(argc, argv, "", kOptions, nullptr)) != -1;) {
    switch (found) {
      case 'c':
        options.configuration = optarg;
        break;
      case 'k':
        options.check = true;
        break;
      case 'v':
        std::puts("aspectd " ASPECT_VERSION);
        return 0;
      case 'h':
        std::fputs(kHelp, stdout);
        return 0;
      default:
        return complain();
    }
  }
  if (optind != argc || options.configuration.empty()) return complain();
  return std::nullopt;
}

int run(const Options& options) {
  if (options.check) return aspect::check(options.configuration) ? 0 : kFailed;
  auto daemon = aspect::Daemon::start(options.configuration);
  if (!daemon) {
    aspect::log_line(daemon.error());
    return kFailed;
  }
  daemon.value()->run();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  aspect::guard_standard_streams();
  Options options;
  if (const auto exit_code = parse(argc, argv, options)) return *exit_code;
  try {
    return run(options);
  } catch (const std::exception& error) {
    aspect::log_line(error.what());
    return kFailed;
  }
}
