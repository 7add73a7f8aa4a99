// Keys of joints: which of the table's a joint of each type has.
#include "harness/scenario/field_keys.h"
#include "harness/scenario/key_rows.h"
#include "harness/scenario/key_tables.h"

#include <algorithm>

namespace cylon::scenario {

const Spec* joint_spec() {
  static const Spec spec = [] {
    const std::vector<Key> keys = keys_of<core::Joint>();
    const auto key = [&](const char* name) { return *std::ranges::find(keys, name, &Key::name); };
    return Spec{
        .label = "[[joint]]",
        .keys = {key("type"), key("body"), key("to")},
        .tag = "type",
        .variants = {{"ball", {key("point")}},
                     {"hinge", {key("point"), key("axis")}},
                     {"distance",
                      {arrow("point", "m", "Of the world, where `to` is absent; else it joins the centres."),
                       key("length")}},
                     {"fixed", {key("point")}}}};
  }();
  return &spec;
}

}  // namespace cylon::scenario
