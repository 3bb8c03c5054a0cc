#include "runtime/output/page_guard.h"

#include <unistd.h>
#include <catch2/catch.hpp>
#include <set>

namespace aspect {
namespace {

using Change = std::function<void(PageRequest&)>;

// What a browser sends from the page itself.
PageRequest own_request(bool changes = true) {
  PageRequest request;
  request.changes = changes;
  request.host = "127.0.0.1:8080";
  request.origin = "http://127.0.0.1:8080";
  request.fetch_site = "same-origin";
  request.content_type = "application/json";
  request.content_length = "17";
  request.token = "0123456789abcdef0123456789abcdef";
  return request;
}

const PageGuard& loopback() {
  static const PageGuard guard("127.0.0.1", own_request().token);
  return guard;
}

int status_of(const PageGuard& guard, const PageRequest& request) {
  const auto refusal = guard.refusal(request);
  if (refusal) CHECK_FALSE(refusal->reason.empty());
  return refusal ? refusal->status : 200;
}

int status_after(const Change& change, bool changes = true) {
  PageRequest request = own_request(changes);
  change(request);
  return status_of(loopback(), request);
}

}  // namespace

TEST_CASE("the page itself may change something, and so may a program that has the token") {
  CHECK(status_after([](PageRequest&) {}) == 200);
  CHECK(status_after([](PageRequest& r) { r.origin = r.fetch_site = ""; }) == 200);
  CHECK(status_after([](PageRequest& r) { r.content_type = "Application/JSON; charset=utf-8"; }) ==
        200);
}

TEST_CASE("a change without the token, or with another one, is refused") {
  for (const char* token :
       {"", "0", "0123456789abcdef0123456789abcdee", "0123456789abcdef0123456789abcdef0",
        "0123456789ABCDEF0123456789ABCDEF"})
    CHECK(status_after([token](PageRequest& r) { r.token = token; }) == 403);
  // Where no token could be made nobody may change anything.
  PageRequest request = own_request();
  request.token = "";
  CHECK(status_of(PageGuard("127.0.0.1", ""), request) == 403);
}

TEST_CASE("another page is refused whatever it sends, and may not even read") {
  for (const char* origin :
       {"http://evil.example", "null", "https://127.0.0.1:8080", "http://127.0.0.1:8081",
        "http://127.0.0.1:8080.evil.example", "http://localhost:8080"}) {
    INFO(origin);
    CHECK(status_after([origin](PageRequest& r) { r.origin = origin; }) == 403);
    CHECK(status_after([origin](PageRequest& r) { r.origin = origin; }, false) == 403);
  }
  for (const char* site : {"cross-site", "same-site", "none"})
    CHECK(status_after([site](PageRequest& r) { r.fetch_site = site; }) == 403);
  // A link from elsewhere opens the page.
  CHECK(status_after([](PageRequest& r) { r.origin = "", r.fetch_site = "cross-site"; }, false) ==
        200);
}

TEST_CASE("a name that somebody else made resolve to this machine is refused") {
  const auto under = [](const PageGuard& guard, const std::string& host) {
    PageRequest request = own_request(false);
    request.host = host;
    request.origin = "";
    return status_of(guard, request);
  };
  for (const char* host : {"rebound.example:8080", "", "127.0.0.1.nip.example", "127.evil.example",
                           "[::2]:8080", "10.0.0.7", "0.0.0.0:8080"})
    CHECK(under(loopback(), host) == 403);
  for (const char* host : {"localhost:8080", "LOCALHOST", "127.0.0.1", "127.3.2.1:1", "[::1]:8080"})
    CHECK(under(loopback(), host) == 200);

  const PageGuard everywhere("0.0.0.0", "token");
  char name[256] = "";
  REQUIRE(gethostname(name, sizeof name - 1) == 0);
  for (const std::string host : {"10.0.0.7:8080", "[fe80::1]:8080", "localhost"})
    CHECK(under(everywhere, host) == 200);
  CHECK(under(everywhere, std::string(name) + ":8080") == 200);
  for (const char* host : {"rebound.example:8080", "", "10.0.0.7.evil.example"})
    CHECK(under(everywhere, host) == 403);
}

TEST_CASE("only JSON of a known and small length is read at all") {
  for (const char* type : {"", "text/plain", "application/x-www-form-urlencoded",
                           "multipart/form-data", "application/jsonp", "text/json"})
    CHECK(status_after([type](PageRequest& r) { r.content_type = type; }) == 415);
  for (const char* length : {"", "-1", "1e3", "0x10", "99999999999999999999"})
    CHECK(status_after([length](PageRequest& r) { r.content_length = length; }) == 411);
  CHECK(status_after([](PageRequest& r) { r.content_length = "65536"; }) == 200);
  CHECK(status_after([](PageRequest& r) { r.content_length = "65537"; }) == 413);
  CHECK(status_after([](PageRequest& r) { r.transfer_encoding = "chunked"; }) == 411);
  CHECK(status_after([](PageRequest& r) { r.content_encoding = "gzip"; }) == 411);
}

TEST_CASE("tokens are long and never the same") {
  std::set<std::string> tokens;
  for (int k = 0; k < 100; ++k) tokens.insert(random_token());
  CHECK(tokens.size() == 100);
  for (const std::string& token : tokens) {
    CHECK(token.size() == 32);
    CHECK(token.find_first_not_of("0123456789abcdef") == std::string::npos);
  }
}

}  // namespace aspect
