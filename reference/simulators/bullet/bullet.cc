// Bullet behind the Simulator interface.  Compiled twice: double (BT_USE_DOUBLE_PRECISION) and float.
#include "harness/core/collision_filter.h"
#include "harness/core/joint_coordinates.h"
#include "harness/core/simulator.h"
#include "harness/core/surfaces.h"
#include "reference/applied/forces.h"
#include "reference/simulators/bullet/bullet_bodies.h"
#include "reference/simulators/bullet/bullet_border.h"
#include "reference/simulators/bullet/bullet_joints.h"
#include "reference/simulators/bullet/bullet_knobs.h"
#include "reference/simulators/bullet/bullet_multibody.h"
#include "reference/simulators/bullet/bullet_settings.h"
#include "reference/simulators/bullet/bullet_shapes.h"
#include "reference/simulators/bullet/bullet_surfaces.h"

#include <BulletCollision/NarrowPhaseCollision/btPersistentManifold.h>
#include <BulletDynamics/ConstraintSolver/btNNCGConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyMLCPConstraintSolver.h>
#include <BulletDynamics/MLCPSolvers/btDantzigSolver.h>
#include <BulletDynamics/MLCPSolvers/btMLCPSolver.h>
#include <btBulletDynamicsCommon.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace cylon::simulators {
namespace {

// ---- What does not touch each other ----------------------------------------------------------------

// Bullet's own rule by groups and masks, which are those of the scene, without pairs that a joint ties and pairs that
// are both static.  (Bullet's default leaves the latter out by groups of its own.)
struct ContactPairs final : btOverlapFilterCallback {
  explicit ContactPairs(std::vector<std::array<int, 2>> jointed) : pairs(std::move(jointed)) {}

  bool needBroadphaseCollision(btBroadphaseProxy* a, btBroadphaseProxy* b) const override {
    const int one = owner(*a), other = owner(*b);
    return (a->m_collisionFilterGroup & b->m_collisionFilterMask) != 0 &&
           (b->m_collisionFilterGroup & a->m_collisionFilterMask) != 0 &&
           !(object(*a).isStaticObject() && object(*b).isStaticObject()) &&
           !std::binary_search(pairs.begin(), pairs.end(),
                               std::array{std::min(one, other), std::max(one, other)});
  }

  // The body's index; of a plane below zero.
  static int owner(const btBroadphaseProxy& proxy) { return object(proxy).getUserIndex2(); }
  static const btCollisionObject& object(const btBroadphaseProxy& proxy) {
    return *static_cast<const btCollisionObject*>(proxy.m_clientObject);
  }

