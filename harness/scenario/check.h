// The key tables applied to a parsed document.
#pragma once

#include "harness/scenario/keys.h"

#include <toml++/toml.h>

#include <string>

namespace cylon::scenario {

/// Throws core::InputError for the first unknown key, missing key, wrong type, value out of its range, or
/// word that is no choice, anywhere below the table.
void check(const toml::table&, const Spec&, const std::string& file);

}  // namespace cylon::scenario
