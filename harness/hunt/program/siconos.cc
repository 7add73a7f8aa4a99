// Siconos's API of 4.4: its kernel, which has no shapes.  Distances of spheres and planes are relations of the program.
#include "harness/hunt/program/dialect.h"

namespace cylon::hunt::program {
namespace {

using Where = SettingRow::Where;

// Moreau-Jean weighs the forces at the end of a step by theta and those at its begin, which Siconos remembers from the step
// before, by 1 - theta: what is pushed is the force of the whole step, of the state to which (1 - theta) of it leads.
constexpr std::string_view functions = R"(
constexpr double friction = ${friction};
using Distance = std::conditional_t<(friction > 0), NewtonEuler3DR, NewtonEuler1DR>;
struct Plane { V n; double offset; };
std::vector<double> radius;  // 0: touches nothing
std::vector<Plane> planes;
double theta;
V weight;               // of a kilogram
std::vector<V> turned;  // where (1 - theta) of the step leads
void act(double t, const std::vector<State>& s);

void store(const V& v, SiconosVector& out, unsigned from = 0) {
  for (unsigned k = 0; k < v.size(); ++k) out.setValue(from + k, v[k]);
}
V of(const SiconosVector& v, unsigned from = 0) { return {v.getValue(from), v.getValue(from + 1), v.getValue(from + 2)}; }

struct Moving : NewtonEulerDS {
  using NewtonEulerDS::NewtonEulerDS;
  void remember_forces(double time) {  // as those at the begin of the step
    if (_forcesMemory.nbVectorsInMemory() == 0) return;  // the first step does so by itself
    computeForces(time, _q, _twist);
    _forcesMemory.getSiconosVectorMutable(0) = *_wrench;
  }
};
std::vector<std::shared_ptr<Moving>> id;
std::vector<std::shared_ptr<SiconosVector>> forces, torques;
std::shared_ptr<TimeStepping> stepping;

// Of a sphere and a plane, n . x - offset - r, or another sphere, |x - x'| - r' - r.
struct Gap : Distance {
  double r, offset;
  V n;
  bool spheres;
  Gap(double r, double offset, const V& n) : r(r), offset(offset), n(n), spheres(n.size() == 0) {}
  void computeh(double, const BlockVector& q, SiconosVector& y) override {
    const V x = of(*q.getAllVect()[0]);
    const V d = spheres ? sub(x, of(*q.getAllVect()[1])) : x;
    if (spheres) n = norm(d) > 0 ? mul(1 / norm(d), d) : V{0, 1, 0};
    const double height = (spheres ? norm(d) : dot(n, x)) - offset;
    store(sub(x, mul(r, n)), *this->_Pc1), store(sub(x, mul(height, n)), *this->_Pc2), store(n, *this->_Nc);
    y.setValue(0, height - r);
  }
};

void link(NonSmoothDynamicalSystem& system, const std::shared_ptr<Gap>& gap, int i, std::shared_ptr<NewtonEulerDS> other) {
  std::shared_ptr<NonSmoothLaw> law;
  if (friction > 0) law = std::make_shared<NewtonImpactFrictionNSL>(${restitution}, 0, friction, 3U);
  else law = std::make_shared<NewtonImpactNSL>(${restitution});
  system.link(std::make_shared<Interaction>(law, gap), id[i], other);
}

void build(int take) {
  theta = 0.5, weight = gravity[take];
  auto system = std::make_shared<NonSmoothDynamicalSystem>(0, 1e300);
  id.clear(), forces.clear(), torques.clear(), planes.clear(), radius.assign(count, 0);
  for (int i = 0; i < count; ++i) {
    const State& s = start[take][i];
    auto place = std::make_shared<SiconosVector>(7U), speed = std::make_shared<SiconosVector>(6U);
    auto inertia = std::make_shared<SimpleMatrix>(3U, 3U);
    store(s.x, *place), store(s.q, *place, 3), store(s.v, *speed), store(back(s.q, s.w), *speed, 3);
    for (unsigned k = 0; k < 3; ++k) inertia->setValue(k, k, body[i].I[k]);
    id.push_back(std::make_shared<Moving>(place, speed, body[i].m, inertia));
    forces.push_back(std::make_shared<SiconosVector>(3U)), torques.push_back(std::make_shared<SiconosVector>(3U));
    id[i]->setFExtPtr(forces[i]), id[i]->setMExtPtr(torques[i]);
    system->insertDynamicalSystem(id[i]);
  }
${shapes}${planes}  for (int i = 0; i < count; ++i) {
    if (radius[i] == 0) continue;
    for (int j = i + 1; j < count; ++j)
      if (radius[j] > 0) link(*system, std::make_shared<Gap>(radius[i], radius[j], V{}), i, id[j]);
    for (const Plane& p : planes) link(*system, std::make_shared<Gap>(radius[i], p.offset, p.n), i, nullptr);
  }
  std::shared_ptr<OneStepNSProblem> problem;
  if (friction > 0) problem = std::make_shared<FrictionContact>(3);
  else problem = std::make_shared<LCP>();
${world_settings}  stepping = std::make_shared<TimeStepping>(system, std::make_shared<TimeDiscretisation>(0., dt), std::make_shared<MoreauJeanOSI>(theta), problem);
${body_settings}  stepping->setWarnOnNonConvergence(false);
  stepping->setCheckSolverFunction([](int, Simulation*) {});  // a step whose solver fails is taken as it is
}

std::vector<State> states() {
  std::vector<State> all;
  for (const auto& one : id) {
    const SiconosVector &x = *one->q(), &u = *one->twist();
    const V q = {x.getValue(3), x.getValue(4), x.getValue(5), x.getValue(6)};
    all.push_back({of(x), q, of(u), turn(q, of(u, 3))});
  }
  return all;
}

void push(int i, const V& F, const V& T) {
  store(add(of(*forces[i]), F), *forces[i]), store(add(of(*torques[i]), back(turned[i], T)), *torques[i]);
}

void step() {
  const double far = (1 - theta) * dt;
  std::vector<State> s = states();
  turned.clear();
  for (int i = 0; i < count; ++i) {
    s[i].x = add(s[i].x, mul(far, s[i].v));
    if (const double w = norm(s[i].w); w > 0) {
      const V q = s[i].q, u = {q[1], q[2], q[3]}, r = mul(std::sin(far * w / 2) / w, s[i].w);
      const double c = cos(far * w / 2);
      const V p = add(add(mul(c, u), mul(q[0], r)), cross(r, u));
      s[i].q = {c * q[0] - dot(r, u), p[0], p[1], p[2]};
    }
    turned.push_back(s[i].q);
    store(mul(body[i].m, weight), *forces[i]), torques[i]->zero();
  }
  act(stepping->startingTime() + far, s);
  for (const auto& one : id) one->remember_forces(stepping->startingTime());
  stepping->computeOneStep();
  stepping->nextStep();
}
)";

constexpr ShapeRow shapes[] = {{"sphere", "${radius}"}};

constexpr SettingRow settings[] = {
    {"integrator", "moreau-jean-implicit", Where::world, "  theta = 1;\n"},
    {"TimeDiscretisation", "dt", Where::program, ""},
    {"relations", "", Where::program, ""},
    {"NewtonImpactNSL, NewtonImpactFrictionNSL", "of the pair", Where::program, ""},
    {"OneStepNSProblem", "", Where::program, ""},
    {"openblas_set_num_threads", "1", Where::program, ""},
    {"springs, drag*", "", Where::program, ""},
    // Of what takes the steps, and so after it.
    {"TimeStepping::setNewtonTolerance", "", Where::body, "  stepping->setNewtonTolerance(${value});\n"},
    {"TimeStepping::setNewtonMaxIteration", "", Where::body,
     "  stepping->setNewtonMaxIteration(${value});\n"},
    {"SICONOS_DPARAM_TOL", "", Where::world,
     "  if (friction > 0) "
     "std::static_pointer_cast<LinearOSNS>(problem)->numericsSolverOptions()->dparam[${name}] = "
     "${value};\n"},
    {"SICONOS_IPARAM_MAX_ITER", "", Where::world,
     "  if (friction > 0) "
     "std::static_pointer_cast<LinearOSNS>(problem)->numericsSolverOptions()->iparam[${name}] = "
     "${value};\n"},
};

}  // namespace

