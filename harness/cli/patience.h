// Locks of files that another process may hold for an instant after it has ended.
#pragma once

#include <functional>

namespace cylon::cli {

/// Whether `lock` succeeds within a second.  A lock belongs to a file that is open; what a cylon was about to
/// start when it was killed has the same file open until it executes: an instant.
bool locks_in_a_moment(const std::function<bool()>& lock);

}  // namespace cylon::cli
