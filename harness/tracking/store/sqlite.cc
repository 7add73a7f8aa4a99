#include "harness/tracking/store/sqlite.h"

#include "harness/core/input_error.h"
#include "harness/tracking/store/complaint.h"
#include "harness/tracking/store/schema.h"

#include <fmt/format.h>
#include <unistd.h>

#include <system_error>
#include <utility>

namespace cylon::store {
namespace {

namespace fs = std::filesystem;

constexpr int busy_ms = 10'000;  // for which another writer is waited for

class SqliteStatement final : public Statement {
 public:
  SqliteStatement(const SqliteDatabase& database, sqlite3_stmt* statement)
      : database_(database), statement_(statement) {}
  SqliteStatement(const SqliteStatement&) = delete;
  SqliteStatement& operator=(const SqliteStatement&) = delete;
  ~SqliteStatement() override { sqlite3_finalize(statement_); }

  void bind(int parameter, const Value& value) override {
    if (const int code = std::visit([&](const auto& given) { return put(parameter, given); }, value))
      database_.fail(code);
  }
  bool step() override {
    const int code = sqlite3_step(statement_);
    if (code != SQLITE_ROW && code != SQLITE_DONE) database_.fail(code);
    return code == SQLITE_ROW;
  }
  void reset() override {
    sqlite3_reset(statement_);
    sqlite3_clear_bindings(statement_);
  }
  bool is_null(int column) const override { return sqlite3_column_type(statement_, column) == SQLITE_NULL; }
  std::int64_t integer(int column) const override { return sqlite3_column_int64(statement_, column); }
  double real(int column) const override { return sqlite3_column_double(statement_, column); }
  std::string text(int column) const override {
    const unsigned char* bytes = sqlite3_column_text(statement_, column);
    return bytes ? std::string(reinterpret_cast<const char*>(bytes),
                               static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)))
                 : "";
  }

 private:
  int put(int parameter, std::monostate) { return sqlite3_bind_null(statement_, parameter); }
  int put(int parameter, std::int64_t value) { return sqlite3_bind_int64(statement_, parameter, value); }
  int put(int parameter, double value) { return sqlite3_bind_double(statement_, parameter, value); }
  int put(int parameter, std::string_view text) {
    return sqlite3_bind_text64(statement_, parameter, text.data() ? text.data() : "", text.size(),
                               SQLITE_TRANSIENT, SQLITE_UTF8);
  }

  const SqliteDatabase& database_;
  sqlite3_stmt* statement_;
};

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw core::InputError(file.string(), 0, 0, why);
}

// A log with something in it beside the file: then the file alone is not the whole store.
bool has_log(const fs::path& file) {
  std::error_code error;
  const auto size = fs::file_size(file.string() + "-wal", error);
  return !error && size > 0;
}

// "file:/a%3Fb?immutable=1": a file that nothing changes needs no lock and no log beside it.
std::string immutable(const fs::path& file) {
  std::string uri = "file:";
  for (const char c : fs::absolute(file).string())
    uri += c == '%' || c == '?' || c == '#' ? fmt::format("%{:02X}", static_cast<unsigned>(c))
                                            : std::string(1, c);
  return uri + "?immutable=1";
}

// SQLite takes what is missing of the last page for zeros.
void require_whole(SqliteDatabase& database, const fs::path& file) {
  const auto pages = static_cast<std::uintmax_t>(database.number("PRAGMA page_count"));
  const auto page = static_cast<std::uintmax_t>(database.number("PRAGMA page_size"));
  std::error_code error;
  if (const auto size = fs::file_size(file, error); !error && !has_log(file) && size < pages * page)
    database.fail(SQLITE_CORRUPT, fmt::format("{} bytes of {}", size, pages * page));
}

void require_file(const fs::path& file) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored)) refuse(file, "is a folder; name a file with --store");
}

}  // namespace

SqliteDatabase::SqliteDatabase(fs::path file, const std::string& name, int flags)
    : Database(file.string()), file_(std::move(file)) {
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

SqliteDatabase::~SqliteDatabase() {
  forget_statements();
  sqlite3_close_v2(handle_);
}

void SqliteDatabase::accept() { sqlite3_db_config(handle_, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 0, nullptr); }

std::unique_ptr<Statement> SqliteDatabase::prepare(const char* sql) {
  sqlite3_stmt* statement = nullptr;
  if (const int code = sqlite3_prepare_v3(handle_, sql, -1, SQLITE_PREPARE_PERSISTENT, &statement, nullptr))
    fail(code);
  return std::make_unique<SqliteStatement>(*this, statement);
}

void SqliteDatabase::script(const std::string& sql) {
  if (const int code = sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr)) fail(code);
}

// The header keeps it as user_version.
std::optional<std::int64_t> SqliteDatabase::schema() {
  const std::int64_t mark = number("PRAGMA application_id"), version = number("PRAGMA user_version");
  const bool empty = number("SELECT count(*) FROM sqlite_schema") == 0;
  if (mark == 0 && version == 0 && empty) return 0;
  return mark == application_id ? std::optional(version) : std::nullopt;
}

void SqliteDatabase::set_schema(std::int64_t version) {
  script(fmt::format("PRAGMA application_id = {}; PRAGMA user_version = {}", application_id, version));
}

std::vector<std::string> SqliteDatabase::damage(bool thorough) {
  std::vector<std::string> found;
  {
    Query row = query(thorough ? "PRAGMA integrity_check" : "PRAGMA quick_check(1)");
    while (row.step())
      if (const std::string said = row.text(); said != "ok") found.push_back("the pages: " + said);
  }
  if (!thorough) return found;
  Query row = query("PRAGMA foreign_key_check");
  while (row.step()) found.push_back(fmt::format("table {}: a row has a dangling reference", row.text()));
  return found;
}

void SqliteDatabase::fail(int code) const {
  fail(code, handle_ ? sqlite3_errmsg(handle_) : sqlite3_errstr(code));
}

void SqliteDatabase::fail(int code, std::string_view message) const {
  fail(complaint(code, message, handle_ ? sqlite3_system_errno(handle_) : 0));
}

std::unique_ptr<Database> open_sqlite_to_read(const fs::path& file) {
  require_file(file);
  std::error_code ignored;
  if (!fs::exists(file, ignored)) refuse(file, "no such store; `cylon track record` creates one");
  const fs::path folder = fs::absolute(file).parent_path();
  const bool frozen = access(folder.c_str(), W_OK) != 0 && !has_log(file);
  auto database =
      std::make_unique<SqliteDatabase>(file, frozen ? immutable(file) : file.string(), SQLITE_OPEN_READONLY);
  require_today(*database);
  require_whole(*database, file);
  return database;
}

std::unique_ptr<Database> open_sqlite_to_write(const fs::path& file) {
  require_file(file);
  if (std::error_code error; !file.parent_path().empty() && !fs::exists(file, error)) {
    fs::create_directories(file.parent_path(), error);
    if (error)
      refuse(file,
             fmt::format("its folder cannot be made ({}); name another file with --store", error.message()));
  }
  auto database =
      std::make_unique<SqliteDatabase>(file, file.string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  const std::int64_t version = require_ours(*database);
  if (version > 0) require_whole(*database, file);
  database->accept();
  if (Query mode = database->query("PRAGMA journal_mode = WAL"); !mode.step() || mode.text() != "wal")
    refuse(file,
           "cannot be written ahead of (is it on a network folder?); name one on a local disk with --store");
  database->script("PRAGMA synchronous = FULL");
  if (version < static_cast<std::int64_t>(migrations().size())) migrate(*database);
  return database;
}

}  // namespace cylon::store
