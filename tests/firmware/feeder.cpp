// Plays frames into vivid's HDMI output, which its HDMI input shows, and does to the driver what
// happens to cameras. Reads commands from standard input, one a line:
//
//   loop WIDTH HEIGHT FOURCC    both ends alike, the loop on, no text in the picture
//   play FILE HOLD [TIMES]      the frames of NAME.WIDTHxHEIGHT.FOURCC, each for HOLD periods of
//                               the output; the last one stays
//   set CONTROL VALUE           of the capture node, by v4l2-ctl's name or 0x and the number
//   locked CONTROL VALUE        tries to set it; fails unless that is refused as busy
//   wait MS
//   hold WIDTH HEIGHT FOURCC    streams from the capture node, as soon as that is possible
//   release                     gives the capture node back
//   close                       lets go of both nodes
//   nodes CAPTURE OUTPUT        lets go of both; from then on it is these
//   await FILE TEXT MS          until TEXT is in five more lines of FILE than now, at most so long
//   run COMMAND                 in a shell
//   mark TEXT                   one line in the log
//
// Every command is logged on standard output with the time when it was done, in seconds of
// CLOCK_MONOTONIC. The first failure ends the program with status 1.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>

#include "video_node.h"

namespace aspect {
namespace {

constexpr int kHoldTries = 5000;

double seconds_now() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) * 1e-9;
}

void sleep_ms(long ms) {
  timespec left{ms / 1000, ms % 1000 * 1000000};
  while (nanosleep(&left, &left) != 0 && errno == EINTR) {
  }
}

struct Words {
  explicit Words(char* line) {
    for (char* word = std::strtok(line, " \n"); word != nullptr && count < 4;
         word = std::strtok(nullptr, " \n"))
      at[count++] = word;
  }
  std::string text(int i) const { return i < count ? at[i] : ""; }
  int number(int i, int otherwise = 0) const { return i < count ? std::atoi(at[i]) : otherwise; }
  char* at[4]{};
  int count = 0;
};

class Feeder {
 public:
  Feeder(const std::string& capture, const std::string& output)
      : capture_(capture, Direction::capture), output_(output, Direction::output) {}

  // Whether it worked; if not, fault() says why.
  bool perform(const std::string& line);
  const std::string& fault() const { return fault_; }

 private:
  bool done(int error, const VideoNode& node);
  bool fail(const std::string& fault);
  bool open(VideoNode& node);
  bool loop(const Words& words);
  bool play(const Words& words);
  bool hold(const Words& words);
  bool await(const Words& words);

  VideoNode capture_, output_;
  std::string fault_;
  int width_px_ = 0, height_px_ = 0;
};

bool Feeder::fail(const std::string& fault) {
  fault_ = fault;
  return false;
}

bool Feeder::done(int error, const VideoNode& node) {
  return error == 0 || fail(node.what());
}

bool Feeder::open(VideoNode& node) {
  return node.is_open() || done(node.open(), node);
}

bool Feeder::loop(const Words& words) {
  width_px_ = words.number(1);
  height_px_ = words.number(2);
  const std::uint32_t fourcc = fourcc_of(words.text(3));
  if (fourcc == 0) return fail("loop WIDTH HEIGHT FOURCC");
  for (VideoNode* node : {&capture_, &output_}) {
    if (!open(*node)) return false;
    if (node == &output_) node->stop();
    if (!done(node->select_hdmi(), *node)) return false;
    if (!done(node->set_timings(width_px_, height_px_), *node)) return false;
    if (!done(node->set_format(fourcc, width_px_, height_px_), *node)) return false;
  }
  constexpr int kNoText = 2;
  return done(capture_.set_control("osd_text_mode", kNoText), capture_) &&
         done(capture_.set_control("loop_video", 1), capture_) && done(output_.start(4), output_);
}

