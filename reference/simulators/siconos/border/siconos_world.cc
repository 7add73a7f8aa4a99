#include "reference/simulators/siconos/border/siconos_world.h"

#include "reference/simulators/siconos/border/siconos_contact.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace cylon::simulators::siconos_border {
namespace {

struct SolverRow {
  const char* name;
  int id;
};

// Those that solve every step of the tests' scenes with their own tolerances and iterations; docs/engines.md says what the others
// do.
constexpr SolverRow solver_rows[] = {
    {"nsgs", SICONOS_FRICTION_3D_NSGS},
    {"tresca", SICONOS_FRICTION_3D_TFP},
    {"fixed-point-projection", SICONOS_FRICTION_3D_FPP},
    {"extragradient", SICONOS_FRICTION_3D_EG},
    {"newton-alart-curnier", SICONOS_FRICTION_3D_NSN_AC},
    {"newton-fischer-burmeister", SICONOS_FRICTION_3D_NSN_FB},
    {"alart-curnier-fixed-point", SICONOS_FRICTION_3D_ACLMFP},
    {"admm", SICONOS_FRICTION_3D_ADMM},
};

FrictionSolver described(const char* name, const SolverOptions& options) {
  return {name, options.dparam[SICONOS_DPARAM_TOL], options.iparam[SICONOS_IPARAM_MAX_ITER]};
}

// None for a solver of another problem.
std::optional<FrictionSolver> friction_solver(const SolverOptions& options) {
  for (const SolverRow& row : solver_rows)
    if (row.id == options.solverId) return described(row.name, options);
  return {};
}

// The error callback of Siconos has no user data, so the counter of the world that is stepping stands here.
thread_local std::int64_t* failures = nullptr;
void count_failure(int info, Simulation* /*simulation*/) {
  if (info != 0 && failures) ++*failures;
}

// Moreau-Jean weighs the forces at the end of a step by theta and those at its begin, which Siconos remembers from the
// step before, by 1 - theta.  What is pushed is the force of the whole step: it is the one at its begin as well.
class PushedBody final : public NewtonEulerDS {
 public:
  using NewtonEulerDS::NewtonEulerDS;
  void remember_forces(double time) {
    computeForces(time, _q, _twist);
    _forcesMemory.getSiconosVectorMutable(0) = *_wrench;
  }
};

}  // namespace

const std::vector<FrictionSolver>& friction_solvers() {
  static const std::vector<FrictionSolver> solvers = [] {
    std::vector<FrictionSolver> all;
    for (const SolverRow& row : solver_rows)
      all.push_back(described(row.name, *FrictionContact(3, row.id).numericsSolverOptions()));
    return all;
  }();
  return solvers;
}

struct World::Parts {
  struct Touch {
    std::shared_ptr<Interaction> interaction;
    std::shared_ptr<SphereContact<NewtonEuler1DR>> smooth;  // one of the two
    std::shared_ptr<SphereContact<NewtonEuler3DR>> rough;
  };

  void add(const Body&);
  void add(const Contact&, bool rough);
  void set_solver(const Settings&, bool rough);

  std::shared_ptr<NonSmoothDynamicalSystem> system =
      std::make_shared<NonSmoothDynamicalSystem>(0, std::numeric_limits<double>::max());
  std::vector<std::shared_ptr<PushedBody>> bodies;
  std::vector<std::shared_ptr<SiconosVector>> forces, torques;
  std::vector<Touch> touches;
  std::shared_ptr<TimeStepping> stepping;
  Complaints complaints;
};

// ---- Building -----------------------------------------------------------------------------------------

World::World(const std::vector<Body>& bodies, const std::vector<Contact>& contacts, const Settings& settings)
    : parts_(std::make_unique<Parts>()) {
  for (const Body& body : bodies) parts_->add(body);
  // One problem has contacts of one kind alone.
  const bool rough = std::any_of(contacts.begin(), contacts.end(),
                                 [](const Contact& contact) { return contact.friction > 0; });
  for (const Contact& contact : contacts) parts_->add(contact, rough);
  parts_->set_solver(settings, rough);
}

World::~World() = default;

// Its speeds are those of the centre in world axes, and of rotation in body axes.
void World::Parts::add(const Body& body) {
  const Motion& start = body.start;
  const auto place = std::make_shared<SiconosVector>(7U), speed = std::make_shared<SiconosVector>(6U);
  for (unsigned k = 0; k < 3; ++k) {
    place->setValue(k, start.position[k]);
    speed->setValue(k, start.velocity[k]), speed->setValue(3 + k, start.spin[k]);
  }
  for (unsigned k = 0; k < 4; ++k) place->setValue(3 + k, start.orientation[k]);
  const auto inertia = std::make_shared<SimpleMatrix>(3U, 3U);
  for (unsigned r = 0; r < 3; ++r)
    for (unsigned c = 0; c < 3; ++c) inertia->setValue(r, c, body.inertia[3 * r + c]);
  bodies.push_back(std::make_shared<PushedBody>(place, speed, body.mass, inertia));
  forces.push_back(std::make_shared<SiconosVector>(3U)),
      torques.push_back(std::make_shared<SiconosVector>(3U));
  bodies.back()->setFExtPtr(forces.back());
  bodies.back()->setMExtPtr(torques.back());
  system->insertDynamicalSystem(bodies.back());
}

