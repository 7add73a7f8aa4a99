// Files written whole or not at all.
#pragma once

#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

namespace cylon::cli {

/// Writes to a file beside `path` and renames it, so that a reader never sees half of it.  A symbolic link is
/// followed; a device or a pipe is written as it stands; "-" is stdout.  Throws core::InputError where that
/// cannot be.
void write_whole(const std::string& path, std::string_view text);

/// The same for what is too large to be held in memory; nothing is left where `write` throws.
void write_whole(const std::string& path, const std::function<void(std::ostream&)>& write);

/// The words of the command line: a file that they name more than once is read by the command, so that it is not written.
void note_words(std::span<const std::string> words);

/// Throws core::InputError now where write_whole could not write later: a missing folder, a directory in the
/// way, and for a file that the command line names twice.
void require_writable(const std::string& path);

/// The same for several files, of which no two may be one; an empty path is none.
void require_writable(std::span<const std::string> paths);

}  // namespace cylon::cli
