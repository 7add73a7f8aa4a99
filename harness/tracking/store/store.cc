#include "harness/tracking/store/store.h"

#include "harness/tracking/store/database.h"
#include "harness/tracking/store/postgres.h"
#include "harness/tracking/store/sealed.h"
#include "harness/tracking/store/sqlite.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cylon::store {
namespace {

std::int64_t id_of(Database& database, const Cell& c) {
  database
      .query(
          "INSERT INTO cell (hash, name, scenario, scenario_hash, engine, path, integrator, precision, "
          "settings, dt, dt_text) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT DO NOTHING")
      .bind(c.hash, c.name(), c.scenario, c.scenario_hash, c.engine, c.path, c.integrator, c.precision,
            c.settings, c.dt, c.dt_text)
      .run();
  Query row = database.query("SELECT id FROM cell WHERE hash = ?");
  row.bind(c.hash).step();
  return row.integer();
}

std::int64_t id_of(Database& database, const Metric& m) {
  const std::string kind(name(m.kind));
  database.query("INSERT INTO metric (name, kind, unit) VALUES (?, ?, ?) ON CONFLICT DO NOTHING")
      .bind(m.name, kind, m.unit)
      .run();
  Query row = database.query("SELECT id FROM metric WHERE name = ? AND kind = ? AND unit = ?");
  row.bind(m.name, kind, m.unit).step();
  return row.integer();
}

std::int64_t id_of(Database& database, const Judgement& j) {
  database.query("INSERT INTO claim (name, observable, unit) VALUES (?, ?, ?) ON CONFLICT DO NOTHING")
      .bind(j.claim, j.observable, j.unit)
      .run();
  Query row = database.query("SELECT id FROM claim WHERE name = ? AND observable = ? AND unit = ?");
  row.bind(j.claim, j.observable, j.unit).step();
  return row.integer();
}

void insert_samples(Database& database, std::int64_t run, std::int64_t cell,
                    const std::vector<Sample>& samples) {
  for (const Sample& s : samples) {
    if (!s.text.empty() && !std::isnan(s.value))
      database.fail(fmt::format("metric {}: a sample is a number or a text, not both", s.metric.name));
    const std::int64_t metric = id_of(database, s.metric);
    if (s.text.empty()) {
      database.query("INSERT INTO sample (cell, metric, run, repetition, value) VALUES (?, ?, ?, ?, ?)")
          .bind(cell, metric, run, s.repetition, s.value)
          .run();
    } else {
      database.query("INSERT INTO sample (cell, metric, run, repetition, text) VALUES (?, ?, ?, ?, ?)")
          .bind(cell, metric, run, s.repetition, s.text)
          .run();
    }
  }
}

bool has_run(Database& database, const std::string& uid, std::int64_t& id) {
  Query row = database.query("SELECT id FROM run WHERE uid = ?");
  if (!row.bind(uid).step()) return false;
  id = row.integer();
  return true;
}

std::int64_t place(Database& database, const RunInfo& run) {
  if (run.revision_order) return *run.revision_order;
  {
    Query same = database.query("SELECT max(revision_order) FROM run WHERE revision = ?");
    if (same.bind(run.revision).step() && !same.is_null()) return same.integer();
  }
  return database.number("SELECT coalesce(max(revision_order), 0) + 1 FROM run");
}

std::int64_t insert(Database& database, RunInfo r) {
  r.revision_order = place(database, r);
  Query row = database.query(
      "INSERT INTO run (uid, label, revision, revision_order, date, machine, os, compiler, flags, build, "
      "command_line, request, note, complete, digest) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, "
      "?) RETURNING id");
  row.bind(r.uid, r.label, r.revision, r.revision_order, r.date, r.machine, r.os, r.compiler, r.flags,
           r.build, r.command_line, r.request, r.note, std::int64_t{r.complete}, digest(r))
      .step();
  const std::int64_t id = row.integer();
  while (row.step()) {  // an INSERT is done when its last row is read
  }
  return id;
}

RunInfo cleaned(RunInfo r) {
  for (std::string* text : {&r.uid, &r.label, &r.revision, &r.date, &r.machine, &r.os, &r.compiler, &r.flags,
                            &r.build, &r.command_line, &r.request, &r.note})
    *text = clean(*text);
  return r;
}

}  // namespace

