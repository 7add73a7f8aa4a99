#include "harness/tracking/store/schema.h"

#include <fmt/format.h>

namespace cylon::store {
namespace {

// Schema 1.  Samples are clustered by series, so that a series is one range of pages.
constexpr const char* tables = R"(
CREATE TABLE run (
  id             INTEGER PRIMARY KEY,
  uid            TEXT NOT NULL UNIQUE,
  label          TEXT NOT NULL,
  revision       TEXT NOT NULL,
  revision_order INTEGER NOT NULL,
  date           TEXT NOT NULL,
  machine        TEXT NOT NULL,
  os             TEXT NOT NULL,
  compiler       TEXT NOT NULL,
  flags          TEXT NOT NULL,
  build          TEXT NOT NULL,
  command_line   TEXT NOT NULL,
  request        TEXT NOT NULL,
  note           TEXT NOT NULL,
  complete       INTEGER NOT NULL CHECK (complete IN (0, 1)),
  digest         TEXT NOT NULL
) STRICT;
CREATE INDEX run_by_revision ON run (revision_order, id);

CREATE TABLE engine_version (
  run     INTEGER NOT NULL REFERENCES run (id) ON DELETE CASCADE,
  engine  TEXT NOT NULL,
  version TEXT NOT NULL,
  PRIMARY KEY (engine, run)
) STRICT, WITHOUT ROWID;
CREATE INDEX engine_version_by_run ON engine_version (run);

CREATE TABLE cell (
  id            INTEGER PRIMARY KEY,
  hash          TEXT NOT NULL UNIQUE,
  name          TEXT NOT NULL,
  scenario      TEXT NOT NULL,
  scenario_hash TEXT NOT NULL,
  engine        TEXT NOT NULL,
  path          TEXT NOT NULL,
  integrator    TEXT NOT NULL,
  precision     TEXT NOT NULL,
  settings      TEXT NOT NULL,
  dt            REAL NOT NULL CHECK (dt >= 0),
  dt_text       TEXT NOT NULL
) STRICT;

CREATE TABLE metric (
  id   INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  kind TEXT NOT NULL CHECK (kind IN ('exact', 'error', 'time', 'size', 'info')),
  unit TEXT NOT NULL,
  UNIQUE (name, kind, unit)
) STRICT;

CREATE TABLE claim (
  id         INTEGER PRIMARY KEY,
  name       TEXT NOT NULL,
  observable TEXT NOT NULL,
  unit       TEXT NOT NULL,
  UNIQUE (name, observable, unit)
) STRICT;

CREATE TABLE result (
  run    INTEGER NOT NULL REFERENCES run (id) ON DELETE CASCADE,
  cell   INTEGER NOT NULL REFERENCES cell (id),
  asked  TEXT NOT NULL,
  digest TEXT NOT NULL,
  PRIMARY KEY (run, cell)
) STRICT, WITHOUT ROWID;

CREATE TABLE sample (
  cell       INTEGER NOT NULL,
  metric     INTEGER NOT NULL REFERENCES metric (id),
  run        INTEGER NOT NULL,
  repetition INTEGER NOT NULL CHECK (repetition >= 0),
  value      REAL,
  text       TEXT,
  PRIMARY KEY (cell, metric, run, repetition),
  FOREIGN KEY (run, cell) REFERENCES result (run, cell) ON DELETE CASCADE,
  CHECK (value IS NULL OR text IS NULL)
) STRICT, WITHOUT ROWID;
CREATE INDEX sample_by_run ON sample (run, cell);

CREATE TABLE verdict (
  cell        INTEGER NOT NULL,
  claim       INTEGER NOT NULL REFERENCES claim (id),
  run         INTEGER NOT NULL,
  status      TEXT NOT NULL,
  expected    TEXT NOT NULL,
  measured    REAL,
  allowed     REAL,
  truth_error REAL,
  detail      TEXT NOT NULL,
  PRIMARY KEY (cell, claim, run),
  FOREIGN KEY (run, cell) REFERENCES result (run, cell) ON DELETE CASCADE
) STRICT, WITHOUT ROWID;
CREATE INDEX verdict_by_run ON verdict (run, cell);

CREATE TABLE anchor (
  name   TEXT NOT NULL PRIMARY KEY,
  "binary" TEXT NOT NULL,
  build  TEXT NOT NULL,
  date   TEXT NOT NULL,
  note   TEXT NOT NULL,
  run    TEXT NOT NULL,
  digest TEXT NOT NULL
) STRICT, WITHOUT ROWID;

CREATE TABLE change_point (
  series   TEXT NOT NULL,
  revision TEXT NOT NULL,
  state    TEXT NOT NULL CHECK (state IN ('detected', 'active', 'ignored', 'fixed')),
  date     TEXT NOT NULL,
  note     TEXT NOT NULL,
  digest   TEXT NOT NULL,
  PRIMARY KEY (series, revision)
) STRICT, WITHOUT ROWID;
)";

// Schema 2.  Seals (harness/seal) of what this store's user wrote; what was imported has none.
constexpr const char* seals = R"(
CREATE TABLE seal (
  kind TEXT NOT NULL CHECK (kind IN ('run', 'result', 'anchor', 'change_point')),
  id   TEXT NOT NULL,
  mac  TEXT NOT NULL,
  PRIMARY KEY (kind, id)
) STRICT, WITHOUT ROWID;
)";

constexpr const char* scripts_of_today[] = {tables, seals};

}  // namespace

std::span<const char* const> migrations() { return scripts_of_today; }

std::int64_t require_ours(Database& database, std::span<const char* const> scripts) {
  const std::optional<std::int64_t> version = database.schema();
  if (!version)
    database.fail("is a database, but not a store of Cylon; it was not changed: name another with --store");
  const auto newest = static_cast<std::int64_t>(scripts.size());
  if (*version > newest)
    database.fail(
        fmt::format("was written by a newer Cylon (schema {}, this one reads up to {}); it was not changed: "
                    "use that Cylon, or name another with --store",
                    *version, newest));
  return *version;
}

void require_today(Database& database) {
  const std::int64_t version = require_ours(database);
  if (version == 0) database.fail("is empty; `cylon track record` creates a store");
  if (version < static_cast<std::int64_t>(migrations().size()))
    database.fail("was written by an older Cylon; any command that writes to it brings it up to date");
}

void migrate(Database& database, std::span<const char* const> scripts) {
  Transaction transaction(database);
  const std::int64_t version = require_ours(database, scripts);  // another may have been first
  for (std::size_t i = static_cast<std::size_t>(version); i < scripts.size(); ++i)
    database.script(database.in_dialect(scripts[i]));
  database.set_schema(static_cast<std::int64_t>(scripts.size()));
  transaction.commit();
}

}  // namespace cylon::store
