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
      {"contact_mode", "dContactApprox1 | dContactBounce", caller,
       "without Approx1 the friction coefficient is a force limit; without Bounce nothing bounces"},
      {"mu, bounce", "the pair's", caller, "ODE reads both for each contact: the values of the scene"},
      {"bounce_vel", "0", caller, "no approach speed below which restitution is dropped"},
      {"contact_surface_layer", "0", "0", "contacts rest without penetration"},
      {"contact_max_correcting_vel", "inf", "inf", "the default of the engine"},
      {"contacts", text(run.contacts), caller, "two box faces share at most eight contact points"},
      {"broad_phase", "dHashSpace", caller, "the default of the engine for many bodies"},
      {"threading", "self-threaded, one per world", "one shared by all worlds",
       "two worlds with shared threading abort the process if two threads step them"},
  };
  if (run.quick) {
    settings.push_back({"iterations", text(run.iterations), "20", "the default of the engine"});
    settings.push_back({"over_relaxation", text(ode_over_relaxation), "1.3", "the default of the engine"});
    settings.push_back({"random_seed", "0 at load", "goes on from the last world",
                        "rows are shuffled at random; the same seed gives the same bits in a repeated run"});
  }
  return settings;
}

std::vector<std::string> unforceable(bool quick) {
  std::vector<std::string> sentences = {
      "Friction is a pyramid along two tangents that ODE chooses, not a Coulomb cone.",
      "The gyroscopic term is implicit and loses energy; it can be switched off, but there is no exact form.",
      "Contacts are detected at the start of a step, so an impact acts up to one step late.",
      "Restitution uses the approach speed before the forces of the step act.",
      "There is no continuous collision detection: a fast body can pass through another within one step.",
      "Impacts at one instant are solved as one complementarity problem, whatever order the scene requests.",
  };
  if (quick) {
    sentences.emplace_back("QuickStep stops after a fixed number of iterations, whatever the residual.");
    sentences.emplace_back(
        "All worlds of a process share one random sequence, so worlds that are stepped in turn affect each "
        "other.");
  } else {
    sentences.emplace_back(
        "Dantzig's solver fails on redundant or exactly touching contacts ('LCP internal error, s <= 0') and "
        "drops their impulses.");
  }
  return sentences;
}

core::Path path(bool quick) {
  OdeSettings run;
  run.quick = quick;
  return {quick ? "quick" : "step",
          quick ? "projected successive over-relaxation, intended for piles"
                : "Dantzig's direct solver, intended for joints and few contacts",
          table(run), unforceable(quick)};
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
          {path(false), path(true)},
          "always 'step'",
          {{integrator_name, 1, "linear momentum"}},
          {{"gyro", {"on", "off"}, "on", "the implicit gyroscopic torque"},
           {"rotation", {"finite", "infinitesimal"}, "infinitesimal", "how far w turns a body within dt"},
           {"erp", {}, "0.2", "share of a constraint's error corrected per step, in [0, 1]"},
           {"cfm", {}, "1e-10", "softness of a constraint [s/kg]"},
           {"contacts", {}, "none", "contacts per pair of shapes, from 1 to 8"},
           {"iterations", {}, "20", "sweeps per step, of path 'quick'"}}};
}

OdeSettings ode_settings(const core::Engine& engine, const core::Setup& setup) {
  OdeSettings run;
  run.quick = engine.paths[choice("path", setup.path, names(engine.paths))].name == "quick";
  choice("integrator", setup.integrator, names(engine.integrators));
  for (const auto& [name, value] : setup.options) {
    const core::Option& option = engine.options[choice("option", name, names(engine.options))];
    const bool first = option.values.empty() || choice("value of option " + name, value, option.values) == 0;
    if (option.name == "gyro") run.gyro = first;
    if (option.name == "rotation") run.finite_rotation = first;
    if (option.name == "erp") run.erp = number(name, value, 0.0, 1.0);
    if (option.name == "cfm") run.cfm = number(name, value, 0.0, std::numeric_limits<double>::max());
    if (option.name == "contacts") run.contacts = number(name, value, 1, ode_most_contacts);
    if (option.name == "iterations") {
      if (!run.quick) throw std::invalid_argument("ode: option iterations belongs to path 'quick'");
      run.iterations = number(name, value, 1, 1000000000);
    }
  }
  return run;
}

core::Terms ode_terms(const OdeSettings& run) {
  const core::Path row = path(run.quick);
  return {row.name, integrator_name, 1, run.gyro ? "implicit" : "none", table(run), row.unforceable};
}

}  // namespace cylon::simulators