  std::vector<std::array<int, 2>> pairs;
};

// ---- Materials: the pair's own values in place of Bullet's products -------------------------------

const Surfaces::Contact& contact(const btCollisionObject* a, const btCollisionObject* b) {
  return static_cast<const Surfaces*>(a->getUserPointer())->between(a->getUserIndex(), b->getUserIndex());
}
btScalar restitution(const btCollisionObject* a, const btCollisionObject* b) {
  return to_bullet(contact(a, b).restitution);
}
btScalar friction(const btCollisionObject* a, const btCollisionObject* b) {
  return to_bullet(contact(a, b).friction);
}

// ---- The world ----------------------------------------------------------------------------------------

struct Solver {
  std::unique_ptr<btMLCPSolverInterface> direct;  // outlives its user
  std::unique_ptr<btConstraintSolver> solver;
};

Solver make_solver(const BulletSettings& settings) {
  Solver result;
  const bool direct = settings.solver == "dantzig";
  if (direct) result.direct = std::make_unique<btDantzigSolver>();
  if (settings.multibody && direct) {
    result.solver = std::make_unique<btMultiBodyMLCPConstraintSolver>(result.direct.get());
  } else if (settings.multibody) {
    result.solver = std::make_unique<btMultiBodyConstraintSolver>();
  } else if (settings.solver == "nncg") {
    result.solver = std::make_unique<btNNCGConstraintSolver>();
  } else if (direct) {
    result.solver = std::make_unique<btMLCPSolver>(result.direct.get());
  } else {
    result.solver = std::make_unique<btSequentialImpulseConstraintSolver>();
  }
  return result;
}

void apply(const BulletSettings& settings, btContactSolverInfo& info) {
  const auto number = [&](const char* option) { return to_bullet(settings.number.at(option)); };
  info.m_erp = number("erp");
  info.m_erp2 = number("erp2");
  info.m_globalCfm = number("cfm");
  info.m_numIterations = static_cast<int>(number("iterations"));
  info.m_warmstartingFactor = number("warm-starting");
  info.m_restitutionVelocityThreshold = number("restitution-threshold");
  info.m_splitImpulsePenetrationThreshold = number("split-threshold");
  info.m_maxGyroscopicForce = number("max-gyroscopic-force");
  info.m_linearSlop = number("slop");
  info.m_sor = number("relaxation");
  info.m_splitImpulse = settings.on("split-impulse") ? 1 : 0;
  if (settings.on("two-friction-directions")) info.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
  if (settings.on("random-order")) info.m_solverMode |= SOLVER_RANDMIZE_ORDER;
  if (settings.on("interleave")) info.m_solverMode |= SOLVER_INTERLEAVE_CONTACT_AND_FRICTION_CONSTRAINTS;
}

// Before anything is in the world: its collision algorithms read these when they are made.
void apply(const BulletSettings& settings, btDefaultCollisionConfiguration& collisions) {
  gContactBreakingThreshold = to_bullet(settings.number.at("breaking-threshold"));
  const auto queries = [&](const char* option) { return static_cast<int>(settings.number.at(option)); };
  if (queries("plane-queries") > 0) collisions.setPlaneConvexMultipointIterations(queries("plane-queries"));
  if (queries("convex-queries") > 0)
    collisions.setConvexConvexMultipointIterations(queries("convex-queries"));
}

// Bullet clears 14 MB for 4096 pairs in every world; one that has fewer parts needs less, and nothing else changes.
btDefaultCollisionConstructionInfo pools(const core::Scene& scene) {
  std::size_t parts = scene.planes.size();
  for (const core::Body& body : scene.bodies) {
    const auto* compound = std::get_if<core::Compound>(&body.shape);
    parts += compound ? compound->parts.size() + 1 : 1;
  }
  btDefaultCollisionConstructionInfo info;
  const auto enough = static_cast<int>(std::min<std::size_t>(parts, 100));
  for (int* size :
       {&info.m_defaultMaxPersistentManifoldPoolSize, &info.m_defaultMaxCollisionAlgorithmPoolSize})
    *size = std::min(*size, enough * enough);
  return info;
}

// The margin of shapes: nothing where Bullet's own rule holds.
std::optional<double> margin(const BulletSettings& settings) {
  const double given = settings.number.at("margin");
  return given == default_margin ? std::nullopt : std::optional(given);
}

// A body and what it touches: a body, or plane p as -1 - p.
core::Pair pair_of(int body, int other) {
  return other >= 0 ? core::Pair{body, other, -1} : core::Pair{body, core::world, -1 - other};
}

// Everything of one run.  Members are destroyed from the last: the world before what stands in it.
class Run {
 public:
  Run(core::Scene scene, const BulletSettings& settings, double dt)
      : scene_(std::move(scene)),
        filters_(scene_),
        pairs_(core::jointed_pairs(scene_)),
        dt_(dt),
        of_all_(core::gravity(scene_)),
        forces_(scene_),
        surfaces_(scene_),
        config_(pools(scene_)),
        dispatcher_(&config_),
        solver_(make_solver(settings)) {
    if (settings.multibody) {
      world_ = std::make_unique<btMultiBodyDynamicsWorld>(
          &dispatcher_, &broadphase_, static_cast<btMultiBodyConstraintSolver*>(solver_.solver.get()),
          &config_);
    } else {
      world_ = std::make_unique<btDiscreteDynamicsWorld>(&dispatcher_, &broadphase_, solver_.solver.get(),
                                                         &config_);
    }
    world_->getPairCache()->setOverlapFilterCallback(&pairs_);
    world_->setGravity(to_bullet(core::gravity(scene_)));
    world_->setApplySpeculativeContactRestitution(settings.on("speculative-restitution"));
    apply(settings, config_);
    apply(settings, world_->getSolverInfo());
    for (std::size_t p = 0; p < scene_.planes.size(); ++p) add_plane(p, settings);
    add_bodies(settings);
    if (!settings.multibody)
      for (const core::Joint& joint : scene_.joints) add_joint(joint, settings.stops());
  }

