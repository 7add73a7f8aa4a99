// The tables of the store, and how an older file becomes today's.  Forward only.
#pragma once

#include "harness/tracking/store/database.h"

#include <span>

namespace cylon::store {

/// Script n makes schema n + 1 of schema n, in the words of SQLite.
std::span<const char* const> migrations();

/// Refuses a database that is no store or of a newer schema, and leaves it untouched.  An empty database is none
/// yet: returns its schema, 0.
std::int64_t require_ours(Database&, std::span<const char* const> scripts = migrations());

/// Refuses one that is empty or older, too: what is only read must be of today's schema.
void require_today(Database&);

/// Runs the scripts that the database lacks, all in one transaction.
void migrate(Database&, std::span<const char* const> scripts = migrations());

}  // namespace cylon::store
