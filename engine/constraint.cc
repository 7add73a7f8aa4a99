#include "engine/constraint.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {

namespace {

// A pivot below this part of its diagonal is rounding: the row follows from the rows before it.
constexpr Real dependent = 4096 * epsilon;

// Joints that are open by more than this part of their rounding: each body makes one turn for all rows, as large turns that
// cancel in sum leave their commutators where they are made one after another.  Of smaller ones these are the square of 1e-7
// (single precision: 1e-3), which the next round closes.
constexpr Real far_from_closed = epsilon < Real(1e-10) ? Real(1e9) : Real(1e4);

// Reduced coordinates keep what such a row asks for, and leave it a diagonal that is rounding:  that of I^-1, a few ulps of
// |s|^2 max(1/I), and that of a lever s, the difference of longer ones, squared.
bool is_kept_already(const Row& row, const std::vector<Body>& bodies) {
  constexpr Real ulps = 64 * epsilon;
  Real rounded = 0;
  const auto add = [&](int body, const Vector3& lever) {
    if (body == fixed_world || bodies[index(body)].locked) return true;
    const Body& b = bodies[index(body)];
    const Real lengths = 64 * row.rounding;
    rounded += ulps * ulps * row.direction.squaredNorm() / b.mass +
               (ulps * lever.squaredNorm() + lengths * lengths) * b.inverse_moments.maxCoeff();
    return b.inverse_mass == 0;
  };
  return add(row.body, row.lever) && add(row.to, row.to_lever) &&
         coupling(row, row, bodies) + yield(row) <= rounded;
}

void push(const Row& row, int body, Real sign, const Vector3& lever, const std::vector<Body>& bodies,
          Motion* motion) {
  const Body& b = bodies[index(body)];
  if (b.locked) return;
  Motion& m = motion[index(body)];
  if (!b.pinned) m.momentum += sign * row.lambda * row.direction;
  if (b.one_axis) {  // the joint that leaves it this axis bears the rest
    const Vector3 axis = m.orientation * b.axis;
    m.angular_momentum += sign * row.lambda * axis.dot(lever) * axis;
  } else {
    m.angular_momentum += sign * row.lambda * lever;
  }
}

void push(const Row& row, const std::vector<Body>& bodies, Motion* motion) {
  push(row, row.body, 1, row.lever, bodies, motion);
  if (row.to != fixed_world) push(row, row.to, -1, row.to_lever, bodies, motion);
}

}  // namespace

Real coupling(const Row& i, const Row& j, const std::vector<Body>& bodies) {
  const auto through = [&](int body, const Vector3& lever) {
    Real sum = 0;
    const Real w = bodies[index(body)].inverse_mass * i.direction.dot(j.direction);
    if (body == j.body) sum += w + lever.dot(j.spin);
    if (body == j.to) sum -= w + lever.dot(j.to_spin);
    return sum;
  };
  Real sum = through(i.body, i.lever);
  if (i.to != fixed_world) sum -= through(i.to, i.to_lever);
  return sum;
}

// Fills the spins and factors A = J M^-1 J^T.
void Rows::measure(const std::vector<Body>& bodies, const Motion* motion, bool closed) {
  // The rows of a joint follow one another, so that the rotation of the row before mostly serves the next too.
  struct Turned {
    int body = fixed_world;
    Matrix3 rotation = Matrix3::Identity();
  };
  const auto spin = [&](Turned& turned, int body, const Vector3& lever) {
    if (turned.body != body) turned = {body, motion[index(body)].orientation.toRotationMatrix()};
    return inverse_inertia_times(bodies[index(body)], turned.rotation, lever);
  };
  Turned first, second;
  for (Row& row : rows) {
    row.spin = spin(first, row.body, row.lever);
    if (row.to != fixed_world) row.to_spin = spin(second, row.to, row.to_lever);
  }
  // What is locked moves by no multiplier and couples nothing.
  const auto end = [&](int body) {
    return body == fixed_world || bodies[index(body)].locked ? SparseFactor::none : body;
  };
  ends_.clear();
  for (const Row& row : rows) ends_.push_back({end(row.body), end(row.to)});
  kept_.clear();
  for (const Row& row : rows) kept_.push_back(is_kept_already(row, bodies));
  factor_.set_pattern(ends_);
  factor_.factor(
      [&](std::size_t i, std::size_t j) {
        if (kept_[i] || kept_[j]) return Real(0);
        return coupling(rows[i], rows[j], bodies) + (i == j ? yield(rows[i]) : Real(0));
      },
      dependent, closed);
}

// A lambda = -residual, lambda = 0 for dependent rows.
void Rows::solve() {
  lambda_.resize(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) lambda_[i] = -rows[i].residual;
  factor_.solve(lambda_);
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].lambda = lambda_[i];
}

