#include "harness/tracking/store/sealed.h"

#include "harness/seal/seal.h"

#include <fmt/format.h>

namespace cylon::store {
namespace {

std::string purpose(const Sealed& row) { return fmt::format("store {} {}", row.kind, row.id); }

}  // namespace

Sealed sealed(const RunInfo& run, const std::string& results) {
  return {"run", run.uid, fmt::format("run {} of {}", run.id, run.revision),
          content_of(run) + (run.complete ? "complete " + results : "going on")};
}

Sealed sealed(const Result& result, const std::string& run_uid) {
  const Cell& c = result.cell;
  std::string text = content_of(result);
  // The result names its cell by a short hash alone.
  for (const std::string* part :
       {&c.scenario, &c.scenario_hash, &c.engine, &c.path, &c.integrator, &c.precision, &c.settings})
    text += fmt::format("{}:{}", part->size(), *part);
  text += fmt::format("{:.17g}", c.dt);
  return {"result", run_uid + "/" + c.hash, fmt::format("{} in run {}", c.name(), run_uid), std::move(text)};
}

Sealed sealed(const Anchor& anchor) {
  return {"anchor", anchor.name, fmt::format("anchor {}", anchor.name), content_of(anchor)};
}

Sealed sealed(const ChangePoint& point) {
  return {"change_point", point.series + " " + point.revision, fmt::format("the step at {}", point.revision),
          content_of(point)};
}

std::string uid_of(Database& database, std::int64_t run) {
  Query row = database.query("SELECT uid FROM run WHERE id = ?");
  return row.bind(run).step() ? row.text() : "";
}

std::string seals_of_results(Database& database, std::int64_t run) {
  std::string all;
  Query row = database.query(
      "SELECT coalesce(s.mac, 'none') FROM result r JOIN cell c ON c.id = r.cell JOIN run u ON u.id = r.run "
      "LEFT "
      "JOIN seal s ON s.kind = 'result' AND s.id = u.uid || '/' || c.hash WHERE r.run = ? ORDER BY c.hash");
  row.bind(run);
  while (row.step()) all += row.text() + ";";
  return all;
}

void write_seal(Database& database, const Sealed& row, Author author) {
  const std::string mac = author == Author::user ? seal::seal(purpose(row), row.text) : "";
  if (mac.empty())
    database.query("DELETE FROM seal WHERE kind = ? AND id = ?").bind(row.kind, row.id).run();
  else
    database
        .query(
            "INSERT INTO seal (kind, id, mac) VALUES (?, ?, ?) ON CONFLICT (kind, id) DO UPDATE SET mac = "
            "excluded.mac")
        .bind(row.kind, row.id, mac)
        .run();
}

std::string read_seal(Database& database, const Sealed& row) {
  Query query = database.query("SELECT mac FROM seal WHERE kind = ? AND id = ?");
  return query.bind(row.kind, row.id).step() ? query.text() : "";
}

bool seal_holds(const std::string& mac, const Sealed& row) {
  return seal::holds(mac, purpose(row), row.text);
}

bool Store::is_own(const Anchor& anchor) const {
  const Sealed row = sealed(anchor);
  return seal_holds(read_seal(*database_, row), row);
}

bool Store::is_own(const RunInfo& run) const {
  const Sealed row = sealed(run, seals_of_results(*database_, run.id));
  return seal_holds(read_seal(*database_, row), row);
}

Seals Store::seals() const {
  Seals found;
  const auto look = [&](const Sealed& row) {
    const std::string mac = read_seal(*database_, row);
    if (seal_holds(mac, row))
      ++found.own;
    else if (seal::is_own(mac))
      found.broken.push_back(fmt::format("{} was changed after you recorded it", clean(row.word)));
    else
      ++found.foreign;
  };
  for (const Anchor& anchor : anchors()) look(sealed(anchor));
  for (const ChangePoint& point : change_points()) look(sealed(point));
  for (const RunInfo& run : runs()) {
    look(sealed(run, seals_of_results(*database_, run.id)));
    for (const Result& result : results(run.id)) look(sealed(result, run.uid));
  }
  return found;
}

}  // namespace cylon::store
