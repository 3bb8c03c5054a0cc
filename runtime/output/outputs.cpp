#include "runtime/output/outputs.h"

#include <vector>

#include "runtime/output/file_lines.h"
#include "runtime/output/line_ring.h"
#include "runtime/output/listener.h"
#include "runtime/output/live_page.h"
#include "runtime/output/mqtt_output.h"
#include "runtime/output/output_counters.h"
#include "runtime/output/stream_output.h"
#include "runtime/output/triggers.h"

namespace aspect {

static_assert(Outputs::kMaxLineBytes == LineRing::kMaxLineBytes);

struct Outputs::Parts {
  LineRing ring;
  OutputCounters counters;
  std::vector<std::unique_ptr<LineOutput>> outputs;  // that are woken for every line
  const StreamOutput* streams = nullptr;
  std::unique_ptr<Triggers> triggers;
  std::unique_ptr<LivePage> page;

  template <typename Output>
  std::optional<Error> take(Result<std::unique_ptr<Output>> opened) {
    if (!opened) return Error{opened.error()};
    outputs.push_back(std::move(opened).value());
    return std::nullopt;
  }
  std::optional<Error> open(const OutputSettings& settings, PageDesk* desk);
};

std::optional<Error> Outputs::Parts::open(const OutputSettings& settings, PageDesk* desk) {
  if (settings.standard_output || settings.unix_socket || settings.tcp) {
    auto opened = StreamOutput::open(settings, ring, counters);
    if (opened) streams = opened.value().get();
    if (auto error = take(std::move(opened))) return error;
  }
  if (settings.file)
    if (auto error = take(FileLines::open(*settings.file, ring, counters))) return error;
  if (settings.mqtt)
    if (auto error = take(open_mqtt_output(*settings.mqtt, ring, counters))) return error;
  if (settings.http) {
    auto opened = open_live_page(*settings.http, ring, counters, desk);
    if (!opened) return Error{opened.error()};
    page = std::move(opened).value();
  }
  if (!settings.triggers.empty()) {
    auto opened = Triggers::open(settings.triggers);
    if (!opened) return Error{opened.error()};
    triggers = std::move(opened).value();
  }
  return std::nullopt;
}

Outputs::Outputs() : parts_(std::make_unique<Parts>()) {}

std::optional<Error> Outputs::check(const OutputSettings& settings) {
  if (settings.tcp)
    if (auto address = numeric_address("tcp", settings.tcp->address, 0); !address)
      return Error{address.error()};
  if (settings.mqtt)
    if (auto error = check_mqtt()) return error;
  if (settings.http) {
    if (auto error = check_http()) return error;
    if (auto address = numeric_address("http", settings.http->address, 0); !address)
      return Error{address.error()};
  }
  for (const TriggerOutput& trigger : settings.triggers)
    if (auto error = Triggers::check(trigger)) return error;
  return std::nullopt;
}

Result<std::unique_ptr<Outputs>> Outputs::open(const OutputSettings& settings, PageDesk* desk) {
  if (auto error = check(settings)) return *error;
  std::unique_ptr<Outputs> outputs(new Outputs());
  if (auto error = outputs->parts_->open(settings, desk)) return *error;
  return outputs;
}

Outputs::~Outputs() {
  // All at once, so that their seconds run together.
  for (const auto& output : parts_->outputs) output->thread().request_stop();
  if (parts_->triggers) parts_->triggers->thread().request_stop();
}

void Outputs::publish(std::string_view line) noexcept {
  if (!parts_->ring.publish(line)) {
    ++parts_->counters.lines_lost;
    return;
  }
  for (const auto& output : parts_->outputs) output->thread().wake();
}

void Outputs::report_seen(std::span<const SeenName> seen) noexcept {
  if (parts_->triggers) parts_->triggers->report_seen(seen);
}

OutputCounts Outputs::counts() const noexcept {
  const OutputCounters& counters = parts_->counters;
  return {parts_->ring.published(), counters.readers.load(),    counters.readers_dropped,
          counters.readers_refused, counters.lines_lost.load(), counters.standard_output_closed};
}

int Outputs::tcp_port() const {
  return parts_->streams ? parts_->streams->tcp_port() : 0;
}

int Outputs::http_port() const {
  return parts_->page ? parts_->page->port() : 0;
}

std::string Outputs::http_address() const {
  return parts_->page ? parts_->page->address() : std::string();
}

}  // namespace aspect
