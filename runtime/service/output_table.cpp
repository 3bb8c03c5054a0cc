#include "runtime/service/output_table.h"

#include "runtime/service/table_reader.h"

namespace aspect {
namespace {

constexpr ClosedRange<int> kPorts{1, 65535};

// A text that must be there and say something.
std::string needed(TableReader& reader, std::string_view key) {
  std::optional<std::string> text;
  reader.read(key, text);
  reader.require(key);
  if (text && text->empty()) reader.fail(key, "is empty; give one");
  return text.value_or("");
}

template <typename Value>
void read_into(TableReader& reader, std::string_view key, Value& value) {
  std::optional<Value> found;
  reader.read(key, found);
  if (found) value = *std::move(found);
}

template <typename Number>
void read_into(TableReader& reader, std::string_view key, ClosedRange<Number> range,
               Number& value) {
  std::optional<Number> found;
  reader.read(key, range, found);
  if (found) value = *found;
}

void read_file(TableReader& reader, FileOutput& output) {
  output.path = needed(reader, "path");
  int mebibytes = static_cast<int>(output.max_bytes >> 20U);
  read_into(reader, "max_mib", {1, 1 << 20}, mebibytes);
  output.max_bytes = static_cast<std::uint64_t>(mebibytes) << 20U;
  read_into(reader, "keep", {0, 1000}, output.keep);
}

void read_socket(TableReader& reader, std::filesystem::path& path) {
  path = needed(reader, "path");
}

void read_tcp(TableReader& reader, TcpOutput& output) {
  read_into(reader, "address", output.address);
  read_into(reader, "port", kPorts, output.port);
  reader.require("port");
}

void read_mqtt(TableReader& reader, MqttOutput& output) {
  read_into(reader, "host", output.host);
  read_into(reader, "port", kPorts, output.port);
  read_into(reader, "topic", output.topic);
  if (output.topic.empty() || output.topic.find_first_of("+#") != std::string::npos)
    reader.fail("topic", "must be the name of one topic, without + and #");
  read_into(reader, "client", output.client);
  read_into(reader, "user", output.user);
  std::string password_file;
  read_into(reader, "password_file", password_file);
  output.password_file = password_file;
  if (!password_file.empty() && output.user.empty())
    reader.fail("password_file", "is of no use without user; add it");
}

void read_http(TableReader& reader, HttpOutput& output) {
  read_into(reader, "address", output.address);
  read_into(reader, "port", kPorts, output.port);
  std::string folder;
  read_into(reader, "record", folder);
  output.record = folder;
}

void read_trigger(TableReader& reader, TriggerOutput& output) {
  output.object = needed(reader, "object");
  read_into(reader, "score_min", {0.0, 1e300}, output.score_min);
  read_into(reader, "frames", {1, 100000}, output.frames);
  read_into(reader, "command", output.command);
  read_into(reader, "gpio_chip", output.gpio_chip);
  read_into(reader, "gpio_line", {0, 65535}, output.gpio_line);
  if (output.command.empty() && output.gpio_chip.empty() && output.gpio_line < 0)
    reader.fail("command", "is missing; add it, or gpio_chip and gpio_line");
  if (output.gpio_chip.empty() != (output.gpio_line < 0))
    reader.fail(output.gpio_chip.empty() ? "gpio_line" : "gpio_chip",
                "is only half of it; give both gpio_chip and gpio_line");
}

// Tables of [output], each read with its own reader.
class OutputTables {
 public:
  OutputTables(TableReader& reader, const std::string& file) : reader_(reader), file_(file) {}

  template <typename Output>
  void read(std::string_view key, std::optional<Output>& output,
            void (*fill)(TableReader&, Output&)) {
    const toml::table* table = reader_.table(key);
    if (table == nullptr) return;
    output.emplace();
    read_one(*table, key, *output, fill);
  }

  template <typename Output>
  void read_all(std::string_view key, std::vector<Output>& outputs,
                void (*fill)(TableReader&, Output&)) {
    const auto tables = reader_.tables(key);
    if (!tables.empty()) outputs.clear();
    for (const toml::table* table : tables) read_one(*table, key, outputs.emplace_back(), fill);
  }

  const std::optional<Error>& error() const { return error_; }

 private:
  template <typename Output>
  void read_one(const toml::table& table, std::string_view key, Output& output,
                void (*fill)(TableReader&, Output&)) {
    TableReader inner(table, file_, "output." + std::string(key));
    fill(inner, output);
    if (auto error = inner.finish(); error && !error_) error_ = std::move(error);
  }

  TableReader& reader_;
  const std::string& file_;
  std::optional<Error> error_;
};

}  // namespace

std::optional<Error> read_outputs(const toml::table& table, const std::string& file,
                                  OutputSettings& settings) {
  TableReader reader(table, file, "output");
  read_into(reader, "stdout", settings.standard_output);
  OutputTables tables(reader, file);
  tables.read("file", settings.file, read_file);
  tables.read("socket", settings.unix_socket, read_socket);
  tables.read("tcp", settings.tcp, read_tcp);
  tables.read("mqtt", settings.mqtt, read_mqtt);
  tables.read("http", settings.http, read_http);
  tables.read_all("trigger", settings.triggers, read_trigger);
  if (auto error = reader.finish()) return error;
  return tables.error();
}

}  // namespace aspect
