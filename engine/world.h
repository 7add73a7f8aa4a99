// A running simulation: advances the motion of a model in fixed steps, impacts at their own times.
#pragma once

#include "engine/dynamics.h"
#include "engine/integrators.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace cylon::engine {

/// One impact within a step.
struct Impact {
  Real time = 0;            ///< [s]
  std::size_t contact = 0;  ///< Index in Model::contacts.
  Real approach = 0;        ///< Speed at which the surfaces met [m/s], >= 0.
  Real separation = 0;      ///< Speed at which they part [m/s], >= 0.
};

class World {
 public:
  /// Starts at t = 0.  Requires one motion per body and step > 0 [s].
  World(Model, std::vector<Motion>, const Integrator&, Real step);

  /// Advances by exactly one step.
  void step();

  Real time() const { return static_cast<Real>(steps_) * step_; }
  const std::vector<Body>& bodies() const { return dynamics_.bodies; }
  const std::vector<Motion>& motion() const { return motion_; }

  /// The impacts of the last step, in order of time.
  const std::vector<Impact>& impacts() const { return impacts_; }

 private:
  struct Hit {
    std::size_t contact = 0;
    Real after = 0;  // time since the start of the part of the step
  };
  enum class Course { clear, touching, closing, rebounding, passing };

  void advance(Real from, Real span);
  std::optional<Hit> first_hit(Real from, Real span);
  Course course(std::size_t contact, const Approach& before, const Approach& after) const;
  Approach approach_after(std::size_t contact, Real from, Real span);
  void collide(std::size_t contact, Real now);
  Real gap_acceleration(std::size_t contact, Real now);
  void release_contacts();

  Dynamics dynamics_;
  Advance integrate_;
  Real step_;
  std::int64_t steps_ = 0;
  std::vector<Motion> motion_, start_;  // now, and at the start of the part of the step
  Workspace work_;
  std::vector<Impact> impacts_;

  struct Candidate {
    std::size_t contact;
    Course course;
    Approach before, after;
  };
  std::vector<Candidate> candidates_;
  std::vector<int> hits_;         // impacts of each contact in this step
  std::vector<Real> rest_speed_;  // of each resting contact: slower than this is rest [m/s]
};

}  // namespace cylon::engine
