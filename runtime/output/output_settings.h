// What outputs are asked for.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace aspect {

struct FileOutput {
  std::filesystem::path path;
  std::uint64_t max_bytes = 16U << 20U;  // a file that would grow beyond is rotated: .1 is newest
  int keep = 3;                          // rotated files kept
  friend bool operator==(const FileOutput&, const FileOutput&) = default;
};
struct TcpOutput {
  std::string address = "127.0.0.1";  // numeric; 0.0.0.0 or :: for every interface
  int port = 0;                       // 0: any that is free
  friend bool operator==(const TcpOutput&, const TcpOutput&) = default;
};
struct MqttOutput {
  std::string host = "127.0.0.1";
  int port = 1883;
  std::string topic = "aspect";
  std::string client{}, user{};  // empty: one made up, nobody
  std::filesystem::path password_file{};
  friend bool operator==(const MqttOutput&, const MqttOutput&) = default;
};
struct HttpOutput {
  std::string address = "127.0.0.1";  // numeric
  int port = 8080;                    // 0: any that is free
  std::filesystem::path record{};     // folder for frames recorded from the page; empty: none
  friend bool operator==(const HttpOutput&, const HttpOutput&) = default;
};
// What happens when an object is seen, and again when it is no longer.
struct TriggerOutput {
  std::string object{};                // name in the index
  double score_min = 0;                // of its best hypothesis
  int frames = 1;                      // that it must be seen in, or be missing from, in a row
  std::vector<std::string> command{};  // whole path of a program, and arguments; it finds
                                       // ASPECT_OBJECT and ASPECT_SEEN (1 or 0) in its environment
  std::string gpio_chip{};             // /dev/gpiochip0
  int gpio_line = -1;                  // high while the object is seen
  friend bool operator==(const TriggerOutput&, const TriggerOutput&) = default;
};

struct OutputSettings {
  bool standard_output = false;
  std::optional<FileOutput> file{};
  std::optional<std::filesystem::path> unix_socket{};
  std::optional<TcpOutput> tcp{};
  std::optional<MqttOutput> mqtt{};
  std::optional<HttpOutput> http{};
  std::vector<TriggerOutput> triggers{};
  friend bool operator==(const OutputSettings&, const OutputSettings&) = default;
};

}  // namespace aspect
