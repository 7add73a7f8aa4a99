// A database behind a narrow door: its prepared statements, transactions, and its complaints as sentences.  SQLite
// (sqlite.cc) and PostgreSQL (postgres.cc) stand behind it; SQL is written as SQLite takes it.  Private to the store.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <variant>
#include <vector>

namespace cylon::store {

/// NULL, a number or a text.
using Value = std::variant<std::monostate, std::int64_t, double, std::string_view>;

/// A prepared statement of one kind of database.
class Statement {
 public:
  Statement() = default;
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  virtual ~Statement() = default;

  virtual void bind(int parameter, const Value&) = 0;  ///< Parameters are counted from 1.
  virtual bool step() = 0;                             ///< Whether there is a further row.
  virtual void reset() = 0;                            ///< Forgets rows and values.

  // Of the row; columns are counted from 0.
  virtual bool is_null(int column) const = 0;
  virtual std::int64_t integer(int column) const = 0;
  virtual double real(int column) const = 0;
  virtual std::string text(int column) const = 0;
};

/// A statement in use: values are bound in order, rows stepped through; reset at the end of its scope, so that no
/// read transaction outlives it.  Two of the same text must not be in use at one time.
class Query {
 public:
  explicit Query(Statement& statement) : statement_(statement) {}
  ~Query() { statement_.reset(); }
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
  std::int64_t integer() { return statement_.integer(column_++); }
  double real();  ///< NaN for NULL.
  std::string text() { return statement_.text(column_++); }
  bool is_null() const { return statement_.is_null(column_); }

 private:
  void put(std::int64_t value) { statement_.bind(++bound_, value); }
  void put(double);  // NaN is NULL
  void put(std::string_view text) { statement_.bind(++bound_, text); }
  void put(const std::optional<std::int64_t>&);
  void put(const std::string& text) { put(std::string_view(text)); }
  void put(const char* text) { put(std::string_view(text)); }

  Statement& statement_;
  int bound_ = 0, column_ = 0;
};

class Database {
 public:
  /// `name` is what a user calls it: a file or an address.
  explicit Database(std::string name) : name_(std::move(name)) {}
  Database(const Database&) = delete;
  Database& operator=(const Database&) = delete;
  virtual ~Database() = default;

  /// `sql` lives as long as the program; prepared once.
  Query query(const char* sql);
  void run(const char* sql) { query(sql).run(); }
  std::int64_t number(const char* sql);
  /// Several statements, not kept.
  virtual void script(const std::string& sql) = 0;

  // ---- Transactions: one writer at a time ----
  virtual void begin() = 0;
  virtual bool in_transaction() const = 0;

  // ---- The schema ----
  /// Which one it has; 0: it is empty; nothing: it holds something else.
  virtual std::optional<std::int64_t> schema() = 0;
  virtual void set_schema(std::int64_t) = 0;
  /// A migration as this database takes it.
  virtual std::string in_dialect(const char* script) const = 0;

  // ---- Others ----
  /// What is damaged below the tables, a sentence each.
  virtual std::vector<std::string> damage(bool thorough) = 0;
  /// Keeps other processes from recording this run as long as the database is open.  False: one does.  Of a file, whose
  /// bytes are locked (tracking/run_lock.h), always true.
  virtual bool hold(std::int64_t) { return true; }

  /// Throws core::InputError: the name, what is wrong with it, and what to do.
  [[noreturn]] void fail(const std::string& sentence) const;
  [[noreturn]] virtual void fail_as_damaged(const std::string& what) const = 0;

  const std::string& name() const { return name_; }

 protected:
  virtual std::unique_ptr<Statement> prepare(const char* sql) = 0;
  void forget_statements() { statements_.clear(); }  // before what they belong to is closed

 private:
  std::string name_;
  std::unordered_map<const char*, std::unique_ptr<Statement>> statements_;
};

/// ROLLBACK unless committed; within another one it is a part of that.
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
