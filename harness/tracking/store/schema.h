// The tables of the store, and how an older file becomes today's.  Forward only.
#pragma once

#include "harness/tracking/store/database.h"

#include <span>

namespace cylon::store {

/// What marks a file as a store of Cylon: "CYLN" in the header of SQLite.
inline constexpr std::int64_t application_id = 0x43594c4e;

/// Script n makes schema n + 1 of schema n, which the header keeps as user_version.
std::span<const char* const> migrations();

/// Refuses a file that is no store or of a newer schema, and leaves it untouched.  An empty database is none
/// yet: returns its schema, 0.
std::int64_t require_ours(Database&, std::span<const char* const> scripts = migrations());

/// Runs the scripts that the file lacks, all in one transaction.
void migrate(Database&, std::span<const char* const> scripts = migrations());

}  // namespace cylon::store