void Rows::constrain_accelerations(const std::vector<Body>& bodies, const Motion* motion,
                                   const Kinematics* kinematics, Load* load) {
  measure(bodies, motion);
  // a = (F - m' v)/m,  s.alpha = (I^-1 s).(torque - w x L)
  const auto acceleration = [&](int body, const Vector3& direction, const Vector3& spin) {
    const std::size_t i = index(body);
    const Vector3 gyroscopic = kinematics[i].angular_velocity.cross(motion[i].angular_momentum);
    const Vector3 force = accelerating(bodies[i], kinematics[i], load[i]);
    return bodies[i].inverse_mass * direction.dot(force) + spin.dot(load[i].torque - gyroscopic);
  };
  for (Row& row : rows) {
    row.residual = row.bias + acceleration(row.body, row.direction, row.spin);
    if (row.to != fixed_world) row.residual -= acceleration(row.to, row.direction, row.to_spin);
  }
  solve();
  add_forces(load);
}

void Rows::project_loads(const std::vector<Body>& bodies, Load* load) {
  const auto change = [&](int body, const Vector3& direction, const Vector3& spin) {
    const Load& l = load[index(body)];
    return bodies[index(body)].inverse_mass * direction.dot(l.force) + spin.dot(l.torque);
  };
  for (Row& row : rows) {
    row.residual = change(row.body, row.direction, row.spin);
    if (row.to != fixed_world) row.residual -= change(row.to, row.direction, row.to_spin);
  }
  solve();
  add_forces(load);
}

void Rows::add_forces(Load* load) const {
  for (const Row& row : rows) {
    load[index(row.body)].force += row.lambda * row.direction;
    load[index(row.body)].torque += row.lambda * row.lever;
    if (row.to == fixed_world) continue;
    load[index(row.to)].force -= row.lambda * row.direction;
    load[index(row.to)].torque -= row.lambda * row.to_lever;
  }
}

bool Rows::closed() const {
  return std::all_of(rows.begin(), rows.end(),
                     [](const Row& row) { return std::abs(row.offset) <= row.rounding; });
}

Real Rows::widest() const {
  Real most = 0;
  for (const Row& row : rows) {
    const Real open = std::abs(row.offset) / row.rounding;
    if (std::isnan(open)) return open;
    most = std::max(most, open);
  }
  return most;
}

Real Rows::opening() const {
  Real widest = 0;
  for (const Row& row : rows) {
    const Real c = std::abs(row.offset);
    if (std::isnan(c)) return c;
    if (c > 1000 * row.rounding) widest = std::max(widest, c);
  }
  return widest;
}

void Rows::project_positions(const std::vector<Body>& bodies, Motion* motion) {
  measure(bodies, motion);
  for (Row& row : rows) row.residual = row.offset;
  solve();
  const bool far = std::ranges::any_of(rows, [](const Row& row) {  // contacts state no rounding
    return row.rounding > 0 && std::abs(row.offset) > far_from_closed * row.rounding;
  });
  std::vector<Vector3> turns(far ? bodies.size() : 0, Vector3::Zero());
  const auto turn = [&](std::size_t body, const Vector3& by) {
    motion[body].orientation = turned(motion[body].orientation, by);
  };
  const auto move = [&](int body, const Vector3& direction, const Vector3& spin, Real lambda) {
    const std::size_t i = index(body);
    if (bodies[i].locked) return;
    motion[i].position += lambda * bodies[i].inverse_mass * direction;
    if (far)
      turns[i] += lambda * spin;
    else
      turn(i, lambda * spin);
  };
  for (const Row& row : rows) {
    move(row.body, row.direction, row.spin, row.lambda);
    if (row.to != fixed_world) move(row.to, row.direction, row.to_spin, -row.lambda);
  }
  for (std::size_t i = 0; i < turns.size(); ++i)
    if (!turns[i].isZero(0)) turn(i, turns[i]);
}

void Rows::project_velocities(const std::vector<Body>& bodies, Motion* motion) {
  measure(bodies, motion, true);
  const auto speed = [&](int body, const Vector3& direction, const Vector3& spin) {
    return direction.dot(velocity(bodies[index(body)], motion[index(body)])) +
           spin.dot(motion[index(body)].angular_momentum);
  };
  for (Row& row : rows) {
    row.residual = speed(row.body, row.direction, row.spin);
    if (row.to != fixed_world) row.residual -= speed(row.to, row.direction, row.to_spin);
    if (row.rotor > 0) row.residual -= row.offset;
  }
  solve();
  for (const Row& row : rows) engine::push(row, bodies, motion);
}

void Rows::push(const std::vector<Real>& change, Real h, const std::vector<Body>& bodies, Motion* motion) {
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i].residual = change[i] / h;
  solve();
  for (const Row& row : rows) engine::push(row, bodies, motion);
}

}  // namespace cylon::engine
