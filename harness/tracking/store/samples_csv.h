// Samples as CSV, one a line: for spreadsheets, and for numbers that were measured elsewhere.
#pragma once

#include "harness/tracking/store/json_lines.h"
#include "harness/tracking/store/store.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace cylon::store {

/// RFC 4180 with a header and CRLF: run, label, revision, order, date, machine, build, scenario,
/// scenario_hash, engine, engine_version, path, integrator, precision, settings, dt, metric, kind, unit,
/// repetition, value, text. Verdicts and notes are left out; a text that a spreadsheet would run as a formula
/// gets an apostrophe.
void write_samples_csv(const Store&, std::ostream&);

/// Adds the lines of such a document in one transaction; columns in any order, of which revision, scenario,
/// engine, metric, kind and value or text are needed.  Lines that agree in all that describes a run are one
/// run, whose uid is `run` or, where that is empty, the hash of these columns: the same file again adds
/// nothing.  Throws core::InputError with the line, the column and the value.
Imported read_samples_csv(Store&, std::string_view document, const std::string& file);

}  // namespace cylon::store
