#include "reference/simulators/ode/ode_options.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <system_error>

namespace cylon::simulators {
namespace {

using Run = OdeSettings;
constexpr double largest = std::numeric_limits<double>::max();

const OdeOption options[] = {
    {.name = "gyro",
     .words = {"on", "off"},
     .engine_default = "on",
     .meaning = "the implicit gyroscopic torque",
     .set = [](Run& run, double i) { run.gyro = i == 0; }},
    {.name = "rotation",
     .words = {"finite", "infinitesimal"},
     .engine_default = "infinitesimal",
     .meaning = "how far w turns a body within dt",
     .set = [](Run& run, double i) { run.finite_rotation = i == 0; }},
    {.name = "erp",
     .engine_default = "0.2",
     .meaning = "share of a constraint's error corrected per step, in [0, 1]",
     .set = [](Run& run, double x) { run.erp = x; },
     .least = 0,
     .most = 1},
    {.name = "cfm",
     .engine_default = "1e-10",
     .meaning = "softness of a constraint [s/kg]",
     .set = [](Run& run, double x) { run.cfm = x; },
     .least = 0,
     .most = largest},
    {.name = "contacts",
     .engine_default = "none",
     .meaning = "contacts per pair of shapes, from 1 to 8",
     .set = [](Run& run, double x) { run.contacts = static_cast<int>(x); },
     .least = 1,
     .most = ode_most_contacts,
     .whole = true},
    {.name = "iterations",
     .engine_default = "20",
     .meaning = "sweeps per step, of dWorldQuickStep",
     .set = [](Run& run, double x) { run.iterations = static_cast<int>(x); },
     .least = 1,
     .most = 1e9,
     .whole = true,
     .of_quick = true},
    {.name = "stepper",
     .words = {"step", "quick"},
     .engine_default = "none",
     .meaning = "dWorldStep or dWorldQuickStep",
     .set = [](Run& run, double i) { run.quick = i == 1; }},
    {.name = "over-relaxation",
     .engine_default = "1.3",
     .meaning = "of dWorldQuickStep's sweeps, in (0, 2)",
     .set = [](Run& run, double x) { run.over_relaxation = x; },
     .least = 0,
     .most = 2,
     .open = true,
     .of_quick = true},
    {.name = "friction",
     .words = {"coefficient", "force"},
     .engine_default = "force",
     .meaning = "what mu is: of the normal force (dContactApprox1), or the largest force itself",
     .set = [](Run& run, double i) { run.coulomb = i == 0; }},
    {.name = "friction-direction",
     .words = {"engine", "slip"},
     .engine_default = "engine",
     .meaning = "first direction of a contact's friction pyramid: ODE's, or that of the slip (dContactFDir1)",
     .set = [](Run& run, double i) { run.along_slip = i == 1; }},
    {.name = "bounce-velocity",
     .engine_default = "none",
     .meaning = "approach speed up to which nothing bounces [m/s]",
     .set = [](Run& run, double x) { run.bounce_velocity = x; },
     .least = 0,
     .most = largest},
    {.name = "contact-cfm",
     .engine_default = "cfm",
     .meaning = "softness of contacts alone (dContactSoftCFM) [s/kg]",
     .set = [](Run& run, double x) { run.contact_cfm = x; },
     .least = 0,
     .most = largest},
    {.name = "contact-erp",
     .engine_default = "erp",
     .meaning = "ERP of contacts alone (dContactSoftERP), in [0, 1]",
     .set = [](Run& run, double x) { run.contact_erp = x; },
     .least = 0,
     .most = 1},
    {.name = "stop-erp",
     .engine_default = "erp",
     .meaning = "ERP of the stops of joints (dParamStopERP), in [0, 1]",
     .set = [](Run& run, double x) { run.stop_erp = x; },
     .least = 0,
     .most = 1},
    {.name = "surface-layer",
     .engine_default = "0",
     .meaning = "depth up to which contacts are left alone [m]",
     .set = [](Run& run, double x) { run.surface_layer = x; },
     .least = 0,
     .most = largest},
    {.name = "springs",
     .words = {"force", "stiff", "joint"},
     .engine_default = "none",
     .meaning = "springs as explicit forces, or as soft joints (implicit) where dt^2 k + dt c > m, or all",
     .set = [](Run& run, double i) { run.stiff_springs = i == 1, run.all_springs = i == 2; }},
};

double number(const OdeOption& option, const std::string& given) {
  double x = 0;
  const char* const end = given.data() + given.size();
  const auto [stop, error] = std::from_chars(given.data(), end, x);
  const bool inside =
      option.open ? x > option.least && x < option.most : x >= option.least && x <= option.most;
  if (error == std::errc() && stop == end && inside && (!option.whole || x == std::floor(x))) return x;
  const std::string range = option.most == largest
                                ? fmt::format("from {} on", option.least)
                                : fmt::format("in {}{}, {}{}", option.open ? '(' : '[', option.least,
                                              option.most, option.open ? ')' : ']');
  throw std::invalid_argument(fmt::format("ode: option {} = '{}' is not a {}number {}", option.name, given,
                                          option.whole ? "whole " : "finite ", range));
}

}  // namespace

std::span<const OdeOption> ode_options() { return options; }

void ode_require(const std::string& kind, const std::string& word, const std::vector<std::string>& valid) {
  if (std::ranges::find(valid, word) != valid.end()) return;
  throw std::invalid_argument(fmt::format("ode: no {} '{}'{} (valid: {})", kind, word,
                                          core::did_you_mean(word, valid), fmt::join(valid, ", ")));
}

void ode_set(OdeSettings& run, const std::string& option, const std::string& given) {
  const auto found = std::ranges::find(options, std::string_view(option),
                                       [](const OdeOption& one) { return std::string_view(one.name); });
  if (found == std::end(options)) {
    std::vector<std::string> names;
    for (const OdeOption& one : options) names.emplace_back(one.name);
    ode_require("option", option, names);
    return;
  }
  if (found->words.empty()) {
    found->set(run, number(*found, given));
    return;
  }
  ode_require("value of option " + option, given, found->words);
  found->set(run, static_cast<double>(std::ranges::find(found->words, given) - found->words.begin()));
}

}  // namespace cylon::simulators
