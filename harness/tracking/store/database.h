// SQLite behind a narrow door: an open file, its prepared statements, transactions, and its complaints as
// sentences.  Private to the store.
#pragma once

#include <sqlite3.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace cylon::store {

class Database;

/// A prepared statement in use: values are bound in order, rows stepped through; reset at the end of its
/// scope, so that no read transaction outlives it.  Two of the same text must not be in use at one time.
class Query {
 public:
  Query(Database& database, sqlite3_stmt* statement) : database_(database), statement_(statement) {}
  ~Query();
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  template <class... Values>
  Query& bind(const Values&... values) {
    (put(values), ...);
    return *this;
  }
  /// Whether there is a further row.
  bool step();
  /// Runs a statement that gives no rows.
  void run();

  // Columns of the row, in order.
  std::int64_t integer();
  double real();  ///< NaN for NULL.
  std::string text();
  bool is_null() const { return sqlite3_column_type(statement_, column_) == SQLITE_NULL; }

 private:
  void put(std::int64_t);
  void put(double);  // NaN is NULL
  void put(std::string_view);
  void put(const std::optional<std::int64_t>&);
  void put(const std::string& text) { put(std::string_view(text)); }
  void put(const char* text) { put(std::string_view(text)); }

  Database& database_;
  sqlite3_stmt* statement_;
  int bound_ = 0, column_ = 0;
};

class Database {
 public:
  /// `name` is the file as sqlite3_open_v2 takes it with `flags`, a path or a URI.  Nothing in the file is
  /// changed, not even by closing it, until accept().
  Database(std::filesystem::path file, const std::string& name, int flags);
  ~Database();
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;

  /// The file is ours: from now on closing it folds the write-ahead log into it.
  void accept();

  /// `sql` lives as long as the program; prepared once.
  Query query(const char* sql);
  void run(const char* sql) { query(sql).run(); }
  /// Several statements, not kept.
  void script(const char* sql);
  std::int64_t number(const char* sql);
  std::int64_t last_id() const { return sqlite3_last_insert_rowid(handle_); }

  /// Throws core::InputError: the file, what is wrong with it, and what to do.
  [[noreturn]] void fail(int code) const;
  [[noreturn]] void fail(int code, std::string_view message) const;
  [[noreturn]] void fail(const std::string& sentence) const;

  bool in_transaction() const { return sqlite3_get_autocommit(handle_) == 0; }

 private:
  std::filesystem::path file_;
  sqlite3* handle_ = nullptr;
  std::unordered_map<const char*, sqlite3_stmt*> statements_;
};

/// BEGIN IMMEDIATE, and ROLLBACK unless committed; within another one it is a part of that.
class Transaction {
 public:
  explicit Transaction(Database&);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  Database& database_;
  bool outer_, open_ = true;
};

}  // namespace cylon::store
