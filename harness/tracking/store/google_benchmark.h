// Google Benchmark's JSON (--benchmark_out=FILE): its results in the history, and times of the history for
// its tools.
#pragma once

#include "harness/tracking/store/json_lines.h"
#include "harness/tracking/store/store.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace cylon::store {

/// Adds one run.  A benchmark's name is the scenario of its cell and its program the engine; real_time and
/// cpu_time become metrics of kind time in [s], a sample per repetition, user counters metrics of kind info.
/// What the file does not tell (revision, label, compiler, …) comes from `given`; machine and date are the
/// file's.  Aggregates (mean, median, …) are passed over.  Throws core::InputError with the place and the
/// key.
Imported read_google_benchmark(Store&, std::string_view document, const std::string& file,
                               const RunInfo& given);

/// One run as Google Benchmark would have written it: a benchmark per cell that has a time in [s], an entry
/// per repetition.  real_time is what cpu_time is where only that was measured.
void write_google_benchmark(const Store&, const RunInfo&, std::ostream&);

}  // namespace cylon::store
