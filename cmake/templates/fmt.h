// What sources would compile each for itself: fmt::format_to takes 1.5 to 2.5 s of the compiler.
// templates/fmt.cc compiles it for all of them.  For precompiled headers alone; no source includes it.
#pragma once

#include <fmt/format.h>

extern template void fmt::detail::vformat_to<char>(fmt::detail::buffer<char>&, fmt::string_view,
                                                   fmt::basic_format_args<fmt::format_context>,
                                                   fmt::detail::locale_ref);
