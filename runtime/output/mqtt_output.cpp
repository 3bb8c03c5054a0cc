// One thread with the library's own loop, driven by poll. A message is handed to the library only
// when it has none left to send: it would queue without end for a broker that stands still.
#include "runtime/output/mqtt_output.h"

#include <mosquitto.h>
#include <poll.h>
#include <algorithm>
#include <array>
#include <cstdio>

#include "runtime/output/descriptor.h"

namespace aspect {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kPause{1000};
constexpr std::chrono::seconds kPauseMost{30};
constexpr std::chrono::seconds kPatience{10};  // for a broker that accepts but does not answer
constexpr int kKeepAlive_s = 30;
constexpr std::size_t kStackBytes = 256U << 10U;

Result<std::string> first_line(const std::filesystem::path& path) {
  std::array<char, 256> text{};
  std::FILE* const file = std::fopen(path.c_str(), "re");
  const bool read = file != nullptr && std::fgets(text.data(), text.size(), file) != nullptr;
  if (file != nullptr) std::fclose(file);
  if (!read)
    return Error{path.string() + ": the MQTT password cannot be read from its first line; " +
                 "check the file and its permissions"};
  const std::string line = text.data();
  return line.substr(0, line.find_first_of("\r\n"));
}

struct Library {
  Library() { ::mosquitto_lib_init(); }
  ~Library() { ::mosquitto_lib_cleanup(); }
};
struct DestroyClient {
  void operator()(mosquitto* client) const { ::mosquitto_destroy(client); }
};

class MqttLines final : public LineOutput {
 public:
  MqttLines(const MqttOutput& settings, const LineRing& ring, OutputCounters& counters)
      : settings_(settings), ring_(ring), counters_(counters), next_(ring.published()) {}
  OutputThread& thread() override { return thread_; }

  std::optional<Error> start() {
    const char* const id = settings_.client.empty() ? nullptr : settings_.client.c_str();
    client_.reset(::mosquitto_new(id, true, this));
    if (!client_) return Error{"mqtt: no client: " + system_error()};
    if (!settings_.user.empty()) {
      std::string password;
      if (!settings_.password_file.empty()) {
        const auto read = first_line(settings_.password_file);
        if (!read) return Error{read.error()};
        password = read.value();
      }
      ::mosquitto_username_pw_set(client_.get(), settings_.user.c_str(), password.c_str());
    }
    ::mosquitto_connect_callback_set(client_.get(), [](mosquitto*, void* self, int code) {
      static_cast<MqttLines*>(self)->answered(code);
    });
    return thread_.start("aspect-mqtt", kStackBytes, [this] { run(); });
  }

 private:
  void answered(int code) {
    if (code != 0) return say_failing(::mosquitto_connack_string(code));
    connected_ = true;
    pause_ = kPause;
    if (failing_) warn(name() + ": connected");
    failing_ = false;
  }
  void say_failing(const char* what) {
    if (!failing_) warn(name() + ": " + what + "; tried again until it works");
    failing_ = true;
  }
  std::string name() const {
    return "mqtt " + settings_.host + " port " + std::to_string(settings_.port);
  }

  void run() {
    while (!thread_.stopping() || (connected_ && behind() && !thread_.out_of_time())) {
      if (!linked_) {
        connect();
      } else {
        exchange();
        while (connected_ && send_next()) {
        }
      }
    }
    if (connected_) ::mosquitto_disconnect(client_.get());
  }

  bool behind() const { return next_ < ring_.published() || ::mosquitto_want_write(client_.get()); }

  void connect() {
    if (const auto now = Clock::now(); now < connects_at_) {
      thread_.sleep(
          std::min(kPause, std::chrono::ceil<std::chrono::milliseconds>(connects_at_ - now)));
      return;
    }
    const int status = ::mosquitto_connect_async(client_.get(), settings_.host.c_str(),
                                                 settings_.port, kKeepAlive_s);
    answer_until_ = Clock::now() + kPatience;
    linked_ = true;
    if (status != MOSQ_ERR_SUCCESS) lose(status);
  }

  // The library closes what is left of a connection before it makes the next.
  void lose(int status) {
    say_failing(status == MOSQ_ERR_ERRNO ? system_error().c_str() : ::mosquitto_strerror(status));
    linked_ = connected_ = false;
    connects_at_ = Clock::now() + pause_;
    pause_ = std::min<std::chrono::milliseconds>(2 * pause_, kPauseMost);
  }

  // Waits, then lets the library read and write.
  void exchange() {
    const int socket = ::mosquitto_socket(client_.get());
    const short events = ::mosquitto_want_write(client_.get()) ? POLLIN | POLLOUT : POLLIN;
    std::array<pollfd, 2> waits{{{thread_.wake_descriptor(), POLLIN, 0}, {socket, events, 0}}};
    const auto longest = thread_.stopping() ? kPause / 50 : kPause;
    ::poll(waits.data(), waits.size(), static_cast<int>(longest.count()));
    if (waits[0].revents != 0) thread_.clear_wake();
    int status = MOSQ_ERR_SUCCESS;
    if ((waits[1].revents & (POLLIN | POLLHUP | POLLERR)) != 0)
      status = ::mosquitto_loop_read(client_.get(), 1);
    if (status == MOSQ_ERR_SUCCESS && (waits[1].revents & POLLOUT) != 0)
      status = ::mosquitto_loop_write(client_.get(), 1);
    if (status == MOSQ_ERR_SUCCESS) status = ::mosquitto_loop_misc(client_.get());
    if (status == MOSQ_ERR_SUCCESS && !connected_ && Clock::now() > answer_until_)
      status = MOSQ_ERR_CONN_LOST;
    if (status != MOSQ_ERR_SUCCESS) lose(status);
  }

  // False when there is nothing to send, or something is being sent.
  bool send_next() {
    if (::mosquitto_want_write(client_.get())) return false;
    const auto [state, line] = ring_.read(next_, line_);
    if (state == LineRing::Reading::State::not_yet) return false;
    if (state == LineRing::Reading::State::gone) {
      skip_lost(ring_, next_, counters_);
      return true;
    }
    const int bytes = static_cast<int>(line.size() - 1);  // a message needs no end
    const int status = ::mosquitto_publish(client_.get(), nullptr, settings_.topic.c_str(), bytes,
                                           line.data(), 0, false);
    if (status != MOSQ_ERR_SUCCESS) {
      lose(status);
      return false;
    }
    ++next_;
    return true;
  }

  const MqttOutput settings_;
  const LineRing& ring_;
  OutputCounters& counters_;
  std::uint64_t next_;
  const Library library_;
  std::unique_ptr<mosquitto, DestroyClient> client_;
  bool linked_ = false;     // there is a socket
  bool connected_ = false;  // the broker has answered
  bool failing_ = false;
  std::chrono::milliseconds pause_ = kPause;
  Clock::time_point connects_at_{}, answer_until_{};
  std::array<char, LineRing::kMaxLineBytes> line_{};
  OutputThread thread_;  // last: it ends before what it uses
};

}  // namespace

std::optional<Error> check_mqtt() {
  return std::nullopt;
}

Result<std::unique_ptr<LineOutput>> open_mqtt_output(const MqttOutput& settings,
                                                     const LineRing& ring,
                                                     OutputCounters& counters) {
  auto output = std::make_unique<MqttLines>(settings, ring, counters);
  if (auto error = output->start()) return *error;
  return std::unique_ptr<LineOutput>(std::move(output));
}

}  // namespace aspect
