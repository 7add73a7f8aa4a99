// Which engines, variants and integrators a scenario is tried with.
#pragma once

#include "harness/study/sweep.h"

#include <span>
#include <string>
#include <vector>

namespace cylon::study {

struct SettingsRequest {
  std::vector<std::string> engines;      ///< Globs over the rows, or ids with variants; none: all, with those
                                         ///< variants that matter to the scene.
  std::vector<std::string> integrators;  ///< Globs over the integrators; none: all.
  bool searched = false;  ///< Rows that are named without a variant stand for those variants too.
};

/// Engine by engine, variant by variant, integrator by integrator.  Where nothing is asked for: every row;
/// of engines in double precision also every value that is not the engine's own of the options `gyro` and
/// `rotation` where a body turns, `solver` and `friction-direction` where something may touch, `springs`
/// where there are springs; and, once for each worker, the paths "stepping" where something may touch and
/// "as-expert".  An engine that cannot be started has one setting without an integrator.  Throws
/// core::InputError for unknown words, process::Interrupted.
std::vector<Setting> settings(const scenario::Scenario&, std::span<const process::EngineRow>,
                              const SettingsRequest&);

/// Whether the gyroscopic term can matter: a body that moves has unequal moments and turns, or may be turned.
bool turns(const core::Scene&);

/// Whether any pair may touch.
bool touches(const core::Scene&);

/// "bullet" and "gyro=none" -> "bullet/gyro=none".
std::string with_option(const std::string& id, const std::string& option);

}  // namespace cylon::study
