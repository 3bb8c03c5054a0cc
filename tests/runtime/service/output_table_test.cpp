#include "runtime/service/output_table.h"

#include <catch2/catch.hpp>

namespace aspect {
namespace {

using Catch::Matchers::Contains;

std::optional<Error> read(const std::string& text, OutputSettings& settings) {
  const toml::table file = toml::parse(text);
  return read_outputs(*file["output"].as_table(), "c.toml", settings);
}

std::string error_of(const std::string& text) {
  OutputSettings settings;
  const auto error = read(text, settings);
  REQUIRE(error);
  return error->message;
}

}  // namespace

TEST_CASE("all outputs are read") {
  OutputSettings settings;
  REQUIRE_FALSE(read(R"([output]
stdout = true
[output.file]
path = "/var/log/aspect/lines"
max_mib = 5
keep = 0
[output.socket]
path = "/run/aspect/socket"
[output.tcp]
address = "::"
port = 4000
[output.mqtt]
host = "broker"
port = 1884
topic = "line/4"
client = "camera"
user = "u"
password_file = "/etc/p"
[output.http]
address = "0.0.0.0"
port = 80
[[output.trigger]]
object = "cube"
score_min = 5
frames = 3
command = ["/bin/echo", "a b"]
[[output.trigger]]
object = "block"
gpio_chip = "/dev/gpiochip0"
gpio_line = 0
)",
                     settings));
  OutputSettings wanted;
  wanted.standard_output = true;
  wanted.file = {"/var/log/aspect/lines", 5U << 20U, 0};
  wanted.unix_socket = "/run/aspect/socket";
  wanted.tcp = {"::", 4000};
  wanted.mqtt = {"broker", 1884, "line/4", "camera", "u", "/etc/p"};
  wanted.http = {"0.0.0.0", 80};
  wanted.triggers = {{"cube", 5, 3, {"/bin/echo", "a b"}, "", -1},
                     {"block", 0, 1, {}, "/dev/gpiochip0", 0}};
  CHECK(settings == wanted);
}

TEST_CASE("a table without keys has the defaults, an absent one changes nothing") {
  OutputSettings settings;
  settings.standard_output = true;
  settings.tcp = {"127.0.0.1", 9};
  OutputSettings wanted = settings;
  REQUIRE_FALSE(read("[output.http]\n[output.mqtt]\n", settings));
  wanted.http.emplace();
  wanted.mqtt.emplace();
  CHECK(settings == wanted);
}

TEST_CASE("what is wrong with an output is said with its line") {
  const std::pair<const char*, const char*> cases[] = {
      {"[output]\nstdot = true\n",
       "c.toml:2: [output] stdot is not known here; did you mean stdout?"},
      {"[output]\nstdout = 1\n", "c.toml:2: [output] stdout is 1; it must be true or false"},
      {"[output]\nfile = 'x'\n", "c.toml:2: [output] file is \"x\"; it must be a table"},
      {"[output.file]\nkeep = 2\n", "[output.file] path is missing; add it"},
      {"[output.file]\npath = ''\n", "[output.file] path is empty"},
      {"[output.file]\npath = 'x'\nmax_mib = 0\n", "c.toml:3: [output.file] max_mib is 0"},
      {"[output.tcp]\naddress = '::'\n", "[output.tcp] port is missing"},
      {"[output.tcp]\nport = 65536\n", "c.toml:2: [output.tcp] port is 65536"},
      {"[output.mqtt]\ntopic = 'a/#'\n", "c.toml:2: [output.mqtt] topic must be"},
      {"[output.mqtt]\npassword_file = 'x'\n", "is of no use without user"},
      {"[output]\n[[output.trigger]]\nframes = 1\n", "[output.trigger] object is missing"},
      {"[output]\n[[output.trigger]]\nobject = 'x'\n", "command is missing; add it, or gpio_chip"},
      {"[[output.trigger]]\nobject = 'x'\ngpio_line = 4\n",
       "c.toml:3: [output.trigger] gpio_line is only half"},
      {"[[output.trigger]]\nobject = 'x'\ngpio_chip = '/dev/g'\n", "gpio_chip is only half"},
      {"[[output.trigger]]\nobject = 'x'\ncommand = []\n", "must be an array of texts in quotes"},
      {"[[output.trigger]]\nobject = 'x'\ncommand = ['/x', 3]\n", "command is 3; it must be"},
      {"[[output.trigger]]\nobject = 'x'\ncommand = ['/x']\nframes = 0\n",
       "c.toml:4: [output.trigger] frames is 0"}};
  for (const auto& [text, expected] : cases) CHECK_THAT(error_of(text), Contains(expected));
}

}  // namespace aspect
