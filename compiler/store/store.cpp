#include "compiler/store/store.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <utility>

#include "compiler/store/sqlite_database.h"
#include "compiler/store/store_file.h"
#include "runtime/base/check.h"

namespace aspect {
namespace {

using Clock = std::chrono::steady_clock;

// Half of what a kill may cost: the other half is for work that is done but not added yet.
constexpr std::chrono::milliseconds kCommitInterval{500};

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

// Made by the first note, so that stores without any stay as they are.
constexpr const char* kNotes =
    "CREATE TABLE IF NOT EXISTS notes (name TEXT PRIMARY KEY, text TEXT NOT NULL)";

using DirectionBytes = std::array<std::byte, 3 * sizeof(double)>;

DirectionBytes bytes_of(const Eigen::Vector3d& direction) {
  DirectionBytes bytes;
  std::memcpy(bytes.data(), direction.data(), bytes.size());
  return bytes;
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

bool is_store(const std::filesystem::path& file) {
  constexpr std::string_view kMagic = "SQLite format 3";
  if (file.extension() == ".store") return true;
  std::string begin(kMagic.size(), '\0');
  std::ifstream(file, std::ios::binary).read(begin.data(), static_cast<long>(begin.size()));
  return begin == kMagic;
}

Result<Store> Store::open(const std::filesystem::path& path, const StoreKey& key) {
  return outcome_of([&] { return Store(std::make_unique<State>(open_store_file(path, &key))); });
}

Result<Store> Store::open_existing(const std::filesystem::path& path) {
  return outcome_of([&] { return Store(std::make_unique<State>(open_store_file(path, nullptr))); });
}

Result<StoreContents> Store::contents() const {
  return outcome_of([&] { return contents_of(*state_->database); });
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

Result<Done> Store::add_finished_run(const FinishedRun& run) {
  return outcome_of([&] {
    SqliteStatement statement =
        state_->database->prepare("INSERT OR REPLACE INTO runs VALUES (?1, ?2, ?3, ?4)");
    statement.bind(1, std::int64_t{run.level});
    statement.bind(2, std::int64_t{run.min_level});
    statement.bind(3, run.threshold);
    statement.bind(4, static_cast<std::int64_t>(run.views));
    state_->begin();
    statement.step();
    state_->commit();
    return Done{};
  });
}

Result<Done> Store::set_note(const std::string& name, const std::string& text) {
  return outcome_of([&] {
    state_->begin();
    state_->database->execute(kNotes);
    SqliteStatement statement =
        state_->database->prepare("INSERT OR REPLACE INTO notes VALUES (?1, ?2)");
    statement.bind(1, name);
    statement.bind(2, text);
    statement.step();
    return Done{};
  });
}

Result<std::string> Store::note(const std::string& name) const {
  return outcome_of([&]() -> std::string {
    const bool has_notes = state_->database->query_integer(
                               "SELECT count(*) FROM sqlite_master WHERE name = 'notes'") > 0;
    if (!has_notes) return {};
    SqliteStatement statement = state_->database->prepare("SELECT text FROM notes WHERE name = ?1");
    statement.bind(1, name);
    return statement.step() ? statement.text(0) : std::string{};
  });
}

Result<Done> Store::flush() {
  return outcome_of([&] {
    state_->commit();
    return Done{};
  });
}

}  // namespace aspect
