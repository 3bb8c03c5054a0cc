#include <httplib.h>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "runtime/output/outputs.h"
#include "tests/runtime/output/output_clients.h"

namespace aspect {
namespace {

using Catch::Matchers::Contains;

std::unique_ptr<Outputs> opened_page() {
  auto outputs = Outputs::open({.http = HttpOutput{"127.0.0.1", 0}});
  if (!outputs) FAIL(outputs.error());
  return std::move(outputs).value();
}

}  // namespace

TEST_CASE("a page, its picture and the line that belongs to it are served") {
  const auto outputs = opened_page();
  httplib::Client client("127.0.0.1", outputs->http_port());
  const auto page = client.Get("/");
  REQUIRE(page);
  CHECK(page->status == 200);
  CHECK_THAT(page->body, Contains("<canvas"));
  // Nothing comes from anywhere else.
  CHECK(page->body.find("http:") == std::string::npos);
  CHECK(page->body.find("https:") == std::string::npos);

  outputs->publish("{\"sequence\": 0}\n");
  CHECK_FALSE(outputs->wants_picture());
  CHECK(client.Get("/picture.bmp")->status == 204);
  CHECK(outputs->wants_picture());
  const std::vector<std::uint8_t> grey(640 * 480, 77);
  outputs->show_picture({grey.data(), 640, 480, 640, PixelFormat::grey8});
  outputs->publish("{\"sequence\": 1}\n");
  CHECK_FALSE(outputs->wants_picture());

  const auto picture = client.Get("/picture.bmp");
  REQUIRE(picture);
  CHECK(picture->status == 200);
  CHECK(picture->get_header_value("Aspect-Line") == "1");
  CHECK(picture->body.size() == 54 + 320 * 240 * 3);
  CHECK(picture->body.substr(54) == std::string(320 * 240 * 3, 77));
  CHECK(client.Get("/picture.bmp?after=1")->status == 204);

  const auto line = nlohmann::json::parse(client.Get("/line?number=1")->body);
  CHECK(line["line"]["sequence"] == 1);
  CHECK(line["lines"] == 2);
  CHECK(nlohmann::json::parse(client.Get("/line")->body) == line);
  CHECK(nlohmann::json::parse(client.Get("/line?number=2")->body)["line"].is_null());
  CHECK(client.Get("/nothing")->status == 404);
}

TEST_CASE("a loopback page is not shown under a foreign name") {
  const auto outputs = opened_page();
  httplib::Client client("127.0.0.1", outputs->http_port());
  CHECK(client.Get("/", {{"Host", "rebound.example:8080"}})->status == 403);
  CHECK(client.Get("/", {{"Host", "localhost:8080"}})->status == 200);
  CHECK(client.Get("/", {{"Host", "[::1]:8080"}})->status == 200);
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
