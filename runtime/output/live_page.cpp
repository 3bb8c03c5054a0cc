#include "runtime/output/live_page.h"

#include <httplib.h>
#include <array>
#include <charconv>
#include <semaphore>
#include <thread>

#include "runtime/output/listener.h"
#include "runtime/output/live_page_html.h"
#include "runtime/output/output_thread.h"
#include "runtime/output/preview_picture.h"

namespace aspect {
namespace {

constexpr std::chrono::seconds kPatience{1};
// Browsers open connections that they may need later: one of them must not block the page.
constexpr std::size_t kThreads = 4;
// The library reads headers with std::regex, which needs a lot where they are long.
constexpr std::size_t kStackBytes = 8U << 20U;

// Connections that are more than can be served soon wait in the kernel, not in our memory.
class FewAtOnce final : public httplib::ThreadPool {
 public:
  FewAtOnce() : ThreadPool(kThreads) {}
  void enqueue(std::function<void()> serve) override {
    free_.acquire();
    ThreadPool::enqueue([this, serve = std::move(serve)] {
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

// The host's name in a URL's authority, without port.
std::string host_of(const std::string& authority) {
  const std::size_t end = authority.starts_with('[') ? authority.find(']') : authority.find(':');
  return authority.starts_with('[') ? authority.substr(1, end - 1) : authority.substr(0, end);
}

class ServedPage final : public LivePage {
 public:
  ServedPage(const LineRing& ring, const OutputCounters& counters)
      : ring_(ring), counters_(counters) {}
  ~ServedPage() override { server_.stop(); }

  std::optional<Error> start(const HttpOutput& settings) {
    const auto address = numeric_address("http", settings.address, settings.port);
    if (!address) return Error{address.error()};
    loopback_ = settings.address.starts_with("127.") || settings.address == "::1";
    server_.new_task_queue = [] { return new FewAtOnce; };
    server_.set_keep_alive_max_count(1);
    server_.set_keep_alive_timeout(kPatience.count());
    server_.set_read_timeout(kPatience);
    server_.set_write_timeout(kPatience);
    server_.set_payload_max_length(0);
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

  bool wants_picture() const noexcept override { return picture_.wanted(); }
  void show_picture(const Frame& frame) noexcept override {
    picture_.show(frame, ring_.published());
  }
  int port() const override { return port_; }

 private:
  using Request = httplib::Request;
  using Response = httplib::Response;

  void route() {
    server_.set_default_headers({{"Cache-Control", "no-store"},
                                 {"X-Content-Type-Options", "nosniff"},
                                 {"Content-Security-Policy",
                                  "default-src 'none'; img-src 'self' blob: data:; connect-src "
                                  "'self'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; "
                                  "frame-ancestors 'none'"}});
    server_.set_pre_routing_handler([this](const Request& request, Response& response) {
      if (!loopback_ || is_local(request)) return httplib::Server::HandlerResponse::Unhandled;
      response.status = 403;
      return httplib::Server::HandlerResponse::Handled;
    });
    server_.Get("/", [](const Request&, Response& response) {
      response.set_content(kLivePageHtml.data(), kLivePageHtml.size(), "text/html; charset=utf-8");
    });
    server_.Get("/picture\\.bmp", [this](const Request& request, Response& response) {
      send_picture(request, response);
    });
    server_.Get("/line", [this](const Request& request, Response& response) {
      send_line(request, response);
    });
  }

  // A name that somebody else made resolve to this machine must not show the picture to a page of
  // theirs (DNS rebinding).
  static bool is_local(const Request& request) {
    const std::string host = host_of(request.get_header_value("Host"));
    return host == "localhost" || host == "::1" || host.starts_with("127.");
  }

  void send_picture(const Request& request, Response& response) {
    auto picture = picture_.fetch(number_in(request, "after"));
    if (!picture) {
      response.status = 204;
      return;
    }
    response.set_header("Aspect-Line", std::to_string(picture->line));
    response.set_content(std::move(picture->bmp), "image/bmp");
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
  PreviewPicture picture_;
  httplib::Server server_;
  int port_ = 0;
  bool loopback_ = true;
  OutputThread thread_;  // last: it ends before what it uses
};

}  // namespace

std::optional<Error> check_http() {
  return std::nullopt;
}

Result<std::unique_ptr<LivePage>> open_live_page(const HttpOutput& settings, const LineRing& ring,
                                                 const OutputCounters& counters) {
  auto page = std::make_unique<ServedPage>(ring, counters);
  if (auto error = page->start(settings)) return *error;
  return std::unique_ptr<LivePage>(std::move(page));
}

}  // namespace aspect