  void step() {
    if (forces_.any()) {
      read(state_);
      const std::vector<applied::Wrench>& wrenches = forces_.at(static_cast<double>(steps_) * dt_, state_);
      for (std::size_t i = 0; i < bodies_.size(); ++i)
        bodies_[i]->push(wrenches[i].force, wrenches[i].torque);
      for (const std::size_t i : forces_.changing()) bodies_[i]->set_mass(forces_.mass(i));
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      if (const auto& own = scene_.bodies[i].gravity) bodies_[i]->fall(*own - of_all_);
    world_->stepSimulation(to_bullet(dt_), 0);
    ++steps_;
  }

  void read(core::State& state) const {
    state.resize(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) state[i] = bodies_[i]->state();
  }

  // What the persistent manifolds hold after the step, points that pressed alone.  Bullet's normal is that on
  // its second object, towards its first.
  std::vector<core::Contact> contacts() {
    std::vector<core::Contact> contacts;
    for (int m = 0; m < dispatcher_.getNumManifolds(); ++m) {
      const btPersistentManifold& manifold = *dispatcher_.getManifoldByIndexInternal(m);
      const int first = manifold.getBody0()->getUserIndex2(), second = manifold.getBody1()->getUserIndex2();
      const bool turned = first < 0;  // the plane comes first
      // Of who sleeps the impulses are those of its last step awake.
      const bool awake = moves(*manifold.getBody0()) || moves(*manifold.getBody1());
      for (int i = 0; i < manifold.getNumContacts(); ++i) {
        const btManifoldPoint& point = manifold.getContactPoint(i);
        const bool solved = point.getDistance() <= manifold.getContactProcessingThreshold();
        if (!solved || !(point.getAppliedImpulse() > 0)) continue;
        core::Contact contact;
        contact.pair = pair_of(turned ? second : first, turned ? first : second);
        contact.point = from_bullet(point.getPositionWorldOnB());
        contact.normal = (turned ? -1 : 1) * from_bullet(point.m_normalWorldOnB);
        if (awake) tell_impulse(point, turned, contact);
        contacts.push_back(contact);
      }
    }
    return contacts;
  }

  // What the joints of rigid bodies did; Bullet's torques are about the centres of mass.
  // Sleepers tell what they did when awake, so nothing is told of them; nor of multibodies, as after a step of
  // links that turn btMultiBodyJointFeedback does not hold the force that moved them.
  std::optional<std::vector<core::Reaction>> reactions() const {
    if (joints_.size() < scene_.joints.size()) return std::nullopt;
    std::vector<core::Reaction> reactions;
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      if (!joints_[j] || (!moves(joints_[j]->getRigidBodyA()) && !moves(joints_[j]->getRigidBodyB())))
        continue;
      const btRigidBody& body = *bodies_[static_cast<std::size_t>(scene_.joints[j].body)]->rigid();
      reactions.push_back(reaction(j, *joints_[j], body, dt_));
      if (!stops_[j]) continue;
      const core::Reaction of_stop = reaction(j, *stops_[j], body, dt_);  // of the same body
      reactions.back().impulse += of_stop.impulse, reactions.back().moment += of_stop.moment;
    }
    return reactions;
  }

