// What sources would compile each for itself: reading and writing JSON takes 1.3 s of the compiler.
// templates/json.cc compiles it for all of them.  For precompiled headers alone; no source includes it.
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace cylon::templates {
using FromString = nlohmann::detail::iterator_input_adapter<std::string::const_iterator>;
using FromView = nlohmann::detail::iterator_input_adapter<const char*>;
}  // namespace cylon::templates

#define CYLON_JSON_TEMPLATES(prefix, Json)                                            \
  prefix template class nlohmann::detail::serializer<Json>;                           \
  prefix template class nlohmann::detail::json_sax_dom_parser<Json>;                  \
  prefix template class nlohmann::detail::json_sax_dom_callback_parser<Json>;         \
  prefix template class nlohmann::detail::lexer<Json, cylon::templates::FromString>;  \
  prefix template class nlohmann::detail::lexer<Json, cylon::templates::FromView>;    \
  prefix template class nlohmann::detail::parser<Json, cylon::templates::FromString>; \
  prefix template class nlohmann::detail::parser<Json, cylon::templates::FromView>;

CYLON_JSON_TEMPLATES(extern, nlohmann::json)
CYLON_JSON_TEMPLATES(extern, nlohmann::ordered_json)
