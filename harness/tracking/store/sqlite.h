// The store in a file of SQLite.  Private to the store.
#pragma once

#include "harness/tracking/store/database.h"

#include <sqlite3.h>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::store {

/// What marks a file as a store of Cylon: "CYLN" in the header of SQLite.
inline constexpr std::int64_t application_id = 0x43594c4e;

class SqliteDatabase final : public Database {
 public:
  /// `name` is the file as sqlite3_open_v2 takes it with `flags`, a path or a URI.  Nothing in the file is
  /// changed, not even by closing it, until accept().
  SqliteDatabase(std::filesystem::path file, const std::string& name, int flags);
  ~SqliteDatabase() override;

  /// The file is ours: from now on closing it folds the write-ahead log into it.
  void accept();

  void script(const std::string& sql) override;
  void begin() override { run("BEGIN IMMEDIATE"); }
  bool in_transaction() const override { return sqlite3_get_autocommit(handle_) == 0; }
  std::optional<std::int64_t> schema() override;
  void set_schema(std::int64_t) override;
  std::string in_dialect(const char* script) const override { return script; }
  std::vector<std::string> damage(bool thorough) override;
  [[noreturn]] void fail_as_damaged(const std::string& what) const override { fail(SQLITE_CORRUPT, what); }

  using Database::fail;
  [[noreturn]] void fail(int code) const;
  [[noreturn]] void fail(int code, std::string_view message) const;

 protected:
  std::unique_ptr<Statement> prepare(const char* sql) override;

 private:
  std::filesystem::path file_;
  sqlite3* handle_ = nullptr;
};

/// The store in a file; it must be there, and is not changed.
std::unique_ptr<Database> open_sqlite_to_read(const std::filesystem::path&);
/// Made where it is missing, and brought up to date where it is older.
std::unique_ptr<Database> open_sqlite_to_write(const std::filesystem::path&);

}  // namespace cylon::store
