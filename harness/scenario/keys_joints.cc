// Keys of joints, planes, materials and the frame.
#include "harness/scenario/key_rows.h"
#include "harness/scenario/key_tables.h"

namespace cylon::scenario {

using enum Kind;

const Spec* joint_spec() {
  const Key point = required(arrow("point", "m", "World coordinates at t = 0."));
  static const Spec spec{
      .label = "[[joint]]",
      .keys = {required(word("type", "Kind of joint.")), on_body(),
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

}  // namespace cylon::scenario
