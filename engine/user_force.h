// A force whose law is given from outside: by a plug-in, or by whoever uses the engine as a library.
#pragma once

#include "engine/body.h"
#include "engine/ends.h"
#include "engine/features.h"
#include "engine/numbering.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace cylon::engine {

/// A body as a law sees it: in the frame of the scene.  Of a law that reads no velocities they may be the inertial ones.
struct SeenBody {
  Real mass = 0;                                    ///< Now [kg].
  Vector3 position = Vector3::Zero();               ///< Centre of mass [m].
  Quaternion orientation = Quaternion::Identity();  ///< Body to world, unit to the error of a step.
  Vector3 velocity = Vector3::Zero();               ///< Of the centre of mass [m/s].
  Vector3 angular_velocity = Vector3::Zero();       ///< World axes [rad/s].
};

/// A function of the time and of the motion of its bodies, and of nothing else: several solutions may be computed side by side,
/// in any order of times, and the same values give the same forces.
class UserLaw {
 public:
  virtual ~UserLaw() = default;
  virtual bool reads_velocities() const = 0;
  virtual bool reads_time() const = 0;
  /// Sets for each body the force at its centre of mass and the torque about that, world axes.  May throw, which ends the run.
  virtual void apply(Time, std::span<const SeenBody>, std::span<Load>) const = 0;
};

/// The forces and torques of a law on some bodies, each of which is named once.
struct UserForce {
  std::vector<int> bodies;             ///< In the order in which the law sees them.
  std::shared_ptr<const UserLaw> law;  ///< Null exerts nothing.

  static constexpr const char* stage = "forces of plug-ins";
  static constexpr const char* one = "a force of a plug-in";
  static constexpr Feature feature = Feature::user_force;
  void add_features(Features& features) const {
    features.add(feature);
    if (reads_velocities()) features.add(Feature::user_force_of_velocities);
  }
  bool reads_velocities() const { return law && law->reads_velocities(); }
  bool reads_time() const { return law && law->reads_time(); }
  bool holds_in_turning_frame() const { return !reads_velocities(); }
  void mark_turned(std::vector<char>& turns) const {
    for (const int body : bodies) turns[static_cast<std::size_t>(body)] = 1;
  }
  void shift_anchors(int, const Vector3&) {}
  std::optional<Ends> ends() const { return std::nullopt; }
  std::optional<Acted> acts_on() const { return bodies; }
  bool acts_on(int body) const { return std::ranges::find(bodies, body) != bodies.end(); }
  void renumber(const Numbering& part) {
    for (int& body : bodies) body = part(body);
  }
};

}  // namespace cylon::engine
