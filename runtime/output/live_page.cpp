#include "runtime/output/live_page.h"

#include <httplib.h>
#include <sys/resource.h>
#include <unistd.h>
#include <array>
#include <charconv>
#include <chrono>
#include <semaphore>
#include <thread>

#include "runtime/output/listener.h"
#include "runtime/output/output_thread.h"
#include "runtime/output/page_files.h"
#include "runtime/output/page_guard.h"

namespace aspect {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kPatience{1};
// Who takes an answer in drops is given up.
constexpr std::chrono::seconds kMostPatience{5};
// Browsers open connections that they may need later: one of them must not block the page.
constexpr std::size_t kThreads = 6;
// The library reads headers with std::regex, which needs a lot where they are long.
constexpr std::size_t kStackBytes = 8U << 20U;
constexpr std::size_t kPieceBytes = 64U << 10U;

// What the page takes time for, frames need not wait for where there is one processor only.
void be_modest() {
  constexpr int kMoreNice = 10;
  thread_local const int done = [] {
    const auto self = static_cast<id_t>(::gettid());
    return ::setpriority(PRIO_PROCESS, self, ::getpriority(PRIO_PROCESS, self) + kMoreNice);
  }();
  static_cast<void>(done);
}

// Connections that are more than can be served soon wait in the kernel, not in our memory.
class FewAtOnce final : public httplib::ThreadPool {
 public:
  FewAtOnce() : ThreadPool(kThreads) {}
  void enqueue(std::function<void()> serve) override {
    free_.acquire();
    ThreadPool::enqueue([this, serve = std::move(serve)] {
      be_modest();
      serve();
      free_.release();
    });
  }

 private:
  std::counting_semaphore<> free_{8};
};

std::optional<std::uint64_t> number_in(const httplib::Request& request, const char* key) {
  const std::string text = request.get_param_value(key);
  std::uint64_t number = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || status != std::errc{} || end != text.data() + text.size()) return {};
  return number;
}

PageRequest page_request(const httplib::Request& request) {
  PageRequest asked;
  asked.changes = request.method != "GET" && request.method != "HEAD";
  asked.host = request.get_header_value("Host");
  asked.origin = request.get_header_value("Origin");
  asked.fetch_site = request.get_header_value("Sec-Fetch-Site");
  asked.content_type = request.get_header_value("Content-Type");
  asked.content_length = request.get_header_value("Content-Length");
  asked.transfer_encoding = request.get_header_value("Transfer-Encoding");
  asked.content_encoding = request.get_header_value("Content-Encoding");
  asked.token = request.get_header_value("Aspect-Token");
  return asked;
}

class ServedPage final : public LivePage {
 public:
  ServedPage(const LineRing& ring, const OutputCounters& counters, PageDesk* desk)
      : ring_(ring), counters_(counters), desk_(desk) {}
  ~ServedPage() override { server_.stop(); }

