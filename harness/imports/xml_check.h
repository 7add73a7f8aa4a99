// What is refused before the library of a format sees it: elements nested so deep that its recursion could exhaust the
// stack, or takes time quadratic in the depth; more bodies than an import takes; a root that is another format's;
// numbers that are none; and a second element where there is one, which urdfdom and libsdformat leave out.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cylon::imports {

/// Elements inside each other.  TinyXML-2, which reads SDFormat, takes as many; urdfdom has no limit.  In MJCF each body
/// of a chain is in the one before, and the limit is lower (program.cc).
inline constexpr int deepest_xml = 500;

/// Bodies of one model.  The limits of time and memory may end the library before: MuJoCo took 36 s for 10 000 free bodies,
/// libsdformat takes 0.85 MB a link.  The error names the count then.
inline constexpr std::size_t most_bodies = 20'000;

struct XmlFacts {
  std::string root;               ///< The name of the first element; "" where there is none.
  unsigned line = 0, column = 0;  ///< Of the root.
  std::size_t bodies = 0;         ///< Elements of the name `body`, but for those of a <state> or a <plugin>.
};

/// Throws core::InputError at the first element that is deeper than `deepest`, at the first `body` (the name of the format's elements)
/// beyond most_bodies and at a second root.  Comments, CDATA, instructions and attributes hold no elements.  Files that this
/// one includes are not looked at.
XmlFacts require_small_xml(std::string_view text, const std::string& file, std::string_view body,
                           int deepest = deepest_xml);

/// Throws core::InputError at the first attribute that has NaN for a number: MuJoCo takes it for one that is not given.
void require_no_nan(std::string_view text, const std::string& file);

/// Of URDF and SDFormat.  Throws core::InputError at the first part of a link or joint that has one of its kind already,
/// such as a second <inertial>: the libraries read one of them and say nothing.
void require_single(std::string_view text, const std::string& file);

}  // namespace cylon::imports
