// The viewer's page and the rules that a browser keeps for it.
#pragma once

#include <string>

namespace cylon::view {

/// <html data-page="view"> with the script and the style that are embedded in the program.  It holds no secret: anybody
/// may ask for it.
std::string page();

/// Content-Security-Policy of every answer: this script alone, no other origin, in no frame.
std::string security_policy();

/// 128 random bits as 32 hex digits.  Throws std::runtime_error where the system gives none.
std::string random_token();

}  // namespace cylon::view
