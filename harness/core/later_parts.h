// What a scene may have that an engine written before does not know.  Such an engine would leave it out and say
// nothing, so it gets no such scene unless it says that it knows the part.
#pragma once

#include "harness/core/collision_filter.h"
#include "harness/core/engine.h"
#include "harness/core/joint_coordinates.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace cylon::core {

struct LaterPart {
  std::string_view word;  ///< In Engine::knows.
  std::string_view text;  ///< For people.
  bool (*is_in)(const Scene&);
};

template <JointType type>
bool has_joint(const Scene& scene) {
  return std::ranges::any_of(scene.joints, [](const Joint& joint) { return joint.type == type; });
}
template <bool (*predicate)(const JointCoordinate&)>
bool has_coordinate(const Scene& scene) {
  return any_coordinate(scene, predicate);
}
inline bool frame_changes(const Scene& scene) {
  return scene.frame &&
         (!scene.frame->acceleration.isZero(0) || !scene.frame->angular_acceleration.isZero(0));
}
inline bool has_friction(const JointCoordinate& c) { return c.friction != 0; }

inline constexpr std::array later_parts = {
    LaterPart{"collision_filters", "collision groups and masks", states_filters},
    LaterPart{"body_gravity", "bodies with gravities of their own", states_own_gravity},
    LaterPart{"slider_joints", "sliders", has_joint<JointType::slider>},
    LaterPart{"cylindrical_joints", "cylindrical joints", has_joint<JointType::cylindrical>},
    LaterPart{"planar_joints", "planar joints", has_joint<JointType::planar>},
    LaterPart{"universal_joints", "universal joints", has_joint<JointType::universal>},
    LaterPart{"screw_joints", "screws", has_joint<JointType::screw>},
    LaterPart{"joint_forces", "springs, dampers or motors of joints", has_coordinate<has_force>},
    LaterPart{"joint_targets", "targets of joints that move", has_coordinate<target_moves>},
    LaterPart{"joint_limits", "limits of joints", has_coordinate<has_limit>},
    LaterPart{"joint_friction", "dry friction in joints", has_coordinate<has_friction>},
    LaterPart{"gimbal_joints", "gimbals", has_joint<JointType::gimbal>},
    LaterPart{"rectangular_joints", "rectangular joints", has_joint<JointType::rectangular>},
    LaterPart{"offset_universal_joints", "universal joints with an offset",
              has_joint<JointType::offset_universal>},
    LaterPart{"joint_armature", "rotors on joints", has_coordinate<has_rotor>},
    LaterPart{"frame_acceleration", "a frame that accelerates or turns unevenly", frame_changes},
    LaterPart{"plugin_forces", "forces of plug-ins", has_plugin_force},
};

/// Why the engine may not get the scene: the first part of it that it does not say it knows.
inline std::optional<std::string> not_known(const Engine& engine, const Scene& scene) {
  for (const LaterPart& part : later_parts)
    if (part.is_in(scene) && std::ranges::find(engine.knows, part.word) == engine.knows.end())
      return "the scene has " + std::string(part.text) +
             ", and the engine does not say that it knows them (" + std::string(part.word) + ")";
  return std::nullopt;
}

}  // namespace cylon::core
