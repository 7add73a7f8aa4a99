// How a worker ended, without the line of stderr that stands behind it.
#pragma once

#include <string>

namespace cylon::process {

/// "exited 3 before done: 0x7f31: bad body" → "exited 3 before done".  What stands behind Child::ending()'s words is the
/// last line of the worker's stderr, in which process ids and addresses differ from run to run.  Any other text as it is.
std::string without_last_words(const std::string&);

}  // namespace cylon::process
