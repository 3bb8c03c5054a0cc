#include "runtime/output/page_guard.h"

#include <arpa/inet.h>
#include <sys/random.h>
#include <unistd.h>
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>

namespace aspect {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

// The host's name in a URL's authority, without port.
std::string host_of(const std::string& authority) {
  const std::size_t end = authority.starts_with('[') ? authority.find(']') : authority.find(':');
  return lower(authority.starts_with('[') ? authority.substr(1, end - 1)
                                          : authority.substr(0, end));
}

bool is_numeric(const std::string& host) {
  std::array<unsigned char, sizeof(in6_addr)> address;
  return ::inet_pton(AF_INET, host.c_str(), address.data()) == 1 ||
         ::inet_pton(AF_INET6, host.c_str(), address.data()) == 1;
}

bool is_loopback(const std::string& host) {
  return is_numeric(host) && (host.starts_with("127.") || host == "::1");
}

std::string machine_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? lower(name.data()) : std::string();
}

// In a time that does not tell how much of it is right.
bool same_secret(const std::string& a, const std::string& b) {
  if (a.size() != b.size()) return false;
  unsigned difference = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    difference |=
        static_cast<unsigned char>(a[k]) ^ static_cast<unsigned>(static_cast<unsigned char>(b[k]));
  return difference == 0;
}

bool is_json(const std::string& content_type) {
  const std::string type = lower(content_type.substr(0, content_type.find(';')));
  return type.substr(0, type.find_last_not_of(" \t") + 1) == "application/json";
}

}  // namespace

std::string random_token() {
  std::array<std::uint8_t, 16> bytes;
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) return {};
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string token;
  for (const std::uint8_t byte : bytes) {
    token += kDigits[byte >> 4U];
    token += kDigits[byte & 15U];
  }
  return token;
}

PageGuard::PageGuard(const std::string& address, std::string token)
    : loopback_(is_loopback(address)), own_name_(machine_name()), token_(std::move(token)) {}

bool PageGuard::knows_host(const std::string& authority) const {
  const std::string host = host_of(authority);
  if (host == "localhost" || is_loopback(host)) return true;
  if (loopback_) return false;
  return is_numeric(host) ||
         (!own_name_.empty() && (host == own_name_ || host == own_name_ + ".local"));
}

std::optional<PageRefusal> PageGuard::refusal(const PageRequest& request) const {
  if (!knows_host(request.host))
    return PageRefusal{403, "Host is not this machine; open the page by the address it listens at"};
  // Of an opaque origin it is "null", which is none of ours either.
  if (!request.origin.empty() && lower(request.origin) != "http://" + lower(request.host))
    return PageRefusal{403, "Origin is another page"};
  if (!request.changes) return std::nullopt;
  if (!request.fetch_site.empty() && request.fetch_site != "same-origin")
    return PageRefusal{403, "Sec-Fetch-Site is another page"};
  if (!is_json(request.content_type))
    return PageRefusal{415, "Content-Type must be application/json"};
  if (!request.transfer_encoding.empty() || !request.content_encoding.empty())
    return PageRefusal{411, "the body must be plain, with a Content-Length"};
  const std::string& length = request.content_length;
  std::uint64_t bytes = 0;
  const auto [end, status] = std::from_chars(length.data(), length.data() + length.size(), bytes);
  if (length.empty() || status != std::errc{} || end != length.data() + length.size())
    return PageRefusal{411, "Content-Length is missing"};
  if (bytes > kMostBodyBytes) return PageRefusal{413, "the body is too large"};
  if (token_.empty() || !same_secret(request.token, token_))
    return PageRefusal{403, "the token is missing or wrong; open the address printed at the start"};
  return std::nullopt;
}

}  // namespace aspect
