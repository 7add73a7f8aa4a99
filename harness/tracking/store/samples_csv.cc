#include "harness/tracking/store/samples_csv.h"

#include "harness/core/input_error.h"
#include "harness/tracking/store/json_object.h"
#include "reports/csv.h"
#include "reports/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <map>
#include <ostream>
#include <utility>
#include <vector>

namespace cylon::store {
namespace {

constexpr const char* columns[] = {
    "run",        "label",      "revision",      "order",  "date",           "machine",
    "build",      "scenario",   "scenario_hash", "engine", "engine_version", "path",
    "integrator", "precision",  "settings",      "dt",     "metric",         "kind",
    "unit",       "repetition", "value",         "text"};

std::string number(double value) { return std::isnan(value) ? "" : fmt::format("{:.17g}", value); }

// ---- In ------------------------------------------------------------------------------------------------

// The lines of a document as fields; a quoted field may hold commas, quotes ("") and line ends.
class Lines {
 public:
  Lines(std::string_view text, Place& place) : text_(text), place_(place) {}

  // The next line's fields; false at the end.  The place is that of its start.
  bool next(std::vector<std::string>& fields) {
    place_.line += lines_taken_;
    lines_taken_ = 0;
    if (at_ >= text_.size()) return false;
    fields.assign(1, "");
    while (at_ < text_.size()) {
      const char c = text_[at_++];
      if (c == '"') {
        quoted(fields.back());
      } else if (c == ',') {
        fields.emplace_back();
      } else if (c == '\n') {
        ++lines_taken_;
        break;
      } else if (c != '\r') {
        fields.back() += c;
      }
    }
    return true;
  }

 private:
  void quoted(std::string& field) {
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      if (c == '"' && text_.substr(at_ + 1, 1) != "\"") {
        ++at_;
        return;
      }
      if (c == '"') ++at_;
      if (c == '\n') ++lines_taken_;
      field += c;
    }
    place_.refuse("a quoted field does not end");
  }

  std::string_view text_;
  Place& place_;
  std::size_t at_ = 0;
  unsigned lines_taken_ = 0;
};

struct Row {
  const Place& place;
  const std::map<std::string, std::size_t>& where;
  const std::vector<std::string>& fields;

  std::string text(const char* column) const {
    const auto found = where.find(column);
    if (found == where.end()) return "";
    const std::string& field = fields[found->second];
    return reports::csv_unguarded(field);
  }

  [[noreturn]] void refuse(const char* column, const std::string& why) const {
    place.refuse(fmt::format("column {}: '{}' {}", column, reports::head(clean(text(column)), 60), why));
  }

  std::string needed(const char* column) const {
    std::string value = text(column);
    if (value.empty()) refuse(column, "must not be empty");
    return value;
  }

  template <class Number>
  Number number(const char* column, Number otherwise, const char* range) const {
    const std::string value = text(column);
    if (value.empty()) return otherwise;
    Number read{};
    const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), read);
    if (error != std::errc() || end != value.data() + value.size()) refuse(column, range);
    if constexpr (std::is_floating_point_v<Number>)
      if (!std::isfinite(read)) refuse(column, range);
    return read;
  }
};

RunInfo run_of(const Row& row) {
  RunInfo r;
  r.label = row.text("label");
  r.revision = row.needed("revision");
  if (!row.text("order").empty())
    r.revision_order = row.number<std::int64_t>("order", 0, "must be a whole number");
  r.date = row.text("date");
  r.machine = row.text("machine");
  r.build = row.text("build");
  r.complete = true;
  r.uid = row.text("run");
  if (r.uid.empty()) r.uid = run_uid(r, 0);
  if (r.uid.size() != 16 || r.uid.find_first_not_of("0123456789abcdef") != std::string::npos)
    row.refuse("run", "must be 16 hex digits, or empty");
  return r;
}

Cell cell_of(const Row& row) {
  Cell c;
  c.scenario = row.needed("scenario");
  c.scenario_hash = row.text("scenario_hash");
  c.engine = row.needed("engine");
  c.path = row.text("path");
  c.integrator = row.text("integrator");
  c.precision = row.text("precision");
  c.settings = row.text("settings");
  c.dt = row.number("dt", 0.0, "must be a number >= 0");
  if (c.dt < 0) row.refuse("dt", "must be a number >= 0");
  c.dt_text = row.text("dt");
  c.hash = cell_hash(c);
  return c;
}

