#include "reference/simulators/bullet/bullet_settings.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

namespace cylon::simulators {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

enum class Kind { number, whole, flag };
enum class Of { every_path, rigid, multibody };

// A number that Bullet lets its user set, or a flag: 0 or 1.
struct Knob {
  const char* option;
  const char* setting;  // Bullet's own name
  double engine_default;
  double least, most;
  const char* meaning;
  Kind kind = Kind::number;
  Of of = Of::every_path;
};
constexpr Knob knobs[] = {
    {"erp", "m_erp", 0.2, 0, 1, "fraction of a joint's position error removed per step"},
    {"erp2", "m_erp2", 0.2, 0, 1, "fraction of a penetration removed per step"},
    {"cfm", "m_globalCfm", 0, 0, infinity, "constraint force mixing of contacts and joints"},
    {"iterations", "m_numIterations", 10, 1, 1e6, "sweeps of the constraint solver per step", Kind::whole},
    {"warm-starting", "m_warmstartingFactor", 0.85, 0, 1,
     "fraction of the last impulses used as the initial guess"},
    {"restitution-threshold", "m_restitutionVelocityThreshold", 0.2, 0, infinity,
     "approach speed below which there is no restitution [m/s]"},
    {"split-threshold", "m_splitImpulsePenetrationThreshold", -0.04, -infinity, infinity,
     "gap above which penetration is corrected through the velocity; rigid paths only [m]"},
    {"contact-threshold", "contactProcessingThreshold", no_limit, 0, infinity,
     "gap up to which a contact is solved before it touches [m]"},
    {"max-gyroscopic-force", "m_maxGyroscopicForce", 100, 0, infinity,
     "limit of the explicit gyroscopic torque; rigid paths only [N m]"},
    {"ccd", "setCcdSweptSphereRadius, setCcdMotionThreshold", 0, 0, 1,
     "continuous collision detection: swept sphere, as a fraction of the largest sphere in the shape; it "
     "sweeps "
     "motions beyond half of that sphere's radius per step; 0: none; rigid paths only",
     Kind::number, Of::rigid},
    {"speculative-restitution", "setApplySpeculativeContactRestitution", 0, 0, 1,
     "the contacts that ccd foresees bounce", Kind::flag, Of::rigid},
    {"plane-queries", "setPlaneConvexMultipointIterations", 0, 0, 64,
     "queries of a polyhedral shape, tilted a little, against a plane while fewer than 3 points are known",
     Kind::whole},
    {"convex-queries", "setConvexConvexMultipointIterations", 0, 0, 64, "the same between two convex shapes",
     Kind::whole},
    {"breaking-threshold", "gContactBreakingThreshold", 0.02, 0, infinity,
     "distance at which a contact point is created or given up, as a fraction of the smaller shape's size"},
    {"slop", "m_linearSlop", 0, -infinity, infinity, "gap that penetration is measured from [m]"},
    {"relaxation", "m_sor", 1, 0, 2, "over-relaxation of the solver's sweeps"},
    {"split-impulse", "m_splitImpulse", 1, 0, 1,
     "deep penetration is corrected without changing the velocity", Kind::flag, Of::rigid},
    {"two-friction-directions", "SOLVER_USE_2_FRICTION_DIRECTIONS", 0, 0, 1,
     "friction along two directions per contact; multibody always has two", Kind::flag, Of::rigid},
    {"random-order", "SOLVER_RANDMIZE_ORDER", 0, 0, 1, "constraints are solved in a random order",
     Kind::flag},
    {"interleave", "SOLVER_INTERLEAVE_CONTACT_AND_FRICTION_CONSTRAINTS", 0, 0, 1,
     "each contact is followed by its friction", Kind::flag, Of::rigid},
    {"sleeping", "activation state", 1, 0, 1, "slow bodies fall asleep; off on our paths", Kind::flag},
    {"margin", "setMargin", default_margin, 0, infinity,
     "margin of all but spheres and capsules, 0.04: at most that, by the shape's size; 0 on our paths [m]"},
    {"damping", "setLinearDamping, setAngularDamping", 0.04, 0, infinity,
     "of a multibody; 0 on our paths [1/s]", Kind::number, Of::multibody},
    {"max-coordinate-velocity", "setMaxCoordinateVelocity", 100, 0, infinity,
     "limit of a multibody's velocities; none on our paths [m/s, rad/s]", Kind::number, Of::multibody},
    {"rk4", "useRK4Integration", 0, 0, 1,
     "a multibody's motion between contacts by Runge-Kutta 4, in place of semi-implicit Euler", Kind::flag,
     Of::multibody},
};

// A number that a path sets.
struct Forced {
  const char* option;
  double value;
  const char* reason;
};
constexpr Forced all_bounce = {"restitution-threshold", 0, "slow impacts must bounce too"};
constexpr Forced no_early_contact = {
    "contact-threshold", 0,
    "a contact solved before it touches reduces or removes the rebound speed, by gap/dt"};
constexpr std::array<Forced, 4> bounce_rigid = {{
    all_bounce,
    no_early_contact,
    {"erp2", 0,
     "penetration correction adds energy to every bounce, as speed (Baumgarte) or as height (split impulse)"},
    {"split-threshold", 0, "if a run sets erp2, the correction must not change the velocity"},
}};
constexpr std::array<Forced, 3> bounce_multibody = {{
    all_bounce,
    no_early_contact,
    {"erp2", 0, "multibody contacts have no split impulse, so any correction adds energy to a bounce"},
}};

// What our paths set everywhere.  Its sentences are in always() and always_multibody().
constexpr std::array<Forced, 4> ours = {{
    {"sleeping", 0, ""},
    {"margin", 0, ""},
    {"damping", 0, ""},
    {"max-coordinate-velocity", no_limit, ""},
}};

std::string text(double value) { return value >= no_limit ? "no limit" : fmt::format("{}", value); }

std::string text(const Knob& k, double value) {
  return k.kind == Kind::flag ? (value != 0 ? "on" : "off") : text(value);
}

const Knob& knob(std::string_view option) {
  for (const Knob& k : knobs)
    if (k.option == option) return k;
  throw std::logic_error(fmt::format("unknown setting '{}'", option));
}

core::Setting setting(const Forced& forced) {
  const Knob& k = knob(forced.option);
  return {k.setting, text(k, forced.value), text(k, k.engine_default), forced.reason};
}

// What every path does, as shipped or not.
std::vector<core::Setting> of_the_scene() {
  return {
      {"stepSimulation", "(dt, 0)", "(dt, 1, 1/60)", "exactly one step of dt, for every dt"},
      {"combined restitution and friction", "of the pair", "product of the bodies'",
       "the scene gives the values of the pair"},
      {"springs, drag, drive, thrust, attraction", "force of the state before the step", "none",
       "Bullet has no such forces; they are constant during the step"},
  };
}

// What every path of ours sets.
std::vector<core::Setting> always() {
  std::vector<core::Setting> settings = of_the_scene();
  settings.insert(settings.begin() + 1,
                  {"activation state", "DISABLE_DEACTIVATION", "ACTIVE_TAG", "no body falls asleep"});
  settings.insert(settings.begin() + 3, {"margin of all but spheres and capsules", "0", "0.04 m",
                                         "edges must be as sharp as in the scene"});
  return settings;
}

std::vector<core::Setting> always_multibody() {
  std::vector<core::Setting> settings = always();
  settings.push_back({"linear and angular damping", "0", "0.04", "the scene has no damping of its own"});
  settings.push_back({"maxCoordinateVelocity", text(no_limit), "100", "no hidden limit of the speed"});
  settings.push_back({"canSleep", "false", "given by the user", "no body falls asleep"});
  settings.push_back({"maxAppliedImpulse of joints that close a loop", text(no_limit), "100 N s",
                      "a joint must hold whatever pulls at it"});
  return settings;
}

std::vector<core::Setting> with(std::vector<core::Setting> settings, std::span<const Forced> forced) {
  for (const Forced& f : forced) settings.push_back(setting(f));
  return settings;
}

// What Bullet does all the same; in brackets the place in the sources of Debian's version, below src/.
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

std::vector<std::string> unforceable_rigid() {
  std::vector<std::string> sentences = unforceable_everywhere;
  sentences.emplace_back(
      "Semi-implicit Euler is the only integrator of btRigidBody "
      "(BulletDynamics/Dynamics/btDiscreteDynamicsWorld.cpp:486, "
      "BulletDynamics/Dynamics/btRigidBody.cpp:102).");
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
      "With rk4, applied forces are constant during the step, and constraint impulses change the position "
      "one "
      "step late (BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.cpp:613).");
  return sentences;
}

