#include <httplib.h>
#include <atomic>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "runtime/output/outputs.h"
#include "tests/runtime/output/output_clients.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;

// Gives a large view, and remembers what it was told.
class MadeDesk final : public PageDesk {
 public:
  static constexpr std::size_t kViewBytes = 2'000'000;

  PageAnswer state() override { return said("{\"state\": 1}"); }
  PageAnswer view(std::optional<std::uint64_t> after) override {
    if (after == 7) return {204, "", nullptr};
    return {200, "application/octet-stream", std::make_shared<const std::string>(kViewBytes, 'v')};
  }
  PageAnswer act(std::string_view action, const std::string& json) override {
    ++acts;
    return said(std::string(action) + json);
  }
  std::atomic<int> acts{0};

 private:
  static PageAnswer said(const std::string& text) {
    return {200, "application/json", std::make_shared<const std::string>(text)};
  }
};

std::unique_ptr<Outputs> opened_page(PageDesk* desk = nullptr) {
  auto outputs = Outputs::open({.http = HttpOutput{"127.0.0.1", 0}}, desk);
  if (!outputs) FAIL(outputs.error());
  return std::move(outputs).value();
}

std::string token_of(const Outputs& outputs) {
  const std::string address = outputs.http_address(), mark = "#token=";
  const std::size_t at = address.find(mark);
  return at == std::string::npos ? "" : address.substr(at + mark.size());
}

}  // namespace

TEST_CASE("a page, all that it is made of and the lines are served") {
  const auto outputs = opened_page();
  httplib::Client client("127.0.0.1", outputs->http_port());
  const auto page = client.Get("/");
  REQUIRE(page);
  CHECK(page->status == 200);
  CHECK_THAT(page->body, Contains("<canvas"));
  for (const char* file : {"/", "/page.css", "/main.js", "/connection.js", "/drawing.js",
                           "/plot.js", "/region.js", "/values.js"}) {
    INFO(file);
    const auto served = client.Get(file);
    REQUIRE(served);
    CHECK(served->status == 200);
    CHECK(served->body.size() > 100);
    // Nothing comes from anywhere else.
    CHECK(served->body.find("http:") == std::string::npos);
    CHECK(served->body.find("https:") == std::string::npos);
    CHECK_THAT(served->get_header_value("Content-Security-Policy"),
               Contains("default-src 'none'") && !Contains("unsafe"));
    CHECK(served->get_header_value("Cross-Origin-Resource-Policy") == "same-origin");
  }

  outputs->publish("{\"sequence\": 0}\n");
  outputs->publish("{\"sequence\": 1}\n");
  const auto line = nlohmann::json::parse(client.Get("/line?number=1")->body);
  CHECK(line["line"]["sequence"] == 1);
  CHECK(line["lines"] == 2);
  CHECK(nlohmann::json::parse(client.Get("/line")->body) == line);
  CHECK(nlohmann::json::parse(client.Get("/line?number=2")->body)["line"].is_null());
  CHECK(client.Get("/nothing")->status == 404);
  // Without a desk there is nothing to see or to change.
  CHECK(client.Get("/view")->status == 404);
  CHECK(outputs->http_address() ==
        "http://127.0.0.1:" + std::to_string(outputs->http_port()) + "/");
}

TEST_CASE("what the desk shows is served whole, and it is told what is asked for") {
  MadeDesk desk;
  const auto outputs = opened_page(&desk);
  httplib::Client client("127.0.0.1", outputs->http_port());
  CHECK(client.Get("/state")->body == "{\"state\": 1}");
  CHECK(client.Get("/view")->body == std::string(MadeDesk::kViewBytes, 'v'));
  CHECK(client.Get("/view?after=7")->status == 204);
  const httplib::Headers token = {{"Aspect-Token", token_of(*outputs)}};
  CHECK(client.Post("/act/settings", token, "{\"a\": 1}", "application/json")->body ==
        "settings{\"a\": 1}");
  CHECK(desk.acts == 1);
  CHECK(client.Get("/act/settings")->status == 404);
  CHECK(client.Put("/act/settings", token, "{}", "application/json")->status == 404);
  CHECK(client.Post("/act/../state", token, "{}", "application/json")->status == 404);
  CHECK(desk.acts == 1);
}

