// Older files are migrated to the current schema, completely or not at all.
#include "harness/tracking/store/schema.h"
#include "harness/core/input_error.h"
#include "harness/tracking/store/sqlite.h"
#include "tests/harness/tracking/store/fixture.h"

namespace cylon::store {
namespace {

using Schemas = Folder;

constexpr const char* first = "CREATE TABLE t (x INTEGER NOT NULL) STRICT; INSERT INTO t VALUES (3), (5)";
constexpr const char* second = "ALTER TABLE t ADD COLUMN y INTEGER NOT NULL DEFAULT 7";
constexpr const char* third = "UPDATE t SET y = x * x";
constexpr const char* broken = "UPDATE t SET y = 0; UPDATE t SET z = 1";

TEST_F(Schemas, MigrateFromAnyEarlierVersion) {
  const std::vector<const char*> scripts = {first, second, third};
  for (std::size_t begun = 1; begun <= scripts.size(); ++begun) {
    const auto path = folder / std::to_string(begun);
    SqliteDatabase database(path, path.string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
    migrate(database, std::span(scripts).first(begun));
    EXPECT_EQ(database.number("PRAGMA user_version"), static_cast<std::int64_t>(begun));
    migrate(database, scripts);
    EXPECT_EQ(require_ours(database, scripts), 3);
    EXPECT_EQ(database.number("SELECT sum(y) FROM t"), 9 + 25);
    migrate(database, scripts);  // nothing is left to be done
    EXPECT_EQ(database.number("SELECT count(*) FROM t"), 2);
  }
}

TEST_F(Schemas, FailedMigrationChangesNothing) {
  const std::vector<const char*> good = {first, second}, bad = {first, second, third, broken};
  SqliteDatabase database(file, file.string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  migrate(database, good);
  EXPECT_THROW(migrate(database, bad), core::InputError);
  EXPECT_EQ(require_ours(database, good), 2);
  EXPECT_EQ(database.number("SELECT sum(y) FROM t"), 14);
}

TEST_F(Schemas, RejectNewerVersion) {
  const std::vector<const char*> scripts = {first, second, third};
  SqliteDatabase database(file, file.string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  migrate(database, scripts);
  EXPECT_THROW(migrate(database, std::span(scripts).first(2)), core::InputError);
  EXPECT_EQ(require_ours(database, scripts), 3);
}

}  // namespace
}  // namespace cylon::store
