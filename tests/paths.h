// Where the tests find what they read and run.  The build writes the definitions into a source of its own, so
// that no other source, and no entry of a compiler cache, depends on where the repository stands.
#pragma once

namespace cylon {

extern const char* const source_dir;  ///< The repository.
extern const char* const binary_dir;  ///< The build folder, with cylon and its workers.

}  // namespace cylon
