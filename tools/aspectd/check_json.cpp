#include <cstdint>

#include "runtime/service/json_text.h"
#include "tools/aspectd/check_report.h"

namespace aspect {
namespace {

void put(JsonText& json, std::string_view key, std::string_view text) {
  json.key(key);
  json.value(text);
}
void put(JsonText& json, std::string_view key, std::int64_t number) {
  json.key(key);
  json.value(number);
}
void put(JsonText& json, std::string_view key, double number) {
  json.key(key);
  json.value(number);
}
void put_bytes(JsonText& json, std::string_view key, std::uint64_t count) {
  put(json, key, static_cast<std::int64_t>(count));
}
void put_lines(JsonText& json, std::string_view key, const std::vector<std::string>& lines) {
  json.key(key);
  json.begin_array();
  for (const std::string& line : lines) json.value(std::string_view(line));
  json.end_array();
}

void put_truth(JsonText& json, std::string_view key, bool truth) {
  json.key(key);
  json.value(truth);
}

void put_camera(JsonText& json, const std::optional<CameraPlan>& camera) {
  json.key("camera");
  if (!camera) return json.json_value("null");
  json.begin_object();
  put(json, "node", camera->node);
  put(json, "driver", camera->driver);
  put(json, "card", camera->card);
  put(json, "bus", camera->bus);
  put(json, "format", camera->fourcc);
  put(json, "width", std::int64_t{camera->width_px});
  put(json, "height", std::int64_t{camera->height_px});
  put(json, "rate_hz", camera->rate_hz);
  put_truth(json, "decoded", camera->decoded);
  put_lines(json, "controls", camera->controls);
  json.end_object();
}

void put_indexes(JsonText& json, const std::vector<CheckedIndex>& indexes) {
  json.key("indexes");
  json.begin_array();
  for (const CheckedIndex& index : indexes) {
    json.begin_object();
    put(json, "object", index.object);
    put_bytes(json, "classes", index.classes);
    put_bytes(json, "key_views", index.key_views);
    json.end_object();
  }
  json.end_array();
}

void put_memory(JsonText& json, const CheckReport& report) {
  if (const Box& part = report.region_of_interest; !part.empty()) {
    json.key("region_of_interest");
    json.begin_object();
    put(json, "x", std::int64_t{part.x});
    put(json, "y", std::int64_t{part.y});
    put(json, "width", std::int64_t{part.width});
    put(json, "height", std::int64_t{part.height});
    json.end_object();
  }
  json.key("memory");
  json.begin_object();
  put_bytes(json, "bytes", report.memory_bytes);
  put(json, "width", std::int64_t{report.width_px});
  put(json, "height", std::int64_t{report.height_px});
  json.end_object();
}

void begin_output(JsonText& json, std::string_view kind) {
  json.begin_object();
  put(json, "kind", kind);
}

void put_address(JsonText& json, std::string_view kind, const std::string& address, int port) {
  begin_output(json, kind);
  put(json, "address", address);
  put(json, "port", std::int64_t{port});
  json.end_object();
}

void put_mqtt(JsonText& json, const MqttOutput& mqtt) {
  begin_output(json, "mqtt");
  put(json, "host", mqtt.host);
  put(json, "port", std::int64_t{mqtt.port});
  put(json, "topic", mqtt.topic);
  json.end_object();
}

void put_outputs(JsonText& json, const OutputSettings& outputs) {
  json.key("outputs");
  json.begin_array();
  if (outputs.standard_output) {
    begin_output(json, "stdout");
    json.end_object();
  }
  if (outputs.file) {
    begin_output(json, "file");
    put(json, "path", outputs.file->path.native());
    put_bytes(json, "max_bytes", outputs.file->max_bytes);
    put(json, "keep", std::int64_t{outputs.file->keep});
    json.end_object();
  }
  if (outputs.unix_socket) {
    begin_output(json, "socket");
    put(json, "path", outputs.unix_socket->native());
    json.end_object();
  }
  if (outputs.tcp) put_address(json, "tcp", outputs.tcp->address, outputs.tcp->port);
  if (outputs.mqtt) put_mqtt(json, *outputs.mqtt);
  if (outputs.http) put_address(json, "http", outputs.http->address, outputs.http->port);
  json.end_array();
}

void put_triggers(JsonText& json, const OutputSettings& outputs) {
  json.key("triggers");
  json.begin_array();
  for (const TriggerOutput& trigger : outputs.triggers) {
    json.begin_object();
    put(json, "object", trigger.object);
    put(json, "score_min", trigger.score_min);
    json.end_object();
  }
  json.end_array();
}

void put_report(JsonText& json, const CheckReport& report) {
  json.begin_object();
  put_truth(json, "right", report.errors.empty());
  put_camera(json, report.camera);
  put_indexes(json, report.indexes);
  put_memory(json, report);
  put_outputs(json, report.outputs);
  put_triggers(json, report.outputs);
  put_lines(json, "warnings", report.warnings);
  put_lines(json, "errors", report.errors);
  json.end_object();
  json.end_line();
}

}  // namespace

std::string check_json(const CheckReport& report) {
  for (std::string text(4096, '\0');; text.resize(2 * text.size())) {
    JsonText json(text);
    put_report(json, report);
    if (!json.fits()) continue;
    text.resize(json.size());
    return text;
  }
}

}  // namespace aspect
