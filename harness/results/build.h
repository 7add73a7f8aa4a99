// What runs an engine that is no native code.  Knows a version's text alone.
#pragma once

#include <string>
#include <string_view>

namespace cylon::results {

/// What the version of an engine says in brackets at its end: "WebAssembly in Node 20.20.2" of "1.1.0 (WebAssembly in Node
/// 20.20.2)"; empty where it says nothing, which is native code.  Costs of two builds do not compare.
std::string build_of(std::string_view version);

/// The same in words: "native code" where it says nothing.
std::string build_in_words(std::string_view version);

}  // namespace cylon::results
