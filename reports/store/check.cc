// Whether what is read is what was written.
#include "reports/store/database.h"
#include "reports/store/store.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

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

}  // namespace

std::vector<std::string> Store::check() const {
  std::vector<std::string> findings;
  {
    Query row = database_->query("PRAGMA integrity_check");
    while (row.step())
      if (const std::string said = row.text(); said != "ok") findings.push_back("the pages: " + clean(said));
  }
  {
    Query row = database_->query("PRAGMA foreign_key_check");
    while (row.step()) findings.push_back(fmt::format("table {}: a row refers to none", clean(row.text())));
  }
  if (!findings.empty()) return findings;  // what is read of damaged pages means nothing
  for (const Cell& cell : cells())
    if (cell_hash(cell) != cell.hash)
      findings.push_back(fmt::format("cell {} ({}) is not what its hash says", cell.hash, cell.name()));
  for (const RunInfo& run : runs()) {
    const auto digests = stored_digests(*database_, run.id);
    for (const Result& result : results(run.id)) {
      const auto stored = digests.find(result.cell.hash);
      if (stored == digests.end() || stored->second != digest(result))
        findings.push_back(fmt::format("run {} of {}: the values of {} are not those that were stored",
                                       run.id, run.revision, result.cell.name()));
    }
  }
  return findings;
}

}  // namespace cylon::store