Store::Store(std::unique_ptr<Database> database) : database_(std::move(database)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

Store Store::open(const std::string& place, Mode mode) {
  const bool read = mode == Mode::read;
  if (is_address(place)) return Store(read ? open_postgres_to_read(place) : open_postgres_to_write(place));
  return Store(read ? open_sqlite_to_read(place) : open_sqlite_to_write(place));
}

bool Store::is_on_server(const std::string& place) { return is_address(place); }

bool Store::hold(std::int64_t run) { return database_->hold(run); }

std::int64_t Store::begin_run(const RunInfo& given) {
  Transaction transaction(*database_);
  if (const std::vector<std::string> found = database_->damage(false); !found.empty())
    database_->fail_as_damaged(found.front());
  RunInfo run = cleaned(given);
  run.complete = false;
  std::int64_t id = 0, ordinal = 0;
  do {
    run.uid = run_uid(run, ordinal++);
  } while (has_run(*database_, run.uid, id));
  id = insert(*database_, run);
  for (const RunInfo& begun : runs())  // with the place in the history that it was given
    if (begun.id == id) write_seal(*database_, sealed(begun, ""), Author::user);
  transaction.commit();
  return id;
}

bool Store::import_run(const RunInfo& given, std::int64_t& id) {
  Transaction transaction(*database_);
  const RunInfo run = cleaned(given);
  if (has_run(*database_, run.uid, id)) return false;
  id = insert(*database_, run);
  transaction.commit();
  return true;
}

void Store::add(std::int64_t run, const Result& given) {
  const Result result = canonical(given);
  if (const std::string word = twice(result); !word.empty())
    database_->fail(fmt::format("{} has {} twice", result.cell.name(), word));
  Transaction transaction(*database_);
  const std::int64_t cell = id_of(*database_, result.cell);
  database_->query("INSERT INTO result (run, cell, asked, digest) VALUES (?, ?, ?, ?)")
      .bind(run, cell, result.asked, digest(result))
      .run();
  if (!result.engine_version.empty())
    database_
        ->query("INSERT INTO engine_version (run, engine, version) VALUES (?, ?, ?) ON CONFLICT DO NOTHING")
        .bind(run, result.cell.engine, result.engine_version)
        .run();
  insert_samples(*database_, run, cell, result.samples);
  for (const Judgement& j : result.judgements)
    database_
        ->query(
            "INSERT INTO verdict (cell, claim, run, status, expected, measured, allowed, truth_error, "
            "detail) "
            "VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(cell, id_of(*database_, j), run, j.status, j.expected, j.measured, j.allowed, j.truth_error,
              j.detail)
        .run();
  write_seal(*database_, sealed(result, uid_of(*database_, run)), author_);
  transaction.commit();
}

void Store::finish_run(std::int64_t id) {
  Transaction transaction(*database_);
  database_->query("UPDATE run SET complete = 1 WHERE id = ?").bind(id).run();
  for (const RunInfo& run : runs())
    if (run.id == id) write_seal(*database_, sealed(run, seals_of_results(*database_, id)), author_);
  transaction.commit();
}

void Store::pin(const Anchor& given, Author author) {
  Transaction transaction(*database_);
  const Anchor a = {clean(given.name), clean(given.binary), clean(given.build),
                    clean(given.date), clean(given.note),   clean(given.run)};
  database_
      ->query(
          "INSERT INTO anchor (name, \"binary\", build, date, note, run, digest) VALUES (?, ?, ?, ?, ?, ?, "
          "?) "
          "ON CONFLICT (name) DO UPDATE SET \"binary\" = excluded.\"binary\", build = excluded.build, date = "
          "excluded.date, note = excluded.note, run = excluded.run, digest = excluded.digest")
      .bind(a.name, a.binary, a.build, a.date, a.note, a.run, digest(a))
      .run();
  write_seal(*database_, sealed(a), author);
  transaction.commit();
}

void Store::set(const ChangePoint& given, Author author) {
  Transaction transaction(*database_);
  const ChangePoint p = {clean(given.series), clean(given.revision), given.state, clean(given.date),
                         clean(given.note)};
  database_
      ->query(
          "INSERT INTO change_point (series, revision, state, date, note, digest) VALUES (?, ?, ?, ?, ?, ?) "
          "ON "
          "CONFLICT (series, revision) DO UPDATE SET state = excluded.state, date = excluded.date, note = "
          "excluded.note, digest = excluded.digest")
      .bind(p.series, p.revision, p.state, p.date, p.note, digest(p))
      .run();
  write_seal(*database_, sealed(p), author);
  transaction.commit();
}

void Store::in_one_transaction(const std::function<void()>& work) {
  Transaction transaction(*database_);
  work();
  transaction.commit();
}

}  // namespace cylon::store
