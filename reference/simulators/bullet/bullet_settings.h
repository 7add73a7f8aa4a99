// What may be set in Bullet and what each path sets, as words and numbers; knows no Bullet header.
#pragma once

#include "harness/core/engine.h"
#include "harness/core/scene_kind.h"

#include <map>
#include <optional>
#include <string>

namespace cylon::simulators {

/// How joints between rigid bodies stop.
struct BulletStops {
  bool ahead = true;  ///< By rows of btGeneric6DofSpring2Constraint, which act before a stop is passed; else
                      ///< by each joint's own.
  std::optional<double> erp;  ///< The part of the way past a stop that a step takes back; nothing: m_erp.
};

/// One run's settings of Bullet, every default written out.
struct BulletSettings {
  std::string path;                      ///< "rigid", "rigid-bounce", "multibody", "as-shipped", "as-expert".
  bool multibody = false;                ///< btMultiBody in place of btRigidBody.
  bool runge_kutta = false;              ///< A multibody's Runge-Kutta 4 in place of semi-implicit Euler.
  std::string gyroscopic;                ///< "implicit-body", "implicit-world", "explicit" or "none".
  std::string solver;                    ///< "sequential-impulse", "nncg" or "dantzig".
  std::map<std::string, double> number;  ///< Every numeric option by its name.
  core::Terms terms;                     ///< The same for the reports.

  /// Why this path cannot do what the run asks for on this scene; empty: it can.
  std::optional<std::string> refused;

  bool on(const char* option) const { return number.at(option) != 0; }
  BulletStops stops() const;
};

/// What Bullet says of itself.
core::Engine bullet_engine(std::string version, std::string precision);

/// What the paths look at in a scene.
struct BulletKind : core::SceneKind {
  bool tree = false;  ///< Nothing touches; every moving body hangs from the world by joints of btMultiBody
                      ///< or has no gyroscopic torque; no force but gravity, drag and dampers of joints acts,
                      ///< and no joint has limits or dry friction.
  bool loops = false;  ///< Joints close a loop, of btMultiBody.
  bool stops = false;  ///< Joints have limits.
  bool swept = false;  ///< Some body has a shape that continuous collision detection sweeps.
  int rk4_order = 4;   ///< Of btMultiBody's Runge-Kutta 4.
};

/// The settings of a setup on a scene of a kind.
/// Throws std::invalid_argument, naming the nearest valid one, for what bullet_engine() does not offer, and for
/// options that the path never has, whatever the scene.
BulletSettings bullet_settings(const core::Engine&, const core::Setup&, const BulletKind&);

}  // namespace cylon::simulators
