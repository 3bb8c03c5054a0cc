#include "compiler/store/sqlite_database.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sqlite3.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace aspect {
namespace {

constexpr const char* kFull =
    "the disk is full; make room and start again, what was done before is kept";

}  // namespace

void SqliteStatement::Finalize::operator()(sqlite3_stmt* statement) const noexcept {
  sqlite3_finalize(statement);
}

SqliteStatement::SqliteStatement(const SqliteDatabase& database, const std::string& sql)
    : database_(database) {
  sqlite3_stmt* statement = nullptr;
  check(sqlite3_prepare_v3(database.handle_.get(), sql.c_str(), -1, SQLITE_PREPARE_PERSISTENT,
                           &statement, nullptr));
  statement_.reset(statement);
}

void SqliteStatement::check(int code) const {
  database_.check(code);
}

void SqliteStatement::bind(int place, std::int64_t value) {
  check(sqlite3_bind_int64(statement_.get(), place, value));
}

void SqliteStatement::bind(int place, double value) {
  check(sqlite3_bind_double(statement_.get(), place, value));
}

// A null destructor is SQLITE_STATIC, whose macro is an old-style cast.
void SqliteStatement::bind(int place, const std::string& text) {
  check(
      sqlite3_bind_text64(statement_.get(), place, text.data(), text.size(), nullptr, SQLITE_UTF8));
}

void SqliteStatement::bind(int place, std::span<const std::byte> bytes) {
  // An empty span may have no address, which SQLite would take for NULL.
  const void* const data = bytes.empty() ? "" : static_cast<const void*>(bytes.data());
  check(sqlite3_bind_blob64(statement_.get(), place, data, bytes.size(), nullptr));
}

bool SqliteStatement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) check(code);
  return false;
}

std::int64_t SqliteStatement::integer(int column) const {
  return sqlite3_column_int64(statement_.get(), column);
}

double SqliteStatement::real(int column) const {
  return sqlite3_column_double(statement_.get(), column);
}

std::string SqliteStatement::text(int column) const {
  const std::span<const std::byte> found = bytes(column);
  return {reinterpret_cast<const char*>(found.data()), found.size()};
}

std::span<const std::byte> SqliteStatement::bytes(int column) const {
  const void* const data = sqlite3_column_blob(statement_.get(), column);
  if (data == nullptr) return {};
  const int size = sqlite3_column_bytes(statement_.get(), column);
  return {static_cast<const std::byte*>(data), static_cast<std::size_t>(size)};
}

void SqliteStatement::reset() noexcept {
  sqlite3_reset(statement_.get());  // its code repeats what step() has thrown
  sqlite3_clear_bindings(statement_.get());
}

void SqliteDatabase::Close::operator()(sqlite3* handle) const noexcept {
  sqlite3_close(handle);
}

SqliteDatabase::SqliteDatabase(const std::filesystem::path& path) : path_(path) {
  check_file();
  // SQLite gives names like "" and ":memory:" a meaning of their own, but none to a path.
  const std::filesystem::path plain = path.is_absolute() ? path : "." / path;
  sqlite3* handle = nullptr;
  constexpr int kFlags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX;
  const int code = sqlite3_open_v2(plain.c_str(), &handle, kFlags, nullptr);
  handle_.reset(handle);
  check(code);
  execute("PRAGMA locking_mode = EXCLUSIVE");
}

// SQLite would find most of this out too, but opens what it may not write for reading, and has
// forgotten the system's reason by the time it gives up.
void SqliteDatabase::check_file() const {
  std::error_code unknown;
  const std::filesystem::file_status status = std::filesystem::status(path_, unknown);
  const bool exists = std::filesystem::exists(status);
  if (exists && !std::filesystem::is_regular_file(status)) {
    fail("not a regular file; pass another --store");
  }
  if (exists && faccessat(AT_FDCWD, path_.c_str(), R_OK | W_OK, AT_EACCESS) != 0) {
    fail(fmt::format("cannot be written ({}); permit it, or pass another --store",
                     std::generic_category().message(errno)));
  }
  const std::filesystem::path folder = path_.has_parent_path() ? path_.parent_path() : ".";
  if (faccessat(AT_FDCWD, folder.c_str(), W_OK | X_OK, AT_EACCESS) != 0) {
    fail(fmt::format("its folder cannot be written ({}); permit it, or pass another --store",
                     std::generic_category().message(errno)));
  }
  // SQLite takes one byte for an empty file.
  if (exists && std::filesystem::file_size(path_, unknown) == 1) {
    fail(fmt::format("not a store of aspectc; {}", kStoreRemedy));
  }
}

void SqliteDatabase::execute(const std::string& sql) {
  check(sqlite3_exec(handle_.get(), sql.c_str(), nullptr, nullptr, nullptr));
}

SqliteStatement SqliteDatabase::first_row(const std::string& sql) const {
  SqliteStatement statement = prepare(sql);
  if (!statement.step()) fail(fmt::format("damaged (no answer to '{}'); {}", sql, kStoreRemedy));
  return statement;
}

std::int64_t SqliteDatabase::query_integer(const std::string& sql) const {
  return first_row(sql).integer(0);
}

std::string SqliteDatabase::query_text(const std::string& sql) const {
  return first_row(sql).text(0);
}

bool SqliteDatabase::in_transaction() const {
  return sqlite3_get_autocommit(handle_.get()) == 0;
}

void SqliteDatabase::check(int code) const {
  if (code != SQLITE_OK) fail(explain(code));
}

void SqliteDatabase::fail(const std::string& reason) const {
  throw SqliteFailure{fmt::format("{}: {}", path_.string(), reason)};
}

std::string SqliteDatabase::explain(int code) const {
  const std::string reason = sqlite3_errmsg(handle_.get());
  constexpr int kPrimary = 0xff;
  switch (code & kPrimary) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "in use by another aspectc; wait for it, or pass another --store";
    case SQLITE_NOTADB:
      return fmt::format("not a store of aspectc; {}", kStoreRemedy);
    case SQLITE_CORRUPT:
      return fmt::format("damaged ({}); {}", reason, kStoreRemedy);
    case SQLITE_FULL:
      return kFull;
    default: {
      const int number = sqlite3_system_errno(handle_.get());
      if (number == ENOSPC || number == EDQUOT) return kFull;
      const std::string detail =
          number == 0 ? reason
                      : fmt::format("{}: {}", reason, std::generic_category().message(number));
      return fmt::format("cannot be read or written ({}); mend that, or pass another --store",
                         detail);
    }
  }
}

}  // namespace aspect
