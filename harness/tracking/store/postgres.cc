#include "harness/tracking/store/postgres.h"

#include "harness/core/input_error.h"
#include "harness/tracking/store/schema.h"

#include <fmt/format.h>
#include <libpq-fe.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <string_view>

namespace cylon::store {
namespace {

// Of advisory locks: writers of a store, and recorders of one run.
constexpr int writers = 0x43594c4e, recorders = 0x43594c4f;

struct Clear {
  void operator()(PGresult* result) const { PQclear(result); }
};
using Rows = std::unique_ptr<PGresult, Clear>;

struct Sentence {
  const char* state;  // an SQLSTATE, or its class
  const char* text;   // {} is PostgreSQL's own message
};

// The first row that fits.
constexpr Sentence sentences[] = {
    {"55P03", "another process is writing to it and did not end in 10 s; wait for it"},
    {"42501", "this user may not do that there ({}); let the owner of the database grant it"},
    {"25006", "is read-only ({})"},
    {"53100",
     "the server has no room to write: what was stored before is kept; make room and go on with `cylon track "
     "record --resume`"},
    {"08", "the connection was lost ({}); what was stored before is kept"},
    {"57", "the server has ended the connection ({}); what was stored before is kept"}};

class PostgresDatabase final : public Database {
 public:
  PostgresDatabase(const std::string& address, bool to_write)
      : Database(without_password(address)), connection_(PQconnectdb(address.c_str())) {
    try {
      if (PQstatus(connection_) != CONNECTION_OK)
        fail(fmt::format("cannot be reached: {}", one_line(PQerrorMessage(connection_))));
      PQsetNoticeProcessor(
          connection_, [](void*, const char*) {}, nullptr);
      script(
          "SET search_path = cylon; SET client_encoding = 'UTF8'; SET lock_timeout = '10s'; "
          "SET extra_float_digits = 3; SET standard_conforming_strings = on; SET synchronous_commit = on");
      if (!to_write) script("SET default_transaction_read_only = on");
    } catch (...) {
      PQfinish(connection_);
      throw;
    }
  }
  ~PostgresDatabase() override {
    forget_statements();
    PQfinish(connection_);
  }

  void script(const std::string& sql) override { require(Rows(PQexec(connection_, sql.c_str()))); }
  // One writer at a time, as in a file.
  void begin() override {
    run("BEGIN");
    try {
      query("SELECT pg_advisory_xact_lock(?)").bind(std::int64_t{writers}).run();
    } catch (...) {
      run("ROLLBACK");
      throw;
    }
  }
  bool in_transaction() const override { return PQtransactionStatus(connection_) != PQTRANS_IDLE; }

  std::optional<std::int64_t> schema() override {
    const auto count = [&](const char* sql) { return number(sql); };
    if (count("SELECT count(*) FROM information_schema.tables WHERE table_schema = 'cylon'") == 0) return 0;
    if (count("SELECT count(*) FROM information_schema.tables WHERE table_schema = 'cylon' AND table_name = "
              "'store'") == 0)
      return std::nullopt;
    return number("SELECT max(schema) FROM store");
  }
  void set_schema(std::int64_t version) override {
    script("CREATE TABLE IF NOT EXISTS store (schema BIGINT NOT NULL); DELETE FROM store");
    query("INSERT INTO store (schema) VALUES (?)").bind(version).run();
  }
  std::string in_dialect(const char* script) const override { return in_postgres(script); }

  // Pages and references are the server's to keep.
  std::vector<std::string> damage(bool) override { return {}; }

  // Of this connection, so that nothing is left should the process be killed.
  bool hold(std::int64_t run) override {
    Query row = query("SELECT CAST(pg_try_advisory_lock(CAST(? AS INTEGER), CAST(? AS INTEGER)) AS INTEGER)");
    return row.bind(std::int64_t{recorders}, run).step() && row.integer() == 1;
  }

  [[noreturn]] void fail_as_damaged(const std::string& what) const override {
    fail(fmt::format("is damaged ({}): restore a backup", what));
  }

  Rows require(Rows rows) const {
    const ExecStatusType status = PQresultStatus(rows.get());
    if (rows && (status == PGRES_COMMAND_OK || status == PGRES_TUPLES_OK)) return rows;
    const char* state = rows ? PQresultErrorField(rows.get(), PG_DIAG_SQLSTATE) : nullptr;
    const std::string message =
        one_line(rows ? PQresultErrorMessage(rows.get()) : PQerrorMessage(connection_));
    for (const Sentence& sentence : sentences)
      if (std::string_view(state ? state : "08").starts_with(sentence.state))
        fail(fmt::format(fmt::runtime(sentence.text), message));
    fail(fmt::format("PostgreSQL refuses: {}", message));
  }
  PGconn* connection() const { return connection_; }

