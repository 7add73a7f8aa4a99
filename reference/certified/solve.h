// States of a smooth scene at chosen times, each number with a proven radius.
#pragma once

#include "reference/certified/flow.h"

#include <span>
#include <string>

namespace cylon::certified {

struct BodyBalls {
  std::array<Ball, 3> position, velocity;  ///< [m], [m/s]
  std::array<Ball, 4> orientation;         ///< (w, x, y, z)
  std::array<Ball, 3> angular_velocity;    ///< World axes [rad/s].

  /// The largest radius of the 13 numbers.
  double radius() const;
};

struct Sampled {
  double time = 0;                ///< [s]
  std::vector<BodyBalls> bodies;  ///< In the order of the scene.
  double conditioning = 0;  ///< ||d state(t)/d state(0)|| in the maximum norm, mixed SI units, to rounding;
                            ///< NaN after a blow, across which it is not followed.
};

struct Goal {
  double radius = 1e-20;  ///< Of every number, in its own unit.
  slong most_bits = 1024;
};

/// A blow on the way.
struct ImpactBall {
  Ball time;  ///< [s]
  core::Pair pair;
};

struct Certificate {
  std::vector<Sampled> samples;     ///< In the order of the times.
  std::vector<ImpactBall> impacts;  ///< In order, up to the last sample.
  double radius = 0;                ///< The largest of all samples.
  bool reached = false;             ///< radius <= goal; else `reason` says what stopped it.
  std::string reason;
  slong bits = 0;
  int steps = 0;
};

/// How far an attempt is; every number is anew with the next one, which is more precise.
struct Reached {
  double time = 0;  ///< [s]
  int steps = 0;
  slong bits = 0;
};
using Watch = std::function<void(const Reached&)>;

/// Step errors and precision start from the goal and tighten until it is reached or `most_bits` would be
/// passed. `times` ascend within [0, horizon of double].  Throws core::OutOfDomain as make_model with
/// Blows::described does, and where the solution cannot be continued to the last time.  After each blow the
/// state is a box anew.  `watch` is called after each step.
Certificate certify(
    const core::Scene&, std::span<const double> times, const Goal& = {}, const Numbers& = exactly,
    const Watch& watch = [](const Reached&) {});

/// The efforts to try one after another; each gets the radius that the last one reached, infinite at first or
/// where it was stuck.
class Attempts {
 public:
  explicit Attempts(const Goal&);
  const Effort& effort() const { return effort_; }
  /// Whether another one is worth trying after one that reached `radius`.
  bool next(double radius);

 private:
  void aim(double step_error);
  Goal goal_;
  Effort effort_;
  double best_;
};

}  // namespace cylon::certified
