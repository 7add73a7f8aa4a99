#include "reference/simulators/bullet/bullet_settings.h"

#include "harness/core/input_error.h"
#include "reference/applied/forces.h"
#include "reference/simulators/bullet/bullet_knobs.h"
#include "reference/simulators/bullet/bullet_limits.h"
#include "reference/simulators/bullet/bullet_rules.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <utility>
#include <vector>

namespace cylon::simulators {
namespace {

constexpr const char* semi_implicit_euler = "semi-implicit-euler";
constexpr const char* runge_kutta = "runge-kutta-4";
constexpr const char* asked_for = "asked for by the run";
const std::vector<std::string> off_on = {"off", "on"};

void require(const std::string& what, const std::string& given, const std::vector<std::string>& valid) {
  if (std::ranges::find(valid, given) != valid.end()) return;
  throw std::invalid_argument(fmt::format("bullet: no {} '{}'{} (valid: {})", what, given,
                                          core::did_you_mean(given, valid), fmt::join(valid, ", ")));
}

template <class Items>
std::vector<std::string> names(const Items& items) {
  std::vector<std::string> result;
  for (const auto& item : items) result.push_back(item.name);
  return result;
}

// ---- Options that are words -----------------------------------------------------------------------

struct Word {
  const char *option, *setting;
  std::string BulletSettings::*value;
  std::vector<std::string> of_rigid, of_multibody;  // the first is Bullet's own
  const char* meaning;

  const std::vector<std::string>& values(bool multibody) const { return multibody ? of_multibody : of_rigid; }
};
const Word words[] = {
    {"gyro",
     "gyroscopic term",
     &BulletSettings::gyroscopic,
     {"implicit-body", "implicit-world", "explicit", "none"},
     {"explicit", "none"},
     "gyroscopic term w x I w; multibody offers explicit (its default) and none"},
    {"solver",
     "constraint solver",
     &BulletSettings::solver,
     {"sequential-impulse", "nncg", "dantzig"},
     {"sequential-impulse", "dantzig"},
     "constraint solver; multibody offers sequential-impulse and dantzig"},
};

// ---- Options that only others make of use -------------------------------------------------------------

struct Need {
  const char* option;
  bool (*met)(const BulletSettings&);
  const char* what;
};
constexpr Need needs[] = {
    {"speculative-restitution", [](const BulletSettings& s) { return s.on("ccd"); }, "ccd"},
    {"max-gyroscopic-force", [](const BulletSettings& s) { return s.gyroscopic == "explicit"; },
     "gyro=explicit"},
    {"split-threshold", [](const BulletSettings& s) { return s.on("split-impulse"); }, "split-impulse=on"},
};

// ---- A path on a scene ----------------------------------------------------------------------------

// What is set, by the name of its option, and why; in the order in which it was first set.
class Chosen {
 public:
  void note(const std::string& option, std::string reason) {
    const auto at = std::ranges::find(all_, option, &std::pair<std::string, std::string>::first);
    if (at == all_.end())
      all_.emplace_back(option, std::move(reason));
    else
      at->second = std::move(reason);
  }
  const std::vector<std::pair<std::string, std::string>>& all() const { return all_; }

