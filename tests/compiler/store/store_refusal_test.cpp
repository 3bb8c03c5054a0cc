// Files that must not be taken for a store, or not for this one.
#include <sqlite3.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <random>
#include <sstream>

#include "compiler/store/store.h"
#include "tests/compiler/store/store_samples.h"

namespace aspect {
namespace {

using Catch::Contains;

std::string read_file(const std::filesystem::path& path) {
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  return bytes.str();
}

void write_file(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

void run_sql(const std::filesystem::path& path, const char* sql) {
  sqlite3* database = nullptr;
  REQUIRE(sqlite3_open(path.c_str(), &database) == SQLITE_OK);
  CHECK(sqlite3_exec(database, sql, nullptr, nullptr, nullptr) == SQLITE_OK);
  CHECK(sqlite3_close(database) == SQLITE_OK);
}

TEST_CASE("a store of another scene is refused and stays as it is") {
  const TemporaryFolder folder;
  write_sample_store(folder / "a.store");
  const std::string before = read_file(folder / "a.store");
  StoreKey other = sample_key();
  other.scene_hash = "77aa01";
  const std::string message = refusal(folder / "a.store", other);
  CHECK_THAT(message, Contains("another scene") && Contains("3f2a90") && Contains("77aa01"));
  CHECK_THAT(message, Contains("delete it, or pass another --store"));
  CHECK((read_file(folder / "a.store") == before));
}

TEST_CASE("a store of other options is refused with the ones that differ") {
  const TemporaryFolder folder;
  write_sample_store(folder / "a.store");
  StoreKey other = sample_key();
  other.options = "min_level=2 max_level=6 threshold=10000";
  const std::string message = refusal(folder / "a.store", other);
  CHECK_THAT(message, Contains("other options") && Contains("max_level=7"));
  CHECK_THAT(message, Contains("max_level=6") && Contains("delete it, or pass another --store"));
}

TEST_CASE("long options with line ends are refused in one short line") {
  const TemporaryFolder folder;
  StoreKey key = sample_key();
  for (int i = 0; i < 500; ++i) key.options += "\noption_" + std::to_string(i) + " = 1";
  REQUIRE(Store::open(folder / "a.store", key).ok());
  StoreKey other = key;
  other.options.replace(other.options.find("option_250 = 1"), 14, "option_250 = 2");
  const std::string message = refusal(folder / "a.store", other);
  CHECK_THAT(message, Contains("option_250 = 1") && Contains("option_250 = 2"));
  CHECK(message.size() < 400);
}

TEST_CASE("a key may hold any bytes") {
  const TemporaryFolder folder;
  const StoreKey key{std::string("a\0b", 3), "'\"; DROP TABLE views; --"};
  REQUIRE(Store::open(folder / "a.store", key).ok());
  CHECK(Store::open(folder / "a.store", key).ok());
  CHECK_THAT(refusal(folder / "a.store", {"a", key.options}), Contains("another scene"));
}

TEST_CASE("a store of another version is refused") {
  const TemporaryFolder folder;
  write_sample_store(folder / "a.store");
  run_sql(folder / "a.store", "PRAGMA user_version = 1");
  CHECK_THAT(refusal(folder / "a.store", sample_key()), Contains("another version"));
}

TEST_CASE("a store of another version of the compiler is refused, and opens without a key") {
  const TemporaryFolder folder;
  StoreKey key = sample_key();
  key.compiler = "1.2.3";
  key.object = "a part";
  REQUIRE(Store::open(folder / "a.store", key).value().add_finished_run({5, 3, 1e4, 642}).ok());
  StoreKey other = key;
  other.compiler = "1.2.4";
  CHECK_THAT(refusal(folder / "a.store", other),
             Contains("another version of aspectc ('1.2.3', not '1.2.4')"));
  const StoreContents contents =
      Store::open_existing(folder / "a.store").value().contents().value();
  CHECK(contents.key.object == "a part");
  CHECK(contents.key.compiler == "1.2.3");
  CHECK(contents.key.options == key.options);
  REQUIRE(contents.runs.size() == 1);
  CHECK(contents.runs[0].level == 5);
  CHECK(contents.runs[0].views == 642);
  CHECK_FALSE(Store::open_existing(folder / "none.store").ok());
  CHECK_FALSE(std::filesystem::exists(folder / "none.store"));
}

TEST_CASE("another program's database is refused and stays as it is") {
  const TemporaryFolder folder;
  run_sql(folder / "tables", "CREATE TABLE views (a)");
  run_sql(folder / "id", "PRAGMA application_id = 5");
  for (const std::string name : {"tables", "id"}) {
    const std::string before = read_file(folder / name);
    const std::string message = refusal(folder / name, sample_key());
    CHECK_THAT(message, Contains("another program") && Contains("pass another --store"));
    CHECK_FALSE(Contains("delete").match(message));
    CHECK((read_file(folder / name) == before));
  }
}

TEST_CASE("what is no database is refused and stays as it is") {
  const TemporaryFolder folder;
  std::mt19937 random(1);
  std::string noise(20000, '\0');
  for (char& byte : noise) byte = static_cast<char>(random() & 0xff);
  for (const std::string& bytes : {noise, std::string("object cube\n"), std::string("x")}) {
    write_file(folder / "a.store", bytes);
    CHECK_THAT(refusal(folder / "a.store", sample_key()), Contains("not a store of aspectc"));
    CHECK((read_file(folder / "a.store") == bytes));
  }
}

TEST_CASE("a truncated store is refused") {
  const TemporaryFolder folder;
  write_sample_store(folder / "a.store");
  const std::string whole = read_file(folder / "a.store");
  std::vector<std::size_t> sizes{1,
                                 15,
                                 16,
                                 17,
                                 50,
                                 99,
                                 100,
                                 511,
                                 512,
                                 513,
                                 1024,
                                 4095,
                                 4096,
                                 4097,
                                 8192,
                                 whole.size() / 2,
                                 whole.size() - 4096,
                                 whole.size() - 1};
  for (const std::size_t size : sizes) {
    INFO(size << " bytes of " << whole.size());
    write_file(folder / "cut.store", whole.substr(0, size));
    CHECK_THAT(refusal(folder / "cut.store", sample_key()),
               Contains("damaged") || Contains("not a store"));
  }
}

TEST_CASE("a store with wrong bytes is refused or read, but never worse") {
  const TemporaryFolder folder;
  write_sample_store(folder / "a.store");
  const std::string whole = read_file(folder / "a.store");
  std::mt19937 random(2);
  int refused = 0;
  for (int round = 0; round < 300; ++round) {
    std::string bytes = whole;
    const int wrong = 1 << (round % 10);
    for (int i = 0; i < wrong; ++i) bytes[random() % bytes.size()] = static_cast<char>(random());
    const std::filesystem::path path = folder / ("wrong" + std::to_string(round));
    write_file(path, bytes);
    Result<Store> store = Store::open(path, sample_key());
    if (!store) {
      ++refused;
      continue;
    }
    static_cast<void>(store.value().each_view([](const auto&, auto) {}).ok());
    static_cast<void>(store.value().each_match([](const auto&, const auto&, double, auto) {}).ok());
    static_cast<void>(store.value().add_view(sample_direction(1000), {}).ok());
    static_cast<void>(store.value().flush().ok());
  }
  CHECK(refused > 100);
}

TEST_CASE("a direction of the wrong length is damage") {
  const TemporaryFolder folder;
  write_sample_store(folder / "a.store");
  run_sql(folder / "a.store", "UPDATE views SET direction = x'00' WHERE id = 150");
  const Store store = open_sound(folder / "a.store");
  const Result<Done> visited = store.each_view([](const auto&, auto) {});
  REQUIRE_FALSE(visited.ok());
  CHECK_THAT(visited.error(), Contains("damaged"));
}

TEST_CASE("a match whose view is missing is damage") {
  const TemporaryFolder folder;
  write_sample_store(folder / "a.store");
  run_sql(folder / "a.store", "DELETE FROM views WHERE id = 150");
  const Store store = open_sound(folder / "a.store");
  CHECK_FALSE(store.each_match([](const auto&, const auto&, double, auto) {}).ok());
}

TEST_CASE("a missing folder, a folder and a device are refused") {
  const TemporaryFolder folder;
  CHECK_THAT(refusal(folder / "no/such/a.store", sample_key()), Contains("No such file"));
  CHECK_THAT(refusal(folder.path(), sample_key()), Contains("not a regular file"));
  CHECK_THAT(refusal("/dev/null", sample_key()), Contains("not a regular file"));
  CHECK_FALSE(Store::open("", sample_key()).ok());
}

TEST_CASE("names that mean something to SQLite are plain files here") {
  const TemporaryFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  for (const std::string name : {":memory:", "file:a.store?mode=memory"}) {
    CHECK(Store::open(name, sample_key()).ok());
    CHECK(std::filesystem::exists(folder / name));
  }
  std::filesystem::current_path(before);
}

}  // namespace
}  // namespace aspect
