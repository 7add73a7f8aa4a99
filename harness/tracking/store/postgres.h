// The store in a schema `cylon` of a PostgreSQL database.  Private to the store.
#pragma once

#include "harness/tracking/store/database.h"

#include <memory>
#include <string>

namespace cylon::store {

/// Whether a store is named by an address of PostgreSQL: postgresql://USER@HOST/DATABASE?…
bool is_address(const std::string& store);

/// The same without a password.
std::string without_password(const std::string& address);

/// As of a file; refused where this program was built without libpq.
std::unique_ptr<Database> open_postgres_to_read(const std::string& address);
std::unique_ptr<Database> open_postgres_to_write(const std::string& address);

/// A script that SQLite takes as PostgreSQL does: types, keys, and the order of texts byte by byte.
std::string in_postgres(std::string script);

/// ? as $1, $2, …; `x GLOB ?` as a regular expression, whose parameters are `globs`.
struct Dialect {
  std::string sql;
  std::vector<int> globs;
};
Dialect in_postgres_statement(const std::string& sql);

/// "a*[0-9]?" as the regular expression that matches the whole of the same texts.
std::string expression_of_glob(const std::string& glob);

}  // namespace cylon::store
