// Detects fixed steps that are too long near the singularity of a gimbal: parallel axes.
#pragma once

#include "engine/model.h"

#include <optional>
#include <vector>

namespace cylon::engine {

/// Watches the gimbals on which a law acts.  With delta the angle between two axes, counted from parallel, the directions
/// of the generalised forces turn as fast as delta'/delta.  A step in which delta changes by more than half of itself does not
/// resolve that.
class GimbalWatch {
 public:
  explicit GimbalWatch(const Model&);

  bool sees_any() const { return !gimbals_.empty(); }

  /// Compares with the last motions, at first those of the model.  The largest change of an angle between axes that
  /// the step did not resolve [rad]; 0 where there is none.
  Real look(const std::vector<Motion>&);

  /// How far from parallel axes were that the last look found heading there, and that are not numbers now [rad].
  std::optional<Real> lost() const { return lost_; }

 private:
  struct Gimbal {
    Coordinate at;
    Real angle;       // between its axes [rad]
    Real change = 0;  // of it in the last step
  };
  std::vector<Gimbal> gimbals_;  // one of each law
  std::optional<Real> lost_;
};

}  // namespace cylon::engine
