// Families of scenes toward what engines are known to do wrong: few bodies, numbers near the weak spot.
#pragma once

#include "harness/core/scene.h"
#include "harness/hunt/dice.h"

namespace cylon::hunt {

/// One free body that spins fast: a ball by radians in a step, or a box mostly about its middle axis.
void make_spin(Dice&, core::Scene&);

/// One ball that falls onto a level plane.
void make_drop(Dice&, core::Scene&);

/// Two balls of unlike masses that hit each other off their centres, without gravity.
void make_blow(Dice&, core::Scene&);

/// One box that slides on a level plane, in any direction.
void make_slide(Dice&, core::Scene&);

/// Equal cubes on each other, now and then under a heavy one.
void make_tower(Dice&, core::Scene&);

/// Equal balls in a row that touch each other, and one that hits them; all on one line, without gravity.
void make_cradle(Dice&, core::Scene&);

}  // namespace cylon::hunt
