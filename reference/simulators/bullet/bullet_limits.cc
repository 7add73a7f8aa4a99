#include "reference/simulators/bullet/bullet_limits.h"

namespace cylon::simulators {
namespace {

const std::vector<std::string> unforceable_everywhere = {
    "A rotation of more than pi/4 per step is reduced: the body rotates by 2 atan(w dt/(pi/4) tan(pi/8)) "
    "(LinearMath/btTransformUtil.h:53, BulletDynamics/Featherstone/btMultiBody.cpp:1823).",
    "An impact acts in a whole step: the one after the bodies overlap, up to dt late, or, where a contact "
    "may be "
    "created before it touches, earlier; there is no time of impact within a step "
    "(BulletDynamics/Dynamics/btDiscreteDynamicsWorld.cpp:473).",
    "Impacts of one step are solved together, by sweeps or as one complementarity problem; their order in "
    "time "
    "is not resolved (BulletDynamics/Dynamics/btDiscreteDynamicsWorld.cpp:480).",
    "At most four contact points are kept per pair "
    "(BulletCollision/NarrowPhaseCollision/btPersistentManifold.h:52).",
    "The world runs on one thread: Debian's build leaves BT_THREADSAFE out (debian/rules, "
    "LinearMath/btThreads.h:72).",
};

}  // namespace

std::vector<std::string> unforceable_rigid() {
  std::vector<std::string> sentences = unforceable_everywhere;
  sentences.emplace_back(
      "Semi-implicit Euler is the only integrator of btRigidBody "
      "(BulletDynamics/Dynamics/btDiscreteDynamicsWorld.cpp:486, "
      "BulletDynamics/Dynamics/btRigidBody.cpp:102).");
  sentences.emplace_back(
      "Continuous collision detection sweeps a body whose shape is one convex shape about its centre of "
      "mass, "
      "and no compound; cones and what is turned against its principal axes are compounds here "
      "(BulletDynamics/Dynamics/btDiscreteDynamicsWorld.cpp:950).");
  return sentences;
}

std::vector<std::string> unforceable_multibody() {
  std::vector<std::string> sentences = unforceable_everywhere;
  sentences.emplace_back(
      "Restitution uses the approach speed after gravity acts in the step, so a bounce gains |g| dt "
      "(BulletDynamics/Featherstone/btMultiBodyConstraintSolver.cpp:779).");
  sentences.emplace_back(
      "The gyroscopic term is explicit or absent; there is no implicit form "
      "(BulletDynamics/Featherstone/btMultiBody.cpp:847).");
  sentences.emplace_back(
      "Penetration is corrected through the velocity only; the branch for split impulses is commented out "
      "(BulletDynamics/Featherstone/btMultiBodyConstraintSolver.cpp:812).");
  sentences.emplace_back(
      "There is no continuous collision detection: it is a sweep of rigid bodies "
      "(BulletDynamics/Dynamics/btDiscreteDynamicsWorld.cpp:950).");
  sentences.emplace_back(
      "With runge-kutta-4, applied forces are constant during the step, and constraint impulses change the "
      "position one step late (BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.cpp:613).");
  return sentences;
}

}  // namespace cylon::simulators
