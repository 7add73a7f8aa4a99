// Each reason for which DART refuses a scene, and the scene beside it that it takes.
#include "reference/simulators/dart/dart_limits.h"

#include "tests/reference/simulators/refusals.h"

namespace cylon::simulators {
namespace {

const Refusal refusals[] = {
    {"DART needs a mass above zero of what moves; 'b' has 0 kg.", [](Scene& s) { s.bodies[1].mass = 0; },
     [](Scene& s) { s.bodies[1].mass = 0, s.bodies[1].locked = true; }},
    {"DART needs principal moments above zero of what moves; 'c' has one of 0 kg m^2.",
     [](Scene& s) { s.bodies[2].inertia(1, 1) = 0; },
     [](Scene& s) { s.bodies[2].inertia(1, 1) = 0, s.bodies[2].locked = true; }},
    {"DART has no constraint that keeps a distance, such as that of 'c'",
     [](Scene& s) { s.joints = {joint(core::JointType::distance, 2, 0)}; },
     [](Scene& s) {
       s.joints = {joint(core::JointType::distance, 2, 0)};
       s.bodies[0].locked = s.bodies[2].locked = true;
     }},
    {"DART has no joint that turns about an axis and slides along it (dart/dynamics/), such as the "
     "cylindrical one of 'c'.",
     [](Scene& s) { s.joints = {joint(core::JointType::cylindrical, 2, core::world)}; },
     [](Scene& s) { s.joints = {joint(core::JointType::slider, 2, core::world)}; }},
    {"The slider of 'c' closes a loop, for which DART has a ball and a weld alone",
     [](Scene& s) {
       s.joints = {joint(core::JointType::ball, 2, core::world),
                   joint(core::JointType::slider, 2, core::world)};
     },
     [](Scene& s) {
       s.joints = {joint(core::JointType::slider, 2, core::world),
                   joint(core::JointType::ball, 2, core::world)};
     }},
    {"The hinge of 'c' closes a loop, for which DART has a ball and a weld alone",
     [](Scene& s) {
       s.joints = {joint(core::JointType::hinge, 2, core::world),
                   joint(core::JointType::hinge, 2, core::world)};
     },
     [](Scene& s) {
       s.joints = {joint(core::JointType::hinge, 2, core::world),
                   joint(core::JointType::ball, 2, core::world)};
     }},
    {"'a' may touch 'b', but the scene has no material for them.",
     [](Scene& s) {
       s.materials = {{{"*", "floor"}, 0.4, 0.3}};
     },
     [](Scene& s) {
       s.materials = {{{"*", "floor"}, 0.4, 0.3}, {{"a", "b"}, 0, 0}};
     }},
    {"Body 'b': DART's own detector collides spheres and boxes alone",
     [](Scene& s) {
       s.bodies[1].shape = core::Cylinder{0.1, 0.3};
     },
     [](Scene& s) {
       s.bodies[1].shape = core::Cylinder{0.1, 0.3}, s.bodies[1].collide = false;
     }},
    {"DART takes a restitution of at most 0.001 for none",
     [](Scene& s) { s.materials[0].restitution = 1e-3; },
     [](Scene& s) { s.materials[0].restitution = 1.1e-3; }},
    {"DART takes a friction of at most 0.001 for none", [](Scene& s) { s.materials[0].friction = 1e-3; },
     [](Scene& s) { s.materials[0].friction = 0; }},
    {"DART has no contact of two spheres whose centres are within 0.001 m "
     "(collision/dart/DARTCollide.cpp:1342), which is all of a contact of 'a' and 'b'.",
     [](Scene& s) { s.bodies[0].shape = core::Sphere{6e-4}, s.bodies[1].shape = core::Sphere{3e-4}; },
     [](Scene& s) { s.bodies[0].shape = core::Sphere{6e-4}, s.bodies[1].shape = core::Sphere{5e-4}; }},
    {"Body 'c' in water: a rod has no volume.",
     [](Scene& s) {
       s.forces.emplace_back(core::Water{.level = 1, .buoyancy = 1000});
       s.bodies[2].shape = core::Rod{0.3};
     },
     [](Scene& s) { s.bodies[2].shape = core::Rod{0.3}; }},
};

TEST(DartLimits, AreEachASentenceAndNoWider) { expect_each(dart_limit, refusals); }

TEST(DartLimits, NeedAStepForward) { expect_a_step_forward("DART"); }

}  // namespace
}  // namespace cylon::simulators
