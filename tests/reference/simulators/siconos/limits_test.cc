// Each reason for which Siconos refuses a scene, and the scene beside it that it takes.
#include "reference/simulators/siconos/siconos_limits.h"

#include "tests/reference/simulators/refusals.h"

namespace cylon::simulators {
namespace {

const Refusal refusals[] = {
    {"Siconos needs a mass above zero of what moves; 'b' has 0 kg.", [](Scene& s) { s.bodies[1].mass = 0; },
     [](Scene& s) { s.bodies[1].mass = 0, s.bodies[1].locked = true; }},
    {"Siconos needs principal moments above zero of what moves; 'c' has one of 0 kg m^2.",
     [](Scene& s) { s.bodies[2].inertia(1, 1) = 0; },
     [](Scene& s) { s.bodies[2].inertia(1, 1) = 0, s.bodies[2].locked = true; }},
    {"Siconos has joints in its library of mechanics alone, which this adapter leaves out; 'c' has one of "
     "type "
     "ball.",
     [](Scene& s) { s.joints = {joint(core::JointType::ball, 2, 0)}; },
     [](Scene& s) {
       s.joints = {joint(core::JointType::ball, 2, 0)};
       s.bodies[0].locked = s.bodies[2].locked = true;
     }},
    {"'a' may touch 'b', but the scene has no material for them.",
     [](Scene& s) {
       s.materials = {{{"*", "floor"}, 0.4, 0.3}};
     },
     [](Scene& s) {
       s.materials = {{{"*", "floor"}, 0.4, 0.3}, {{"a", "b"}, 0, 0}};
     }},
    {"Body 'b': the kernel of Siconos has no shapes; this adapter gives it the distances of spheres and "
     "planes "
     "alone.",
     [](Scene& s) {
       s.bodies[1].shape = core::Box{{0.1, 0.2, 0.3}};
     },
     [](Scene& s) {
       s.bodies[1].shape = core::Box{{0.1, 0.2, 0.3}}, s.bodies[1].collide = false;
     }},
    {"Body 'c' in water: a rod has no volume.",
     [](Scene& s) {
       s.forces.emplace_back(core::Water{.level = 1, .buoyancy = 1000});
       s.bodies[2].shape = core::Rod{0.3};
     },
     [](Scene& s) { s.bodies[2].shape = core::Rod{0.3}; }},
};

TEST(SiconosLimits, AreEachASentenceAndNoWider) { expect_each(siconos_limit, refusals); }

TEST(SiconosLimits, NeedAStepForward) { expect_a_step_forward("Siconos"); }

}  // namespace
}  // namespace cylon::simulators
