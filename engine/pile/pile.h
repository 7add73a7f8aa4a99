// Many bodies, or bodies in stacks: fixed steps, contacts by sequential impulses, joints as further rows.
#pragma once

#include "engine/model.h"
#include "engine/pile/settings.h"
#include "engine/stepper.h"

#include <cstdint>
#include <memory>

namespace cylon::engine {

/// A stepper for any model without a rotating frame.  Spheres and planes without joints take a path of their
/// own, structure of arrays and eight contacts at once.  First order in dt; second where all contacts are
/// solved to rounding and nothing strikes.  Nothing passes through anything as long as no body moves farther
/// than half its smallest half-width in dt / 16; a diagnostic says when one did.  Another order of the bodies
/// is another order of the sweeps, and another, equally good, solution.
/// `first`: the step at which it starts.
std::unique_ptr<Stepper> make_pile(const Model&, Time dt, const PileSettings& = {}, std::int64_t first = 0);

}  // namespace cylon::engine
