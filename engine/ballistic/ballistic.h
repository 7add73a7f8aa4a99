// Spheres and points under uniform gravity alone, event by event: between two events every motion is a closed
// form (a parabola, and a spin that is constant or grows evenly), so nothing is ever integrated.
#pragma once

#include "engine/model.h"
#include "engine/stepper.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace cylon::engine {

/// The state in which the stepper stopped because what follows is none of its motions.
struct Handover {
  Time time = 0;  ///< In (t_n, t_{n+1}] of the step that ended early, or 0 before the first [s].
  std::vector<Motion> motions;  ///< Of all bodies at that instant; impacts up to it are done.
  std::string reason;
};

/// What it can express: flight, impacts with restitution and Coulomb friction, and one plane under a body, on
/// which it rests, slides straight or rolls.  Bounces on a plane that get ever shorter end in closed form: an
/// impact whose further bounces would all be over within `max(1e-9 dt, 16 ulp(t))` takes restitution 0, which
/// has the same normal impulse as all of them together; speeds differ by rounding, heights by
/// less than gravity times that time squared.
///
/// What it cannot: two planes pressed at once, spheres that stay pressed against each other, sliding with
/// friction across a slope, a body that is hit without end at one instant.  Then handover() has a value,
/// step() does nothing more, and the caller goes on with another stepper from that instant.
///
/// Impacts::sequential: impacts at one instant follow each other in the order of the pairs' indices; where another
/// order may do something else, a diagnostic says so.
/// Impacts::simultaneous: all contacts that touch at that instant take the one set of impulses with
///   u+ + e min(u-, 0) >= 0,  J >= 0,  (u+ + e min(u-, 0)) J = 0   (Newton's law as a complementarity
///   problem)
class Ballistic : public Stepper {
 public:
  virtual const std::optional<Handover>& handover() const = 0;
};

/// Nothing where make_ballistic can take the model; else the reason why not.
std::optional<std::string> ballistic_unsupported(const Model&);
inline bool ballistic_applies(const Model& model) { return !ballistic_unsupported(model); }

/// Requires ballistic_applies(model) and dt > 0.  Copies the model.
std::unique_ptr<Ballistic> make_ballistic(const Model&, Time dt);

}  // namespace cylon::engine