void World::Parts::add(const Contact& contact, bool rough) {
  Touch touch;
  if (rough) {
    touch.rough = std::make_shared<SphereContact<NewtonEuler3DR>>(contact);
    touch.interaction = std::make_shared<Interaction>(
        std::make_shared<NewtonImpactFrictionNSL>(contact.restitution, 0, contact.friction, 3U), touch.rough);
  } else {
    touch.smooth = std::make_shared<SphereContact<NewtonEuler1DR>>(contact);
    touch.interaction =
        std::make_shared<Interaction>(std::make_shared<NewtonImpactNSL>(contact.restitution), touch.smooth);
  }
  const bool two = contact.partner == Partner::moving_sphere;
  const std::shared_ptr<NewtonEulerDS> other =
      two ? bodies[static_cast<std::size_t>(contact.other)] : nullptr;
  system->link(touch.interaction, bodies[static_cast<std::size_t>(contact.body)], other);
  touches.push_back(std::move(touch));
}

void World::Parts::set_solver(const Settings& settings, bool rough) {
  std::shared_ptr<OneStepNSProblem> problem;
  if (rough) {
    problem = std::make_shared<FrictionContact>(3, solver_rows[settings.solver].id);
    SolverOptions& options = *problem->numericsSolverOptions();
    if (settings.solver_tolerance) options.dparam[SICONOS_DPARAM_TOL] = *settings.solver_tolerance;
    if (settings.solver_iterations) options.iparam[SICONOS_IPARAM_MAX_ITER] = *settings.solver_iterations;
  } else {
    problem = std::make_shared<LCP>();
  }
  stepping = std::make_shared<TimeStepping>(system, std::make_shared<TimeDiscretisation>(0., settings.dt),
                                            std::make_shared<MoreauJeanOSI>(settings.theta), problem);
  stepping->setNewtonTolerance(settings.newton_tolerance);
  stepping->setNewtonMaxIteration(static_cast<unsigned>(settings.newton_iterations));
  stepping->setWarnOnNonConvergence(false);  // complaints() tells
  stepping->setCheckSolverFunction(count_failure);
}

// ---- A step -------------------------------------------------------------------------------------------

void World::push(std::size_t body, const Vector& force, const Vector& torque) {
  store(force, *parts_->forces[body]);
  store(torque, *parts_->torques[body]);
}

void World::set_mass(std::size_t body, double mass) { parts_->bodies[body]->setScalarMass(mass); }

void World::step() {
  // The first step remembers what it begins with by itself.
  for (const auto& body : parts_->bodies)
    if (body->forcesMemory().nbVectorsInMemory() > 0) body->remember_forces(parts_->stepping->startingTime());
  failures = &parts_->complaints.of_solver;
  parts_->stepping->computeOneStep();
  failures = nullptr;
  if (!parts_->stepping->isNewtonConverge()) ++parts_->complaints.of_newton;
  parts_->stepping->nextStep();
}

// ---- Reading ------------------------------------------------------------------------------------------

Motion World::motion(std::size_t body) const {
  const SiconosVector &q = *parts_->bodies[body]->q(), &speed = *parts_->bodies[body]->twist();
  return {vector(q),
          {q.getValue(3), q.getValue(4), q.getValue(5), q.getValue(6)},
          vector(speed),
          vector(speed, 3)};
}

std::vector<Pressed> World::pressed() const {
  std::vector<Pressed> all;
  for (std::size_t i = 0; i < parts_->touches.size(); ++i) {
    const Parts::Touch& touch = parts_->touches[i];
    const SiconosVector& impulse = *touch.interaction->lambda(1);
    if (!(impulse.getValue(0) > 0)) continue;
    all.push_back(touch.rough ? touch.rough->pressed(impulse) : touch.smooth->pressed(impulse));
    all.back().contact = static_cast<int>(i);
  }
  return all;
}

const Complaints& World::complaints() const { return parts_->complaints; }

double World::mass(std::size_t body) const { return parts_->bodies[body]->scalarMass(); }

// The lower right of its matrix of masses.
std::array<double, 9> World::inertia(std::size_t body) const {
  const SiconosMatrix& mass = *parts_->bodies[body]->mass();
  std::array<double, 9> inertia{};
  for (unsigned r = 0; r < 3; ++r)
    for (unsigned c = 0; c < 3; ++c) inertia[3 * r + c] = mass.getValue(3 + r, 3 + c);
  return inertia;
}

std::optional<FrictionSolver> World::solver() const {
  return friction_solver(*(*parts_->stepping->oneStepNSProblems()->begin())->numericsSolverOptions());
}

Settings World::defaults() {
  TimeStepping stepping(std::make_shared<NonSmoothDynamicalSystem>(0., 1.),
                        std::make_shared<TimeDiscretisation>(0., 1e-3));
  FrictionContact problem(3);
  const std::optional<FrictionSolver> solver = friction_solver(*problem.numericsSolverOptions());
  const auto& all = friction_solvers();
  Settings own;
  own.solver = static_cast<std::size_t>(
      std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == solver->name; }) -
      all.begin());
  own.solver_tolerance = solver->tolerance, own.solver_iterations = solver->iterations;
  own.theta = MoreauJeanOSI().theta();
  own.newton_tolerance = stepping.newtonTolerance();
  own.newton_iterations = static_cast<int>(stepping.newtonMaxIteration());
  return own;
}

}  // namespace cylon::simulators::siconos_border
