// What stands behind a page: gives it what to show and does what it asks for.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace aspect {

struct PageAnswer {
  int status = 200;                            // of HTTP; others than 200 with a reason, or no body
  std::string_view type = "application/json";  // lives for ever
  std::shared_ptr<const std::string> body;     // null: none
};

// All of it is called from the page's threads, from several at once.
class PageDesk {
 public:
  virtual ~PageDesk() = default;

  // One JSON object: what can be set, and how it is.
  virtual PageAnswer state() = 0;

  // The newest frame as it is seen. 204 where there is nothing newer than view `after` for a while.
  virtual PageAnswer view(std::optional<std::uint64_t> after) = 0;

  // Does what it is told, for who has the token. `json` is the request's body, whatever it is.
  // Where it cannot be done, the answer's "refused" says why.
  virtual PageAnswer act(std::string_view action, const std::string& json) = 0;
};

}  // namespace aspect