// ---- As an expert sets it: one rule, a function of the scene's kind -----------------------------

struct Expert {
  bool multibody = false;
  const char* gyroscopic = "implicit-body";
  const char* solver = "sequential-impulse";
  std::vector<Forced> forced;
};

constexpr const char* expert_rule =
    "btMultiBody with rk4 where nothing touches, no force but gravity and drag acts, every moving body hangs "
    "from "
    "the world by joints or has no gyroscopic torque, and masses are within a factor of 1000; else "
    "btRigidBody. "
    "What may touch: continuous collision detection, 200 sweeps, points of a plane by 3 queries, kept for "
    "longer; "
    "Dantzig's solver where masses differ by a factor of 1000; where a pair bounces, the contacts of "
    "rigid-bounce";

constexpr double wide_mass_ratio = 1000;

constexpr std::array<Forced, 4> expert_contact = {{
    {"ccd", 0.9, "fast bodies must not tunnel; a slow body's bits are the same"},
    {"plane-queries", 3, "a box on a plane needs its corners in the first step"},
    {"iterations", 200, "10 sweeps leave stacks and friction unsolved"},
    {"breaking-threshold", 0.1, "points at rest must not be given up and found again"},
}};
constexpr Forced expert_rk4 = {"rk4", 1, "order 4 with hinges, 2 with ball joints; nothing needs a contact"};

