#include "harness/tracking/store/database.h"

#include "harness/core/input_error.h"
#include "harness/tracking/store/complaint.h"

#include <cmath>
#include <limits>
#include <utility>

namespace cylon::store {
namespace {

constexpr int busy_ms = 10'000;  // for which another writer is waited for

}  // namespace

Query::~Query() {
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
}

bool Query::step() {
  column_ = 0;
  const int code = sqlite3_step(statement_);
  if (code != SQLITE_ROW && code != SQLITE_DONE) database_.fail(code);
  return code == SQLITE_ROW;
}

void Query::run() {
  while (step()) {
  }
}

std::int64_t Query::integer() { return sqlite3_column_int64(statement_, column_++); }

double Query::real() {
  const bool null = is_null();
  const double value = sqlite3_column_double(statement_, column_++);
  return null ? std::numeric_limits<double>::quiet_NaN() : value;
}

std::string Query::text() {
  const int column = column_++;
  const unsigned char* bytes = sqlite3_column_text(statement_, column);
  return bytes ? std::string(reinterpret_cast<const char*>(bytes),
                             static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)))
               : "";
}

void Query::put(std::int64_t value) {
  if (const int code = sqlite3_bind_int64(statement_, ++bound_, value)) database_.fail(code);
}

void Query::put(double value) {
  const int code = std::isnan(value) ? sqlite3_bind_null(statement_, ++bound_)
                                     : sqlite3_bind_double(statement_, ++bound_, value);
  if (code) database_.fail(code);
}

void Query::put(std::string_view text) {
  if (const int code = sqlite3_bind_text64(statement_, ++bound_, text.data() ? text.data() : "", text.size(),
                                           SQLITE_TRANSIENT, SQLITE_UTF8))
    database_.fail(code);
}

void Query::put(const std::optional<std::int64_t>& value) {
  if (value) return put(*value);
  if (const int code = sqlite3_bind_null(statement_, ++bound_)) database_.fail(code);
}

Database::Database(std::filesystem::path file, const std::string& name, int flags) : file_(std::move(file)) {
  const int code =
      sqlite3_open_v2(name.c_str(), &handle_, flags | SQLITE_OPEN_URI | SQLITE_OPEN_EXRESCODE, nullptr);
  try {
    if (code) fail(code);
    sqlite3_busy_timeout(handle_, busy_ms);
    sqlite3_db_config(handle_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
    sqlite3_db_config(handle_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    script("PRAGMA foreign_keys = ON; PRAGMA trusted_schema = OFF");
  } catch (...) {
    sqlite3_close_v2(handle_);
    throw;
  }
}

Database::~Database() {
  for (const auto& [sql, statement] : statements_) sqlite3_finalize(statement);
  sqlite3_close_v2(handle_);
}

void Database::accept() { sqlite3_db_config(handle_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 0, nullptr); }

Query Database::query(const char* sql) {
  sqlite3_stmt*& statement = statements_[sql];
  if (!statement)
    if (const int code = sqlite3_prepare_v3(handle_, sql, -1, SQLITE_PREPARE_PERSISTENT, &statement, nullptr))
      fail(code);
  return {*this, statement};
}

void Database::script(const char* sql) {
  if (const int code = sqlite3_exec(handle_, sql, nullptr, nullptr, nullptr)) fail(code);
}

std::int64_t Database::number(const char* sql) {
  Query row = query(sql);
  return row.step() ? row.integer() : 0;
}

void Database::fail(int code) const { fail(code, handle_ ? sqlite3_errmsg(handle_) : sqlite3_errstr(code)); }

void Database::fail(int code, std::string_view message) const {
  fail(complaint(code, message, handle_ ? sqlite3_system_errno(handle_) : 0));
}

void Database::fail(const std::string& sentence) const {
  throw core::InputError(file_.string(), 0, 0, sentence);
}

Transaction::Transaction(Database& database) : database_(database), outer_(!database.in_transaction()) {
  if (outer_) database_.run("BEGIN IMMEDIATE");
}

void Transaction::commit() {
  if (outer_) database_.run("COMMIT");
  open_ = false;
}

// Where the disk is full SQLite has rolled back by itself.
Transaction::~Transaction() {
  if (!outer_ || !open_ || !database_.in_transaction()) return;
  try {
    database_.run("ROLLBACK");
  } catch (const core::InputError&) {  // the next writer rolls it back
  }
}

}  // namespace cylon::store
