#include "scenarios/keys.h"

#include "harness/core/claim.h"
#include "harness/core/observable.h"
#include "harness/core/verdict.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace cylon::scenarios {
namespace {

using enum Kind;

const Range any;
const Range positive{.low = 0, .open = true};
const Range not_negative{.low = 0};
const Range unit_interval{.low = 0, .high = 1};

// ---- A row for each shape of key -----------------------------------------------------------------

Key word(std::string name, std::string meaning, std::vector<std::string> choices = {}) {
  return {.name = std::move(name), .meaning = std::move(meaning), .choices = std::move(choices)};
}
Key plain(std::string name, Kind kind, std::string meaning) {
  return {.name = std::move(name), .kind = kind, .meaning = std::move(meaning)};
}
Key real(std::string name, std::string unit, std::string meaning, Range range = any) {
  return {.name = std::move(name),
          .kind = number,
          .meaning = std::move(meaning),
          .unit = std::move(unit),
          .range = range};
}
Key integer(std::string name, std::string meaning, Range range) {
  return {.name = std::move(name), .kind = whole, .meaning = std::move(meaning), .range = range};
}
Key arrow(std::string name, std::string unit, std::string meaning, Range range = any) {
  return {.name = std::move(name),
          .kind = vector,
          .meaning = std::move(meaning),
          .unit = std::move(unit),
          .range = range};
}
Key nested(std::string name, Kind kind, const Spec* (*spec)(), std::string meaning) {
  return {.name = std::move(name), .kind = kind, .meaning = std::move(meaning), .spec = spec};
}
Key required(Key key) {
  key.required = true;
  return key;
}

std::vector<Key> operator+(std::vector<Key> a, const std::vector<Key>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// The words of an enumeration of core, in its own order.
template <class Enum>
std::vector<std::string> words(Enum last) {
  std::vector<std::string> result;
  for (int i = 0; i <= static_cast<int>(last); ++i) result.emplace_back(core::name(static_cast<Enum>(i)));
  return result;
}

// ---- Shapes and bodies ---------------------------------------------------------------------------

std::vector<Spec::Variant> primitives() {
  const Key radius = required(real("radius", "m", "Radius.", positive));
  const Key length =
      required(real("length", "m", "Length along body y; of a capsule, of its cylinder.", positive));
  return {{"sphere", {radius}},
          {"box", {required(arrow("half_extents", "m", "Half the edges along body x, y, z.", positive))}},
          {"capsule", {radius, length}},
          {"cylinder", {radius, length}},
          {"cone", {radius, length}},
          {"rod", {length}},
          {"disc", {radius}},
          {"hull", {required(plain("vertices", points, "The convex hull of these points [m]."))}},
          {"mesh",
           {word("file", "Wavefront OBJ beside the scenario; or vertices and faces."),
            plain("vertices", points, "[m]"),
            plain("faces", triangles, "Indices from 0, counter-clockwise seen from outside."),
            real("scale", "", "Factor on every coordinate; 1 when absent.", positive)}}};
}

const Spec* part_keys() {
  static const Spec spec{
      .label = "a part of a compound",
      .keys = {required(word("type", "Kind of shape.")),
               required(real("mass", "kg", "Mass of the part.", positive)),
               arrow("position", "m",
                     "Centre of mass of the part; the origin is moved to the common centre."),
               plain("orientation", quaternion, "(w, x, y, z), part to body.")},
      .tag = "type",
      .variants = primitives()};
  return &spec;
}

const Spec* shape_keys() {
  static const Spec spec = [] {
    Spec s{.label = "shape",
           .keys = {required(word("type", "Kind of shape; its axis lies along body y."))},
           .tag = "type",
           .variants = primitives()};
    s.variants.push_back(
        {"compound", {required(nested("parts", tables, part_keys, "Rigidly joined parts."))}});
    return s;
  }();
  return &spec;
}

std::vector<Key> body_keys() {
  return {
      required(word("name", "Unique; forces, joints, materials and claims refer to it.")),
      real("mass", "kg", "Required, unless locked or a compound.", positive),
      plain("inertia", moments,
            "Principal moments about the centre of mass in body axes, or nine numbers by rows [kg m^2]; "
            "absent: from "
            "the shape; without a shape, mass x 1 m^2 about every axis, since a point has no orientation."),
      arrow("position", "m", "Of the centre of mass, world axes."),
      plain("orientation", quaternion, "Unit (w, x, y, z), body to world."),
      arrow("velocity", "m/s", "Of the centre of mass, world axes; must fit the joints."),
      arrow("angular_velocity", "rad/s", "World axes."),
      nested("shape", table, shape_keys, "Absent: a point or bare rigid body."),
      plain("locked", boolean, "Does not move, whatever acts on it."),
      plain("collide", boolean, "Takes part in contacts; absent: true where there is a shape."),
      word("color", "For viewers: \"#rrggbb\".")};
}

const Spec* body_spec() {
  static const Spec spec{.label = "[[body]]", .keys = body_keys()};
  return &spec;
}

const Spec* lattice_spec() {
  static const Spec spec{
      .label = "[[lattice]]",
      .keys = body_keys() + std::vector<Key>{{.name = "count",
                                              .kind = counts,
                                              .meaning = "Bodies along x, y, z.",
                                              .required = true,
                                              .range = {.low = 1}},
                                             required(arrow("spacing", "m",
                                                            "Between neighbours along x, y, z; "
                                                            "`position` is the first one's."))}};
  return &spec;
}

const Spec* cloud_spec() {
  static const Spec spec{
      .label = "[[cloud]]",
      .keys =
          body_keys() +
          std::vector<Key>{
              required(integer("count", "Number of bodies.", {.low = 1})),
              required(arrow("low", "m", "Least corner for the centres.")),
              required(arrow("high", "m", "Greatest corner for the centres.")),
              real("speed", "m/s", "Of each, in a random direction, on top of `velocity`.", not_negative),
              integer("seed", "Same seed, same cloud, everywhere.", {.low = 0, .high = 9007199254740992.0})}};
  return &spec;
}

// ---- Forces --------------------------------------------------------------------------------------

const Key on_body = required(word("body", "Name of the body."));

const Spec* spring_spec() {
  static const Spec spec{
      .label = "[[spring]]",
      .keys = {on_body, arrow("anchor", "m", "On the body, body axes."),
               word("to", "Name of the other body; or `pin`."), arrow("pin", "m", "A point of the world."),
               arrow("to_anchor", "m", "On the other body, its axes."),
               required(real("stiffness", "N/m", "F = stiffness (|d| - rest_length) along d.", not_negative)),
               real("rest_length", "m", "", not_negative),
               real("damping", "N s/m", "Along d.", not_negative)}};
  return &spec;
}
const Spec* drag_spec() {
  static const Spec spec{.label = "[[drag]]",
                         .keys = {on_body, real("linear", "kg/s", "F = -linear v.", not_negative),
                                  real("angular", "kg m^2/s", "Torque = -angular w.", not_negative),
                                  real("momentum", "1/s", "Torque = -momentum L_spin.", not_negative)}};
  return &spec;
}
const Spec* thrust_spec() {
  static const Spec spec{
      .label = "[[thrust]]",
      .keys = {on_body, arrow("force", "N", "Constant, body axes; or `mass_rate`."),
               real("mass_rate", "kg/s", "Of the body's mass; < 0 is a rocket."),
               arrow("exhaust_velocity", "m/s", "Of the mass, relative to the body, body axes."),
               arrow("exchanged_velocity", "m/s", "Of the mass, world axes (accretion).")}};
  return &spec;
}
const Spec* drive_spec() {
  static const Spec spec{
      .label = "[[drive]]",
      .keys = {on_body, required(arrow("force", "N", "Amplitude of F cos(frequency t), world axes.")),
               required(real("frequency", "rad/s", "Angular frequency.", not_negative))}};
  return &spec;
}
const Spec* attraction_spec() {
  static const Spec spec{
      .label = "[[attraction]]",
      .keys = {on_body, required(word("to", "Name of the other body.")),
               required(real("strength", "m^3/(kg s^2)", "F = strength m m' / d^2; < 0 repels."))}};
  return &spec;
}
const Spec* water_spec() {
  static const Spec spec{
      .label = "[[water]]",
      .keys = {real("level", "m", "Of the surface at rest; its waves: docs/engines.md."),
               real("wave", "m", "Amplitude.", not_negative), real("speed", "rad/s", "Of the wave's phase."),
               required(real("buoyancy", "N or kg/m^3", "Mode step: the lift; mode volume: the density.",
                             not_negative)),
               real("drag", "kg/s", "Below the surface.", not_negative),
               word("mode", "Archimedes, or a constant lift below the surface.", {"volume", "step"})}};
  return &spec;
}

// ---- Joints, contacts, frame ---------------------------------------------------------------------

const Spec* joint_spec() {
  const Key point = required(arrow("point", "m", "World coordinates at t = 0."));
  static const Spec spec{
      .label = "[[joint]]",
      .keys = {required(word("type", "Kind of joint.")), on_body,
               word("to", "The other body; absent: the world.")},
      .tag = "type",
      .variants = {
          {"ball", {point}},
          {"hinge", {point, required(arrow("axis", "", "World axes at t = 0, any length but zero."))}},
          {"distance",
           {arrow("point", "m", "Of the world, where `to` is absent; else it joins the centres."),
            real("length", "m", "Absent: the distance at t = 0.", positive)}},
          {"fixed", {point}}}};
  return &spec;
}
const Spec* plane_spec() {
  static const Spec spec{.label = "[[plane]]",
                         .keys = {required(word("name", "Unique among planes and bodies.")),
                                  arrow("normal", "", "Unit; solid where normal . x < offset; absent: y."),
                                  real("offset", "m", "")}};
  return &spec;
}
const Spec* material_spec() {
  static const Spec spec{
      .label = "[[material]]",
      .keys = {
          required(plain("between", pair,
                         "Two names of bodies, planes or generators; \"*\" is all, an exact pair wins.")),
          required(real("restitution", "", "Of the pair.", unit_interval)),
          required(real("friction", "", "Coulomb's, of the pair.", not_negative))}};
  return &spec;
}
const Spec* frame_spec() {
  static const Spec spec{.label = "[frame]",
                         .keys = {arrow("velocity", "m/s", "Of the frame in which the scene is given."),
                                  arrow("angular_velocity", "rad/s", "Of that frame.")}};
  return &spec;
}

// ---- Claims --------------------------------------------------------------------------------------

const Spec* follows_spec() {
  static const Spec spec{
      .label = "follows",
      .keys = {required(word("file", "Recorded data in the format truth/1, beside the scenario."))}};
  return &spec;
}
const Spec* constants_spec() {
  static const Spec spec = [] {
    Spec by_order{.label = "constants"};
    for (int p = 1; p <= highest_order; ++p)
      by_order.keys.push_back(real(std::to_string(p), fmt::format("unit/s^{}", p + 1), "", positive));
    return by_order;
  }();
  return &spec;
}
const Spec* tolerance_spec() {
  static const Spec spec{
      .label = "tolerance",
      .keys = {
          real("absolute", "", "In the observable's unit.", not_negative),
          real("relative", "", "Times the largest |truth| over the horizon; of a drift, the initial value.",
               not_negative),
          plain("order", boolean, "The bound is C dt^p T, with p the scheme's order, which is checked too."),
          real("constant", "unit/s^(p+1)", "Of that bound, whatever the order.", positive),
          nested(
              "constants", table, constants_spec,
              "Of that bound by order: { 1 = 4.9, 4 = 0.2 }; a scheme is held to the highest up to its own."),
          required(
              word("reason", "Rounding, truncation, convention or measured, and how the number follows."))}};
  return &spec;
}
// Each kind with what it is and the numbers that it has.
std::string event_meaning() {
  std::string text = "Of observable = \"event\".";
  for (const core::EventType& type : core::event_types()) {
    text += fmt::format(" {}: {} (", type.name, type.meaning);
    for (const core::EventQuantity which : type.quantities)
      text += fmt::format("{}{}", which == type.quantities.front() ? "" : ", ", core::name(which));
    text += ").";
  }
  return text;
}
const Spec* claim_spec() {
  static const Spec spec{
      .label = "[[claim]]",
      .keys = {
          nested("follows", text_or_table, follows_spec,
                 "An exact solution by name, \"certified\" (any smooth scene), or { file = … }."),
          word("conserves", "The observable that keeps its initial value.", words(core::Quantity::event)),
          word("observable", "What follows.", words(core::Quantity::event)),
          word("body", "Absent: all; the worst counts, momenta and energies are totals."),
          word("component", "Of a vector.", {"x", "y", "z", "horizontal"}),
          arrow("about", "m", "Of angular_momentum and apsides; absent: the origin."),
          plain("until", Kind::until,
                "Horizon [s], or \"horizon\": as long as an error of one ulp stays below a tenth of the "
                "tolerance, of follows = \"certified\"; absent: the duration."),
          plain("sample", Kind::sample, "Time between samples, or \"step\" for every step."),
          word("measure", "How the deviations become one number; absent: max.", words(core::Reduction::rate)),
          word("event", event_meaning(), words(core::EventKind::crossing)),
          word("to", "Of event = \"apsis\": the other body; absent: `about`, a point of the world."),
          integer("index", "Of the event, counted per pair or body; absent: 1.", {.low = 0, .high = 1e9}),
          word("quantity", "Of the event; absent: time.", words(core::EventQuantity::order)),
          required(nested("tolerance", table, tolerance_spec, "How well it must hold, and why."))}};
  return &spec;
}

// ---- Expectations and suites ---------------------------------------------------------------------

const Spec* row_spec() {
  static const Spec spec{
      .label = "[[row]]",
      .keys = {required(word("engine", "Glob over engine ids.")), word("scenario", "Glob; absent: all."),
               word("claim", "Glob over claim labels; absent: all."),
               word("integrator", "Glob; absent: all."), plain("dt", steps, "Steps; absent: all."),
               required(word("status", "What the verdict will be.", words(core::Status::protocol))),
               required(word("reason", "Why.")), word("link", "Where it is discussed.")}};
  return &spec;
}
const Spec* published_spec() {
  static const Spec spec{
      .label = "[[published]]",
      .keys = {required(word("engine", "Id as in `engines`.")), required(plain("dt", step, "Step.")),
               required(word("value", "As published.")), required(word("source", "Where."))}};
  return &spec;
}

}  // namespace

std::string describe(const Range& range, const std::string& unit) {
  const bool low = std::isfinite(range.low), high = std::isfinite(range.high);
  const std::string suffix = unit.empty() ? "" : " " + unit;
  if (low && high)
    return fmt::format("in {}{:g}, {:g}]{}", range.open ? '(' : '[', range.low, range.high, suffix);
  if (low) return fmt::format("{} {:g}{}", range.open ? ">" : ">=", range.low, suffix);
  if (high) return fmt::format("<= {:g}{}", range.high, suffix);
  return "finite" + suffix;
}

const Spec& scenario_keys() {
  static const Spec spec{
      .label = "a scenario",
      .keys = {
          word("title", "One line for people."),
          word("story", "Two to four sentences for people."),
          plain("tags", texts, "For selection."),
          plain(
              "sources", texts,
              "Where the case was reported or proposed: \"owner/repository#number\" of GitHub, or a title."),
          required(real("duration", "s", "A whole number of steps.", positive)),
          required(plain("step", step, "Nominal step [s]: a number, or text like \"1/60\".")),
          arrow("gravity", "m/s^2", "Absent: none."),
          word("impacts", "How several impacts at one instant resolve.", {"sequential", "simultaneous"}),
          nested("body", tables, body_spec, "A rigid body."),
          nested("lattice", tables, lattice_spec, "Equal bodies on a grid: name[0], name[1], …, x fastest."),
          nested("cloud", tables, cloud_spec,
                 "Equal bodies at random places that do not overlap: name[0], …"),
          nested("spring", tables, spring_spec, "A spring with damping."),
          nested("drag", tables, drag_spec, "Resistance of a medium."),
          nested("thrust", tables, thrust_spec, "A motor, a rocket or accretion."),
          nested("drive", tables, drive_spec, "A harmonic force."),
          nested("attraction", tables, attraction_spec, "Gravity between two bodies."),
          nested("water", tables, water_spec, "A water surface."),
          nested("joint", tables, joint_spec, "A joint."),
          nested("plane", tables, plane_spec, "A fixed half-space."),
          nested("material", tables, material_spec, "What happens where a pair touches."),
          nested("frame", table, frame_spec, "The frame in which the initial state is given."),
          nested("claim", tables, claim_spec, "What must hold, and how well.")}};
  return spec;
}

const Spec& expected_keys() {
  static const Spec spec{
      .label = "expected.toml",
      .keys = {{.name = "versions", .kind = table, .meaning = "Engine glob = list of version globs."},
               nested("row", tables, row_spec, "One expectation; the last row that matches wins.")}};
  return spec;
}

const Spec& suite_keys() {
  static const Spec spec{
      .label = "a suite",
      .keys = {
          word("title", "One line."), word("story", "What the suite reproduces."),
          word("claim", "Glob over the claim labels that `published` speaks of; absent: all."),
          required(plain("scenarios", texts, "Globs over scenario names.")),
          required(plain("engines", texts, "Engine ids, with options: \"ode/erp=0,cfm=0\".")),
          plain("steps", steps, "Numbers, or texts like \"1/60\"; absent: each scenario's nominal step."),
          nested("published", tables, published_spec, "A published value.")}};
  return spec;
}

}  // namespace cylon::scenarios
