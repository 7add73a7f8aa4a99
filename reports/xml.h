// Foreign text as XML 1.0.
#pragma once

#include <string>
#include <string_view>

namespace cylon::reports {

/// The text for an attribute or an element: markup as entities, line ends as character references (an
/// attribute would turn them into spaces), and what XML or a terminal must not see escaped.
std::string xml(std::string_view);

}  // namespace cylon::reports