TEST_CASE("what may not be changed does not reach the desk") {
  MadeDesk desk;
  const auto outputs = opened_page(&desk);
  const std::string token = token_of(*outputs);
  REQUIRE(token.size() == 32);
  httplib::Client client("127.0.0.1", outputs->http_port());
  const auto status = [&](httplib::Headers headers, const char* type, std::string body) {
    const auto answer = client.Post("/act/save", headers, body, type);
    return answer ? answer->status : -1;
  };
  CHECK(status({}, "application/json", "{}") == 403);
  CHECK(status({{"Aspect-Token", "no"}}, "application/json", "{}") == 403);
  CHECK(status({{"Aspect-Token", token}}, "text/plain", "{}") == 415);
  CHECK(status({{"Aspect-Token", token}, {"Origin", "http://evil.example"}}, "application/json",
               "{}") == 403);
  CHECK(status({{"Aspect-Token", token}, {"Host", "evil.example"}}, "application/json", "{}") ==
        403);
  CHECK(status({{"Aspect-Token", token}}, "application/json", std::string(100'000, ' ')) == 413);
  const auto pieces = client.Post(
      "/act/save", {{"Aspect-Token", token}},
      [](std::size_t, httplib::DataSink& sink) {
        sink.write("{}", 2);
        sink.done();
        return true;
      },
      "application/json");
  CHECK((!pieces || pieces->status == 411));
  CHECK(desk.acts == 0);
  // No other page is let in on it.
  CHECK_FALSE(client.Options("/act/save")->has_header("Access-Control-Allow-Origin"));
}

TEST_CASE("a loopback page is not shown under a foreign name") {
  const auto outputs = opened_page();
  httplib::Client client("127.0.0.1", outputs->http_port());
  CHECK(client.Get("/", {{"Host", "rebound.example:8080"}})->status == 403);
  CHECK(client.Get("/", {{"Host", "localhost:8080"}})->status == 200);
  CHECK(client.Get("/", {{"Host", "[::1]:8080"}})->status == 200);
}

TEST_CASE("a reader that takes nothing of a large view keeps nobody else waiting") {
  MadeDesk desk;
  const auto outputs = opened_page(&desk);
  std::vector<Descriptor> still;
  for (int k = 0; k < 3; ++k) {
    still.push_back(connect_tcp(outputs->http_port()));
    const std::string request = "GET /view HTTP/1.1\r\nHost: localhost\r\n\r\n";
    REQUIRE(::write(still.back().get(), request.data(), request.size()) ==
            static_cast<ssize_t>(request.size()));
  }
  httplib::Client client("127.0.0.1", outputs->http_port());
  const auto before = std::chrono::steady_clock::now();
  CHECK(client.Get("/state")->status == 200);
  CHECK(std::chrono::steady_clock::now() - before < std::chrono::milliseconds(500));
}

TEST_CASE("a page's port that is in use is an error, and pages that stand still hold nothing up") {
  auto outputs = opened_page();
  const int port = outputs->http_port();
  CHECK_THAT(Outputs::open({.http = HttpOutput{"127.0.0.1", port}}).error(),
             Contains("is the port in use"));
  const Descriptor still = connect_tcp(port), too = connect_tcp(port);
  httplib::Client client("127.0.0.1", port);
  CHECK(client.Get("/")->status == 200);
  const auto before = std::chrono::steady_clock::now();
  outputs.reset();
  CHECK(std::chrono::steady_clock::now() - before < std::chrono::seconds(3));
}

}  // namespace aspect