Sample sample_of(const Row& row) {
  Sample s;
  s.metric.name = row.needed("metric");
  const auto kind = kind_from(row.needed("kind"));
  if (!kind) row.refuse("kind", "is none of exact, error, time, size, info");
  s.metric.kind = *kind;
  s.metric.unit = row.text("unit");
  s.repetition = row.number<std::int64_t>("repetition", 0, "must be a whole number >= 0");
  if (s.repetition < 0) row.refuse("repetition", "must be a whole number >= 0");
  s.value = row.number("value", s.value, "must be a finite number, or empty");
  s.text = row.text("text");
  if (!s.text.empty() && !std::isnan(s.value)) row.refuse("text", "stands beside a value: one of them only");
  return s;
}

std::map<std::string, std::size_t> header(const std::vector<std::string>& fields, const Place& place) {
  const std::vector<std::string> known(std::begin(columns), std::end(columns));
  std::map<std::string, std::size_t> where;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (std::find(known.begin(), known.end(), fields[i]) == known.end())
      place.refuse(
          fmt::format("unknown column '{}'{}", clean(fields[i]), core::did_you_mean(fields[i], known)));
    if (!where.emplace(fields[i], i).second) place.refuse(fmt::format("column '{}' stands twice", fields[i]));
  }
  for (const char* needed : {"revision", "scenario", "engine", "metric", "kind"})
    if (!where.contains(needed)) place.refuse(fmt::format("there is no column '{}'", needed));
  if (!where.contains("value") && !where.contains("text")) place.refuse("there is no column 'value'");
  return where;
}

using Key = std::pair<std::string, std::string>;  // run's uid, cell's hash

struct Read {
  std::vector<RunInfo> runs;                    // in the order of the file
  std::vector<std::pair<Key, Result>> results;  // likewise
  std::vector<Place> places;                    // of the first line of each
};

Read read_all(std::string_view document, Place place) {
  Lines lines(document, place);
  std::vector<std::string> fields;
  if (!lines.next(fields)) place.refuse("is empty");
  const auto where = header(fields, place);
  const std::size_t width = fields.size();
  Read read;
  std::map<std::string, std::size_t> run_at;
  std::map<Key, std::size_t> result_at;
  while (lines.next(fields)) {
    if (fields.size() == 1 && fields[0].empty()) continue;
    if (fields.size() != width)
      place.refuse(fmt::format("{} fields, where the header has {}", fields.size(), width));
    const Row row{place, where, fields};
    const RunInfo run = run_of(row);
    if (run_at.try_emplace(run.uid, read.runs.size()).second) read.runs.push_back(run);
    const Cell cell = cell_of(row);
    const auto [at, fresh] = result_at.try_emplace({run.uid, cell.hash}, read.results.size());
    if (fresh) {
      read.results.emplace_back(at->first, Result{cell, row.text("engine_version"), "", {}, {}});
      read.places.push_back(place);
    }
    read.results[at->second].second.samples.push_back(sample_of(row));
  }
  return read;
}

}  // namespace

void write_samples_csv(const Store& store, std::ostream& out) {
  // Numbers go as they are: a minus sign is no formula.
  for (const char* separator = ""; const char* column : columns)
    out << std::exchange(separator, ",") << column;
  out << "\r\n";
  for (const RunInfo& r : store.runs())
    for (const Result& result : store.results(r.id))
      for (const Sample& s : result.samples) {
        const Cell& c = result.cell;
        const auto texts = [&](std::initializer_list<std::string_view> fields) {
          for (const std::string_view field : fields) out << reports::csv_field(field) << ',';
        };
        texts({r.uid, r.label, r.revision});
        out << r.revision_order.value_or(0) << ',';
        texts({r.date, r.machine, r.build, c.scenario, c.scenario_hash, c.engine, result.engine_version,
               c.path, c.integrator, c.precision, c.settings});
        out << number(c.dt) << ',';
        texts({s.metric.name, name(s.metric.kind), s.metric.unit});
        out << s.repetition << ',' << number(s.value) << ',' << reports::csv_field(s.text) << "\r\n";
      }
}

Imported read_samples_csv(Store& store, std::string_view document, const std::string& file) {
  const Read read = read_all(document, {file, 1});
  Imported imported;
  store.in_one_transaction([&] {
    std::map<std::string, std::int64_t> ids;
    for (const RunInfo& run : read.runs) imported.runs += store.import_run(run, ids[run.uid]) ? 1 : 0;
    for (std::size_t i = 0; i < read.results.size(); ++i) {
      const auto& [key, result] = read.results[i];
      if (const std::string word = twice(result); !word.empty())
        read.places[i].refuse(fmt::format("{}: {} stands twice", result.cell.name(), word));
      const std::string stored = store.stored_digest(ids[key.first], key.second);
      if (!stored.empty() && stored != digest(result))
        read.places[i].refuse(
            fmt::format("{} of run {} is in the store with other values", result.cell.name(), key.first));
      if (stored.empty()) store.add(ids[key.first], result);
      ++(stored.empty() ? imported.results : imported.here_already);
    }
  });
  return imported;
}

}  // namespace cylon::store
