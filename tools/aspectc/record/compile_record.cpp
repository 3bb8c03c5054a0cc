#include "tools/aspectc/record/compile_record.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <utility>

#include "tools/aspectc/record/content_hash.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHead = "aspectc inputs 1 ";
constexpr std::uintmax_t kMaxBytes = std::uintmax_t{64} << 20;

// Names of files may hold any byte.
std::string on_one_line(std::string_view text) {
  std::string line;
  for (const char c : text)
    if (c >= ' ' && c <= '~' && c != '%')
      line += c;
    else
      line += fmt::format("%{:02x}", static_cast<unsigned char>(c));
  return line;
}

std::optional<std::string> from_one_line(std::string_view line) {
  std::string text;
  for (std::size_t k = 0; k < line.size(); ++k) {
    if (line[k] != '%') {
      text += line[k];
      continue;
    }
    unsigned byte = 0;
    if (line.size() - k < 3) return std::nullopt;
    const char* digits = line.data() + k + 1;
    if (std::from_chars(digits, digits + 2, byte, 16).ptr != digits + 2) return std::nullopt;
    text += static_cast<char>(byte);
    k += 2;
  }
  return text;
}

// Up to the separator, which goes too; all where there is none.
std::string_view take_until(std::string_view& text, char separator) {
  const std::size_t end = std::min(text.find(separator), text.size());
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return taken;
}

// False where the line means nothing.
bool add_line(CompileRecord& record, std::string_view key, std::string_view rest) {
  std::string hash;
  if (key == "file") hash = take_until(rest, ' ');
  const std::optional<std::string> value = from_one_line(rest);
  if (!value) return false;
  if (key == "object") record.objects.push_back({*value, {}, {}, {}, {}, {}});
  if (key == "program") record.program = *value;
  if (key == "index") record.index_hash = *value;
  if (key == "object" || key == "program" || key == "index") return true;
  if (record.objects.empty()) return false;
  RecordedObject& object = record.objects.back();
  if (key == "scene")
    object.scene = *value;
  else if (key == "store")
    object.store = *value;
  else if (key == "settings")
    object.settings = *value;
  else if (key == "file")
    object.inputs.push_back({*value, hash});
  else if (key == "warning")
    object.warnings.push_back(*value);
  else
    return false;
  return true;
}

}  // namespace

fs::path record_file_of(const fs::path& index) {
  return index.native() + ".inputs";
}

std::string record_text(const CompileRecord& record) {
  std::string lines = fmt::format("program {}\nindex {}\n", record.program, record.index_hash);
  const auto add = [&](std::string_view key, std::string_view text) {
    lines += fmt::format("{} {}\n", key, on_one_line(text));
  };
  for (const RecordedObject& object : record.objects) {
    add("object", object.name);
    add("scene", object.scene);
    add("store", object.store);
    add("settings", object.settings);
    for (const RecordedFile& file : object.inputs) add("file " + file.hash, file.name);
    for (const std::string& warning : object.warnings) add("warning", warning);
  }
  return fmt::format("{}{}\n{}", kHead, content_hash(lines), lines);
}

std::optional<CompileRecord> parse_record(std::string_view text) {
  const std::string_view head = take_until(text, '\n');
  if (head != fmt::format("{}{}", kHead, content_hash(text))) return std::nullopt;
  CompileRecord record;
  while (!text.empty()) {
    std::string_view line = take_until(text, '\n');
    const std::string_view key = take_until(line, ' ');
    if (!add_line(record, key, line)) return std::nullopt;
  }
  return record;
}

std::optional<CompileRecord> read_record(const fs::path& index) {
  const fs::path file = record_file_of(index);
  std::error_code unknown;
  if (!fs::is_regular_file(file, unknown) || fs::file_size(file, unknown) > kMaxBytes)
    return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  return stream ? parse_record(text) : std::nullopt;
}

// Without the dots that change nothing; ".." stays, since what stands before it may be a link.
std::string recorded_name(const fs::path& file, const fs::path& folder) {
  const auto plain = [](const fs::path& path) {
    fs::path kept;
    std::error_code unknown;
    for (const fs::path& part : fs::absolute(path, unknown))
      if (part != "." && !part.empty()) kept /= part;
    return kept;
  };
  const std::string whole = plain(file).string(), beginning = plain(folder).string() + "/";
  return whole.starts_with(beginning) ? whole.substr(beginning.size()) : whole;
}

std::vector<RecordedFile> recorded_files(const std::vector<std::string>& files,
                                         const fs::path& folder) {
  std::vector<RecordedFile> recorded;
  for (const std::string& file : files) recorded.push_back({recorded_name(file, folder), {}});
  std::sort(recorded.begin(), recorded.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  recorded.erase(std::unique(recorded.begin(), recorded.end()), recorded.end());
  return files_now(recorded, folder);
}

std::vector<RecordedFile> files_now(const std::vector<RecordedFile>& recorded,
                                    const fs::path& folder) {
  std::vector<RecordedFile> now = recorded;
  for (RecordedFile& file : now) file.hash = content_hash_of_file(folder / file.name);
  return now;
}

std::timespec file_time_now() {
  std::timespec now{};
  ::clock_gettime(CLOCK_REALTIME_COARSE, &now);
  return now;
}

// By the time of the last change of whatever kind, which no program can set back; that of its
// folder tells of a file that is gone.
bool has_changed_since(const fs::path& file, const std::timespec& time) {
  struct stat status {};
  if (::stat(file.c_str(), &status) != 0 && ::stat(file.parent_path().c_str(), &status) != 0)
    return false;
  const std::timespec& changed = status.st_ctim;
  return std::pair(changed.tv_sec, changed.tv_nsec) >= std::pair(time.tv_sec, time.tv_nsec);
}

}  // namespace aspect
