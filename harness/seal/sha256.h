// SHA-256, by libsodium: tells files and programs apart.
#pragma once

#include <string>
#include <string_view>

namespace cylon::seal {

/// 64 hex digits, FIPS 180-4.
std::string sha256(std::string_view message);

}  // namespace cylon::seal
