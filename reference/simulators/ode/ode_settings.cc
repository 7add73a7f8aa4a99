#include "reference/simulators/ode/ode_settings.h"

#include "reference/applied/forces.h"
#include "reference/simulators/ode/ode_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

namespace cylon::simulators {
namespace {

using core::Setting;

constexpr const char* integrator_name = "semi-implicit-euler";
constexpr const char* caller = "none: set by the caller";

std::string text(double x) { return fmt::format("{}", x); }

std::string contact_mode(const OdeSettings& run) {
  std::string mode = run.coulomb ? "dContactApprox1 | dContactBounce" : "dContactBounce";
  if (run.contact_cfm) mode += " | dContactSoftCFM";
  if (run.contact_erp) mode += " | dContactSoftERP";
  if (run.along_slip) mode += " | dContactFDir1";
  return mode;
}

// ---- The table of a run ---------------------------------------------------------------------------

// A setting that is listed, the options that change it, and what it does whatever its value.
struct Row {
  std::vector<std::string_view> options;
  const char* name;
  std::string value, engine_default;
  const char* meaning;
};

std::vector<Row> rows(const OdeSettings& run) {
  std::vector<Row> all = {
      {{"stepper"},
       "solver",
       run.quick ? "dWorldQuickStep" : "dWorldStep",
       caller,
       "dWorldStep solves directly, dWorldQuickStep by sweeps"},
      {{"rotation"},
       "rotation",
       run.finite_rotation ? "finite" : "infinitesimal",
       "infinitesimal",
       "finite rotates a body by |w| dt; infinitesimal by 2 atan(|w| dt/2)"},
      {{"gyro"},
       "gyro",
       run.gyro ? "on" : "off",
       "on",
       "without w x L the motion is wrong although its energy is conserved"},
      {{"erp"}, "erp", text(run.erp), "0.2", "set before joints are created, because they copy it"},
      {{"cfm"}, "cfm", text(run.cfm), "1e-10", "set before joints are created, because they copy it"},
      {{}, "auto_disable", "off", "off", "bodies must not be put to sleep"},
      {{}, "damping", "0", "0", "only the drag of the scene may remove energy"},
      {{"friction", "friction-direction"},
       "contact_mode",
       contact_mode(run),
       caller,
       "Bounce: the pair's restitution; Approx1: mu is a coefficient, else a force"},
      {{}, "mu, bounce", "the pair's", caller, "ODE reads both for each contact: the values of the scene"},
      {{"bounce-velocity"},
       "bounce_vel",
       text(run.bounce_velocity),
       caller,
       "approach speed up to which nothing bounces"},
      {{"surface-layer"},
       "contact_surface_layer",
       text(run.surface_layer),
       "0",
       "depth up to which contacts are left alone"},
      {{}, "contact_max_correcting_vel", "inf", "inf", "the default of the engine"},
      {{"contacts"},
       "contacts",
       text(run.contacts),
       caller,
       "two box faces share at most eight contact points"},
      {{}, applied::applied_forces, applied::as_applied, caller, applied::why_applied},
      {{}, "broad_phase", "dHashSpace", caller, "one space for all shapes"},
      {{},
       "threading",
       "self-threaded, one per world",
       "one shared by all worlds",
       "two worlds with shared threading abort the process if two threads step them"},
  };
  if (run.contact_cfm)
    all.push_back({{"contact-cfm"}, "soft_cfm", text(*run.contact_cfm), "cfm", "softness of contacts alone"});
  if (run.contact_erp)
    all.push_back({{"contact-erp"}, "soft_erp", text(*run.contact_erp), "erp", "ERP of contacts alone"});
  if (run.stop_erp)
    all.push_back(
        {{"stop-erp"}, "stop_erp", text(*run.stop_erp), "erp", "ERP of the stops of joints (dParamStopERP)"});
  if (run.all_springs || run.stiff_springs)
    all.push_back({{"springs"},
                   "springs",
                   run.all_springs ? "joint" : "joint where stiff",
                   caller,
                   "a joint of ERP dt k/(dt k + c) and CFM 1/(dt k + c) is an implicit spring"});
  if (run.quick) {
    all.push_back({{"iterations"}, "iterations", text(run.iterations), "20", "sweeps per step"});
    all.push_back(
        {{"over-relaxation"}, "over_relaxation", text(run.over_relaxation), "1.3", "of the sweeps"});
    all.push_back({{},
                   "random_seed",
                   "0 at load",
                   "goes on from the last world",
                   "rows are shuffled at random; the same seed gives the same bits in a repeated run"});
  }
  return all;
}

// A path or a run that sets an option has its reason; else the row says what the setting does.
std::vector<Setting> table(const OdeSettings& run) {
  std::vector<Setting> settings;
  for (const Row& row : rows(run)) {
    std::string why;
    for (const std::string_view option : row.options)
      if (const auto reason = run.reasons.find(std::string(option)); reason != run.reasons.end())
        why += (why.empty() ? "" : "; ") + reason->second;
    settings.push_back({row.name, row.value, row.engine_default, why.empty() ? row.meaning : why});
  }
  return settings;
}

// What ODE does all the same; in brackets the place in the sources of Debian's version, below ode/src/.
std::vector<std::string> unforceable(bool quick) {
  std::vector<std::string> sentences = {
      "Friction is a pyramid: two directions, each with its own bound; the caller may choose the first for "
      "each contact (joints/contact.cpp:220).",
      "The gyroscopic term is implicit and loses energy; it can be switched off, but there is no exact form "
      "(step.cpp:642, quickstep.cpp:1194).",
      "Contacts are detected at the start of a step, so an impact acts up to one step late: dSpaceCollide "
      "and dCollide see one instant (collision_space.cpp:779).",
      "Restitution uses the approach speed before the forces of the step act (joints/contact.cpp:188).",
      "There is no continuous collision detection: a fast body can pass through another within one step; a "
      "caller may cast rays of its own (ray.cpp).",
      "Impacts at one instant are solved as one complementarity problem, whatever order the scene requests "
      "(lcp.cpp:1067, quickstep.cpp:1772).",
      "Motion is semi-implicit Euler; there is no other integrator (util.cpp:583).",
  };
  if (quick) {
    sentences.emplace_back(
        "QuickStep stops after a fixed number of iterations, whatever the residual (quickstep.cpp:1772).");
  } else {
    sentences.emplace_back(
        "Dantzig's solver fails on redundant or exactly touching contacts ('LCP internal error, s <= 0') and "
        "drops their impulses (lcp.cpp:1067).");
  }
  return sentences;
}

// ---- What the paths set, as a table -----------------------------------------------------------------

bool rests_in_a_stack(const OdeKind& kind) { return kind.stacked && !kind.bounces && !kind.wide(); }
// What sweeps leave of a load on a stop would else carry it on without end.
bool solves_directly(const OdeKind& kind) { return !rests_in_a_stack(kind); }
bool meets_without_bounce(const OdeKind& kind) {
  return kind.piles && !kind.stacked && !kind.bounces && !kind.wide();
}
bool bounces(const OdeKind& kind) { return kind.bounces; }
// Directions that follow the slips of many bodies break the symmetry of a scene.
bool keeps_to_the_slip(const OdeKind& kind) { return !meets_without_bounce(kind); }
bool only_on_the_ground(const OdeKind& kind) { return kind.touches && !kind.bounces && !kind.piles; }

// One setting of a path where a scene is of a kind.
struct Rule {
  const char *path, *option, *value;  // as a user gives them
  bool (*holds)(const OdeKind&);      // null: always
  const char *where, *reason;
};

constexpr const char* exact_turn = "finite rotates a body by |w| dt; infinitesimal by 2 atan(|w| dt/2)";
constexpr const char* a_coefficient = "without Approx1 the friction coefficient is a force limit";
constexpr const char* nothing_back =
    "ODE leaves a stop with the larger of e v and ERP depth/dt, which nothing takes back";
constexpr const char* stack =
    "where moving bodies touch at the start, nothing bounces and masses are within a factor of 1000";

constexpr Rule rules[] = {
    {"step", "rotation", "finite", nullptr, "", exact_turn},
    {"step", "friction", "coefficient", nullptr, "", a_coefficient},
    {"step", "stop-erp", "0", nullptr, "", nothing_back},

    {"quick", "stepper", "quick", nullptr, "", "the path"},
    {"quick", "rotation", "finite", nullptr, "", exact_turn},
    {"quick", "friction", "coefficient", nullptr, "", a_coefficient},

    {"as-expert", "rotation", "finite", nullptr, "", exact_turn},
    {"as-expert", "friction", "coefficient", nullptr, "", a_coefficient},
    {"as-expert", "stop-erp", "0", solves_directly, "except where dWorldQuickStep takes the steps, below",
     nothing_back},
    {"as-expert", "friction-direction", "slip", keeps_to_the_slip, "except where soft_cfm is 1e-05, below",
     "one side of the pyramid lies on Coulomb's cone"},
    {"as-expert", "springs", "stiff", nullptr, "", "an explicit force diverges beyond dt^2 k = 4 m"},
    {"as-expert", "stepper", "quick", rests_in_a_stack, stack,
     "Dantzig's solver fails on the redundant contacts of a stack"},
    {"as-expert", "iterations", "100", rests_in_a_stack, stack, "20 sweeps leave stacks unsolved"},
    {"as-expert", "contact-cfm", "1e-5", meets_without_bounce,
     "where moving bodies may meet and do not touch at the start, nothing bounces and masses are within a "
     "factor of 1000",
     "a little softness keeps the direct solver off singular rows"},
    {"as-expert", "contact-erp", "0", bounces, "where a pair bounces",
     "ODE bounces with the larger of e v and ERP depth/dt"},
    {"as-expert", "surface-layer", "0.0001", only_on_the_ground,
     "where nothing bounces and moving bodies touch the ground alone", "contacts at rest stay contacts"},
};

// On scenes of a kind, or, without one, what holds on all.
OdeSettings of_path(const std::string& path, const OdeKind* kind) {
  OdeSettings run;
  run.path = path;
  for (const Rule& rule : rules)
    if (rule.path == path && (!rule.holds || (kind && rule.holds(*kind)))) {
      ode_set(run, rule.option, rule.value);
      run.reasons[rule.option] = rule.reason;
    }
  return run;
}

// The table of a path: what it sets everywhere, then what it sets where.
core::Path path(const std::string& name, std::string summary) {
  const OdeSettings everywhere = of_path(name, nullptr);
  core::Path result{name, std::move(summary), table(everywhere), unforceable(everywhere.quick)};
  for (const Rule& rule : rules) {
    if (rule.path != name || !rule.holds) continue;
    OdeSettings there = everywhere;
    there.quick = there.quick || std::string_view(rule.option) == "iterations";
    ode_set(there, rule.option, rule.value);
    for (const Row& row : rows(there))
      if (std::ranges::find(row.options, rule.option) != row.options.end())
        result.settings.push_back(
            {row.name, row.value, row.engine_default, fmt::format("{}: {}", rule.where, rule.reason)});
  }
  return result;
}

template <class Named>
std::vector<std::string> names(const std::vector<Named>& all) {
  std::vector<std::string> result;
  result.reserve(all.size());
  for (const Named& one : all) result.push_back(one.name);
  return result;
}

}  // namespace

core::Engine ode_engine(std::string version) {
  core::Engine engine{
      "ode",
      std::move(version),
      "double",
      {path("step", "Dantzig's direct solver, intended for joints and few contacts"),
       path("quick", "projected successive over-relaxation, intended for piles"),
       path("as-shipped",
            "dWorldStep and every setting as ODE has it by itself; of the contact callback, "
            "which ODE leaves to its caller, the scene's friction and restitution and no "
            "other flag"),
       path("as-expert",
            "one rule for all scenes, by dWorldStep or dWorldQuickStep; its settings say where "
            "they hold")},
      "always 'step'",
      {{integrator_name, 1, "linear momentum"}},
      {},
      {"collision_filters", "frame_acceleration", "body_gravity", "slider_joints", "cylindrical_joints",
       "universal_joints", "gimbal_joints", "joint_forces", "joint_targets", "joint_limits",
       "joint_friction"}};
  for (const OdeOption& option : ode_options())
    engine.options.push_back({option.name, option.words, option.engine_default, option.meaning});
  return engine;
}

OdeSettings ode_settings(const core::Engine& engine, const core::Setup& setup, const OdeKind& kind) {
  if (!setup.path.empty()) ode_require("path", setup.path, names(engine.paths));
  if (!setup.integrator.empty()) ode_require("integrator", setup.integrator, names(engine.integrators));
  OdeSettings run = of_path(setup.path.empty() ? engine.paths.front().name : setup.path, &kind);
  for (const auto& [name, value] : setup.options) {
    ode_set(run, name, value);
    run.reasons[name] = "asked for by the run";
  }
  for (const OdeOption& option : ode_options())
    if (option.of_quick && setup.options.contains(option.name) && !run.quick)
      run.refused = fmt::format("option {} belongs to dWorldQuickStep, and path {} has dWorldStep here",
                                option.name, run.path);
  if (run.refused && run.path != "as-expert")
    throw std::invalid_argument(fmt::format("ode: {}", *run.refused));
  return run;
}

core::Terms ode_terms(const OdeSettings& run) {
  return {run.path, integrator_name, 1, run.gyro ? "implicit" : "none", table(run), unforceable(run.quick)};
}

}  // namespace cylon::simulators