Expert expert(const BulletKind& kind) {
  Expert result;
  const bool wide = kind.mass_ratio >= wide_mass_ratio;
  if (kind.tree && !wide) {
    result.multibody = true;
    result.forced = {expert_rk4};
    return result;
  }
  if (wide) result.solver = "dantzig";
  if (kind.touches) result.forced.assign(expert_contact.begin(), expert_contact.end());
  if (kind.bounces) result.forced.insert(result.forced.end(), bounce_rigid.begin(), bounce_rigid.end());
  return result;
}

[[noreturn]] void refuse(const std::string& what, const std::string& given,
                         const std::vector<std::string>& valid) {
  throw std::invalid_argument(fmt::format("bullet: no {} '{}'{} (valid: {})", what, given,
                                          core::did_you_mean(given, valid), fmt::join(valid, ", ")));
}

void require(const std::string& what, const std::string& given, const std::vector<std::string>& valid) {
  for (const std::string& name : valid)
    if (name == given) return;
  refuse(what, given, valid);
}

template <class Items>
std::vector<std::string> names(const Items& items) {
  std::vector<std::string> result;
  for (const auto& item : items) result.push_back(item.name);
  return result;
}

const std::vector<std::string> off_on = {"off", "on"};

double parse(const Knob& k, const std::string& given) {
  if (k.kind == Kind::flag) {
    require(fmt::format("value of option {}", k.option), given, off_on);
    return given == "on" ? 1 : 0;
  }
  double value = 0;
  const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), value);
  const bool whole = k.kind == Kind::whole;
  if (error != std::errc() || end != given.data() + given.size() || !(value >= k.least && value <= k.most) ||
      (whole && value != std::floor(value)))
    throw std::invalid_argument(fmt::format("bullet: {} = '{}' is not a {}number in [{}, {}] ({})", k.option,
                                            given, whole ? "whole " : "", k.least, k.most, k.meaning));
  return value;
}

void require_path(const Knob& k, const BulletSettings& settings) {
  if (k.of == Of::every_path || (k.of == Of::multibody) == settings.multibody) return;
  throw std::invalid_argument(fmt::format("bullet: option {} belongs to {}, and path {} has none here",
                                          k.option, k.of == Of::rigid ? "btRigidBody" : "btMultiBody",
                                          settings.path));
}

}  // namespace

