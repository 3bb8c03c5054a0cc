// Tables: `key` holds what the store belongs to, `views` the views by direction, `matches` the
// matches by the row ids of their views, the smaller first. A direction is the 24 bytes of its
// three doubles: SQLite's own REAL would lose the sign of -0.0.
#include "compiler/store/store.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <system_error>
#include <utility>

#include "compiler/store/sqlite_database.h"
#include "runtime/base/check.h"

namespace aspect {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kCommitInterval{1};
constexpr std::int64_t kApplicationId = 0x41737063;  // "Aspc"; bytes 68 to 71 of the file
constexpr std::int64_t kSchemaVersion = 1;

constexpr const char* kSchema = R"(
  CREATE TABLE key (scene_hash TEXT NOT NULL, options TEXT NOT NULL);
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
)";

constexpr const char* kAddView = R"(
  INSERT INTO views (direction, view) VALUES (?1, ?2)
  ON CONFLICT (direction) DO UPDATE SET view = excluded.view)";

constexpr const char* kAddMatch = R"(
  INSERT OR REPLACE INTO matches (smaller, larger, from_larger, cost, mapping)
  VALUES (?1, ?2, ?3, ?4, ?5))";

constexpr const char* kEachMatch = R"(
  SELECT f.direction, t.direction, cost, mapping FROM matches
  LEFT JOIN views f ON f.id = CASE WHEN from_larger THEN larger ELSE smaller END
  LEFT JOIN views t ON t.id = CASE WHEN from_larger THEN smaller ELSE larger END
  ORDER BY smaller, larger)";

using DirectionBytes = std::array<std::byte, 3 * sizeof(double)>;

DirectionBytes bytes_of(const Eigen::Vector3d& direction) {
  DirectionBytes bytes;
  std::memcpy(bytes.data(), direction.data(), bytes.size());
  return bytes;
}

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
  SqliteStatement insert = database.prepare("INSERT INTO key VALUES (?1, ?2)");
  insert.bind(1, key.scene_hash);
  insert.bind(2, key.options);
  insert.step();
  database.execute("COMMIT");
}

// Nothing is written before the file is known to be ours.
std::unique_ptr<SqliteDatabase> open_database(const std::filesystem::path& path,
                                              const StoreKey& key) {
  auto database = std::make_unique<SqliteDatabase>(path);
  const bool blank = is_blank(*database);
  if (!blank) {
    check_version(*database);
    check_key(*database, key);
    check_soundness(*database, path);
  }
  configure(*database);
  if (blank) create(*database, key);
  return database;
}

// The border between what throws and what returns.
template <typename Work>
auto outcome_of(const Work& work) -> Result<decltype(work())> {
  try {
    return work();
  } catch (const SqliteFailure& failure) {
    return Error{failure.message};
  }
}

}  // namespace

struct Store::State {
  explicit State(std::unique_ptr<SqliteDatabase> sound) : database(std::move(sound)) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State();

  void begin();
  void commit_if_due();
  void commit();
  std::int64_t view_id(const Eigen::Vector3d& direction);
  Eigen::Vector3d direction(const SqliteStatement& row, int column) const;

  std::unique_ptr<SqliteDatabase> database;
  SqliteStatement add_view = database->prepare(kAddView);
  SqliteStatement find_view = database->prepare("SELECT id FROM views WHERE direction = ?1");
  SqliteStatement add_match = database->prepare(kAddMatch);
  SqliteStatement each_view = database->prepare("SELECT direction, view FROM views ORDER BY id");
  SqliteStatement each_match = database->prepare(kEachMatch);
  Clock::time_point first_write;
};

Store::State::~State() {
  try {
    commit();
  } catch (const SqliteFailure&) {
    // Whoever wants to know calls flush().
  }
}

void Store::State::begin() {
  if (database->in_transaction()) return;
  database->execute("BEGIN");
  first_write = Clock::now();
}

void Store::State::commit_if_due() {
  if (Clock::now() - first_write >= kCommitInterval) commit();
}

void Store::State::commit() {
  if (database->in_transaction()) database->execute("COMMIT");
}

std::int64_t Store::State::view_id(const Eigen::Vector3d& direction) {
  const DirectionBytes bytes = bytes_of(direction);
  const StatementReset reset(find_view);
  find_view.bind(1, Bytes(bytes));
  if (!find_view.step()) {
    database->fail(fmt::format("a match of a view that was never added ({}, {}, {})", direction.x(),
                               direction.y(), direction.z()));
  }
  return find_view.integer(0);
}

Eigen::Vector3d Store::State::direction(const SqliteStatement& row, int column) const {
  const Bytes bytes = row.bytes(column);
  if (bytes.size() != sizeof(DirectionBytes)) {
    database->fail(
        fmt::format("damaged (a direction of {} bytes); {}", bytes.size(), kStoreRemedy));
  }
  Eigen::Vector3d direction;
  std::memcpy(direction.data(), bytes.data(), bytes.size());
  return direction;
}

Store::Store(std::unique_ptr<State> state) : state_(std::move(state)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

Result<Store> Store::open(const std::filesystem::path& path, const StoreKey& key) {
  return outcome_of([&] { return Store(std::make_unique<State>(open_database(path, key))); });
}

Result<Done> Store::each_view(const VisitView& visit) const {
  return outcome_of([&] {
    SqliteStatement& row = state_->each_view;
    const StatementReset reset(row);
    while (row.step()) visit(state_->direction(row, 0), row.bytes(1));
    return Done{};
  });
}

Result<Done> Store::each_match(const VisitMatch& visit) const {
  return outcome_of([&] {
    SqliteStatement& row = state_->each_match;
    const StatementReset reset(row);
    while (row.step()) {
      visit(state_->direction(row, 0), state_->direction(row, 1), row.real(2), row.bytes(3));
    }
    return Done{};
  });
}

Result<Done> Store::add_view(const Eigen::Vector3d& direction, Bytes view) {
  return outcome_of([&] {
    const DirectionBytes bytes = bytes_of(direction);
    SqliteStatement& statement = state_->add_view;
    const StatementReset reset(statement);
    statement.bind(1, Bytes(bytes));
    statement.bind(2, view);
    state_->begin();
    statement.step();
    state_->commit_if_due();
    return Done{};
  });
}

Result<Done> Store::add_match(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double cost,
                              Bytes mapping) {
  ASPECT_CHECK(!std::isnan(cost));
  return outcome_of([&] {
    const std::int64_t from_id = state_->view_id(from);
    const std::int64_t to_id = state_->view_id(to);
    ASPECT_CHECK(from_id != to_id);
    SqliteStatement& statement = state_->add_match;
    const StatementReset reset(statement);
    statement.bind(1, std::min(from_id, to_id));
    statement.bind(2, std::max(from_id, to_id));
    statement.bind(3, std::int64_t{from_id > to_id});
    statement.bind(4, cost);
    statement.bind(5, mapping);
    state_->begin();
    statement.step();
    state_->commit_if_due();
    return Done{};
  });
}

Result<Done> Store::flush() {
  return outcome_of([&] {
    state_->commit();
    return Done{};
  });
}

}  // namespace aspect