  std::optional<Error> start(const HttpOutput& settings) {
    const auto address = numeric_address("http", settings.address, settings.port);
    if (!address) return Error{address.error()};
    address_ = settings.address;
    guard_ = PageGuard(settings.address, desk_ != nullptr ? random_token() : "");
    server_.new_task_queue = [] { return new FewAtOnce; };
    server_.set_keep_alive_max_count(1);
    server_.set_keep_alive_timeout(kPatience.count());
    server_.set_read_timeout(kPatience);
    server_.set_write_timeout(kPatience);
    server_.set_payload_max_length(PageGuard::kMostBodyBytes);
    server_.set_tcp_nodelay(true);
    // The library would share a port with other processes.
    server_.set_socket_options([](int socket) {
      const int yes = 1;
      ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    route();
    const bool any = settings.port == 0;
    port_ = any ? server_.bind_to_any_port(settings.address) : settings.port;
    if (port_ < 0 || (!any && !server_.bind_to_port(settings.address, port_)))
      return Error{"http " + settings.address + " port " + std::to_string(settings.port) +
                   ": cannot be listened at; is the port in use, or the address not of this "
                   "machine?"};
    if (auto error =
            thread_.start("aspect-http", kStackBytes, [this] { server_.listen_after_bind(); }))
      return error;
    // Before it runs it cannot be stopped.
    for (int k = 0; k < 1000 && !server_.is_running(); ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return std::nullopt;
  }

  int port() const override { return port_; }
  std::string address() const override {
    const bool every = address_ == "0.0.0.0" || address_ == "::";
    const bool colons = address_.find(':') != std::string::npos;
    const std::string host = every ? "localhost" : colons ? "[" + address_ + "]" : address_;
    const std::string fragment = guard_.token().empty() ? "" : "#token=" + guard_.token();
    return "http://" + host + ":" + std::to_string(port_) + "/" + fragment;
  }

 private:
  using Request = httplib::Request;
  using Response = httplib::Response;

  void route() {
    server_.set_default_headers(
        {{"Cache-Control", "no-store"},
         {"X-Content-Type-Options", "nosniff"},
         {"Referrer-Policy", "no-referrer"},
         {"Cross-Origin-Resource-Policy", "same-origin"},
         {"Cross-Origin-Opener-Policy", "same-origin"},
         {"Content-Security-Policy",
          "default-src 'none'; img-src 'self' blob: data:; connect-src 'self'; style-src 'self'; "
          "script-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"}});
    server_.set_pre_routing_handler([this](const Request& request, Response& response) {
      const auto refusal = guard_.refusal(page_request(request));
      if (!refusal) return httplib::Server::HandlerResponse::Unhandled;
      response.status = refusal->status;
      response.set_content(std::string(refusal->reason) + "\n", "text/plain");
      return httplib::Server::HandlerResponse::Handled;
    });
    for (const PageFile& file : page_files())
      server_.Get(std::string(file.path), [&file](const Request&, Response& response) {
        response.set_content(file.text.data(), file.text.size(), std::string(file.type));
      });
    server_.Get("/line", [this](const Request& request, Response& response) {
      send_line(request, response);
    });
    if (desk_ == nullptr) return;
    server_.Get("/state",
                [this](const Request&, Response& response) { send(desk_->state(), response); });
    server_.Get("/view", [this](const Request& request, Response& response) {
      send(desk_->view(number_in(request, "after")), response);
    });
    server_.Post("/act/([a-z]+)", [this](const Request& request, Response& response) {
      send(desk_->act(request.matches[1].str(), request.body), response);
    });
  }

  static void send(const PageAnswer& answer, Response& response) {
    response.status = answer.status;
    if (!answer.body) return;
    const auto started = Clock::now();
    response.set_content_provider(
        answer.body->size(), std::string(answer.type),
        [body = answer.body, started](std::size_t offset, std::size_t length,
                                      httplib::DataSink& sink) {
          return Clock::now() - started < kMostPatience &&
                 sink.write(body->data() + offset, std::min(length, kPieceBytes));
        });
  }

  void send_line(const Request& request, Response& response) {
    const std::uint64_t published = ring_.published();
    const std::uint64_t number =
        number_in(request, "number").value_or(published > 0 ? published - 1 : 0);
    std::vector<char> buffer(LineRing::kMaxLineBytes);
    const auto reading =
        ring_.read(number, std::span<char, LineRing::kMaxLineBytes>(buffer.data(), buffer.size()));
    std::string body = "{\"number\": " + std::to_string(number);
    const auto add = [&](const char* name, std::uint64_t value) {
      body += std::string(", \"") + name + "\": " + std::to_string(value);
    };
    add("lines", published);
    add("readers", counters_.readers);
    add("readers_dropped", counters_.readers_dropped);
    add("lines_lost", counters_.lines_lost);
    body += ", \"line\": ";
    body += reading.state == LineRing::Reading::State::line ? reading.line : "null";
    response.set_content(body + "}\n", "application/json");
  }

  const LineRing& ring_;
  const OutputCounters& counters_;
  PageDesk* desk_;
  PageGuard guard_;
  httplib::Server server_;
  std::string address_;
  int port_ = 0;
  OutputThread thread_;  // last: it ends before what it uses
};

}  // namespace

std::optional<Error> check_http() {
  return std::nullopt;
}

Result<std::unique_ptr<LivePage>> open_live_page(const HttpOutput& settings, const LineRing& ring,
                                                 const OutputCounters& counters, PageDesk* desk) {
  auto page = std::make_unique<ServedPage>(ring, counters, desk);
  if (auto error = page->start(settings)) return *error;
  return std::unique_ptr<LivePage>(std::move(page));
}

}  // namespace aspect
