// Actuators: each exerts gear (gain u + bias) on its joint, with u its control, or its activation where it has one.
#include "harness/imports/mjcf/mjcf.h"

#include <fmt/format.h>

namespace cylon::imports {
namespace {

enum Rule { fixed = 0, affine = 1 };  // of gains; of biases none and affine (mjtGain, mjtBias)

// b0 + b1 length + b2 velocity; with gains as well.
struct Affine {
  double constant = 0, of_length = 0, of_velocity = 0;
};

Affine affine_of(const Compiled& m, const char* parameters, int columns, int i) {
  return {m.number(parameters, columns * i), m.number(parameters, columns * i + 1),
          m.number(parameters, columns * i + 2)};
}

}  // namespace

std::vector<Drive> drives_of(const Compiled& m, foreign::Model& model) {
  std::vector<Drive> drives(static_cast<std::size_t>(m.size("njnt")));
  const int count = m.count("actuator");
  if (m.disabled("actuation") || count == 0) return drives;
  const int columns = static_cast<int>(m.length("actuator_biasprm")) / count;
  for (int i = 0; i < count; ++i) {
    const auto lose = [&](const char* what, const char* detail) {
      model.losses.push_back({what, m.place("actuator", i), detail});
    };
    const int gain_rule = m.integer("actuator_gaintype", i), bias_rule = m.integer("actuator_biastype", i);
    if (gain_rule > affine || bias_rule > affine) {
      lose("actuator_state", "a muscle, a motor with a current or a rule of its own");
      continue;
    }
    const int control = m.integer("actuator_ctrladr", i, i);
    const bool has_control = control >= 0 && static_cast<std::size_t>(control) < m.started("ctrl");
    double u = has_control ? m.start("ctrl", control) : 0;
    if (m.integer("actuator_dyntype", i) != 0) {
      bool rests = u == 0;
      for (std::size_t a = 0; a < m.started("act"); ++a)
        rests = rests && m.start("act", static_cast<int>(a)) == 0;
      if (!rests) {
        lose("actuator_state", "its activation changes");
        continue;
      }
      u = 0;  // the activation, which stays
    }
    const Affine gain = affine_of(m, "actuator_gainprm", columns, i);
    const Affine bias = bias_rule == affine ? affine_of(m, "actuator_biasprm", columns, i) : Affine{};
    const double constant = gain.constant * u + bias.constant;
    const double of_length = (gain_rule == affine ? gain.of_length * u : 0) + bias.of_length;
    const double of_velocity = (gain_rule == affine ? gain.of_velocity * u : 0) + bias.of_velocity;
    const auto transmission = static_cast<MjTransmission>(m.integer("actuator_trntype", i));
    if (m.number("actuator_armature", i) != 0) lose("armature", "");
    if (constant == 0 && of_length == 0 && of_velocity == 0) {
      lose("actuator", "");
      continue;
    }
    const int joint = m.integer("actuator_trnid", 2 * i);
    const auto kind = static_cast<MjJoint>(
        transmission <= MjTransmission::joint_in_parent ? m.integer("jnt_type", joint) : 0);
    if (transmission > MjTransmission::joint_in_parent || kind < MjJoint::slide) {
      lose("actuator_force", "not on a hinge or a slider");
      continue;
    }
    if (m.integer("actuator_forcelimited", i) != 0 || m.integer("jnt_actfrclimited", joint) != 0) {
      lose("actuator_force", "its force is limited");
      continue;
    }
    // length = gear q, Q = gear f.
    const double gear = m.number("actuator_gear", 6 * i);
    Drive& drive = drives[static_cast<std::size_t>(joint)];
    drive.force += gear * constant;
    drive.stiffness -= gear * gear * of_length;
    drive.damping -= gear * gear * of_velocity;
  }
  return drives;
}

}  // namespace cylon::imports
