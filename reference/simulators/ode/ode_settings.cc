#include "reference/simulators/ode/ode_settings.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <stdexcept>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

namespace cylon::simulators {
namespace {

using core::Setting;

constexpr const char* integrator_name = "semi-implicit-euler";

std::string text(double x) { return fmt::format("{}", x); }

std::string contact_mode(const OdeSettings& run) {
  std::string mode = run.coulomb ? "dContactApprox1 | dContactBounce" : "dContactBounce";
  if (run.contact_cfm >= 0) mode += " | dContactSoftCFM";
  if (run.contact_erp >= 0) mode += " | dContactSoftERP";
  if (run.along_slip) mode += " | dContactFDir1";
  return mode;
}

// What every run sets.
std::vector<Setting> table(const OdeSettings& run) {
  const std::string caller = "none: set by the caller";
  std::vector<Setting> settings = {
      {"solver", run.quick ? "dWorldQuickStep" : "dWorldStep", caller, "the path"},
      {"rotation", run.finite_rotation ? "finite" : "infinitesimal", "infinitesimal",
       "finite rotates a body by |w| dt; infinitesimal by 2 atan(|w| dt/2)"},
      {"gyro", run.gyro ? "on" : "off", "on",
       "without w x L the motion is wrong although its energy is conserved"},
      {"erp", text(run.erp), "0.2", "set before joints are created, because they copy it"},
      {"cfm", text(run.cfm), "1e-10", "set before joints are created, because they copy it"},
      {"auto_disable", "off", "off", "bodies must not be put to sleep"},
      {"damping", "0", "0", "only the drag of the scene may remove energy"},
      {"contact_mode", contact_mode(run), caller,
       "without Approx1 the friction coefficient is a force limit; without Bounce nothing bounces"},
      {"mu, bounce", "the pair's", caller, "ODE reads both for each contact: the values of the scene"},
      {"bounce_vel", text(run.bounce_velocity), caller,
       "no approach speed below which restitution is dropped"},
      {"contact_surface_layer", text(run.surface_layer), "0", "contacts rest without penetration"},
      {"contact_max_correcting_vel", "inf", "inf", "the default of the engine"},
      {"contacts", text(run.contacts), caller, "two box faces share at most eight contact points"},
      {"broad_phase", "dHashSpace", caller, "the default of the engine for many bodies"},
      {"threading", "self-threaded, one per world", "one shared by all worlds",
       "two worlds with shared threading abort the process if two threads step them"},
  };
  if (run.contact_cfm >= 0)
    settings.push_back({"soft_cfm", text(run.contact_cfm), caller, "of the callback that ODE's demo shows"});
  if (run.contact_erp >= 0)
    settings.push_back({"soft_erp", text(run.contact_erp), caller, "of contacts alone"});
  if (run.all_springs || run.stiff_springs)
    settings.push_back({"springs", run.all_springs ? "joint" : "joint where stiff", caller,
                        "a joint of ERP dt k/(dt k + c) and CFM 1/(dt k + c) is an implicit spring"});
  if (run.quick) {
    settings.push_back({"iterations", text(run.iterations), "20", "the default of the engine"});
    settings.push_back({"over_relaxation", text(run.over_relaxation), "1.3", "the default of the engine"});
    settings.push_back({"random_seed", "0 at load", "goes on from the last world",
                        "rows are shuffled at random; the same seed gives the same bits in a repeated run"});
  }
  return settings;
}

// What ODE does all the same; in brackets the place in the sources of Debian's version, below ode/src/.
std::vector<std::string> unforceable(bool quick) {
  std::vector<std::string> sentences = {
      "Friction is a pyramid: two directions, each with its own bound; the caller may choose the first for "
      "each "
      "contact (joints/contact.cpp:220).",
      "The gyroscopic term is implicit and loses energy; it can be switched off, but there is no exact form "
      "(step.cpp:642, quickstep.cpp:1194).",
      "Contacts are detected at the start of a step, so an impact acts up to one step late: dSpaceCollide "
      "and "
      "dCollide see one instant (collision_space.cpp:779).",
      "Restitution uses the approach speed before the forces of the step act (joints/contact.cpp:188).",
      "There is no continuous collision detection: a fast body can pass through another within one step; a "
      "caller "
      "may cast rays of its own (ray.cpp).",
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

// The callback of ODE's demo (demo/demo_boxstack.cpp:131), with the mu and bounce of the pair.
OdeSettings as_shipped() {
  OdeSettings run;
  run.path = "as-shipped";
  run.finite_rotation = false;
  run.coulomb = false;
  run.bounce_velocity = 0.1;
  run.contact_cfm = 0.01;
  return run;
}

// ---- As an expert sets it: one rule, a function of the scene's kind -----------------------------

constexpr const char* expert_rule =
    "friction along the slip; springs with dt^2 k + dt c > m are soft joints; where moving bodies may touch, "
    "nothing "
    "bounces and masses are within a factor of 1000, dWorldQuickStep with 100 sweeps; else dWorldStep; where "
    "a pair "
    "bounces, contact ERP 0; where nothing bounces and only single bodies touch the ground, a surface layer "
    "of 0.1 mm";

constexpr double wide_mass_ratio = 1000;

OdeSettings as_expert(const OdeKind& kind) {
  OdeSettings run;
  run.path = "as-expert";
  run.along_slip = true;
  run.stiff_springs = true;
  run.quick = kind.piles && !kind.bounces && kind.mass_ratio < wide_mass_ratio;
  run.iterations = 100;
  if (kind.bounces) run.contact_erp = 0;  // ODE bounces with the larger of e v and ERP depth/dt
  if (!kind.bounces && !kind.piles) run.surface_layer = 1e-4;  // contacts at rest stay contacts
  return run;
}

OdeSettings of_path(const std::string& name, const OdeKind& kind) {
  if (name == "as-shipped") return as_shipped();
  if (name == "as-expert") return as_expert(kind);
  OdeSettings run;
  run.path = name;
  run.quick = name == "quick";
  return run;
}

core::Path path(const std::string& name, std::string summary) {
  const OdeSettings run = of_path(name, {});
  return {name, std::move(summary), table(run), unforceable(run.quick)};
}

template <class Named>
std::vector<std::string> names(const std::vector<Named>& all) {
  std::vector<std::string> result;
  result.reserve(all.size());
  for (const Named& one : all) result.push_back(one.name);
  return result;
}

// The place of a word among the valid ones; "" is the first.
std::size_t choice(const std::string& kind, const std::string& word, const std::vector<std::string>& valid) {
  if (word.empty()) return 0;
  const auto found = std::ranges::find(valid, word);
  if (found == valid.end())
    throw std::invalid_argument(
        fmt::format("ode: unknown {} '{}'{}", kind, word, core::did_you_mean(word, valid)));
  return static_cast<std::size_t>(found - valid.begin());
}

template <class Number>
Number number(const std::string& option, const std::string& given, Number least, Number most) {
  Number x = 0;
  const char* const end = given.data() + given.size();
  const auto [stop, error] = std::from_chars(given.data(), end, x);
  if (error != std::errc() || stop != end || !(x >= least && x <= most))
    throw std::invalid_argument(fmt::format("ode: option {} = '{}' is not {} in [{}, {}]", option, given,
                                            std::is_integral_v<Number> ? "a whole number" : "a number", least,
                                            most));
  return x;
}

}  // namespace

core::Engine ode_engine(std::string version) {
  return {"ode",
          std::move(version),
          "double",
          {path("step", "Dantzig's direct solver, intended for joints and few contacts"),
           path("quick", "projected successive over-relaxation, intended for piles"),
           path("as-shipped", "every setting as ODE has it by itself, and the contact callback of its demo"),
           path("as-expert", fmt::format("one rule for all scenes: {}", expert_rule))},
          "always 'step'",
          {{integrator_name, 1, "linear momentum"}},
          {{"gyro", {"on", "off"}, "on", "the implicit gyroscopic torque"},
           {"rotation", {"finite", "infinitesimal"}, "infinitesimal", "how far w turns a body within dt"},
           {"erp", {}, "0.2", "share of a constraint's error corrected per step, in [0, 1]"},
           {"cfm", {}, "1e-10", "softness of a constraint [s/kg]"},
           {"contacts", {}, "none", "contacts per pair of shapes, from 1 to 8"},
           {"iterations", {}, "20", "sweeps per step, of path 'quick'"},
           {"stepper", {"step", "quick"}, "none", "dWorldStep or dWorldQuickStep"},
           {"over-relaxation", {}, "1.3", "of QuickStep's sweeps, in (0, 2)"},
           {"friction",
            {"coefficient", "force"},
            "force",
            "what mu is: of the normal force (dContactApprox1), or the largest force itself"},
           {"friction-direction",
            {"engine", "slip"},
            "engine",
            "first direction of a contact's friction pyramid: ODE's, or that of the slip (dContactFDir1)"},
           {"bounce-velocity", {}, "none", "approach speed up to which nothing bounces [m/s]"},
           {"contact-cfm", {}, "cfm", "softness of contacts alone (dContactSoftCFM) [s/kg]"},
           {"contact-erp", {}, "erp", "ERP of contacts alone (dContactSoftERP), in [0, 1]"},
           {"surface-layer", {}, "0", "depth up to which contacts are left alone [m]"},
           {"springs",
            {"force", "stiff", "joint"},
            "none",
            "springs as explicit forces, or as soft joints (implicit) where dt^2 k + dt c > m, or all"}}};
}

OdeSettings ode_settings(const core::Engine& engine, const core::Setup& setup, const OdeKind& kind) {
  constexpr double most = std::numeric_limits<double>::max();
  OdeSettings run = of_path(engine.paths[choice("path", setup.path, names(engine.paths))].name, kind);
  choice("integrator", setup.integrator, names(engine.integrators));
  for (const auto& [name, value] : setup.options) {
    const core::Option& option = engine.options[choice("option", name, names(engine.options))];
    const std::size_t word =
        option.values.empty() ? 0 : choice("value of option " + name, value, option.values);
    const bool first = word == 0;
    if (option.name == "gyro") run.gyro = first;
    if (option.name == "rotation") run.finite_rotation = first;
    if (option.name == "erp") run.erp = number(name, value, 0.0, 1.0);
    if (option.name == "cfm") run.cfm = number(name, value, 0.0, most);
    if (option.name == "contacts") run.contacts = number(name, value, 1, ode_most_contacts);
    if (option.name == "stepper") run.quick = !first;
    if (option.name == "friction") run.coulomb = first;
    if (option.name == "friction-direction") run.along_slip = !first;
    if (option.name == "bounce-velocity") run.bounce_velocity = number(name, value, 0.0, most);
    if (option.name == "contact-cfm") run.contact_cfm = number(name, value, 0.0, most);
    if (option.name == "contact-erp") run.contact_erp = number(name, value, 0.0, 1.0);
    if (option.name == "surface-layer") run.surface_layer = number(name, value, 0.0, most);
    if (option.name == "springs") run.stiff_springs = word == 1, run.all_springs = word == 2;
    if (option.name == "iterations") run.iterations = number(name, value, 1, 1000000000);
    if (option.name == "over-relaxation") run.over_relaxation = number(name, value, 0.0, 2.0);
  }
  for (const char* const of_quick : {"iterations", "over-relaxation"})
    if (setup.options.contains(of_quick) && !run.quick)
      throw std::invalid_argument(fmt::format("ode: option {} belongs to path 'quick'", of_quick));
  return run;
}

core::Terms ode_terms(const OdeSettings& run) {
  return {run.path, integrator_name, 1, run.gyro ? "implicit" : "none", table(run), unforceable(run.quick)};
}

}  // namespace cylon::simulators