bool Feeder::play(const Words& words) {
  const int file = ::open(words.text(1).c_str(), O_RDONLY | O_CLOEXEC);
  struct stat status {};
  if (file < 0 || fstat(file, &status) != 0) return fail(words.text(1) + ": cannot be read");
  const std::size_t frame_bytes = output_.frame_bytes();
  const auto file_bytes = static_cast<std::size_t>(status.st_size);
  void* data = mmap(nullptr, file_bytes, PROT_READ, MAP_PRIVATE, file, 0);
  ::close(file);
  if (data == MAP_FAILED || frame_bytes == 0 || file_bytes % frame_bytes != 0)
    return fail(words.text(1) + ": not whole frames of " + std::to_string(frame_bytes) + " bytes");
  int error = 0;
  for (int time = 0; time < words.number(3, 1); ++time)
    for (std::size_t at = 0; at < file_bytes && error == 0; at += frame_bytes)
      for (int period = 0; period < words.number(2, 1) && error == 0; ++period)
        error = output_.put(static_cast<const std::uint8_t*>(data) + at);
  if (error == 0) error = output_.drain(1);
  munmap(data, file_bytes);
  return done(error, output_);
}

bool Feeder::hold(const Words& words) {
  int error = 0;
  for (int i = 0; i < kHoldTries; ++i) {
    error = capture_.is_open() ? 0 : capture_.open();
    if (error == 0)
      error = capture_.set_format(fourcc_of(words.text(3)), words.number(1), words.number(2));
    if (error == 0) error = capture_.start(4);
    if (error == 0) return true;
    sleep_ms(1);
  }
  return done(error, capture_);
}

// The time being over is no failure: whoever reads the log sees it.
bool Feeder::await(const Words& words) {
  constexpr int kLines = 5, kStep_ms = 10;
  std::FILE* file = std::fopen(words.text(1).c_str(), "re");
  if (file == nullptr) return fail(words.text(1) + ": cannot be read");
  std::fseek(file, 0, SEEK_END);
  char line[65536];
  int found = 0;
  for (int ms = 0; found < kLines && ms < words.number(3); ms += kStep_ms) {
    sleep_ms(kStep_ms);
    std::clearerr(file);
    while (std::fgets(line, sizeof line, file) != nullptr)
      if (std::strstr(line, words.text(2).c_str()) != nullptr) ++found;
  }
  std::fclose(file);
  return true;
}

bool Feeder::perform(const std::string& line) {
  std::string copy = line;
  const Words words(copy.data());
  const std::string verb = words.text(0);
  if (verb == "loop") return loop(words);
  if (verb == "play") return play(words);
  if (verb == "hold") return hold(words);
  if (verb == "await") return await(words);
  if (verb == "mark") return true;
  if (verb == "set")
    return open(capture_) && done(capture_.set_control(words.text(1), words.number(2)), capture_);
  if (verb == "locked") {
    if (!open(capture_)) return false;
    const int error = capture_.set_control(words.text(1), words.number(2));
    return error == EBUSY || fail(error == 0 ? "it could be set" : capture_.what());
  }
  if (verb == "wait") {
    sleep_ms(words.number(1));
  } else if (verb == "release") {
    capture_.stop();
  } else if (verb == "close") {
    capture_.close();
    output_.close();
  } else if (verb == "nodes") {
    capture_.move_to(words.text(1));
    output_.move_to(words.text(2));
  } else if (verb == "run") {
    if (std::system(line.c_str() + line.find("run") + 3) != 0) return fail("it failed");
  } else {
    return fail("no such command");
  }
  return true;
}

int feed(const char* capture, const char* output) {
  Feeder feeder(capture, output);
  char line[1024];
  while (std::fgets(line, sizeof line, stdin) != nullptr) {
    line[std::strcspn(line, "\n")] = '\0';
    const char* command = line + std::strspn(line, " ");
    if (*command == '\0' || *command == '#') continue;
    const bool done = feeder.perform(command);
    std::printf("%.6f feeder: %s%s%s\n", seconds_now(), command,
                done ? "" : ": failed: ", done ? "" : feeder.fault().c_str());
    std::fflush(stdout);
    if (!done) return 1;
  }
  return 0;
}

}  // namespace
}  // namespace aspect

int main(int argc, char** argv) {
  return aspect::feed(argc > 1 ? argv[1] : "/dev/video0", argc > 2 ? argv[2] : "/dev/video1");
}
