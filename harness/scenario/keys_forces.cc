// Keys of the forces.
#include "harness/scenario/key_rows.h"
#include "harness/scenario/key_tables.h"

namespace cylon::scenario {

using enum Kind;

const Spec* spring_spec() {
  static const Spec spec{
      .label = "[[spring]]",
      .keys = {on_body(), arrow("anchor", "m", "On the body, body axes."),
               word("to", "Name of the other body; or `pin`."), arrow("pin", "m", "A point of the world."),
               arrow("to_anchor", "m", "On the other body, its axes."),
               required(real("stiffness", "N/m", "F = stiffness (|d| - rest_length) along d.", not_negative)),
               real("rest_length", "m", "", not_negative),
               real("damping", "N s/m", "Along d.", not_negative)}};
  return &spec;
}
const Spec* drag_spec() {
  static const Spec spec{.label = "[[drag]]",
                         .keys = {on_body(), real("linear", "kg/s", "F = -linear v.", not_negative),
                                  real("angular", "kg m^2/s", "Torque = -angular w.", not_negative),
                                  real("momentum", "1/s", "Torque = -momentum L_spin.", not_negative)}};
  return &spec;
}
const Spec* thrust_spec() {
  static const Spec spec{
      .label = "[[thrust]]",
      .keys = {on_body(), arrow("force", "N", "Constant, body axes; or `mass_rate`."),
               real("mass_rate", "kg/s", "Of the body's mass; < 0 is a rocket."),
               arrow("exhaust_velocity", "m/s", "Of the mass, relative to the body, body axes."),
               arrow("exchanged_velocity", "m/s", "Of the mass, world axes (accretion).")}};
  return &spec;
}
const Spec* drive_spec() {
  static const Spec spec{
      .label = "[[drive]]",
      .keys = {on_body(), required(arrow("force", "N", "Amplitude of F cos(frequency t), world axes.")),
               required(real("frequency", "rad/s", "Angular frequency.", not_negative))}};
  return &spec;
}
const Spec* attraction_spec() {
  static const Spec spec{
      .label = "[[attraction]]",
      .keys = {on_body(), required(word("to", "Name of the other body.")),
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

}  // namespace cylon::scenario
