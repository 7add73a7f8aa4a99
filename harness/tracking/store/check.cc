// Integrity check of the store: digests and references.
#include "harness/tracking/store/database.h"
#include "harness/tracking/store/store.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace cylon::store {
namespace {

std::map<std::string, std::string> stored_digests(Database& database, std::int64_t run) {
  std::map<std::string, std::string> digests;
  Query row =
      database.query("SELECT c.hash, r.digest FROM result r JOIN cell c ON c.id = r.cell WHERE r.run = ?");
  row.bind(run);
  while (row.step()) {
    const std::string cell = row.text();
    digests[cell] = row.text();
  }
  return digests;
}

// `sql` gives a key and the digest that was stored; `key_and_word` the key of a row and what a user calls it.
template <class Row, class KeyAndWord>
void require_digests(Database& database, const char* sql, const std::vector<Row>& rows,
                     KeyAndWord key_and_word, std::vector<std::string>& findings) {
  std::map<std::string, std::string> stored;
  Query query = database.query(sql);
  while (query.step()) {
    const std::string key = query.text();
    stored[key] = query.text();
  }
  for (const Row& row : rows)
    if (const auto [key, word] = key_and_word(row); stored[key] != digest(row))
      findings.push_back(fmt::format("the stored values of {} have changed", clean(word)));
}

}  // namespace

std::vector<std::string> Store::check() const {
  std::vector<std::string> findings;
  for (const std::string& found : database_->damage(true)) findings.push_back(clean(found));
  if (!findings.empty()) return findings;    // what is read of damaged pages means nothing
  std::map<std::string, std::string> names;  // which hold the step as it was given
  {
    Query row = database_->query("SELECT hash, name FROM cell");
    while (row.step()) {
      const std::string hash = row.text();
      names[hash] = row.text();
    }
  }
  for (const Cell& cell : cells())
    if (cell_hash(cell) != cell.hash || names[cell.hash] != cell.name())
      findings.push_back(fmt::format("cell {} ({}) does not match its hash", cell.hash, cell.name()));
  require_digests(
      *database_, "SELECT uid, digest FROM run", runs(),
      [](const RunInfo& run) { return std::pair(run.uid, run.revision); }, findings);
  require_digests(
      *database_, "SELECT name, digest FROM anchor", anchors(),
      [](const Anchor& anchor) { return std::pair(anchor.name, anchor.name); }, findings);
  require_digests(
      *database_, "SELECT series || ' ' || revision, digest FROM change_point", change_points(),
      [](const ChangePoint& p) { return std::pair(p.series + " " + p.revision, p.revision); }, findings);
  for (const RunInfo& run : runs()) {
    const auto digests = stored_digests(*database_, run.id);
    for (const Result& result : results(run.id)) {
      const auto stored = digests.find(result.cell.hash);
      if (stored == digests.end() || stored->second != digest(result))
        findings.push_back(fmt::format("run {} of {}: the values of {} have changed since they were stored",
                                       run.id, run.revision, result.cell.name()));
    }
  }
  return findings;
}

}  // namespace cylon::store
