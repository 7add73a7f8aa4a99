#include "reference/simulators/mujoco/mujoco_options.h"

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

using Place = MujocoPlace;
constexpr double largest = std::numeric_limits<double>::max();
const std::vector<std::string> off_on = {"disable", "enable"};

// Defaults: mj_defaultOption, engine/engine_io.c:44, and mj_defaultSolRefImp, engine/engine_io.c:37.
const MujocoOption options[] = {
    {.name = "cone",
     .setting = "cone",
     .place = Place::option,
     .words = {"pyramidal", "elliptic"},
     .engine_default = 0,
     .meaning = "friction within a pyramid of four edges, inside Coulomb's cone, or within the cone itself"},
    {.name = "impratio",
     .setting = "impratio",
     .place = Place::option,
     .engine_default = 1,
     .meaning = "how much stiffer friction is than the normal force",
     .least = 0,
     .most = largest,
     .above = true},
    {.name = "noslip-iterations",
     .setting = "noslip_iterations",
     .place = Place::option,
     .engine_default = 0,
     .meaning = "sweeps after the solver that take the slip out of friction",
     .least = 0,
     .most = 1e6,
     .whole = true},
    {.name = "noslip-tolerance",
     .setting = "noslip_tolerance",
     .place = Place::option,
     .engine_default = 1e-6,
     .meaning = "improvement, of the cost, below which those sweeps end",
     .least = 0,
     .most = largest},
    {.name = "solver",
     .setting = "solver",
     .place = Place::option,
     .words = {"PGS", "CG", "Newton"},
     .engine_default = 2,
     .meaning = "constraint solver"},
    {.name = "iterations",
     .setting = "iterations",
     .place = Place::option,
     .engine_default = 100,
     .meaning = "of the constraint solver per step, at most",
     .least = 1,
     .most = 1e6,
     .whole = true},
    {.name = "tolerance",
     .setting = "tolerance",
     .place = Place::option,
     .engine_default = 1e-8,
     .meaning = "improvement, of the cost, below which the constraint solver ends",
     .least = 0,
     .most = largest},
    {.name = "jacobian",
     .setting = "jacobian",
     .place = Place::option,
     .words = {"dense", "sparse", "auto"},
     .engine_default = 2,
     .meaning = "of the constraints; auto: sparse from 60 degrees of freedom on"},
    {.name = "ccd-iterations",
     .setting = "mpr_iterations",
     .place = Place::option,
     .engine_default = 50,
     .meaning = "of the search for contacts between convex shapes (MPR), at most",
     .least = 1,
     .most = 1e6,
     .whole = true},
    {.name = "ccd-tolerance",
     .setting = "mpr_tolerance",
     .place = Place::option,
     .engine_default = 1e-6,
     .meaning = "of that search [m]",
     .least = 0,
     .most = largest,
     .above = true},
    {.name = "warmstart",
     .setting = "warmstart",
     .place = Place::flag,
     .words = off_on,
     .engine_default = 1,
     .meaning = "the constraint solver starts from the accelerations of the last step"},
    {.name = "refsafe",
     .setting = "refsafe",
     .place = Place::flag,
     .words = off_on,
     .engine_default = 1,
     .meaning = "solref-time is taken as at least two steps"},
    {.name = "multiccd",
     .setting = "multiccd",
     .place = Place::flag,
     .words = off_on,
     .engine_default = 0,
     .meaning = "more than one contact point between convex shapes other than boxes"},
    {.name = "solref-time",
     .setting = "solref timeconst",
     .place = Place::reference,
     .engine_default = 0.02,
     .meaning = "time in which contacts and constraints correct an error [s]",
     .least = 0,
     .most = largest,
     .above = true},
    {.name = "solref-damping",
     .setting = "solref dampratio",
     .place = Place::reference,
     .engine_default = 1,
     .meaning = "damping of that correction as a ratio to critical damping",
     .least = 0,
     .most = largest,
     .above = true},
    {.name = "solimp-least",
     .setting = "solimp dmin",
     .place = Place::impedance,
     .engine_default = 0.9,
     .meaning = "impedance of a constraint without violation, in [0.0001, 0.9999]; 1 were rigid",
     .least = 1e-4,
     .most = 0.9999},
    {.name = "solimp-most",
     .setting = "solimp dmax",
     .place = Place::impedance,
     .engine_default = 0.95,
     .meaning = "impedance from solimp-width on",
     .least = 1e-4,
     .most = 0.9999},
    {.name = "solimp-width",
     .setting = "solimp width",
     .place = Place::impedance,
     .engine_default = 0.001,
     .meaning = "violation at which the impedance is solimp-most [m]",
     .least = 0,
     .most = largest},
};

double number(const MujocoOption& option, const std::string& given) {
  double x = 0;
  const char* const end = given.data() + given.size();
  const auto [stop, error] = std::from_chars(given.data(), end, x);
  const bool inside = (option.above ? x > option.least : x >= option.least) && x <= option.most;
  if (error == std::errc() && stop == end && inside && (!option.whole || x == std::floor(x))) return x;
  const std::string range = option.most == largest
                                ? fmt::format("{} {}", option.above ? "above" : "from", option.least)
                                : fmt::format("in [{}, {}]", option.least, option.most);
  throw std::invalid_argument(fmt::format("mujoco: option {} = '{}' is not a {}number {}", option.name, given,
                                          option.whole ? "whole " : "finite ", range));
}

}  // namespace

std::span<const MujocoOption> mujoco_options() { return options; }

MujocoValues mujoco_defaults() {
  MujocoValues values;
  for (const MujocoOption& option : options) values[option.name] = option.engine_default;
  return values;
}

std::string mujoco_text(const MujocoOption& option, double value) {
  return option.words.empty() ? fmt::format("{}", value) : option.words[static_cast<std::size_t>(value)];
}

const MujocoOption& mujoco_option(std::string_view name) {
  const auto found = std::ranges::find(options, name, &MujocoOption::name);
  if (found == std::end(options)) throw std::logic_error(fmt::format("unknown setting '{}'", name));
  return *found;
}

void mujoco_require(const std::string& kind, const std::string& word, const std::vector<std::string>& valid) {
  if (std::ranges::find(valid, word) != valid.end()) return;
  throw std::invalid_argument(fmt::format("mujoco: no {} '{}'{} (valid: {})", kind, word,
                                          core::did_you_mean(word, valid), fmt::join(valid, ", ")));
}

void mujoco_set(MujocoValues& values, const std::string& option, const std::string& given) {
  std::vector<std::string> names;
  for (const MujocoOption& one : options) names.emplace_back(one.name);
  mujoco_require("option", option, names);
  const MujocoOption& found = mujoco_option(option);
  if (found.words.empty()) {
    values[option] = number(found, given);
    return;
  }
  mujoco_require("value of option " + option, given, found.words);
  values[option] = static_cast<double>(std::ranges::find(found.words, given) - found.words.begin());
}

}  // namespace cylon::simulators
