// SQLite's error codes as sentences for a user.
#pragma once

#include <string>
#include <string_view>

namespace cylon::store {

/// What is wrong and what to do, for a result code of SQLite, its message, and errno where it has one.
std::string complaint(int code, std::string_view message, int error_number);

}  // namespace cylon::store
