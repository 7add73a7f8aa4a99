// A pile of equal spheres dropped as a lattice into an open box (radius 0.5 m, friction 0.5, no restitution,
// steps of 1/60 s for 5 s, 10 iterations): this engine in float, Bullet in float and ODE's QuickStep, one
// thread each, in one run.  A time never travels without its error: every row says how deep the settled pile
// overlaps.
//   pile_bench [--huge]     10^5 spheres too, which takes minutes in the other engines
// Bullet: no damping, no sleeping, one step per call; else as it comes.  ODE: sweep and prune, approximate
// friction cone, ERP and CFM as they come.
#include "engine/pile/pile.h"

#include <benchmark/benchmark.h>
#include <btBulletDynamicsCommon.h>
#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <functional>
#include <memory>
#include <vector>

namespace {

namespace engine = cylon::engine;

using Point = Eigen::Vector3d;

constexpr double radius = 0.5, mass = 1, friction = 0.5, step = 1. / 60, gravity = 9.81;
constexpr int steps = 300, iterations = 10;

struct Plane {
  Point normal;
  double offset;
};

struct Pile {
  std::vector<Point> centres;
  std::vector<Plane> planes;
};

Pile make_pile(int count) {
  const int side = count <= 1000 ? 10 : count <= 10000 ? 20 : 46;
  const double half = 0.55 * side + 0.1;
  Pile pile;
  pile.planes = {
      {{0, 1, 0}, 0}, {{1, 0, 0}, -half}, {{-1, 0, 0}, -half}, {{0, 0, 1}, -half}, {{0, 0, -1}, -half}};
  for (int i = 0; i < count; ++i) {
    const int x = i % side, z = i / side % side, y = i / side / side;
    pile.centres.emplace_back(1.1 * x - half + 0.65 + 0.01 * (i * 7 % 11), 0.6 + 1.1 * y,
                              1.1 * z - half + 0.65 + 0.01 * (i * 5 % 13));
  }
  return pile;
}

/// The deepest and the mean overlap [m].
std::pair<double, double> overlap(const Pile& pile, const std::vector<Point>& centres) {
  double worst = 0, sum = 0;
  int touching = 0;
  const auto add = [&](double depth) {
    if (depth <= 0) return;
    worst = std::max(worst, depth), sum += depth, ++touching;
  };
  std::vector<Point> sorted = centres;
  std::sort(sorted.begin(), sorted.end(), [](const Point& a, const Point& b) { return a.x() < b.x(); });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (const Plane& plane : pile.planes) add(radius - (plane.normal.dot(sorted[i]) - plane.offset));
    for (std::size_t j = i + 1; j < sorted.size() && sorted[j].x() < sorted[i].x() + 2 * radius; ++j)
      add(2 * radius - (sorted[i] - sorted[j]).norm());
  }
  return {worst, touching > 0 ? sum / touching : 0};
}

struct Subject {
  std::function<void()> advance;
  std::function<std::vector<Point>()> centres;
};

Subject ours(const Pile& pile, int parts) {
  using engine::Real;
  engine::Model model;
  model.forces.gravity = engine::Vector3(0, -Real(gravity), 0);
  const engine::Body ball = engine::make_body(
      Real(mass), engine::Matrix3(engine::Matrix3::Identity() * Real(0.4 * mass * radius * radius)));
  for (const Point& centre : pile.centres) {
    model.bodies.push_back(ball);
    model.motions.push_back(engine::make_motion(ball, centre.cast<Real>(), engine::Quaternion::Identity(),
                                                engine::Vector3::Zero(), engine::Vector3::Zero()));
    model.shapes.push_back(engine::Sphere{Real(radius)});
    model.surfaces.push_back(0);
  }
  for (const Plane& plane : pile.planes) {
    model.planes.push_back({plane.normal.cast<Real>(), Real(plane.offset)});
    model.plane_surfaces.push_back(0);
  }
  model.surface_count = 1;
  model.materials = {engine::Material{0, Real(friction)}};
  engine::PileSettings settings;
  settings.substeps = parts;
  const std::shared_ptr<engine::Stepper> stepper = engine::make_pile(model, step, settings);
  return {[stepper] { stepper->step(); },
          [stepper] {
            std::vector<engine::Motion> motions;
            stepper->read(motions);
            std::vector<Point> centres;
            for (const auto& motion : motions) centres.push_back(motion.position.cast<double>());
            return centres;
          }};
}

struct BulletPile {
  btDefaultCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broad_phase;
  btSequentialImpulseConstraintSolver solver;
  btDiscreteDynamicsWorld world{&dispatcher, &broad_phase, &solver, &configuration};
  btSphereShape sphere{btScalar(radius)};
  std::vector<std::unique_ptr<btCollisionShape>> planes;
  std::vector<std::unique_ptr<btRigidBody>> bodies;
  std::size_t first = 0;

