#include "harness/validation/touches.h"

#include "harness/validation/length_scale.h"

#include <cmath>
#include <limits>

namespace cylon::validation {
namespace {

using core::BodyState, core::State, measured::Experiment;

// Kinetic energy, and potential energy above the height at which the centre lies on the plane [J].
double energy(const Experiment& e, const BodyState& s) {
  const core::Body& body = e.model.scene.bodies[e.bodies[0]];
  const core::Plane& plane = e.model.scene.planes[0];
  const double height = plane.normal.dot(s.position) - plane.offset,
               g = core::gravity_of(e.model.scene, body).norm();
  return body.mass * (s.velocity.squaredNorm() / 2 + g * height) +
         s.angular_velocity.dot(core::world_inertia(body, s.orientation) * s.angular_velocity) / 2;
}

// Frames first … last - 1 that do not touch.
struct Flight {
  std::size_t first = 0, last = 0;
};

std::vector<Flight> flights(const Experiment& e, const std::vector<State>& states) {
  std::vector<Flight> all;
  bool flies = false;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const bool did = flies;
    flies = gap(e, states[i][0]) > touching;
    if (flies && !did) all.push_back({i, i});
    if (flies) all.back().last = i + 1;
  }
  return all;
}

// NaN where too few frames are clear of touches.
double mean_energy(const Experiment& e, const std::vector<State>& states, Flight flight) {
  constexpr std::size_t beside = 2, least = 3;
  if (flight.first > 0) flight.first += beside;
  const std::size_t margin = flight.last < states.size() ? beside : 0;
  if (flight.first + least + margin > flight.last) return std::numeric_limits<double>::quiet_NaN();
  flight.last -= margin;
  double sum = 0;
  for (std::size_t i = flight.first; i < flight.last; ++i) sum += energy(e, states[i][0]);
  return sum / static_cast<double>(flight.last - flight.first);
}

}  // namespace

std::optional<Touch> first_touch(const Experiment& e, const std::vector<State>& states) {
  double before = gap(e, states.front()[0]) - touching;
  if (before <= 0) return std::nullopt;
  for (std::size_t i = 1; i < states.size(); ++i) {
    const double now = gap(e, states[i][0]) - touching;
    if (now <= 0) {
      const double later = now / (now - before);  // share of a frame
      return Touch{(static_cast<double>(i) - later) / e.rate,
                   states[i][0].position + later * (states[i - 1][0].position - states[i][0].position)};
    }
    before = now;
  }
  return std::nullopt;
}

std::optional<double> loss_after_first(const Experiment& e, const std::vector<State>& states) {
  const auto touch = first_touch(e, states);
  const auto frame = static_cast<std::size_t>(std::ceil(((touch ? touch->time : 0) + 0.1) * e.rate));
  if (!touch || frame >= states.size()) return std::nullopt;
  return 1 - energy(e, states[frame][0]) / energy(e, states[0][0]);
}

std::vector<double> losses_of_touches(const Experiment& e, const std::vector<State>& states) {
  std::vector<double> energies, losses;
  for (const Flight& flight : flights(e, states)) energies.push_back(mean_energy(e, states, flight));
  for (std::size_t k = 1; k < energies.size(); ++k) losses.push_back(1 - energies[k] / energies[k - 1]);
  return losses;
}

std::vector<TouchCount> touch_counts(const Experiment& e) {
  std::vector<TouchCount> all;
  for (const measured::Run& run : e.runs) {
    const std::vector<double> losses = losses_of_touches(e, run.states);
    if (all.size() < losses.size()) all.resize(losses.size());
    for (std::size_t k = 0; k < losses.size(); ++k)
      ++all[k].flights, all[k].known += std::isfinite(losses[k]);
  }
  return all;
}

}  // namespace cylon::validation
