#include "reference/measured/experiment_keys.h"

#include "harness/scenario/key_rows.h"
#include "reference/measured/parameter.h"

namespace cylon::measured {
namespace {

using scenario::Kind, scenario::Spec;

const Spec* column_spec() {
  static const Spec spec{
      .label = "[columns]",
      .keys = {
          required(scenario::word("run", "Column whose value tells the runs apart.")),
          scenario::word("frame", "Column that counts the frames of a run, one by one; absent: not checked."),
          scenario::word("time", "Column of the time of a frame [s]; absent: not held against the rate."),
          scenario::plain("position", Kind::texts, "Of a free body, three columns: of the centre of mass."),
          scenario::plain("orientation", Kind::texts, "Four columns: w, x, y, z of body to world."),
          scenario::plain("velocity", Kind::texts, "Three columns: of the centre of mass."),
          scenario::plain("angular_velocity", Kind::texts, "Three columns."),
          scenario::plain(
              "angles", Kind::texts,
              "Of a chain, a column for each body: its absolute angle about the first hinge's axis."),
          scenario::plain("rates", Kind::texts, "Of a chain, a column for each body.")}};
  return &spec;
}

const Spec* unit_spec() {
  static const Spec spec{
      .label = "[units]",
      .keys = {
          absent("\"m\"",
                 scenario::word("length", "Of positions; velocities are this a second.", {"m", "cm", "mm"})),
          absent("\"rad\"", scenario::word("angle", "Angular velocities are this a second.", {"rad", "deg"})),
          absent("\"y\"", scenario::word("up", "The axis of the data that points up.", {"y", "z"})),
          absent("\"right\"",
                 scenario::word("hand", "Whether the axes are right- or left-handed.", {"right", "left"})),
          absent("\"world\"", scenario::word("angular_velocity", "Its axes.", {"world", "body"})),
          absent("0", scenario::real("zero", "",
                                     "Of a chain: the angle of the data where the scene has the bodies."))}};
  return &spec;
}

const Spec* correlation_spec() {
  static const Spec spec{
      .label = "[[uncertainty.correlation]]",
      .keys = {required(scenario::plain(
                   "between", Kind::pair,
                   "Two coordinates of a state in the axes of the scene: \"velocity x\", \"angle 2\"")),
               required(scenario::real("value", "", "From -1 to 1.", core::any))}};
  return &spec;
}

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const ParameterKind& kind : parameter_kinds()) names.push_back(kind.name);
  return names;
}

const Spec* parameter_spec() {
  static const Spec spec{
      .label = "[[parameter]]",
      .keys = {required(scenario::word("name", "For --parameters and reports.")),
               required(scenario::word("kind", "What it changes.", kind_names())),
               scenario::word("body", "The body that it is of; absent: every measured one."),
               required(scenario::real("low", "", "The least that it can be.", core::any)),
               required(scenario::real("start", "", "Where the fit begins.", core::any)),
               required(scenario::real("high", "", "The most that it can be.", core::any))}};
  return &spec;
}

const Spec* fit_spec() {
  static const Spec spec{
      .label = "[fit]",
      .keys = {required(scenario::real("horizon", "s", "Length of the windows that a run is cut into.",
                                       core::positive)),
               absent("no discrepancy",
                      scenario::real("degrees", "",
                                     "Degrees of freedom of the model's discrepancy, a factor of each "
                                     "window's covariance.",
                                     core::positive))}};
  return &spec;
}

const Spec* uncertainty_spec() {
  static const Spec spec{
      .label = "[uncertainty]",
      .keys = {
          absent("0", scenario::real("noise", "m", "Of each coordinate of a measured position.",
                                     core::not_negative)),
          absent("0",
                 scenario::real("position", "m", "Of each coordinate of the start.", core::not_negative)),
          absent("0", scenario::real("orientation", "rad", "Of a small turn of the start about each axis.",
                                     core::not_negative)),
          absent("0",
                 scenario::real("velocity", "m/s", "Of each coordinate of the start.", core::not_negative)),
          absent("0", scenario::real("angular_velocity", "rad/s", "Of each coordinate of the start.",
                                     core::not_negative)),
          absent("0", scenario::real("angle_noise", "rad",
                                     "Of a measured orientation about each axis, or of an angle of a chain.",
                                     core::not_negative)),
          absent("0",
                 scenario::real("angle", "rad", "Of each angle of a chain's start.", core::not_negative)),
          absent("0",
                 scenario::real("rate", "rad/s", "Of each rate of a chain's start.", core::not_negative)),
          nested("correlation", Kind::tables, correlation_spec, "Of errors of a state; absent ones are 0."),
          absent("0", scenario::real("friction", "", "Of every friction of the scene.", core::not_negative)),
          absent("0", scenario::real("restitution", "", "Of every restitution of the scene.",
                                     core::not_negative))}};
  return &spec;
}

}  // namespace

const Spec& experiment_keys() {
  static const Spec spec{
      .label = "an experiment",
      .keys = {
          required(scenario::word("title", "One line.")),
          required(scenario::word("source", "Who measured it, and where it was published.")),
          required(scenario::word("licence", "Of the data.")),
          scenario::word("instrument", "What it was measured with."),
          scenario::plain("known", Kind::texts, "What is known to be wrong with the data."),
          required(
              scenario::word("data", "The table: CSV with a head line, plain or gzip; beside this file.")),
          required(scenario::word("model", "The scene, a scenario file without claims; beside this file.")),
          scenario::word("body", "The body of the scene that was measured."),
          scenario::plain("bodies", Kind::texts,
                          "In its place the bodies of a chain of hinges, from the fixed end on."),
          required(scenario::real("rate", "1/s", "Frames a second.", core::positive)),
          absent("1",
                 scenario::integer("every", "Only each so many-th frame of a run is taken.", {.low = 1})),
          required(nested("columns", Kind::table, column_spec, "Which columns hold what.")),
          nested("units", Kind::table, unit_spec, "Units and axes of the data."),
          nested("uncertainty", Kind::table, uncertainty_spec, "Standard deviations."),
          nested("fit", Kind::table, fit_spec, "How parameters are fitted."),
          nested("parameter", Kind::tables, parameter_spec, "What may be fitted.")}};
  return spec;
}

}  // namespace cylon::measured
