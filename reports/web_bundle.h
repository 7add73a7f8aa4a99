// Script and style of the report and the live viewer (reports/web), embedded in the program.
#pragma once

#include <string_view>

namespace cylon::web {

/// What a page puts between <script> and </script>, and between <style> and </style>.
std::string_view script();
std::string_view style();

/// "sha256-…" of the script, for a Content-Security-Policy.
std::string_view script_hash();

}  // namespace cylon::web
