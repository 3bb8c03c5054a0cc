// Tables: `key` holds what the store belongs to, `views` the views by direction, `matches` the
// matches by the row ids of their views, the smaller first, `runs` what was asked for and is
// complete. A direction is the 24 bytes of its three doubles: SQLite's own REAL would lose the sign
// of -0.0.
#include "compiler/store/store_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <system_error>

namespace aspect {
namespace {

constexpr std::int64_t kApplicationId = 0x41737063;  // "Aspc"; bytes 68 to 71 of the file
constexpr std::int64_t kSchemaVersion = 2;

constexpr const char* kSchema = R"(
  CREATE TABLE key (
    scene_hash TEXT NOT NULL,
    options TEXT NOT NULL,
    compiler TEXT NOT NULL,
    object TEXT NOT NULL);
  CREATE TABLE views (
    id INTEGER PRIMARY KEY,
    direction BLOB NOT NULL UNIQUE,
    view BLOB NOT NULL);
  CREATE TABLE matches (
    smaller INTEGER NOT NULL REFERENCES views,
    larger INTEGER NOT NULL REFERENCES views,
    from_larger INTEGER NOT NULL,
    cost REAL NOT NULL,
    mapping BLOB NOT NULL,
    PRIMARY KEY (smaller, larger)) WITHOUT ROWID;
  CREATE TABLE runs (
    level INTEGER NOT NULL,
    min_level INTEGER NOT NULL,
    threshold REAL NOT NULL,
    views INTEGER NOT NULL,
    PRIMARY KEY (level, min_level, threshold)) WITHOUT ROWID;
)";

// The text from shortly before its first difference to the other, cut to a length that leaves the
// message readable and without line ends.
std::string excerpt(const std::string& text, const std::string& other) {
  constexpr std::size_t kBefore = 24;
  constexpr std::size_t kLongest = 72;
  const auto differ = std::mismatch(text.begin(), text.end(), other.begin(), other.end());
  const auto at = static_cast<std::size_t>(differ.first - text.begin());
  const std::size_t begin = at > kBefore ? at - kBefore : 0;
  std::string part = text.substr(begin, kLongest);
  std::replace_if(
      part.begin(), part.end(), [](char c) { return c == '\n' || c == '\r' || c == '\t'; }, ' ');
  return fmt::format("'{}{}{}'", begin > 0 ? "..." : "", part,
                     begin + kLongest < text.size() ? "..." : "");
}

// An empty file, or one whose creation was cut short before its only transaction.
bool is_blank(const SqliteDatabase& database) {
  const std::int64_t application = database.query_integer("PRAGMA application_id");
  const std::int64_t tables = database.query_integer("SELECT count(*) FROM sqlite_master");
  if (application == 0 && tables == 0) return true;
  if (application == kApplicationId) return false;
  database.fail("a database of another program, not a store of aspectc; pass another --store");
}

void check_version(const SqliteDatabase& database) {
  const std::int64_t version = database.query_integer("PRAGMA user_version");
  if (version == kSchemaVersion) return;
  database.fail(fmt::format("written by another version of aspectc (store version {}, not {}); {}",
                            version, kSchemaVersion, kStoreRemedy));
}

void check_key(const SqliteDatabase& database, const StoreKey& key) {
  const std::string compiler = database.query_text("SELECT compiler FROM key");
  if (compiler != key.compiler) {
    database.fail(fmt::format("written by another version of aspectc ({}, not {}); {}",
                              excerpt(compiler, key.compiler), excerpt(key.compiler, compiler),
                              kStoreRemedy));
  }
  const std::string scene_hash = database.query_text("SELECT scene_hash FROM key");
  if (scene_hash != key.scene_hash) {
    database.fail(fmt::format("holds the views of another scene (hash {}, now {}); {}",
                              excerpt(scene_hash, key.scene_hash),
                              excerpt(key.scene_hash, scene_hash), kStoreRemedy));
  }
  const std::string options = database.query_text("SELECT options FROM key");
  if (options != key.options) {
    database.fail(fmt::format("was made with other options ({}, now {}); {}",
                              excerpt(options, key.options), excerpt(key.options, options),
                              kStoreRemedy));
  }
}

// SQLite reads a last page that is cut short as if zeros followed. It may be cut short honestly
// only while the log still holds what a killed process was about to write there.
bool is_cut_short(const SqliteDatabase& database, const std::filesystem::path& path) {
  std::error_code unknown;
  const std::uintmax_t log_bytes = std::filesystem::file_size(path.string() + "-wal", unknown);
  if (!unknown && log_bytes > 0) return false;
  const std::int64_t pages = database.query_integer("PRAGMA page_count");
  const std::int64_t page_bytes = database.query_integer("PRAGMA page_size");
  const std::uintmax_t bytes = std::filesystem::file_size(path, unknown);
  return !unknown && bytes < static_cast<std::uintmax_t>(pages * page_bytes);
}

void check_soundness(const SqliteDatabase& database, const std::filesystem::path& path) {
  const std::string verdict = is_cut_short(database, path)
                                  ? "its end is missing"
                                  : database.query_text("PRAGMA quick_check(1)");
  if (verdict == "ok") return;
  database.fail(fmt::format("damaged ({}); {}", excerpt(verdict, {}), kStoreRemedy));
}

void configure(SqliteDatabase& database) {
  if (database.query_text("PRAGMA journal_mode = WAL") != "wal") {
    database.fail("its file system cannot hold a store; pass another --store");
  }
  database.execute("PRAGMA synchronous = NORMAL");
}

void create(SqliteDatabase& database, const StoreKey& key) {
  database.execute(
      fmt::format("BEGIN EXCLUSIVE; PRAGMA application_id = {}; PRAGMA user_version = {}; {}",
                  kApplicationId, kSchemaVersion, kSchema));
  SqliteStatement insert = database.prepare("INSERT INTO key VALUES (?1, ?2, ?3, ?4)");
  insert.bind(1, key.scene_hash);
  insert.bind(2, key.options);
  insert.bind(3, key.compiler);
  insert.bind(4, key.object);
  insert.step();
  database.execute("COMMIT");
}

}  // namespace