 private:
  std::vector<std::pair<std::string, std::string>> all_;
};

void set(BulletSettings& settings, const std::string& option, const std::string& value) {
  if (option == "integrator") {
    settings.runge_kutta = value == runge_kutta;
    return;
  }
  for (const Word& word : words)
    if (option == word.option) {
      settings.*word.value = value;
      return;
    }
  settings.number[option] = parse(knob(option), value);
}

// What every path does, as shipped or not.
std::vector<core::Setting> of_the_scene() {
  return {
      {"stepSimulation", "(dt, 0)", "(dt, 1, 1/60)", "exactly one step of dt, for every dt"},
      {"combined restitution and friction", "of the pair", "product of the bodies'",
       "the scene gives the values of the pair"},
      {applied::applied_forces, applied::as_applied, "none", applied::why_applied},
  };
}

core::Setting setting(const BulletSettings& settings, const std::string& option, const std::string& reason) {
  if (option == "integrator")
    return {"useRK4Integration", settings.runge_kutta ? "on" : "off", "off", reason};
  for (const Word& word : words)
    if (option == word.option)
      return {word.setting, settings.*word.value, word.values(settings.multibody).front(), reason};
  const Knob& k = knob(option);
  return {k.setting, text(k, settings.number.at(option)), text(k, k.engine_default), reason};
}

core::Setting no_limit_of_loops() {
  return {"setMaxAppliedImpulse of joints that close a loop, and of stops", "no limit", "100 N s",
          "a joint must hold whatever pulls at it"};
}

core::Setting bias_of_hinges() {
  return {"bias factor of a hinge's own stops", "1", "0.3", "it multiplies the rate after the stop"};
}

// Bullet's own values, for bodies of one sort.
BulletSettings own(bool multibody) {
  BulletSettings settings;
  settings.multibody = multibody;
  for (const Word& word : words) settings.*word.value = word.values(multibody).front();
  for (const Knob& k : knobs()) settings.number[k.option] = k.engine_default;
  return settings;
}

// All rules of a path, each with where it holds.
core::Path path(const char* name, std::string summary, std::vector<std::string> limits) {
  core::Path result{name, std::move(summary), of_the_scene(), std::move(limits)};
  for (const BulletRule& rule : bullet_rules()) {
    if (!rule.of(name)) continue;
    BulletSettings settings = own(std::string_view(name) == "multibody");
    set(settings, rule.option, rule.value);
    const std::string where = *rule.where ? fmt::format("{}: ", rule.where) : "";
    result.settings.push_back(setting(settings, rule.option, where + rule.reason));
  }
  if (std::string_view(name) == "multibody") {
    result.settings.push_back(no_limit_of_loops());
  } else if (std::string_view(name) == "as-shipped") {
    result.settings.push_back(bias_of_hinges());
  }
  return result;
}

std::vector<std::string> limits_of_both() {
  std::vector<std::string> limits = unforceable_rigid();
  for (const std::string& one : unforceable_multibody())
    if (std::ranges::find(limits, one) == limits.end()) limits.push_back(one);
  return limits;
}

// Why bodies of this sort have not what the run asks for, or nothing.
std::optional<std::string> missing(const BulletSettings& settings, const core::Setup& setup) {
  const char* const sort = settings.multibody ? "btMultiBody" : "btRigidBody";
  const char* const other = settings.multibody ? "btRigidBody" : "btMultiBody";
  for (const auto& [option, value] : setup.options) {
    for (const Word& word : words) {
      const std::vector<std::string>& values = word.values(settings.multibody);
      if (option == word.option && std::ranges::find(values, value) == values.end())
        return fmt::format("no {} '{}' on path {}: {} has {}", option, value, settings.path, sort,
                           fmt::join(values, ", "));
    }
    const auto k = std::ranges::find(knobs(), option, &Knob::option);
    if (k != knobs().end() && k->of != KnobOf::every_path &&
        (k->of == KnobOf::multibody) != settings.multibody)
      return fmt::format("option {} belongs to {}, and path {} has {} here", option, other, settings.path,
                         sort);
  }
  for (const Need& need : needs)
    if (setup.options.contains(need.option) && !need.met(settings))
      return fmt::format("option {} does nothing without {}", need.option, need.what);
  return std::nullopt;
}

// Why the integrator that is asked for is not the path's, or nothing.
std::optional<std::string> other_integrator(const BulletSettings& settings, const std::string& asked) {
  if (asked.empty() || (asked == runge_kutta) == settings.runge_kutta) return std::nullopt;
  if (settings.path == "as-expert")
    return fmt::format("The rule of path as-expert takes {} here.",
                       settings.runge_kutta ? runge_kutta : semi_implicit_euler);
  return "btRigidBody has semi-implicit Euler alone; path multibody has runge-kutta-4.";
}

}  // namespace

BulletStops BulletSettings::stops() const {
  const double erp = number.at("stop-erp");
  return {on("stops-ahead"), std::isnan(erp) ? std::nullopt : std::optional(erp)};
}

core::Engine bullet_engine(std::string version, std::string precision) {
  core::Engine engine;
  engine.name = "bullet";
  engine.version = std::move(version);
  engine.precision = std::move(precision);
  engine.paths = {
      path("rigid", "btRigidBody, contacts as Bullet sets them", unforceable_rigid()),
      path("rigid-bounce", "btRigidBody, contacts set so that a bounce keeps its energy",
           unforceable_rigid()),
      path("multibody", "btMultiBody: a tree for each set of bodies that joints connect",
           unforceable_multibody()),
      path("as-shipped", "btRigidBody, and every setting as Bullet has it by itself", unforceable_rigid()),
      path("as-expert", fmt::format("one rule for all scenes: {}", expert_multibody), limits_of_both()),
  };
  engine.default_path_rule = "any restitution > 0 between a touching pair: rigid-bounce, else rigid";
  engine.integrators = {
      {semi_implicit_euler, 1, "linear momentum; symplectic without rotation and contact"},
      {runge_kutta, 4,
       "nothing in particular; only btMultiBody has it; order 2 with ball joints; order 1 with contacts, "
       "loops, "
       "applied forces or a free base that turns"},
  };
  engine.knows = {"collision_filters",  "frame_acceleration", "body_gravity",     "slider_joints",
                  "cylindrical_joints", "planar_joints",      "universal_joints", "gimbal_joints",
                  "rectangular_joints", "joint_forces",       "joint_targets",    "joint_limits",
                  "joint_friction"};
  for (const Word& word : words)
    engine.options.push_back({word.option, word.of_rigid, word.of_rigid.front(), word.meaning});
  for (const Knob& k : knobs())
    engine.options.push_back({k.option, k.kind == KnobKind::flag ? off_on : std::vector<std::string>(),
                              text(k, k.engine_default), fmt::format("{}: {}", k.setting, k.meaning)});
  return engine;
}

BulletSettings bullet_settings(const core::Engine& engine, const core::Setup& setup, const BulletKind& kind) {
  if (!setup.path.empty()) require("path", setup.path, names(engine.paths));
  if (!setup.integrator.empty()) require("integrator", setup.integrator, names(engine.integrators));

  const bool by_rule = setup.path.empty();
  const std::string path = by_rule ? (kind.bounces ? "rigid-bounce" : "rigid") : setup.path;
  const bool by_expert = path == "as-expert";
  BulletSettings settings = own(path == "multibody" || (by_expert && expert_takes_multibody(kind)));
  settings.path = path;

  Chosen chosen;
  for (const BulletRule& rule : bullet_rules())
    if (rule.of(path) && rule.applies(kind)) {
      set(settings, rule.option, rule.value);
      chosen.note(rule.option, rule.reason);
    }
  if (path == "multibody" && setup.integrator == runge_kutta) {
    settings.runge_kutta = true;
    chosen.note("integrator", asked_for);
  }
  for (const auto& [option, value] : setup.options) {
    require("option", option, names(engine.options));
    for (const Word& word : words)
      if (option == word.option) require(option, value, word.of_rigid);
    set(settings, option, value);
    chosen.note(option, asked_for);
  }

  settings.refused = missing(settings, setup);
  if (settings.refused && !by_expert)
    throw std::invalid_argument(fmt::format("bullet: {}", *settings.refused));
  if (!settings.refused) settings.refused = other_integrator(settings, setup.integrator);

  settings.terms.path = path;
  settings.terms.integrator = settings.runge_kutta ? runge_kutta : semi_implicit_euler;
  settings.terms.order = settings.runge_kutta ? kind.rk4_order : 1;
  settings.terms.gyroscopic = settings.gyroscopic;
  settings.terms.settings = of_the_scene();
  for (const auto& [option, reason] : chosen.all()) {
    const auto need = std::ranges::find(needs, option, &Need::option);
    if (need != std::end(needs) && !need->met(settings)) continue;  // a rule's, in force with another option
    core::Setting one = setting(settings, option, reason);
    if (option == "ccd" && !kind.swept) {
      if (reason != asked_for) continue;
      one.value = "none", one.reason = "asked for by the run, but no body here has a shape that is swept";
    }
    settings.terms.settings.push_back(one);
  }
  if (settings.multibody && (kind.loops || kind.stops))
    settings.terms.settings.push_back(no_limit_of_loops());
  if (!settings.multibody && kind.stops && !settings.on("stops-ahead"))
    settings.terms.settings.push_back(bias_of_hinges());
  settings.terms.unforceable = settings.multibody ? unforceable_multibody() : unforceable_rigid();
  return settings;
}

}  // namespace cylon::simulators
