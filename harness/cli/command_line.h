// Words of a command line, as a shell and a person read them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::cli {

/// The word as a POSIX shell takes it for itself: bare where that is safe, else in single quotes.
std::string shell_word(std::string_view);

/// The words with spaces between, each as a shell takes it.
std::string shell_command(std::span<const std::string> words);

/// How this program is called again: "cylon", and with it --sandbox where engines run in one now, so that a command which
/// is printed starts no stranger's engine without.
std::vector<std::string> program_words();

/// A foreign text that cannot command the terminal: control characters and bytes that are no UTF-8 are
/// escaped; line ends stay.
std::string plain(std::string_view);

/// The same, line ends escaped as well.
std::string plain_line(std::string_view);

}  // namespace cylon::cli
