// Keys of bodies, their shapes and the generators.
#include "harness/scenario/field_keys.h"
#include "harness/scenario/key_rows.h"

#include <algorithm>

namespace cylon::scenario {
namespace {

using enum Kind;

std::vector<Key> operator+(std::vector<Key> a, const std::vector<Key>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// The keys of a table, with those of the table that one of them holds.
std::vector<Key> with(std::vector<Key> keys, std::string_view name, const Spec* (*spec)()) {
  std::ranges::find(keys, name, &Key::name)->spec = spec;
  return keys;
}

std::vector<Spec::Variant> primitives() {
  std::vector<Spec::Variant> variants;
  core::for_each_shape<core::Primitive>([&]<class Kind>() {
    variants.push_back({std::string(core::Element<Kind>::name), keys_of<Kind>()});
  });
  std::vector<Key>& mesh = variants.back().keys;
  mesh.insert(mesh.begin(),
              word("file", "Wavefront OBJ beside the scenario. Either this or `vertices` and `faces`."));
  mesh.push_back(absent("1", real("scale", "", "Factor on all coordinates.", positive)));
  return variants;
}

const Spec* part_keys() {
  static const Spec spec = [] {
    std::vector<Key> keys = keys_of<core::Part>();
    keys.front() =
        required(word("type", "Kind of shape."));  // the shape's keys stand beside those of the part
    return Spec{.label = "a part of a compound", .keys = keys, .tag = "type", .variants = primitives()};
  }();
  return &spec;
}

const Spec* shape_keys() {
  static const Spec spec = [] {
    Spec s{.label = "shape",
           .keys = {required(word(
               "type", "Kind of shape, centred on the centre of mass, axis of revolution along body y."))},
           .tag = "type",
           .variants = primitives()};
    s.variants.push_back({std::string(core::Element<core::Compound>::name),
                          with(keys_of<core::Compound>(), "parts", part_keys)});
    return s;
  }();
  return &spec;
}

std::vector<Key> body_keys() { return with(keys_of<core::Body>(), "shape", shape_keys); }

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
                                                            "`position` is that of the first body."))}};
  return &spec;
}

const Spec* cloud_spec() {
  static const Spec spec{
      .label = "[[cloud]]",
      .keys = body_keys() +
              std::vector<Key>{
                  required(integer("count", "Number of bodies.", {.low = 1})),
                  required(arrow("low", "m", "Least corner for the centres.")),
                  required(arrow("high", "m", "Greatest corner for the centres.")),
                  absent("0", real("speed", "m/s", "Of each body in a random direction, added to `velocity`.",
                                   not_negative)),
                  absent("the number of clouds before it",
                         integer("seed", "The same seed gives the same cloud on every machine.",
                                 {.low = 0, .high = 9007199254740992.0}))}};
  return &spec;
}

}  // namespace cylon::scenario
