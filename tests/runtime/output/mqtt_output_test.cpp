#include <fcntl.h>
#include <mosquitto.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <catch2/catch.hpp>

#include "runtime/output/listener.h"
#include "runtime/output/outputs.h"
#include "tests/runtime/output/made_lines.h"
#include "tests/runtime/output/output_clients.h"
#include "tests/temporary_folder.h"

namespace aspect {
namespace {

constexpr const char* kBroker = "/usr/sbin/mosquitto";
constexpr std::size_t kLongest = 2000;

// Debian's broker, on a port of its own.
class Broker {
 public:
  explicit Broker(int port) {
    const auto configuration = folder_.write(
        "conf", "listener " + std::to_string(port) + " 127.0.0.1\nallow_anonymous true\n");
    std::string file = configuration.string(), program = kBroker, option = "-c";
    char* const arguments[] = {program.data(), option.data(), file.data(), nullptr};
    posix_spawn_file_actions_t files;
    ::posix_spawn_file_actions_init(&files);
    ::posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    REQUIRE(::posix_spawn(&process_, kBroker, &files, nullptr, arguments, environ) == 0);
    ::posix_spawn_file_actions_destroy(&files);
  }
  ~Broker() {
    ::kill(process_, SIGTERM);
    ::waitpid(process_, nullptr, 0);
  }

 private:
  TemporaryFolder folder_;
  pid_t process_ = 0;
};

// Counts the lines that come to it.
class Subscriber {
 public:
  explicit Subscriber(int port) : client_(::mosquitto_new(nullptr, true, this)) {
    ::mosquitto_message_callback_set(
        client_, [](mosquitto*, void* self, const mosquitto_message* message) {
          std::string line(static_cast<const char*>(message->payload),
                           static_cast<std::size_t>(message->payloadlen));
          static_cast<Subscriber*>(self)->tally.take(line + "\n", kLongest);
        });
    ::mosquitto_subscribe_callback_set(client_, [](mosquitto*, void* self, int, int, const int*) {
      static_cast<Subscriber*>(self)->subscribed_ = true;
    });
    REQUIRE(comes_true(
        [&] { return ::mosquitto_connect(client_, "127.0.0.1", port, 30) == MOSQ_ERR_SUCCESS; }));
    REQUIRE(::mosquitto_subscribe(client_, nullptr, "a/b", 0) == MOSQ_ERR_SUCCESS);
    CHECK(comes_true([&] { return take_some() && subscribed_; }));
  }
  ~Subscriber() { ::mosquitto_destroy(client_); }
  bool take_some() { return ::mosquitto_loop(client_, 20, 1) == MOSQ_ERR_SUCCESS; }
  LineTally tally;

 private:
  mosquitto* client_;
  bool subscribed_ = false;
};

int free_port() {
  return bound_port(open_tcp_listener("127.0.0.1", 0).value().get());
}

std::unique_ptr<Outputs> opened(int port) {
  auto outputs = Outputs::open(
      {.mqtt = MqttOutput{
           .port = port, .topic = "a/b", .client = "", .user = "", .password_file = ""}});
  if (!outputs) FAIL(outputs.error());
  return std::move(outputs).value();
}

}  // namespace

TEST_CASE("lines reach a broker, also one that comes later") {
  if (::access(kBroker, X_OK) != 0) {
    WARN("mosquitto is not installed: MQTT is not tested");
    return;
  }
  const int port = free_port();
  // Nobody there yet; what is published meanwhile is kept as long as the ring has it.
  const auto outputs = opened(port);
  for (std::uint64_t number = 0; number < 50; ++number)
    outputs->publish(made_line(number, kLongest));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  const Broker broker(port);
  Subscriber subscriber(port);
  CHECK(comes_true([&] { return subscriber.take_some() && subscriber.tally.last == 49U; }));
  for (std::uint64_t number = 50; number < 200; ++number)
    outputs->publish(made_line(number, kLongest));
  CHECK(comes_true([&] { return subscriber.take_some() && subscriber.tally.last == 199U; }));
  CHECK(subscriber.tally.whole == 200);
  CHECK(subscriber.tally.broken + subscriber.tally.gaps + subscriber.tally.disordered == 0);
  CHECK(outputs->counts().lines_lost == 0);
}

TEST_CASE("a broker that accepts and then stands still costs a second at the end at most") {
  const auto listener = open_tcp_listener("127.0.0.1", 0);
  auto outputs = opened(bound_port(listener.value().get()));
  for (std::uint64_t number = 0; number < 3000; ++number)
    outputs->publish(made_line(number, kLongest));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  CHECK(outputs->counts().lines_lost == 0);
  const auto before = std::chrono::steady_clock::now();
  outputs.reset();
  CHECK(std::chrono::steady_clock::now() - before < std::chrono::seconds(3));
}

}  // namespace aspect
