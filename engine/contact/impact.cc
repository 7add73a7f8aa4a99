#include "engine/contact/impact.h"

#include "engine/contact/response.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace cylon::engine {

namespace {

// Energy made by P: P.u- + P.A P/2.
Real energy_made(const MatrixX& a, const VectorX& before, const VectorX& p) {
  return p.dot(before + a * p / 2);
}

// The largest theta in [0, 1] for which P_0 + theta D makes no energy: root of c + b theta + a theta^2.
Real harmless_part(const MatrixX& response, const VectorX& before, const VectorX& plastic, const VectorX& d) {
  const Real c = energy_made(response, before, plastic);
  const Real b = d.dot(before + response * plastic), a = d.dot(response * d) / 2;
  if (!(a > 0)) return b > 0 ? std::clamp<Real>(-c / b, 0, 1) : Real(1);
  const Real root = std::max<Real>(0, b * b - 4 * a * c);
  return std::clamp<Real>((std::sqrt(root) - b) / (2 * a), 0, 1);
}

// Rates of all rows.  Joints keep the rate that they have (zero, but for rounding): what they must not do is
// change.
VectorX speeds(const Response& response, const std::vector<Body>& bodies, const Motion* motion) {
  const std::vector<Row>& rows = response.rows();
  VectorX speed = VectorX::Zero(static_cast<Eigen::Index>(rows.size()));
  for (Eigen::Index i = 0; i < response.contact_rows(); ++i)
    speed[i] = speed_of(rows[static_cast<std::size_t>(i)], bodies, motion);
  return speed;
}

// Which points an impulse at a point changes: those whose rows have a part in common with its own in A, the rows
// of friction only where there is friction.
class Coupling {
 public:
  Coupling(std::span<const TouchPoint> touches, std::span<const Row> joints, const std::vector<Body>& bodies,
           const Motion* motion)
      : touches_(touches), response_(touches, joints, bodies, motion) {}

  bool operator()(std::size_t i, std::size_t k) const {
    const MatrixX& a = response_.matrix();
    for (Eigen::Index r = first(i); r < end(i); ++r)
      for (Eigen::Index c = first(k); c < end(k); ++c)
        if (std::abs(a(r, c)) > 64 * epsilon * std::sqrt(a(r, r) * a(c, c))) return true;
    return false;
  }

 private:
  static Eigen::Index first(std::size_t i) { return 3 * static_cast<Eigen::Index>(i); }
  Eigen::Index end(std::size_t i) const { return first(i) + (touches_[i].friction > 0 ? 3 : 1); }

  std::span<const TouchPoint> touches_;
  Response response_;
};

// Of all rounds of strike() together.
constexpr std::int64_t most_operations = 3 << 20;

// There, by an impulse of that size, whatever joints make of it.
Real speed_given(const TouchPoint& touch, const std::vector<Body>& bodies, const Motion* motion,
                 Real impulse) {
  const auto yields = [&](int body) {
    if (body == fixed_world) return Real(0);
    const Body& b = bodies[index(body)];
    const Real turned = rotates(b) ? b.inverse_inertia.norm() : Real(0);
    return b.inverse_mass + turned * (touch.position - motion[index(body)].position).squaredNorm();
  };
  return impulse * (yields(touch.body) + yields(touch.other));
}

}  // namespace

Real speed_rounding(const TouchPoint& touch, const std::vector<Body>& bodies, const Motion* motion) {
  if (touch.row) {
    // Of w = I^-1 L by all of L: a body with one axis has parts of L that turn nothing.
    const auto terms = [&](int body, const Vector3& lever) {
      const Body& b = bodies[index(body)];
      const Motion& m = motion[index(body)];
      const Real spin = rotates(b) ? b.inverse_inertia.norm() * m.angular_momentum.norm() : Real(0);
      return touch.row->direction.norm() * velocity(b, m).norm() + lever.norm() * spin;
    };
    return 32 * epsilon *
           (terms(touch.body, touch.row->lever) +
            (touch.other != fixed_world ? terms(touch.other, touch.row->to_lever) : Real(0)));
  }
  const auto size = [&](int body) {
    const Body& b = bodies[index(body)];
    const Motion& m = motion[index(body)];
    Real v = velocity(b, m).norm();
    if (rotates(b)) v += angular_velocity(b, m).norm() * (touch.position - m.position).norm();
    return v;
  };
  Real sum = size(touch.body);
  if (touch.other != fixed_world) sum += size(touch.other);
  return 32 * epsilon * sum;
}

