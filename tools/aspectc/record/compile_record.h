// What an index was made from: NAME.aspect.inputs, beside it. A text of one line an item, which
// begins with a hash of all the rest.
#pragma once

#include <ctime>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace aspect {

// Where the file stands, from the folder of the record on if it lies in there, and what it held.
struct RecordedFile {
  std::string name, hash;
  bool operator==(const RecordedFile&) const = default;
};

struct RecordedObject {
  std::string name, settings;
  std::string scene, store;          // as RecordedFile::name; no store: empty
  std::vector<RecordedFile> inputs;  // all that were read or looked for
  std::vector<std::string> warnings;
  bool operator==(const RecordedObject&) const = default;
};

struct CompileRecord {
  std::string program, index_hash;
  std::vector<RecordedObject> objects;  // more than one in a combined index
  bool operator==(const CompileRecord&) const = default;
};

std::filesystem::path record_file_of(const std::filesystem::path& index);

std::string record_text(const CompileRecord& record);

// Nothing where a single byte is not as record_text() wrote it.
std::optional<CompileRecord> parse_record(std::string_view text);

// The record beside an index; nothing where there is none or it is damaged.
std::optional<CompileRecord> read_record(const std::filesystem::path& index);

std::string recorded_name(const std::filesystem::path& file, const std::filesystem::path& folder);

// What the files hold now: sorted, each once.
std::vector<RecordedFile> recorded_files(const std::vector<std::string>& files,
                                         const std::filesystem::path& folder);
std::vector<RecordedFile> files_now(const std::vector<RecordedFile>& recorded,
                                    const std::filesystem::path& folder);

// The time as file systems stamp it, and whether a file may have changed since, touched or written.
std::timespec file_time_now();
bool has_changed_since(const std::filesystem::path& file, const std::timespec& time);

}  // namespace aspect
