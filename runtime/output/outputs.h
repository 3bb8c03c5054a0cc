// Where lines go: standard output, a file, sockets and what else is configured. The frame loop
// hands a line over and goes on; whoever reads too slowly loses its connection, never the loop's
// time.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/base/result.h"
#include "runtime/vision/frame.h"

namespace aspect {

struct FileOutput {
  std::filesystem::path path;
  std::uint64_t max_bytes = 16U << 20U;  // a file that would grow beyond is rotated: .1 is newest
  int keep = 3;                          // rotated files kept
};
struct TcpOutput {
  std::string address = "127.0.0.1";  // numeric; 0.0.0.0 or :: for every interface
  int port = 0;
};
struct MqttOutput {
  std::string host = "127.0.0.1";
  int port = 1883;
  std::string topic = "aspect";
  std::string client, user, password_file;
};
struct HttpOutput {
  std::string address = "127.0.0.1";
  int port = 8080;
};
// What happens when an object is seen, and again when it is no longer.
struct TriggerOutput {
  std::string object;                // name in the index
  double score_min = 0;              // of its best hypothesis
  int frames = 1;                    // that it must be seen in, or be missing from, in a row
  std::vector<std::string> command;  // program and arguments; ASPECT_OBJECT, ASPECT_SEEN are set
  std::string gpio_chip;             // /dev/gpiochip0
  int gpio_line = -1;
};

struct OutputSettings {
  bool standard_output = false;
  std::optional<FileOutput> file;
  std::optional<std::filesystem::path> unix_socket;
  std::optional<TcpOutput> tcp;
  std::optional<MqttOutput> mqtt;
  std::optional<HttpOutput> http;
  std::vector<TriggerOutput> triggers;
};

// What a trigger needs to know of one object seen in a frame.
struct SeenName {
  std::string_view object;
  double score = 0;
};

struct OutputCounts {
  std::uint64_t lines = 0;
  std::uint64_t readers = 0;          // connected now
  std::uint64_t readers_dropped = 0;  // because they were too slow
  std::uint64_t lines_lost = 0;       // of outputs that cannot be dropped: file, standard output
};

class Outputs {
 public:
  static constexpr std::size_t kMaxLineBytes = 32U << 10U;

  // Opens everything, takes all memory and starts the thread that writes. One line where something
  // cannot be had, or is not in this build.
  [[nodiscard]] static Result<std::unique_ptr<Outputs>> open(const OutputSettings& settings);
  // Writes what can be written at once, up to a second, and closes.
  ~Outputs();

  // Never waits, never allocates; a line of at most kMaxLineBytes with its end. From one thread.
  void publish(std::string_view line) noexcept;

  // Which objects the frame shows, for triggers. Same thread, same promise.
  void report_seen(std::span<const SeenName> seen) noexcept;

  // A page is open that shows pictures: the loop may then hand frames over, scaled down and copied
  // at once.
  [[nodiscard]] bool wants_picture() const noexcept;
  void show_picture(const Frame& frame) noexcept;

  [[nodiscard]] OutputCounts counts() const noexcept;

 private:
  Outputs();
  class Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace aspect
