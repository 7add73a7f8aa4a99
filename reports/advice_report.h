// An advice for people and programs.
#pragma once

#include "harness/results/advice.h"
#include "reports/console_options.h"
#include "reports/provenance.h"

#include <string>

namespace cylon::reports {

/// Two lines per engine: the pick with its margin, the runner-up and what ten times better costs; or how near
/// the engine comes.  Below it what each part of the scene costs.
std::string advice_text(const results::Advice&, const ConsoleOptions&);

/// The same with every number; costs stand in members of their own, "cpu_seconds_per_second".
std::string advice_json(const results::Advice&, const Provenance&);

}  // namespace cylon::reports
