// What a user gets for input that cannot be: the place, the key, the valid range, the nearest valid name.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::core {

/// what() reads "file:line:column: message", cut to 2000 bytes; line 0 leaves the place out.  Programs exit
/// with 2.
struct InputError : std::runtime_error {
  explicit InputError(const std::string& message);
  InputError(const std::string& file, unsigned line, unsigned column, const std::string& message);

  std::string file;               ///< Empty where no file is at fault.
  unsigned line = 0, column = 0;  ///< From 1; 0: the file as a whole.
};

/// ", did you mean 'x'?" for the candidate with the least edit distance, at most a third of the
/// longer word away (two letters at least); else "".  Words of more than 64 bytes, and candidates beyond the
/// first 10 000, are not looked at.
std::string did_you_mean(std::string_view word, std::span<const std::string> candidates);

}  // namespace cylon::core
