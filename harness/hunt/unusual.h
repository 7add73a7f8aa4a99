// Random scenes of what few scenes hold: locked bodies, shapes of points and of parts, water; and any scene in another
// size, with another mass and another step.
#pragma once

#include "harness/core/scene.h"
#include "harness/hunt/dice.h"
#include "harness/hunt/trial.h"

namespace cylon::hunt {

/// Solids that fall onto locked ones, with a material of its own for one pair; half of them with a floor below.
void make_furniture(Dice&, core::Scene&);

/// Hulls and compounds that fly, spin, and hit each other or a floor.
void make_points_and_parts(Dice&, core::Scene&);

/// Solids that sink, float or are thrown into water, calm or with waves.
void make_bath(Dice&, core::Scene&);

/// The same scene a thousand times smaller to a thousand times larger, under the same acceleration: lengths by 4^k, times by 2^k,
/// masses by any power of two, so that an engine that knows no length of its own gives the same numbers to the last bit.  Where
/// water acts, whose numbers have two dimensions (restate.h), or a plug-in's force, the step alone changes.
void set_far_from_one(Dice&, Trial&);

}  // namespace cylon::hunt
