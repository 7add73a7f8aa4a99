// Simbody's API of 3.7.  Joints are those of its tree; what may touch needs a stiffness that no scene states.
#include "harness/hunt/program/dialect.h"

namespace cylon::hunt::program {
namespace {

using core::JointType;
using Where = SettingRow::Where;

constexpr std::string_view functions = R"(
using SimTK::MobilizedBody, SimTK::Rotation, SimTK::SpatialVec, SimTK::Transform, SimTK::UnitVec3, SimTK::Vec3;
SimTK::MultibodySystem* world;
SimTK::SimbodyMatterSubsystem* matter;
SimTK::Integrator* integrator;
SimTK::Vector_<SpatialVec>* wrenches;
std::vector<SimTK::MobilizedBodyIndex> id;
std::vector<Transform> placed;   // at the start
std::vector<SpatialVec> speeds;  // then, in the axes of the joint, against what the body hangs from
int taken;

Vec3 vec(const V& v) { return Vec3(v[0], v[1], v[2]); }
V of(const Vec3& v) { return {v[0], v[1], v[2]}; }

void act(double t, const std::vector<State>& s);
std::vector<State> states(const SimTK::State& now) {
  std::vector<State> all;
  for (SimTK::MobilizedBodyIndex i : id) {
    const MobilizedBody& one = matter->getMobilizedBody(i);
    const SimTK::Quaternion q = one.getBodyRotation(now).convertRotationToQuaternion();
    const SpatialVec& speed = one.getBodyVelocity(now);
    all.push_back({of(one.getBodyOriginLocation(now)), {q[0], q[1], q[2], q[3]}, of(speed[1]), of(speed[0])});
  }
  return all;
}

struct Law : SimTK::Force::Custom::Implementation {
  void calcForce(const SimTK::State& now, SimTK::Vector_<SpatialVec>& on, SimTK::Vector_<Vec3>&, SimTK::Vector&) const override {
    wrenches = &on;
    act(now.getTime(), states(now));
  }
  SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }
};
void push(int i, const V& F, const V& T) { (*wrenches)[id[i]] += SpatialVec(vec(T), vec(F)); }

// By a joint whose frame has this place in the world at the start.
template <class Joint>
void hang(int take, int i, int to, const Transform& place) {
  const State& s = start[take][i];
  const bool free = std::is_same_v<Joint, MobilizedBody::Free>;
  MobilizedBody& parent = to < 0 ? matter->updGround() : matter->updMobilizedBody(id[to]);
  const SimTK::Body::Rigid rigid(SimTK::MassProperties(body[i].m, Vec3(0), SimTK::Inertia(vec(body[i].I))));
  id.push_back(Joint(parent, to < 0 ? place : ~placed[to] * place, rigid, free ? place : ~placed[i] * place).getMobilizedBodyIndex());
  speeds.emplace_back(~place.R() * vec(to < 0 ? s.w : sub(s.w, start[take][to].w)), free ? vec(s.v) : Vec3(0));
}

void fixed_steps(SimTK::Integrator* one) { integrator = one, one->setFixedStepSize(dt), one->setAllowInterpolation(false); }

void build(int take) {
  world = new SimTK::MultibodySystem, matter = new SimTK::SimbodyMatterSubsystem(*world);
  auto* forces = new SimTK::GeneralForceSubsystem(*world);
  SimTK::Force::UniformGravity(*forces, *matter, vec(gravity[take]));
  SimTK::Force::Custom(*forces, new Law);
  id.clear(), placed.clear(), speeds.clear(), taken = 0;
  for (const State& s : start[take]) placed.emplace_back(Rotation(SimTK::Quaternion(s.q[0], s.q[1], s.q[2], s.q[3])), vec(s.x));
${joints}  SimTK::State state = world->realizeTopology();
  world->realizeModel(state);
  for (int i = 0; i < count; ++i) {
    const MobilizedBody& one = matter->getMobilizedBody(id[i]);
    if (MobilizedBody::Free::isInstanceOf(one)) one.setQToFitTransform(state, placed[i]);
    one.setUToFitVelocity(state, speeds[i]);
  }
${world_settings}  integrator->initialize(state);
}

void step() {
  for (++taken; integrator->getTime() < taken * dt;) integrator->stepTo(taken * dt);
}

std::vector<State> states() {
  world->realize(integrator->getState(), SimTK::Stage::Velocity);
  return states(integrator->getState());
}
)";

