// Verdict rows as JSON: what other programs read, and what --rerun-failed and --resume read back.
#pragma once

#include "harness/results/verdict.h"
#include "reports/provenance.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace cylon::reports {

/// Version of the format; a reader refuses any other.
inline constexpr int schema = 1;

/// A document of `cylon run --json`.
struct RunReport {
  Provenance provenance;
  std::vector<results::Verdict> verdicts;
};

/// Null where the number is not finite.
nlohmann::ordered_json number(double);

nlohmann::ordered_json diagnostic_json(const told::Diagnostic&);

/// One row: every named field in a fixed order, present in every row.  Numbers that are not finite are null.
nlohmann::ordered_json row(const results::Verdict&);
nlohmann::ordered_json provenance_json(const Provenance&);

/// {"schema": 1, "provenance": {…}, "verdicts": […]}
nlohmann::ordered_json document(const RunReport&);

/// The same as text, one row per line, ASCII only (all else as \uNNNN, so that it is harmless on a terminal),
/// doubles with the digits that give the same bits back (17 at most).  Bytes that are no UTF-8 become U+FFFD.
std::string to_json(const std::vector<results::Verdict>&, const Provenance&);

/// Reads such a document.  Keys that it does not know are passed over; what a provenance leaves out is empty.
/// Throws core::InputError, with `file`, line and column or with the row and the key, for anything malformed.
RunReport read_json(std::string_view document, const std::string& file);
RunReport read_document(nlohmann::ordered_json, const std::string& file);

/// A line of a journal, without the line feed.
std::string to_json_line(const results::Verdict&);
results::Verdict from_json_line(std::string_view line, const std::string& file = "journal",
                                unsigned line_number = 1);

}  // namespace cylon::reports