extern const Dialect siconos;
const Dialect siconos = {
    "siconos",
    "Siconos",
    &cpp,
    "apt-get install g++ libsiconos-kernel-dev libsiconos-numerics-dev",
    "c++ -std=c++17 -fconcepts ${file} -o fault -isystem /usr/include/siconos -isystem "
    "/usr/include/siconos/kernel "
    "-isystem /usr/include/siconos/numerics -lsiconos_kernel -lsiconos_numerics && OPENBLAS_NUM_THREADS=1 "
    "./fault",
    "#include <SolverOptions.h>\n"
    "#include <BlockVector.hpp>\n"
    "#include <FrictionContact.hpp>\n"
    "#include <Interaction.hpp>\n"
    "#include <LCP.hpp>\n"
    "#include <MoreauJeanOSI.hpp>\n"
    "#include <NewtonEuler1DR.hpp>\n"
    "#include <NewtonEuler3DR.hpp>\n"
    "#include <NewtonEulerDS.hpp>\n"
    "#include <NewtonImpactFrictionNSL.hpp>\n"
    "#include <NewtonImpactNSL.hpp>\n"
    "#include <NonSmoothDynamicalSystem.hpp>\n"
    "#include <SiconosVector.hpp>\n"
    "#include <SimpleMatrix.hpp>\n"
    "#include <TimeDiscretisation.hpp>\n"
    "#include <TimeStepping.hpp>\n",
    functions,
    "  radius[${i}] = ${shape};\n",
    "",
    "  planes.push_back({${normal_vector}, ${offset}});\n",
    shapes,
    {},
    settings,
    {},
    true};

}  // namespace cylon::hunt::program
