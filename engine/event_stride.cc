// EventStepper where following events one by one does not come to an end: a short time in one go, by impulses.
#include "engine/contact/response.h"
#include "engine/event_stepper.h"
#include "engine/joint.h"

#include <algorithm>
#include <cmath>

namespace cylon::engine {

namespace {

constexpr int most_rounds = 200;

}  // namespace

// Moreau's step over h:  momenta take the forces, K* = K + h F; impulses P take them to velocities that obey
// the law of impact (engine/contact/impact.h) at all points that can meet within h at once,
//   u+ = u* + A P,   u_n+ >= max(-e u_n-, -g/h),   Coulomb's law for P_t and u_t+,
// and the bodies go on freely with those.  Slip that its friction can end within h ends.  Of first order, and
// of bounded work whatever the contacts do.  J. J. Moreau, Unilateral contact and dry friction in finite
// freedom dynamics (1988), sections 10-12.  Returns how far the velocities at contacts are from that [m/s].
Real EventStepper::stride(Time from, Time span) {
  pass_kink(from);
  const std::vector<Body>& bodies = system_.model().bodies;
  const Real h = static_cast<Real>(span);
  Motion* motion = motions();
  std::vector<TouchPoint> touches;
  std::vector<Real> least;  // of u_n+ [m/s]
  const std::vector<Spot> spots = this->spots(h);
  for (const Spot& spot : spots) {
    const TouchPoint& touch = touches.emplace_back(spot.touch);
    const Real u = gap_rate(touch, bodies, motion);
    const bool bounces = !plastic_ && u < -rest_speed_ && touch.gap + h * u < 0;
    least.push_back(bounces ? -touch.restitution * u : -std::max(touch.gap, Real(0)) / h);
  }
  Real off = 0;
  system_.set_holder(nullptr);
  system_.kick(from, h, y_.data());
  if (!touches.empty()) {
    const std::vector<Row> joints = joint_rows(motion);
    const Response response(touches, joints, bodies, motion);
    VectorX free(static_cast<Eigen::Index>(response.rows().size()));
    for (Eigen::Index i = 0; i < free.size(); ++i) {
      const Row& row = response.rows()[static_cast<std::size_t>(i)];
      free[i] = row.rotor > 0 ? 0 : speed_of(row, bodies, motion);  // a rotor keeps the rate that it has
    }
    VectorX offset = response.offset(free);
    for (std::size_t i = 0; i < least.size(); ++i) offset[3 * static_cast<Eigen::Index>(i)] -= least[i];
    CoulombProblem problem = coulomb_problem(response, touches, std::move(offset));
    for (Real& bound : problem.bound) bound *= h;
    const VectorX relaxed = relaxed_force(problem, most_rounds);
    off = violation(problem, relaxed);
    const VectorX impulses = response.multipliers(free, relaxed);
    apply_impulses(response.rows(), impulses, bodies, motion);
    for (std::size_t i = 0; keep_ && i < touches.size(); ++i) {
      Vector3 impulse = Vector3::Zero();
      for (std::size_t k = 3 * i; k < 3 * i + 3; ++k)
        impulse += impulses[static_cast<Eigen::Index>(k)] * response.rows()[k].direction;
      tell(spots[i], impulse);
    }
    work_ += solution(touches.size());
  }
  held_.clear();
  system_.set_holder(this);  // joints are closed by close_gaps()
  const std::vector<Real> rates = rotor_rates();
  system_.drift(h, y_.data());
  turn_rotors(rates);
  resting_ = false;
  fresh_ = instant_ = true;
  return off;
}

std::vector<Real> EventStepper::rotor_rates() const {
  const std::vector<Body>& bodies = system_.model().bodies;
  std::vector<Row> rows;
  add_rotor_rows(system_.model(), motions(), rows);
  std::vector<Real> rates;
  for (const Row& row : rows) rates.push_back(speed_of(row, bodies, motions()));
  return rates;
}

// The drift has turned the axes of rotors, and with them the rates of their coordinates, as if there were none.
void EventStepper::turn_rotors(const std::vector<Real>& rates) {
  if (rates.empty()) return;
  Motion* motion = motions();
  rows_.rows = joint_rows(motion);
  for (std::size_t k = 0; k < rates.size(); ++k)
    rows_.rows[rows_.rows.size() - rates.size() + k].offset = rates[k];
  rows_.project_velocities(system_.model().bodies, motion);
}

// What the strides left of surfaces inside each other, and of joints apart.
void EventStepper::close_gaps() {
  const std::vector<Body>& bodies = system_.model().bodies;
  Motion* motion = motions();
  system_.project(y_.data());
  rows_.rows = conditions(motion);
  for (const Spot& spot : spots()) {
    if (spot.touch.gap > 0 || spot.touch.axis > 0) continue;
    std::vector<Row> three;
    append_rows(spot.touch, bodies, motion, three);
    three[0].offset = spot.touch.gap;
    three[0].rounding = 16 * epsilon * scale_of(candidates_[spot.held.candidate], motion);
    rows_.rows.push_back(three[0]);
  }
  if (!rows_.closed()) rows_.project_positions(bodies, motion);
}

}  // namespace cylon::engine