// A pin turns about z; the frame of other joints is the world's at the start.
constexpr std::string_view ball =
    "  hang<MobilizedBody::Ball>(take, ${a}, ${b}, Transform(vec(${point_vector})));\n";
constexpr std::string_view hinge =
    "  hang<MobilizedBody::Pin>(take, ${a}, ${b}, Transform(Rotation(UnitVec3(vec(${axis_vector})), "
    "SimTK::ZAxis), vec(${point_vector})));\n";
constexpr std::string_view fixed =
    "  hang<MobilizedBody::Weld>(take, ${a}, ${b}, Transform(vec(${point_vector})));\n";
constexpr JointRow joints[] = {
    {JointType::ball, ball, ball}, {JointType::hinge, hinge, hinge}, {JointType::fixed, fixed, fixed}};

constexpr SettingRow settings[] = {
    {"integrator", "runge-kutta-merson", Where::world,
     "  fixed_steps(new SimTK::RungeKuttaMersonIntegrator(*world));\n"},
    {"integrator", "runge-kutta-feldberg", Where::world,
     "  fixed_steps(new SimTK::RungeKuttaFeldbergIntegrator(*world));\n"},
    {"integrator", "runge-kutta-3", Where::world,
     "  fixed_steps(new SimTK::RungeKutta3Integrator(*world));\n"},
    {"integrator", "verlet", Where::world, "  fixed_steps(new SimTK::VerletIntegrator(*world));\n"},
    {"integrator", "semi-explicit-euler", Where::world,
     "  fixed_steps(new SimTK::SemiExplicitEulerIntegrator(*world, dt));\n"},
    {"integrator", "semi-explicit-euler-2", Where::world,
     "  fixed_steps(new SimTK::SemiExplicitEuler2Integrator(*world));\n"},
    {"integrator", "runge-kutta-merson-adaptive", Where::world,
     "  integrator = new SimTK::RungeKuttaMersonIntegrator(*world);\n"},
    {"integrator", "runge-kutta-feldberg-adaptive", Where::world,
     "  integrator = new SimTK::RungeKuttaFeldbergIntegrator(*world);\n"},
    {"integrator", "runge-kutta-3-adaptive", Where::world,
     "  integrator = new SimTK::RungeKutta3Integrator(*world);\n"},
    {"integrator", "verlet-adaptive", Where::world, "  integrator = new SimTK::VerletIntegrator(*world);\n"},
    {"integrator", "semi-explicit-euler-2-adaptive", Where::world,
     "  integrator = new SimTK::SemiExplicitEuler2Integrator(*world);\n"},
    {"setFixedStepSize", "", Where::program, ""},
    {"joints", "a tree", Where::program, ""},
    {"openblas_set_num_threads", "1", Where::program, ""},
    {"springs, drag*", "", Where::program, ""},
    {"tolerance of a step", "", Where::world, "  integrator->setAccuracy(${value});\n"},
    {"setAccuracy", "", Where::world, "  integrator->setAccuracy(${value});\n"},
    {"setConstraintTolerance", "", Where::world, "  integrator->setConstraintTolerance(${value});\n"},
    {"setProjectEveryStep", "every-step", Where::world, "  integrator->setProjectEveryStep(true);\n"},
    {"setUseInfinityNorm", "infinity", Where::world, "  integrator->setUseInfinityNorm(true);\n"},
    {"setAllowInterpolation", "disable", Where::world, "  integrator->setAllowInterpolation(false);\n"},
};

}  // namespace

extern const Dialect simbody;
const Dialect simbody = {
    "simbody",
    "Simbody",
    &cpp,
    "apt-get install g++ libsimbody-dev",
    // In C++20 two of its indices compare in two ways.
    "c++ -std=c++17 -fconcepts ${file} -o fault -isystem /usr/include/simbody -lSimTKsimbody -lSimTKmath "
    "-lSimTKcommon && ./fault",
    "#include <SimTKsimbody.h>\n",
    functions,
    "",
    "",
    "",
    {},
    joints,
    settings,
    "  hang<MobilizedBody::Free>(take, ${a}, -1, Transform());\n",
    true};

}  // namespace cylon::hunt::program