// Nothing is written before the file is known to be ours.
std::unique_ptr<SqliteDatabase> open_store_file(const std::filesystem::path& path,
                                                const StoreKey* key) {
  std::error_code unknown;
  if (key == nullptr && !std::filesystem::exists(path, unknown))
    throw SqliteFailure{fmt::format("{}: no such file; check the path", path.string())};
  auto database = std::make_unique<SqliteDatabase>(path);
  const bool blank = is_blank(*database);
  if (blank && key == nullptr) database->fail("empty; a store is made by compiling a scene");
  if (!blank) {
    check_version(*database);
    if (key != nullptr) check_key(*database, *key);
    check_soundness(*database, path);
  }
  configure(*database);
  if (blank) create(*database, *key);
  return database;
}

StoreContents contents_of(const SqliteDatabase& database) {
  StoreContents contents;
  contents.key = {database.query_text("SELECT scene_hash FROM key"),
                  database.query_text("SELECT options FROM key"),
                  database.query_text("SELECT compiler FROM key"),
                  database.query_text("SELECT object FROM key")};
  contents.views = static_cast<std::size_t>(database.query_integer("SELECT count(*) FROM views"));
  contents.matches =
      static_cast<std::size_t>(database.query_integer("SELECT count(*) FROM matches"));
  SqliteStatement row = database.prepare(
      "SELECT level, min_level, threshold, views FROM runs ORDER BY level, min_level, threshold");
  while (row.step())
    contents.runs.push_back({static_cast<int>(row.integer(0)), static_cast<int>(row.integer(1)),
                             row.real(2), static_cast<std::size_t>(row.integer(3))});
  return contents;
}

}  // namespace aspect
