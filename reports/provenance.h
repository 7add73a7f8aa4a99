// Which build on which machine made the rows of a report.
#pragma once

#include <string>

namespace cylon::reports {

/// The only part of a report that may differ between two runs of the same input (with CPU times).
struct Provenance {
  std::string cylon;           ///< Version: "0.1.0".
  std::string revision;        ///< Of the source, from git; empty when it is not known.
  std::string compiler;        ///< "gcc 12.2.0"
  std::string flags;           ///< That decide the bits of a result.
  std::string machine;         ///< Processor and number of logical CPUs.
  std::string os;              ///< "Debian GNU/Linux 12 (bookworm), Linux 6.1.0 x86_64"
  std::string date;            ///< ISO 8601; given by the caller, never read from a clock here.
  std::string command_line;    ///< Given by the caller.
  double tolerance_scale = 1;  ///< By which all tolerances were multiplied; 1: a plain run.
};

/// Fills everything but the date, the command line and the scale of the tolerances.  The build may define
/// CYLON_VERSION, CYLON_REVISION and CYLON_FLAGS; without them the version is "unknown", the revision empty
/// and the flags are those that the compiler's own macros give away.
Provenance build_and_machine();

}  // namespace cylon::reports