  explicit BulletPile(const Pile& pile) {
    world.setGravity(btVector3(0, -btScalar(gravity), 0));
    world.getSolverInfo().m_numIterations = iterations;
    const auto add = [&](btScalar m, btCollisionShape* shape, const btVector3& at) {
      btVector3 inertia(0, 0, 0);
      if (m > 0) shape->calculateLocalInertia(m, inertia);
      btRigidBody::btRigidBodyConstructionInfo info(m, nullptr, shape, inertia);
      info.m_startWorldTransform.setOrigin(at);
      info.m_friction = std::sqrt(btScalar(friction)), info.m_restitution = 0;
      bodies.push_back(std::make_unique<btRigidBody>(info));
      bodies.back()->setActivationState(DISABLE_DEACTIVATION);
      world.addRigidBody(bodies.back().get());
    };
    for (const Plane& plane : pile.planes) {
      const btVector3 n(btScalar(plane.normal.x()), btScalar(plane.normal.y()), btScalar(plane.normal.z()));
      planes.push_back(std::make_unique<btStaticPlaneShape>(n, btScalar(plane.offset)));
      add(0, planes.back().get(), btVector3(0, 0, 0));
    }
    first = bodies.size();
    for (const Point& p : pile.centres)
      add(btScalar(mass), &sphere, btVector3(btScalar(p.x()), btScalar(p.y()), btScalar(p.z())));
  }
  ~BulletPile() {
    for (auto& body : bodies) world.removeRigidBody(body.get());
  }
};

Subject bullet(const Pile& pile) {
  const auto b = std::make_shared<BulletPile>(pile);
  return {[b] { b->world.stepSimulation(btScalar(step), 0); },
          [b] {
            std::vector<Point> centres;
            for (std::size_t i = b->first; i < b->bodies.size(); ++i) {
              const btVector3& p = b->bodies[i]->getWorldTransform().getOrigin();
              centres.emplace_back(p.x(), p.y(), p.z());
            }
            return centres;
          }};
}

struct OdePile {
  dWorldID world = dWorldCreate();
  dSpaceID space = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XZY);
  dJointGroupID group = dJointGroupCreate(0);
  std::vector<dBodyID> bodies;

  explicit OdePile(const Pile& pile) {
    dRandSetSeed(0);
    dWorldSetGravity(world, 0, -gravity, 0);
    dWorldSetQuickStepNumIterations(world, iterations);
    for (const Plane& p : pile.planes)
      dCreatePlane(space, p.normal.x(), p.normal.y(), p.normal.z(), p.offset);
    for (const Point& p : pile.centres) {
      bodies.push_back(dBodyCreate(world));
      dMass m;
      dMassSetSphereTotal(&m, mass, radius);
      dBodySetMass(bodies.back(), &m);
      dBodySetPosition(bodies.back(), p.x(), p.y(), p.z());
      dGeomSetBody(dCreateSphere(space, radius), bodies.back());
    }
  }
  ~OdePile() { dJointGroupDestroy(group), dSpaceDestroy(space), dWorldDestroy(world); }

  static void near(void* data, dGeomID a, dGeomID b) {
    auto* self = static_cast<OdePile*>(data);
    dContact contact[4];
    std::memset(contact, 0, sizeof contact);
    const int n = dCollide(a, b, 4, &contact[0].geom, sizeof(dContact));
    for (int i = 0; i < n; ++i) {
      contact[i].surface.mode = dContactApprox1;
      contact[i].surface.mu = friction;
      dJointAttach(dJointCreateContact(self->world, self->group, contact + i), dGeomGetBody(a),
                   dGeomGetBody(b));
    }
  }
  void advance() {
    dSpaceCollide(space, this, &near);
    dWorldQuickStep(world, step);
    dJointGroupEmpty(group);
  }
};

Subject ode(const Pile& pile) {
  const auto o = std::make_shared<OdePile>(pile);
  return {[o] { o->advance(); },
          [o] {
            std::vector<Point> centres;
            for (dBodyID body : o->bodies) {
              const dReal* p = dBodyGetPosition(body);
              centres.emplace_back(p[0], p[1], p[2]);
            }
            return centres;
          }};
}

void measure(benchmark::State& state, const std::function<Subject(const Pile&)>& make) {
  const int count = static_cast<int>(state.range(0));
  const Pile pile = make_pile(count);
  for (auto _ : state) {
    const Subject subject = make(pile);
    const std::clock_t start = std::clock();
    for (int k = 0; k < steps; ++k) subject.advance();
    const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    state.SetIterationTime(seconds);
    state.counters["ns_per_body_step"] = 1e9 * seconds / (static_cast<double>(count) * steps);
    const auto [worst, mean] = overlap(pile, subject.centres());
    state.counters["overlap_mm"] = 1000 * worst;
    state.counters["mean_overlap_mm"] = 1000 * mean;
  }
}

}  // namespace

int main(int argc, char** argv) {
  const bool huge = argc > 1 && std::strcmp(argv[1], "--huge") == 0;
  if (huge) --argc, ++argv;
  dInitODE2(0);
  dAllocateODEDataForThread(dAllocateMaskAll);
  for (const int count : {1000, 10000, 100000}) {
    if (count == 100000 && !huge) continue;
    const auto add = [&](const char* name, const std::function<Subject(const Pile&)>& make) {
      benchmark::RegisterBenchmark(name, [make](benchmark::State& state) { measure(state, make); })
          ->Arg(count)
          ->Iterations(1)
          ->UseManualTime()
          ->Unit(benchmark::kMillisecond);
    };
    add("in_house_float/10", [](const Pile& pile) { return ours(pile, 10); });
    add("in_house_float/4", [](const Pile& pile) { return ours(pile, 4); });
    add("bullet_float/10", bullet);
    add("ode_quick/10", ode);
  }
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  dCloseODE();
}
