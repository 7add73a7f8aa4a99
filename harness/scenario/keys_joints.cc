// Keys of joints: which of the table's a joint of each type has.
#include "harness/scenario/field_keys.h"
#include "harness/scenario/key_rows.h"

namespace cylon::scenario {
namespace {

template <class Coordinate>
const Spec* coordinate_spec() {
  static const Spec spec{.label = fmt::format("[[joint.{}]]", core::Element<Coordinate>::name),
                         .keys = keys_of<Coordinate>()};
  return &spec;
}

std::vector<Key> joint_keys() {
  std::vector<Key> keys = keys_of<core::Joint>();
  for (Key& key : keys) {
    if (key.name == core::Element<core::JointDisplacement>::name)
      key.spec = coordinate_spec<core::JointDisplacement>;
    if (key.name == core::Element<core::JointAngle>::name) key.spec = coordinate_spec<core::JointAngle>;
  }
  return keys;
}

}  // namespace

const Spec* joint_spec() {
  static const Spec spec = [] {
    constexpr auto& types = core::Words<core::JointType>::list;
    const std::vector<Key> all = joint_keys();
    Spec result{.label = "[[joint]]", .tag = "type"};
    for (std::size_t type = 0; type < types.size(); ++type) {
      const core::Joint with_world{.type = static_cast<core::JointType>(type)};
      core::Joint with_body = with_world;
      with_body.to = 0;
      Spec::Variant variant{.name = std::string(types[type])};
      std::size_t next = 0;
      core::for_each_field(with_world, [&](const auto& field, const auto&) {
        Key key = all[next++];
        if (!field.applies) {
          if (type == 0) result.keys.push_back(std::move(key));
        } else if (field.applies(with_world)) {
          key.required &= field.applies(with_body);
          variant.keys.push_back(std::move(key));
        }
      });
      result.variants.push_back(std::move(variant));
    }
    return result;
  }();
  return &spec;
}

}  // namespace cylon::scenario
