// What `--baseline` means: a build folder, a `cylon` binary, a git revision that is built here, or a stored
// run.
#pragma once

#include "harness/cli/context.h"
#include "harness/study/cell.h"
#include "harness/study/side.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace cylon::tracking {

/// The workers of a folder, under the ids of Cylon's own engines.
study::Side side_of_folder(const std::string& name, const std::filesystem::path& folder);

/// The folder of workers that a user means by a build folder, the prefix of an installation or a binary in either;
/// nothing where the word is none of these.
/// Throws core::InputError for a folder without workers.
std::optional<std::filesystem::path> worker_folder(const std::string& word);

/// The full hash of a revision of the repository that this Cylon was built from; nothing where git knows
/// none.
std::optional<std::string> revision_of(const cli::Context&, const std::string& word);

/// The workers that the cells need, built of that revision in a worktree under .cylon/baselines/ of the
/// working folder (preset release, with ccache where it is installed), and kept there; a second call only
/// looks whether they are there.  A worker that the revision does not have is left out.  Says on stderr what
/// it does. Throws core::InputError, naming the log, where it cannot be checked out or built.
study::Side side_of_revision(const cli::Context&, const std::string& word, const std::string& sha,
                             const std::vector<study::Cell>&);

}  // namespace cylon::tracking