 protected:
  std::unique_ptr<Statement> prepare(const char* sql) override;

 private:
  static std::string one_line(std::string text) {
    while (!text.empty() && text.back() == '\n') text.pop_back();
    std::ranges::replace(text, '\n', ' ');
    return text;
  }

  PGconn* connection_;
  std::size_t prepared_ = 0;
};

// Numbers go as text of all digits, texts as they are.  The rows of a result are all here at once.
class PostgresStatement final : public Statement {
 public:
  PostgresStatement(const PostgresDatabase& database, std::string name, Dialect dialect)
      : database_(database), name_(std::move(name)), dialect_(std::move(dialect)) {
    database_.require(
        Rows(PQprepare(database_.connection(), name_.c_str(), dialect_.sql.c_str(), 0, nullptr)));
  }

  void bind(int parameter, const Value& value) override {
    const auto place = static_cast<std::size_t>(parameter - 1);
    if (values_.size() <= place) values_.resize(place + 1);
    values_[place] = std::visit([](const auto& given) { return bound(given); }, value);
    if (std::ranges::find(dialect_.globs, parameter) != dialect_.globs.end())
      values_[place].bytes = expression_of_glob(*values_[place].bytes);
  }

  bool step() override {
    if (!rows_) {
      execute();
      row_ = -1;
    }
    return ++row_ < PQntuples(rows_.get());
  }

  void reset() override {
    rows_.reset();
    values_.clear();
  }

  bool is_null(int column) const override { return PQgetisnull(rows_.get(), row_, column) != 0; }
  std::int64_t integer(int column) const override { return number<std::int64_t>(column); }
  double real(int column) const override { return number<double>(column); }
  std::string text(int column) const override {
    return {PQgetvalue(rows_.get(), row_, column),
            static_cast<std::size_t>(PQgetlength(rows_.get(), row_, column))};
  }

 private:
  struct Bound {
    std::optional<std::string> bytes;  // nothing: NULL
    int binary = 0;
  };
  static Bound bound(std::monostate) { return {}; }
  static Bound bound(std::int64_t value) { return {fmt::format("{}", value), 0}; }
  static Bound bound(double value) { return {fmt::format("{}", value + 0.0), 0}; }  // no -0, as in SQLite
  static Bound bound(std::string_view text) { return {std::string(text), 1}; }

  void execute() {
    std::vector<const char*> values;
    std::vector<int> lengths, binary;
    for (const Bound& value : values_) {
      values.push_back(value.bytes ? value.bytes->c_str() : nullptr);
      lengths.push_back(value.bytes ? static_cast<int>(value.bytes->size()) : 0);
      binary.push_back(value.binary);
    }
    rows_ = database_.require(
        Rows(PQexecPrepared(database_.connection(), name_.c_str(), static_cast<int>(values.size()),
                            values.data(), lengths.data(), binary.data(), 0)));
  }

  template <class Number>
  Number number(int column) const {
    const std::string digits = text(column);
    Number value{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size())
      database_.fail_as_damaged(fmt::format("'{}' is no number", digits));
    return value;
  }

  const PostgresDatabase& database_;
  std::string name_;
  Dialect dialect_;
  std::vector<Bound> values_;
  Rows rows_;
  int row_ = -1;
};

std::unique_ptr<Statement> PostgresDatabase::prepare(const char* sql) {
  return std::make_unique<PostgresStatement>(*this, fmt::format("s{}", ++prepared_),
                                             in_postgres_statement(sql));
}

}  // namespace

std::unique_ptr<Database> open_postgres_to_read(const std::string& address) {
  auto database = std::make_unique<PostgresDatabase>(address, false);
  require_today(*database);
  return database;
}

std::unique_ptr<Database> open_postgres_to_write(const std::string& address) {
  auto database = std::make_unique<PostgresDatabase>(address, true);
  if (require_ours(*database) < static_cast<std::int64_t>(migrations().size())) {
    database->script("CREATE SCHEMA IF NOT EXISTS cylon");
    migrate(*database);
  }
  return database;
}

}  // namespace cylon::store
