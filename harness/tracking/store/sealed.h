// The texts that are sealed, one for each row that a user writes, and the table that keeps their seals.
#pragma once

#include "harness/tracking/store/database.h"
#include "harness/tracking/store/store.h"

#include <cstdint>
#include <string>

namespace cylon::store {

/// What a seal is of: its row by kind and id, what a user calls it, and the text.
struct Sealed {
  std::string kind, id, word, text;
};

/// `results`: seals_of_results() of the run, so that none can be taken away from a run that is complete.
Sealed sealed(const RunInfo&, const std::string& results);
Sealed sealed(const Result&, const std::string& run_uid);
Sealed sealed(const Anchor&);
Sealed sealed(const ChangePoint&);

/// The seals of a run's results in the order of their ids.
std::string seals_of_results(Database&, std::int64_t run);
std::string uid_of(Database&, std::int64_t run);

/// Writes the user's seal; of an import takes away what was there.
void write_seal(Database&, const Sealed&, Author);

/// The seal that the store has of it; "" where none.
std::string read_seal(Database&, const Sealed&);
bool seal_holds(const std::string& mac, const Sealed&);

}  // namespace cylon::store