ImpactOutcome strike_at_once(std::span<const TouchPoint> touches, std::span<const Row> joints,
                             const std::vector<Body>& bodies, Motion* motion, std::vector<Hold>* memory) {
  ImpactOutcome outcome;
  outcome.impulse.assign(touches.size(), Vector3::Zero());
  outcome.approach.assign(touches.size(), 0);
  const Response response(touches, joints, bodies, motion);
  const VectorX free = speeds(response, bodies, motion);

  const VectorX before = response.offset(free);
  VectorX wanted = before;
  bool bounces = false;
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(i);
    outcome.approach[i] = std::max<Real>(0, -before[row]);
    if (!(before[row] < 0)) continue;
    wanted[row] = (1 + touches[i].restitution) * before[row];
    bounces = bounces || touches[i].restitution > 0;
  }
  CoulombProblem problem = coulomb_problem(response, touches, wanted);
  problem.bound.assign(touches.size(), 0);  // a force that is bounded has no impulse
  if (memory) problem.guess = *memory;
  const CoulombSolution solution = solve(problem);
  if (memory && solution.exact) *memory = solution.hold;
  VectorX impulse = solution.force;
  outcome.exact = solution.exact;
  outcome.violation = solution.violation;
  outcome.rounds = 1;
  outcome.operations = solution.operations;
  const Real terms = impulse.cwiseAbs().dot(before.cwiseAbs() + (response.matrix() * impulse).cwiseAbs());
  if (bounces && energy_made(response.matrix(), before, impulse) > 64 * epsilon * terms) {
    CoulombProblem without = problem;
    without.offset = before;
    without.guess.clear();
    const CoulombSolution plastic = solve(without);
    outcome.operations += plastic.operations;
    outcome.exact = outcome.exact && plastic.exact;
    outcome.violation = std::max(outcome.violation, plastic.violation);
    const VectorX difference = impulse - plastic.force;
    impulse =
        plastic.force + harmless_part(response.matrix(), before, plastic.force, difference) * difference;
  }
  const VectorX lambda = response.multipliers(free, impulse);
  apply_impulses(response.rows(), lambda, bodies, motion);
  for (std::size_t i = 0; i < touches.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      outcome.impulse[i] +=
          lambda[static_cast<Eigen::Index>(3 * i + axis)] * response.rows()[3 * i + axis].direction;
    }
  }
  return outcome;
}

bool stop_slip(std::span<const TouchPoint> touches, std::span<const Row> joints,
               const std::vector<Body>& bodies, Motion* motion) {
  const Response response(touches, joints, bodies, motion);
  const VectorX free = speeds(response, bodies, motion);
  CoulombProblem problem = coulomb_problem(response, touches, response.offset(free));
  problem.bound.assign(touches.size(), 0);
  std::vector<Hold> holds(touches.size());  // all points stick
  for (std::size_t i = 0; i < touches.size(); ++i)
    if (touches[i].row) holds[i].grip = Grip::slides;
  const VectorX impulse = held_force(problem, holds);
  if (!obeys(problem, holds, impulse)) return false;
  apply_impulses(response.rows(), response.multipliers(free, impulse), bodies, motion);
  return true;
}

ImpactOutcome strike(std::span<const TouchPoint> touches, Impacts impacts, std::span<const Row> joints,
                     const std::vector<Body>& bodies, Motion* motion) {
  if (impacts == Impacts::simultaneous) return strike_at_once(touches, joints, bodies, motion);

  ImpactOutcome outcome;
  outcome.impulse.assign(touches.size(), Vector3::Zero());
  outcome.approach.assign(touches.size(), 0);
  std::vector<int> pairs;
  for (const TouchPoint& t : touches) pairs.push_back(t.pair);
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

  // Speeds that solutions leave by their own error: by rounding anywhere, by what violates the law where it does.
  Real rounding = 0;
  std::vector<Real> violated(pairs.size(), 0);
  const auto approaches = [&](const TouchPoint& t) {
    const auto p = static_cast<std::size_t>(std::ranges::lower_bound(pairs, t.pair) - pairs.begin());
    return t.normal.dot(relative_velocity(t, bodies, motion)) <
           -std::max({speed_rounding(t, bodies, motion), rounding, 2 * violated[p]});
  };

  std::vector<std::vector<Hold>> memory(pairs.size());  // how each pair was held in the round before
  const auto solve_group = [&](const std::vector<std::size_t>& members, Real restitution_factor,
                               std::vector<Hold>* before) {
    std::vector<TouchPoint> group;
    for (const std::size_t i : members) {
      group.push_back(touches[i]);
      group.back().restitution *= restitution_factor;
    }
    const ImpactOutcome part = strike_at_once(group, joints, bodies, motion, before);
    for (std::size_t g = 0; g < members.size(); ++g) {
      const Real given = speed_given(group[g], bodies, motion, part.impulse[g].norm());
      rounding = std::max(rounding, 64 * epsilon * given);
      outcome.impulse[members[g]] += part.impulse[g];
      outcome.approach[members[g]] = std::max(outcome.approach[members[g]], part.approach[g]);
    }
    outcome.exact = outcome.exact && part.exact;
    outcome.violation = std::max(outcome.violation, part.violation);
    ++outcome.rounds;
    outcome.operations += part.operations;
    return part.violation;
  };

  std::optional<Coupling> coupling;
  const auto might_be_first = [&](const std::vector<std::size_t>& members, std::size_t i) {
    if (touches[i].pair == touches[members.front()].pair || !approaches(touches[i])) return false;
    if (!coupling) coupling.emplace(touches, joints, bodies, motion);
    return std::any_of(members.begin(), members.end(), [&](std::size_t k) { return (*coupling)(i, k); });
  };

  std::vector<std::size_t> members;
  while (outcome.turns < most_impact_rounds && outcome.operations <= most_operations) {
    ++outcome.turns;
    bool any = false;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
      members.clear();
      bool struck = false;
      for (std::size_t i = 0; i < touches.size(); ++i) {
        if (touches[i].pair != pairs[p]) continue;
        members.push_back(i);
        struck = struck || approaches(touches[i]);
      }
      if (!struck) continue;
      any = true;
      for (std::size_t i = 0; i < touches.size() && !outcome.order_counts; ++i)
        outcome.order_counts = might_be_first(members, i);
      violated[p] = solve_group(members, 1, &memory[p]);
    }
    if (!any) return outcome;
  }
  outcome.ended = false;
  members.resize(touches.size());
  for (std::size_t i = 0; i < members.size(); ++i) members[i] = i;
  solve_group(members, 0, nullptr);
  return outcome;
}

}  // namespace cylon::engine
