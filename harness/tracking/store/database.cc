#include "harness/tracking/store/database.h"

#include "harness/core/input_error.h"

#include <cmath>
#include <limits>

namespace cylon::store {

bool Query::step() {
  column_ = 0;
  return statement_.step();
}

void Query::run() {
  while (step()) {
  }
}

double Query::real() {
  const int column = column_++;
  return statement_.is_null(column) ? std::numeric_limits<double>::quiet_NaN() : statement_.real(column);
}

void Query::put(double value) { statement_.bind(++bound_, std::isnan(value) ? Value() : Value(value)); }

void Query::put(const std::optional<std::int64_t>& value) {
  statement_.bind(++bound_, value ? Value(*value) : Value());
}

Query Database::query(const char* sql) {
  std::unique_ptr<Statement>& statement = statements_[sql];
  if (!statement) statement = prepare(sql);
  return Query(*statement);
}

std::int64_t Database::number(const char* sql) {
  Query row = query(sql);
  return row.step() ? row.integer() : 0;
}

void Database::fail(const std::string& sentence) const { throw core::InputError(name_, 0, 0, sentence); }

Transaction::Transaction(Database& database) : database_(database), outer_(!database.in_transaction()) {
  if (outer_) database_.begin();
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
