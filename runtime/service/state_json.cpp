#include "runtime/service/state_json.h"

#include "runtime/service/json_text.h"

namespace aspect {

std::size_t write_state_json(std::string_view state, std::string_view camera,
                             std::string_view reason, double time_s, std::span<char> out) noexcept {
  JsonText json(out);
  json.begin_object();
  json.key("state");
  json.value(state);
  json.key("camera");
  json.value(camera);
  if (!reason.empty()) {
    json.key("reason");
    json.value(reason);
  }
  json.key("time_s");
  json.value(time_s);
  json.end_object();
  json.end_line();
  return json.fits() ? json.size() : 0;
}

}  // namespace aspect
