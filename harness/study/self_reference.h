// A fine run that stands in for a truth where there is none.
#pragma once

#include "harness/study/yardstick.h"

#include <span>

namespace cylon::study {

/// The in-house engine's error-controlled integrator at its finest, where the scenario follows no truth and
/// nothing may touch (an impact magnifies, and a pile is chaos); nothing where the run fails or the engine
/// says that it could not keep the tolerance.
std::optional<Reference> self_reference(const scenario::Scenario&, std::int64_t samples,
                                        std::span<const process::EngineRow>, const process::Limits&);

}  // namespace cylon::study
