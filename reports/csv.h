// Verdict rows as CSV, for spreadsheets.
#pragma once

#include "harness/results/verdict.h"

#include <string>
#include <string_view>
#include <vector>

namespace cylon::reports {

/// RFC 4180: a header with the JSON rows' names, then a line per verdict, CRLF.  Numbers with 17 digits,
/// empty where they are not finite; lists and settings joined by "; ".  A text that a spreadsheet would run
/// as a formula (it begins with = + - @, a tab or a carriage return) gets an apostrophe in front; control
/// characters other than tab and line ends are escaped.
std::string to_csv(const std::vector<results::Verdict>&);

/// One text as a field of such a file.
std::string csv_field(std::string_view);

/// A field's text without the guarding apostrophe.
std::string csv_unguarded(std::string_view);

}  // namespace cylon::reports
