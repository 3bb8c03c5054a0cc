// What is kept beside an index, down to the byte.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "tests/temporary_folder.h"
#include "tools/aspectc/options/option_table.h"
#include "tools/aspectc/record/compile_record.h"
#include "tools/aspectc/record/content_hash.h"
#include "tools/aspectc/record/program_identity.h"
#include "tools/aspectc/record/settings_text.h"

namespace aspect {
namespace {

namespace fs = std::filesystem;

CompileRecord sample() {
  RecordedObject part{"part", "level 3\nscoring 1\n", "part.b", "part.store", {}, {}};
  part.inputs = {{"odd \xff\n%41.mtl", kAbsent}, {"part.b", content_hash("abc")}};
  part.warnings = {"part.b:3: two lines\nin one"};
  return {"program", content_hash("index"), {part, {"other", "", "o.obj", "", {}, {}}}};
}

// Than the option has.
OptionValue another_value(const Option& option, const CompileSettings& settings) {
  std::vector<OptionValue> values = {true, false};
  if (const auto* whole = std::get_if<WholeForm>(&option.form))
    values = {whole->range.least, whole->range.most};
  if (const auto* number = std::get_if<NumberForm>(&option.form))
    values = {number->range.least, number->range.most};
  if (const auto* numbers = std::get_if<NumbersForm>(&option.form))
    values = {std::vector<double>(numbers->count, numbers->range.most)};
  if (std::holds_alternative<WordForm>(option.form)) values = {0, 1};
  return option.get(settings) == values.front() ? values.back() : values.front();
}

}  // namespace

TEST_CASE("hashes are those of the xxhash project") {
  // XXH3 of 128 bits as `xxhsum -H2` prints it.
  CHECK(content_hash("") == "99aa06d3014798d86001c324468d497f");
  const TemporaryFolder folder;
  const std::string large(3'000'000, 'x');
  CHECK(content_hash_of_file(folder.write("x", large)) == content_hash(large));
  CHECK(content_hash_of_file(folder.path() / "none") == kAbsent);
  CHECK(content_hash_of_file(folder.path()) == kAbsent);
}

TEST_CASE("a record is read as it was written, whatever bytes names have") {
  const std::optional<CompileRecord> read = parse_record(record_text(sample()));
  REQUIRE(read);
  CHECK(*read == sample());
}

TEST_CASE("a record with one byte changed, gone or too many is none") {
  const std::string text = record_text(sample());
  for (std::size_t k = 0; k < text.size(); ++k) {
    std::string damaged = text;
    damaged[k] = static_cast<char>(damaged[k] ^ 1);
    CHECK_FALSE(parse_record(damaged));
    CHECK_FALSE(parse_record(text.substr(0, k)));
  }
  CHECK_FALSE(parse_record(text + "\n"));
}

TEST_CASE("names are the same from every folder, and those outside are whole") {
  const fs::path folder = "/a/b";
  CHECK(recorded_name("/a/b/c/d.b", folder) == "c/d.b");
  CHECK(recorded_name("/a/b/./d.b", folder) == "d.b");
  CHECK(recorded_name("/a/bc/d.b", folder) == "/a/bc/d.b");
  CHECK(recorded_name("/a/b/../d.b", folder) == "../d.b");
  CHECK(recorded_name("d.b", ".") == "d.b");
  CHECK(recorded_name(fs::absolute("d.b"), ".") == "d.b");
}

TEST_CASE("a file that comes, goes or changes changes what is recorded of it, a touch does not") {
  const TemporaryFolder folder;
  folder.write("a.b", "one");
  const auto before = recorded_files(
      {folder.path() / "a.b", folder.path() / "m.mtl", folder.path() / "a.b"}, folder.path());
  REQUIRE(before.size() == 2);
  CHECK(before[1] == RecordedFile{"m.mtl", kAbsent});
  fs::last_write_time(folder.path() / "a.b", fs::file_time_type::clock::now());
  CHECK(files_now(before, folder.path()) == before);
  folder.write("m.mtl", "");
  CHECK_FALSE(files_now(before, folder.path()) == before);
  fs::remove(folder.path() / "m.mtl");
  CHECK(files_now(before, folder.path()) == before);
  folder.write("M.mtl", "");  // which a reader may take for it
  CHECK_FALSE(files_now(before, folder.path()) == before);
  fs::remove(folder.path() / "M.mtl");
  CHECK(files_now(before, folder.path()) == before);
  folder.write("a.b", "two");
  CHECK_FALSE(files_now(before, folder.path()) == before);
}

TEST_CASE("a file that is written or goes while it is read is told by its time") {
  const TemporaryFolder folder;
  const fs::path file = folder.write("a.b", "one"), none = folder.path() / "none";
  struct stat status {};
  REQUIRE(::stat(folder.path().c_str(), &status) == 0);
  std::timespec later = status.st_ctim;
  later.tv_nsec = later.tv_nsec + 1;
  CHECK(has_changed_since(file, status.st_ctim));
  CHECK(has_changed_since(none, status.st_ctim));
  CHECK_FALSE(has_changed_since(file, later));
  CHECK_FALSE(has_changed_since(none, later));
}

TEST_CASE("every option but the number of threads stands in the settings' text") {
  for (const Option& option : compile_option_table()) {
    CompileSettings settings;
    const std::string before = settings_text(settings);
    option.set(settings, another_value(option, settings));
    INFO(option.text.flag);
    CHECK((settings_text(settings) == before) == (option.text.key == "jobs"));
  }
}

TEST_CASE("lamps, surfaces and colours of parts stand in the settings' text") {
  const CompileSettings plain;
  std::vector<CompileSettings> all(7, plain);
  all[1].light.lamps.push_back({{1, 2, 3}, {1, 1, 1}, true});
  all[2].light.lamps.push_back({{1, 2, 3}, {1, 1, 1}, false});
  all[3].surfaces.push_back({"p.toml:3", 1, {}, Eigen::Vector3d{1, 0, 0}, {}});
  all[4].surfaces.push_back({"p.toml:3", 1, {}, {}, Eigen::Vector3d{1, 0, 0}});
  all[5].mesh.colours["0"] = {1, 0, 0};
  all[6].mesh.colours["1"] = {1, 0, 0};
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) CHECK(settings_text(all[i]) != settings_text(all[k]));
  CompileSettings moved = all[3];
  moved.surfaces[0].place = "p.toml:9";
  CHECK(settings_text(moved) == settings_text(all[3]));
}

TEST_CASE("a program's identity is its own and stays") {
  CHECK(program_identity() == program_identity());
  CHECK(program_identity() != content_hash(""));
}

}  // namespace aspect
