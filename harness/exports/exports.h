// A scenario as a scene of another project: MJCF and SDFormat, of what these formats can say.  What one cannot say is an
// error that names key and line; nothing is left out.
//
// Written with z up and in such a way that harness/imports makes the same scene of it again, to rounding: masses,
// inertias, poses, joints with what acts along them, contacts and gravity.  Names, claims and the story are not.
#pragma once

#include "harness/scenario/scenario.h"

#include <string>
#include <string_view>
#include <vector>

namespace cylon::exports {

struct Exported {
  std::string xml;
  std::vector<std::string> notes;  ///< What who reads the file must know, one line each.
};

/// `format`: "MJCF" or "SDFormat".  `text`: of the scenario's file, for the lines of errors.  Throws core::InputError.
Exported export_scenario(const scenario::Scenario&, std::string_view text, std::string_view format);

}  // namespace cylon::exports
