// Rigid bodies on hinges to the world between two stops: from stop to stop the pendulum of pendulum.h; at a stop
// theta' turns round to -e theta'.  A body that gravity presses against a stop stays there where e = 0.  The stops are
// within half a turn of the lowest position, and between them the body starts.  Domain: one hinge to the world per
// body, gravity across it, stops on both sides, and nothing else along it; finitely many bounces; no flight on the
// separatrix.
#include "reference/exact/domain.h"
#include "reference/exact/pendulum.h"
#include "reference/exact/pieces.h"
#include "reference/exact/solutions.h"

#include "harness/core/joint_coordinates.h"

#include <memory>
#include <numbers>

namespace cylon::exact {
namespace {

constexpr auto name = "limited_pendulum";
constexpr std::size_t most_pieces = 1000;

// Stops as angles from the lowest position.
struct Stops {
  Wide lower, upper, restitution;
};

Stops stops_of(const core::Scene& scene, std::size_t index, const HingedBody& body) {
  const core::JointAngle& law = hinge_of(scene, index).angles.front();
  const Wide here = 2 * std::atan2(body.initial.sine, body.initial.cosine) - Wide(law.start);
  return {here + Wide(*law.lower), here + Wide(*law.upper), law.restitution};
}

Track track_of(const core::Scene& scene, std::size_t index, double horizon) {
  const auto body = std::make_shared<const HingedBody>(scene, index);
  const Stops stops = stops_of(scene, index, *body);
  const std::string of = named(scene, static_cast<int>(index));
  Track track;
  Wide t = 0;
  PendulumMotion::Value now = body->initial;
  for (std::size_t pieces = 0; t <= horizon * beyond; ++pieces) {
    if (pieces > most_pieces) refuse(name, of + " strikes its stops more than 1000 times");
    const PendulumMotion flight(body->frequency, now);
    if (flight.on_separatrix()) refuse(name, of + " is on the separatrix or too near it");
    track.add(t, [body, flight](Wide s) { return body->state(flight.at(s)); });
    const PendulumMotion::Arrival arrival = flight.arrives(stops.lower, stops.upper);
    t += arrival.time;
    const Wide angle = arrival.upper ? stops.upper : stops.lower;
    now = {std::sin(angle / 2), std::cos(angle / 2), -stops.restitution * flight.at(arrival.time).rate};
    if (t > horizon * beyond || stops.restitution > 0) continue;
    now.rate = 0;
    if (arrival.upper == (angle < 0)) {  // gravity pulls to theta = 0
      track.add(t, [body, now](Wide) { return body->state(now); });
      break;
    }
  }
  return track;
}

Course solve(const core::Scene& scene, double horizon) {
  Course course;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) course.tracks.push_back(track_of(scene, i, horizon));
  return course;
}

void check_stops(const core::Scene& scene, int index) {
  const auto i = static_cast<std::size_t>(index);
  const std::string of = named(scene, index);
  const core::Joint& hinge = hinge_of(scene, i);
  if (hinge.angles.empty() || !hinge.angles.front().lower || !hinge.angles.front().upper)
    refuse(name, "the hinge of " + of + " has not two stops");
  const core::JointAngle& law = hinge.angles.front();
  if (core::has_force(law) || law.friction != 0)
    refuse(name, "something acts along the hinge of " + of + " beside its stops");
  const HingedBody body(scene, i);
  if (!(body.frequency > 0)) refuse(name, of + " is no pendulum: gravity does not turn it");
  const Stops stops = stops_of(scene, i, body);
  if (!(stops.lower > -std::numbers::pi_v<Wide> && stops.upper < std::numbers::pi_v<Wide>))
    refuse(name, "the stops of " + of + " are not within half a turn of its lowest position");
  if (law.start <= *law.lower || law.start >= *law.upper) refuse(name, of + " starts at a stop");
}

}  // namespace

core::Truth limited_pendulum(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces_beside_joints(name, scene, {"gravity"});
  check_no_contacts(name, scene);
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) {
    check_hinge(name, scene, i);
    check_stops(scene, i);
  }
  return truth_of(
      name, scene, [horizon](const core::Scene& s) { return solve(s, horizon); }, horizon,
      "Whittaker, Analytical Dynamics, section 44, from stop to stop");
}

}  // namespace cylon::exact