 private:
  static bool moves(const btCollisionObject& object) {
    return object.isActive() && !object.isStaticOrKinematicObject();
  }

  static void tell_impulse(const btManifoldPoint& point, bool turned, core::Contact& contact) {
    contact.impulse = static_cast<double>(point.getAppliedImpulse());
    contact.friction =
        (turned ? -1 : 1) *
        (static_cast<double>(point.m_appliedImpulseLateral1) * from_bullet(point.m_lateralFrictionDir1) +
         static_cast<double>(point.m_appliedImpulseLateral2) * from_bullet(point.m_lateralFrictionDir2));
  }

  void add_plane(std::size_t p, const BulletSettings& settings) {
    core::Body ground;
    ground.locked = ground.collide = true;
    const Placing placing{make_shape(scene_.planes[p], shapes_),
                          core::principal_axes(ground.inertia),
                          &surfaces_,
                          surfaces_.of_plane(p),
                          -1 - static_cast<int>(p),
                          filters_.of_plane[p]};
    planes_.push_back(make_rigid(ground, placing, settings, *world_));
  }

  void add_bodies(const BulletSettings& settings) {
    std::vector<Placing> placings;
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      const core::Body& body = scene_.bodies[i];
      const core::PrincipalAxes principal = core::principal_axes(body.inertia);
      const core::Shape bare;
      placings.push_back(
          {make_shape(body.collide ? body.shape : bare, principal.rotation, margin(settings), shapes_),
           principal, &surfaces_, surfaces_.of_body(i), static_cast<int>(i), filters_.of_body[i]});
    }
    bodies_.resize(scene_.bodies.size());
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      if (bodies_[i]) continue;  // in the tree of one before
      if (!settings.multibody || scene_.bodies[i].locked)
        bodies_[i] = make_rigid(scene_.bodies[i], placings[i], settings, *world_);
      else
        make_multibody(scene_, tree_of(scene_, static_cast<int>(i)), placings, settings, dt_,
                       static_cast<btMultiBodyDynamicsWorld&>(*world_), bodies_, constraints_);
    }
  }

  void add_joint(const core::Joint& joint, const BulletStops& stops) {
    const auto rigid = [&](int i) {
      return i == core::world ? nullptr : bodies_[static_cast<std::size_t>(i)]->rigid();
    };
    btRigidBody &a = *rigid(joint.body), *const b = rigid(joint.to);
    joints_.emplace_back(), stops_.emplace_back();
    if (a.isStaticObject() && (!b || b->isStaticObject())) return;  // both ends are locked
    add(joints_.back() = make_joint(joint, a, b, dt_, stops));
    if ((stops_.back() = make_stop(joint, a, b, stops))) add(stops_.back());
  }

  void add(const std::unique_ptr<btTypedConstraint>& constraint) {
    constraint->setJointFeedback(&feedback_.emplace_back());
    world_->addConstraint(constraint.get());
  }

  core::Scene scene_;
  core::CollisionFilters filters_;
  ContactPairs pairs_;
  double dt_;
  core::Vector3 of_all_;  // gravity of bodies without their own [m/s^2]
  applied::Forces forces_;
  std::int64_t steps_ = 0;
  core::State state_;

  Surfaces surfaces_;
  Shapes shapes_;
  btDefaultCollisionConfiguration config_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  Solver solver_;
  std::vector<std::unique_ptr<BulletBody>> planes_, bodies_;
  std::deque<btJointFeedback> feedback_;                    // of joints_, which point at it
  std::vector<std::unique_ptr<btTypedConstraint>> joints_;  // of the scene's; null between locked ends
  std::vector<std::unique_ptr<btTypedConstraint>> stops_;   // those beside them; null where they are none
  std::vector<std::unique_ptr<btMultiBodyConstraint>> constraints_;  // of multibodies
  std::unique_ptr<btDiscreteDynamicsWorld> world_;
};

// ---- What it cannot do --------------------------------------------------------------------------------

