// aspectd: the deployed camera runtime.
#include <fmt/format.h>
#include <getopt.h>
#include <cstdio>
#include <cstring>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/standard_streams.h"
#include "runtime/service/daemon.h"
#include "runtime/service/daemon_log.h"
#include "runtime/workbench/workbench_desk.h"
#include "tools/aspectd/aspectd_command.h"
#include "tools/aspectd/check.h"
#include "tools/command_line/help_text.h"

namespace {

constexpr int kFailed = 1, kWrongUsage = 2;

struct Options {
  std::string configuration;
  bool check = false, json = false;
};

int complain(const std::string& message) {
  std::fprintf(stderr, "aspectd: %s; see aspectd --help\n", message.c_str());
  return kWrongUsage;
}

// For getopt_long, which finds the place among them.
std::vector<option> long_options(const aspect::CommandText& command) {
  std::vector<option> all;
  for (const aspect::CommandOption& one : command.options)
    all.push_back({one.names.back().c_str() + std::strlen("--"),
                   one.value.empty() ? no_argument : required_argument, nullptr, 0});
  all.push_back({});
  return all;
}

int complain_of_word(const aspect::CommandText& command, const char* word) {
  for (const aspect::CommandOption& one : command.options)
    if (word == one.names.back()) return complain(fmt::format("{} needs {}", word, one.value));
  return complain(aspect::no_such_option(command, word));
}

// What to do, or the exit code after help, version or a complaint have been printed.
std::optional<int> parse(int argc, char** argv, Options& options) {
  const aspect::CommandText command = aspect::aspectd_command();
  const std::vector<option> known = long_options(command);
  opterr = 0;
  int place = 0;
  for (int found = 0; (found = getopt_long(argc, argv, "h", known.data(), &place)) != -1;) {
    if (found == '?') return complain_of_word(command, argv[optind - 1]);
    const std::string_view name =
        found == 'h' ? "help" : known[static_cast<std::size_t>(place)].name;
    if (name == "config") options.configuration = optarg;
    if (name == "check") options.check = true;
    if (name == "json") options.json = true;
    if (name == "version") return std::puts("aspectd " ASPECT_VERSION), 0;
    if (name == "help") return std::fputs(help_text(command).c_str(), stdout), 0;
  }
  if (optind != argc) return complain(std::string(argv[optind]) + ": is one word too many");
  if (options.configuration.empty()) return complain("no --config FILE.toml given");
  if (options.json && !options.check) return complain("--json is for --check; give both");
  return std::nullopt;
}

int run(const Options& options) {
  if (options.check) return aspect::check(options.configuration, options.json) ? 0 : kFailed;
  auto daemon = aspect::Daemon::start(
      options.configuration, {.make_workbench = aspect::make_camera_workbench, .calls = nullptr});
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
