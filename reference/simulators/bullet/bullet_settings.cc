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

// A number that Bullet lets its user set.
struct Knob {
  const char* option;
  const char* setting;  // Bullet's own name
  double engine_default;
  double least, most;
  const char* meaning;
};
constexpr Knob knobs[] = {
    {"erp", "m_erp", 0.2, 0, 1, "fraction of a joint's position error removed per step"},
    {"erp2", "m_erp2", 0.2, 0, 1, "fraction of a penetration removed per step"},
    {"cfm", "m_globalCfm", 0, 0, infinity, "constraint force mixing of contacts and joints"},
    {"iterations", "m_numIterations", 10, 1, 1e6, "sweeps of the constraint solver per step"},
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

std::string text(double value) { return value >= no_limit ? "no limit" : fmt::format("{}", value); }

const Knob& knob(std::string_view option) {
  for (const Knob& k : knobs)
    if (k.option == option) return k;
  throw std::logic_error(fmt::format("unknown setting '{}'", option));
}

core::Setting setting(const Forced& forced) {
  const Knob& k = knob(forced.option);
  return {k.setting, text(forced.value), text(k.engine_default), forced.reason};
}

// What every path sets that no option changes.
std::vector<core::Setting> always() {
  return {
      {"stepSimulation", "(dt, 0)", "(dt, 1, 1/60)", "exactly one step of dt, for every dt"},
      {"activation state", "DISABLE_DEACTIVATION", "ACTIVE_TAG", "no body falls asleep"},
      {"combined restitution and friction", "of the pair", "product of the bodies'",
       "the scene gives the values of the pair"},
      {"margin of all but spheres and capsules", "0", "0.04 m", "edges must be as sharp as in the scene"},
      {"springs, drag, drive, thrust, attraction", "force of the state before the step", "none",
       "Bullet has no such forces; they are constant during the step"},
  };
}

std::vector<core::Setting> always_multibody() {
  std::vector<core::Setting> settings = always();
  settings.push_back({"linear and angular damping", "0", "0.04", "the scene has no damping of its own"});
  settings.push_back({"maxCoordinateVelocity", text(no_limit), "100", "no hidden limit of the speed"});
  settings.push_back({"canSleep", "false", "given by the user", "no body falls asleep"});
  return settings;
}

std::vector<core::Setting> with(std::vector<core::Setting> settings, std::span<const Forced> forced) {
  for (const Forced& f : forced) settings.push_back(setting(f));
  return settings;
}

// What Bullet does all the same.
const std::vector<std::string> unforceable_everywhere = {
    "A rotation of more than pi/4 per step is reduced: the body rotates by 2 atan(w dt/(pi/4) tan(pi/8)).",
    "Semi-implicit Euler is the only integrator: motion is first order in dt.",
    "If a pair has restitution, an impact acts in the step after the bodies overlap, up to dt late. If no "
    "pair has, a contact is created up to 0.02 m ahead and may act early.",
    "Several contacts are solved by a fixed number of sweeps; the result of simultaneous impacts is neither "
    "that of a sequence nor that of one simultaneous impact.",
    "Friction acts along one direction per contact, the direction of sliding, which is updated each step.",
    "Contacts are kept in a cache of at most four points per pair, with a breaking distance of 0.02 m.",
    "The world runs on one thread; Debian's build has no task scheduler.",
};

std::vector<std::string> unforceable_multibody() {
  std::vector<std::string> sentences = unforceable_everywhere;
  sentences.emplace_back(
      "Restitution uses the approach speed after gravity acts in the step, so a bounce gains |g| dt.");
  sentences.emplace_back("The gyroscopic term is explicit or absent; there is no implicit form.");
  sentences.emplace_back("Penetration is corrected through the velocity only; split impulses are ignored.");
  return sentences;
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

double parse(const Knob& k, const std::string& given) {
  double value = 0;
  const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), value);
  const bool whole = std::string_view(k.option) != "iterations" || value == std::floor(value);
  if (error != std::errc() || end != given.data() + given.size() || !(value >= k.least && value <= k.most) ||
      !whole)
    throw std::invalid_argument(fmt::format("bullet: {} = '{}' is not a {}number in [{}, {}] ({})", k.option,
                                            given, std::string_view(k.option) == "iterations" ? "whole " : "",
                                            k.least, k.most, k.meaning));
  return value;
}

}  // namespace

