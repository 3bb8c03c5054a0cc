// SQLite's C interface with owners for its handles. Its errors are thrown as one line, which the
// store turns into a Result. Knows nothing of what the store keeps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

struct sqlite3;
struct sqlite3_stmt;

namespace aspect {

class SqliteDatabase;

// One line: the file, what is wrong with it, and what to do about it.
struct SqliteFailure {
  std::string message;
};

// What a user can do about a file that is of no use.
inline constexpr const char* kStoreRemedy = "delete it, or pass another --store";

// A prepared statement of a database, which must outlive it. Places and columns count as in SQLite:
// places from 1, columns from 0. A place takes a view of the caller's bytes, which must live until
// the statement is reset.
class SqliteStatement {
 public:
  void bind(int place, std::int64_t value);
  void bind(int place, double value);
  void bind(int place, const std::string& text);
  void bind(int place, std::span<const std::byte> bytes);

  bool step();  // true: at a row; false: done

  std::int64_t integer(int column) const;
  double real(int column) const;
  std::string text(int column) const;
  std::span<const std::byte> bytes(int column) const;  // until the next step or reset

  void reset() noexcept;  // makes it ready to be stepped from its start with other values

 private:
  friend class SqliteDatabase;
  struct Finalize {
    void operator()(sqlite3_stmt* statement) const noexcept;
  };

  SqliteStatement(const SqliteDatabase& database, const std::string& sql);
  void check(int code) const;

  const SqliteDatabase& database_;
  std::unique_ptr<sqlite3_stmt, Finalize> statement_;
};

// Resets the statement when it goes out of scope, however that happens.
class StatementReset {
 public:
  explicit StatementReset(SqliteStatement& statement) : statement_(statement) {}
  ~StatementReset() { statement_.reset(); }
  StatementReset(const StatementReset&) = delete;
  StatementReset& operator=(const StatementReset&) = delete;

 private:
  SqliteStatement& statement_;
};

class SqliteDatabase {
 public:
  // Opens or creates a regular file for reading and writing. Nothing is read or locked yet; what
  // the first access locks stays locked until this is gone.
  explicit SqliteDatabase(const std::filesystem::path& path);

  SqliteDatabase(const SqliteDatabase&) = delete;
  SqliteDatabase& operator=(const SqliteDatabase&) = delete;

  SqliteStatement prepare(const std::string& sql) const { return {*this, sql}; }
  void execute(const std::string& sql);  // one or more statements, their rows ignored

  // The first column of the first row.
  std::int64_t query_integer(const std::string& sql) const;
  std::string query_text(const std::string& sql) const;

  bool in_transaction() const;

  // Throws for a reason of ours.
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  friend class SqliteStatement;
  struct Close {
    void operator()(sqlite3* handle) const noexcept;
  };

  void check_file() const;
  SqliteStatement first_row(const std::string& sql) const;
  void check(int code) const;  // throws what SQLite's last call has to say, unless it went well
  std::string explain(int code) const;

  std::filesystem::path path_;
  std::unique_ptr<sqlite3, Close> handle_;
};

}  // namespace aspect
