// What is refused before the library of a format sees it: elements nested so deep that its recursion could exhaust the
// stack, or takes time quadratic in the depth.
#pragma once

#include <string>
#include <string_view>

namespace cylon::imports {

/// Elements inside each other; in MJCF each body of a chain is in the one before.  TinyXML-2, which reads MJCF and SDFormat,
/// takes as many; urdfdom has no limit.
inline constexpr int deepest_xml = 500;

/// Throws core::InputError at the first element that is deeper.  Comments, CDATA, instructions and attributes hold no
/// elements.  Files that this one includes are not looked at.
void require_shallow_xml(std::string_view text, const std::string& file);

}  // namespace cylon::imports