core::Engine bullet_engine(std::string version, std::string precision) {
  core::Engine engine;
  engine.name = "bullet";
  engine.version = std::move(version);
  engine.precision = std::move(precision);
  engine.paths = {
      {"rigid", "btRigidBody, contacts as Bullet sets them", always(), unforceable_everywhere},
      {"rigid-bounce", "btRigidBody, contacts set so that a bounce keeps its energy",
       with(always(), bounce_rigid), unforceable_everywhere},
      {"multibody",
       "btMultiBody: free bases, or a link on a fixed base for a body hung from the world; "
       "m_restitutionVelocityThreshold, contactProcessingThreshold and m_erp2 are set only where a touching "
       "pair bounces",
       with(always_multibody(), bounce_multibody), unforceable_multibody()},
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
       "constraint solver; multibody offers sequential-impulse"},
  };
  for (const Knob& k : knobs)
    engine.options.push_back(
        {k.option, {}, text(k.engine_default), fmt::format("{}: {}", k.setting, k.meaning)});
  return engine;
}

BulletSettings bullet_settings(const core::Engine& engine, const core::Setup& setup, bool bounces) {
  if (!setup.path.empty()) require("path", setup.path, names(engine.paths));
  if (!setup.integrator.empty()) require("integrator", setup.integrator, names(engine.integrators));

  BulletSettings settings;
  const bool by_rule = setup.path.empty() || setup.path == "rigid";
  settings.path = by_rule ? (bounces ? "rigid-bounce" : "rigid") : setup.path;
  settings.gyroscopic = settings.multibody() ? "explicit" : "implicit-body";
  settings.solver = "sequential-impulse";
  settings.terms = {settings.path, engine.integrators[0].name, engine.integrators[0].order, "", {}, {}};
  settings.terms.settings = settings.multibody() ? always_multibody() : always();
  settings.terms.unforceable = settings.multibody() ? unforceable_multibody() : unforceable_everywhere;
  for (const Knob& k : knobs) settings.number[k.option] = k.engine_default;

  const auto force = [&](const Forced& forced) {
    settings.number[forced.option] = forced.value;
    if (!setup.options.contains(forced.option)) settings.terms.settings.push_back(setting(forced));
  };
  if (settings.path == "rigid-bounce")
    for (const Forced& forced : bounce_rigid) force(forced);
  if (settings.multibody() && bounces)
    for (const Forced& forced : bounce_multibody) force(forced);

  for (const auto& [option, value] : setup.options) {
    require("option", option, names(engine.options));
    const char* const asked = "asked for by the run";
    if (option == "gyro" || option == "solver") {
      const std::vector<std::string> of_path =
          !settings.multibody() ? engine.options[option == "gyro" ? 0 : 1].values
          : option == "gyro"    ? std::vector<std::string>{"explicit", "none"}
                                : std::vector<std::string>{"sequential-impulse"};
      require(option + " on path " + settings.path, value, of_path);
      std::string& chosen = option == "gyro" ? settings.gyroscopic : settings.solver;
      settings.terms.settings.push_back({option, value, chosen, asked});
      chosen = value;
    } else {
      const Knob& k = knob(option);
      settings.number[option] = parse(k, value);
      settings.terms.settings.push_back({k.setting, value, text(k.engine_default), asked});
    }
  }
  settings.terms.gyroscopic = settings.gyroscopic;
  return settings;
}

}  // namespace cylon::simulators
