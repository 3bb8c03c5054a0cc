// Who may see a page, and who may change something through it. The dangers are pages of others in
// the same browser: they can send requests here (cross-site request forgery), and make a name of
// theirs resolve to this machine (DNS rebinding); and whoever else reaches the port.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace aspect {

// 128 bits of the kernel's randomness as 32 hexadecimal digits; empty where there is none.
std::string random_token();

// Headers as they came; empty: none.
struct PageRequest {
  bool changes = false;  // asks for a change: POST
  std::string host, origin, fetch_site, content_type, content_length, transfer_encoding,
      content_encoding, token;
};

struct PageRefusal {
  int status = 403;  // of HTTP
  std::string_view reason;
};

class PageGuard {
 public:
  static constexpr std::size_t kMostBodyBytes = 64U << 10U;

  PageGuard() = default;
  // `address` is what is listened at.
  PageGuard(const std::string& address, std::string token);

  // Before anything of the body is read. Reading needs a Host that no stranger's name can be: an
  // address in numbers, localhost or this machine's own name; at a loopback address only those of
  // the loopback. A change needs the token as well, JSON of a known length, and where a browser
  // says which page asks, that it is this one.
  std::optional<PageRefusal> refusal(const PageRequest& request) const;

  const std::string& token() const { return token_; }

 private:
  bool knows_host(const std::string& authority) const;

  bool loopback_ = true;
  std::string own_name_, token_;
};

}  // namespace aspect