// What the paths look at.
BulletKind bullet_kind(const core::Scene& scene) {
  BulletKind kind{core::scene_kind(scene)};
  const auto is_smooth = [](const core::Force& f) {
    return std::holds_alternative<core::Drag>(f) || std::holds_alternative<core::UniformGravity>(f);
  };
  const bool hung = !untreelike(scene) && all_hung(scene);
  const bool acted_on = core::any_coordinate(scene, [](const core::JointCoordinate& c) {
    return core::has_limit(c) || c.friction != 0 || c.force != 0 || c.stiffness != 0;
  });
  kind.tree = !kind.touches && hung && !acted_on && !core::has_fictitious_forces(scene) &&
              std::ranges::all_of(scene.forces, is_smooth);
  kind.stops = core::any_coordinate(scene, [](const core::JointCoordinate& c) { return core::has_limit(c); });
  kind.loops = !untreelike(scene) && has_loops(scene);
  kind.swept = std::ranges::any_of(scene.bodies, [](const core::Body& body) {
    return !body.locked && body.collide &&
           swept_radius(body.shape, core::principal_axes(body.inertia).rotation) > 0;
  });
  // All four stages take the forces, the impulses and the orientation of a free base from the step's
  // beginning, and the orientation of a ball joint loses the fourth order.
  const bool balls = std::ranges::any_of(scene.joints, [](const core::Joint& j) {
    return core::kind_of(j.type).turns_freely() && !core::kind_of(j.type).joins_centres();
  });
  kind.rk4_order = !hung || kind.touches || kind.applied || acted_on ? 1 : balls ? 2 : 4;
  return kind;
}

class Bullet final : public core::Simulator {
 public:
  // Bullet's combination callbacks are global; the surfaces they read hang on each collision object.
  Bullet() : engine_(bullet_engine(version(), sizeof(btScalar) == sizeof(double) ? "double" : "float")) {
    gCalculateCombinedRestitutionCallback = restitution;
    gCalculateCombinedFrictionCallback = friction;
  }

  const core::Engine& engine() const override { return engine_; }

  std::optional<std::string> unsupported(const core::Scene& scene, const core::Setup& setup) const override {
    if (auto reason = applied::unmapped(scene)) return reason;
    for (const core::Body& body : scene.bodies)
      if (auto reason = body.collide ? untouchable(body.shape, body.locked) : std::nullopt)
        return fmt::format("Body '{}': {}", body.name, *reason);
    for (const core::Joint& joint : scene.joints)
      if (auto reason = missing(joint)) return reason;
    if (core::pair_without_material(scene)) return "A pair that may touch has no material.";
    const BulletSettings settings = bullet_settings(engine_, setup, bullet_kind(scene));
    if (settings.multibody) {
      if (auto reason = untreelike(scene)) return reason;
    } else {
      for (const core::Joint& joint : scene.joints)
        if (auto reason = simulators::unsupported(scene, joint, settings.on("stops-ahead"))) return reason;
    }
    return settings.refused;
  }

  core::Terms load(const core::Scene& scene, const core::Setup& setup) override {
    const BulletSettings settings = bullet_settings(engine_, setup, bullet_kind(scene));
    run_.reset();
    run_ = std::make_unique<Run>(scene, settings, setup.dt);
    return settings.terms;
  }

  void step() override { run_->step(); }
  void read(core::State& state) const override { run_->read(state); }
  std::vector<core::Contact> contacts() const override { return run_->contacts(); }
  std::optional<std::vector<core::Reaction>> reactions() const override { return run_->reactions(); }

 private:
  static std::string version() { return fmt::format("{}.{}", btGetVersion() / 100, btGetVersion() % 100); }

  core::Engine engine_;
  std::unique_ptr<Run> run_;
};

}  // namespace
}  // namespace cylon::simulators

namespace cylon::core {

std::unique_ptr<Simulator> make_simulator() { return std::make_unique<simulators::Bullet>(); }

}  // namespace cylon::core
