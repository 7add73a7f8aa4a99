// Actuators: each exerts gear (gain u + bias) on its joint, with u its control, or its activation where it has one.
#include "harness/imports/mjcf/mjcf.h"

#include <fmt/format.h>

#include <algorithm>

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

// The control: what the start says, within its range.
double control_of(const Compiled& m, int i) {
  const int control = m.integer("actuator_ctrladr", i, i);
  const bool has_control = control >= 0 && static_cast<std::size_t>(control) < m.started("ctrl");
  const double u = has_control ? m.start("ctrl", control) : 0;
  if (m.integer("actuator_ctrllimited", i) == 0 || m.disabled("clampctrl")) return u;
  return std::clamp(u, m.number("actuator_ctrlrange", 2 * i), m.number("actuator_ctrlrange", 2 * i + 1));
}

// The activation, which starts at 0, where it stays there.
bool rests(const Compiled& m, int i, double u) {
  if (u != 0) return false;
  for (std::size_t a = 0; a < m.started("act"); ++a)
    if (m.start("act", static_cast<int>(a)) != 0) return false;
  return m.integer("actuator_actlimited", i) == 0 ||
         (m.number("actuator_actrange", 2 * i) <= 0 && m.number("actuator_actrange", 2 * i + 1) >= 0);
}

// Where it is one coordinate that the actuator acts on: its joint.
std::optional<int> joint_of(const Compiled& m, int i) {
  const auto transmission = static_cast<MjTransmission>(m.integer("actuator_trntype", i));
  if (transmission > MjTransmission::joint_in_parent) return std::nullopt;
  const int joint = m.integer("actuator_trnid", 2 * i);
  if (static_cast<MjJoint>(m.integer("jnt_type", joint)) < MjJoint::slide) return std::nullopt;
  return joint;
}

// A damper of the actuator itself is one of its joint: it acts without a control, whatever limits the force, and in
// disabled groups too.
void add_dampers(const Compiled& m, std::vector<Drive>& drives, foreign::Model& model) {
  if (m.disabled("damper")) return;
  for (int i = 0, count = m.count("actuator"); i < count; ++i) {
    const double damping = m.number("actuator_damping", i), gear = m.number("actuator_gear", 6 * i);
    const bool curved = m.any("actuator_dampingpoly", i, count);
    if (damping == 0 && !curved) continue;
    const std::optional<int> joint = joint_of(m, i);
    if (joint && !curved)
      drives[static_cast<std::size_t>(*joint)].damping += gear * gear * damping;
    else
      model.losses.push_back(
          {"joint_damping", m.place("actuator", i), curved ? "not linear" : "not on a hinge or a slider"});
  }
}

}  // namespace

std::vector<Drive> drives_of(const Compiled& m, foreign::Model& model) {
  std::vector<Drive> drives(static_cast<std::size_t>(m.size("njnt")));
  const int count = m.count("actuator");
  add_dampers(m, drives, model);
  if (m.disabled("actuation")) {
    for (int i = 0; i < count; ++i)
      model.losses.push_back({"actuator", m.place("actuator", i), "actuation is disabled"});
    return drives;
  }
  if (count == 0) return drives;
  const int columns = static_cast<int>(m.length("actuator_biasprm")) / count;
  for (int i = 0; i < count; ++i) {
    const auto lose = [&](const char* what, const char* detail) {
      model.losses.push_back({what, m.place("actuator", i), detail});
    };
    if (m.number("actuator_armature", i) != 0) lose("armature", "");
    if (m.disabled_group(m.integer("actuator_group", i))) {
      lose("actuator", "its group is disabled");
      continue;
    }
    const int gain_rule = m.integer("actuator_gaintype", i), bias_rule = m.integer("actuator_biastype", i);
    if (gain_rule > affine || bias_rule > affine) {
      lose("actuator_state", "a muscle, a motor with a current or a rule of its own");
      continue;
    }
    double u = control_of(m, i);
    if (m.integer("actuator_ctrlnum", i, 1) > 1) {
      lose("actuator_state", "more than one control");
      continue;
    }
    if (m.number("actuator_delay", i) != 0 && u != 0) {
      lose("actuator_state", "its control comes later");
      continue;
    }
    if (m.integer("actuator_dyntype", i) != 0) {
      if (!rests(m, i, u)) {
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
    if (constant == 0 && of_length == 0 && of_velocity == 0) {
      lose("actuator", "");
      continue;
    }
    const std::optional<int> joint = joint_of(m, i);
    if (!joint) {
      lose("actuator_force", "not on a hinge or a slider");
      continue;
    }
    if (m.integer("actuator_forcelimited", i) != 0 || m.integer("jnt_actfrclimited", *joint) != 0) {
      lose("actuator_force", "its force is limited");
      continue;
    }
    // length = gear q, Q = gear f.
    const double gear = m.number("actuator_gear", 6 * i);
    Drive& drive = drives[static_cast<std::size_t>(*joint)];
    drive.force += gear * constant;
    drive.stiffness -= gear * gear * of_length;
    drive.damping -= gear * gear * of_velocity;
  }
  return drives;
}

}  // namespace cylon::imports