core::Engine bullet_engine(std::string version, std::string precision) {
  core::Engine engine;
  engine.name = "bullet";
  engine.version = std::move(version);
  engine.precision = std::move(precision);
  engine.paths = {
      {"rigid", "btRigidBody, contacts as Bullet sets them", always(), unforceable_rigid()},
      {"rigid-bounce", "btRigidBody, contacts set so that a bounce keeps its energy",
       with(always(), bounce_rigid), unforceable_rigid()},
      {"multibody",
       "btMultiBody: a tree for each set of bodies that joints connect; "
       "m_restitutionVelocityThreshold, contactProcessingThreshold and m_erp2 are set only where a touching "
       "pair bounces",
       with(always_multibody(), bounce_multibody), unforceable_multibody()},
      {"as-shipped", "btRigidBody, and every setting as Bullet has it by itself", of_the_scene(),
       unforceable_rigid()},
      {"as-expert", fmt::format("one rule for all scenes: {}", expert_rule), always(), unforceable_rigid()},
  };
  engine.default_path_rule = "any restitution > 0 between a touching pair: rigid-bounce, else rigid";
  engine.integrators = {
      {"semi-implicit-euler", 1, "linear momentum; symplectic without rotation and contact"}};
  engine.options = {
      {"gyro",
       {"implicit-body", "implicit-world", "explicit", "none"},
       "implicit-body",
       "gyroscopic term w x I w; multibody offers explicit (its default) and none"},
      {"solver",
       {"sequential-impulse", "nncg", "dantzig"},
       "sequential-impulse",
       "constraint solver; multibody offers sequential-impulse and dantzig"},
  };
  for (const Knob& k : knobs)
    engine.options.push_back({k.option, k.kind == Kind::flag ? off_on : std::vector<std::string>(),
                              text(k, k.engine_default), fmt::format("{}: {}", k.setting, k.meaning)});
  return engine;
}

BulletSettings bullet_settings(const core::Engine& engine, const core::Setup& setup, const BulletKind& kind) {
  if (!setup.path.empty()) require("path", setup.path, names(engine.paths));
  if (!setup.integrator.empty()) require("integrator", setup.integrator, names(engine.integrators));

  BulletSettings settings;
  const bool by_rule = setup.path.empty() || setup.path == "rigid";
  settings.path = by_rule ? (kind.bounces ? "rigid-bounce" : "rigid") : setup.path;
  const bool shipped = settings.path == "as-shipped", by_expert = settings.path == "as-expert";
  const Expert experts = by_expert ? expert(kind) : Expert();
  settings.multibody = settings.path == "multibody" || experts.multibody;
  settings.gyroscopic = settings.multibody ? "explicit" : experts.gyroscopic;
  settings.solver = experts.solver;
  settings.terms = {settings.path, engine.integrators[0].name, engine.integrators[0].order, "", {}, {}};
  settings.terms.settings = shipped ? of_the_scene() : settings.multibody ? always_multibody() : always();
  settings.terms.unforceable = settings.multibody ? unforceable_multibody() : unforceable_rigid();
  for (const Knob& k : knobs) settings.number[k.option] = k.engine_default;
  if (!shipped)
    for (const Forced& forced : ours) settings.number[forced.option] = forced.value;

  const auto force = [&](const Forced& forced) {
    settings.number[forced.option] = forced.value;
    if (!setup.options.contains(forced.option)) settings.terms.settings.push_back(setting(forced));
  };
  if (settings.path == "rigid-bounce")
    for (const Forced& forced : bounce_rigid) force(forced);
  if (settings.path == "multibody" && kind.bounces)
    for (const Forced& forced : bounce_multibody) force(forced);
  for (const Forced& forced : experts.forced) force(forced);
  if (by_expert)
    settings.terms.settings.push_back({"solver", settings.solver, "sequential-impulse", "the expert's rule"});

  for (const auto& [option, value] : setup.options) {
    require("option", option, names(engine.options));
    const char* const asked = "asked for by the run";
    if (option == "gyro" || option == "solver") {
      const std::vector<std::string> of_path =
          !settings.multibody ? engine.options[option == "gyro" ? 0 : 1].values
          : option == "gyro"  ? std::vector<std::string>{"explicit", "none"}
                              : std::vector<std::string>{"sequential-impulse", "dantzig"};
      require(option + " on path " + settings.path, value, of_path);
      std::string& chosen = option == "gyro" ? settings.gyroscopic : settings.solver;
      settings.terms.settings.push_back({option, value, chosen, asked});
      chosen = value;
    } else {
      const Knob& k = knob(option);
      require_path(k, settings);
      settings.number[option] = parse(k, value);
      settings.terms.settings.push_back({k.setting, value, text(k, k.engine_default), asked});
    }
  }
  if (settings.on("rk4")) settings.terms.integrator = "runge-kutta-4", settings.terms.order = kind.rk4_order;
  settings.terms.gyroscopic = settings.gyroscopic;
  return settings;
}

}  // namespace cylon::simulators
