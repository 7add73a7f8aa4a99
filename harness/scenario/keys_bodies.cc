// Keys of bodies, their shapes and the generators.
#include "harness/scenario/key_rows.h"
#include "harness/scenario/key_tables.h"

namespace cylon::scenario {
namespace {

using enum Kind;

std::vector<Key> operator+(std::vector<Key> a, const std::vector<Key>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

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

}  // namespace

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

}  // namespace cylon::scenario
