#include "engine/contact/coulomb.h"

#include "engine/contact/coulomb_point.h"
#include "engine/contact/held_force.h"
#include "engine/contact/sharing.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {

namespace {

bool is_rough(const CoulombProblem& p, std::size_t i) { return p.friction[i] > 0 || is_dry(p, i); }

// Rounding of f and u: the largest of each point's terms, with room for the sums over all points; of u with its error.
struct Rounding {
  VectorX force, rate;  // per point
};

Rounding rounding(const CoulombProblem& p, const VectorX& f) {
  const std::size_t k = p.friction.size();
  Rounding r{VectorX::Zero(static_cast<Eigen::Index>(k)), VectorX::Zero(static_cast<Eigen::Index>(k))};
  const Real scale = 512 * epsilon, least = std::numeric_limits<Real>::min();  // below it digits are lost
  Real largest = 0;
  for (std::size_t i = 0; i < k; ++i) {
    const auto rows = p.response.middleRows<3>(first_row(i));
    const Real u = rows.cwiseAbs().rowwise().sum().maxCoeff() * (f.size() ? f.cwiseAbs().maxCoeff() : 0) +
                   p.offset.segment<3>(first_row(i)).norm();
    r.rate[static_cast<Eigen::Index>(i)] = std::max(scale * u, least) + p.error_of(i);
    const Real a = p.response.diagonal().segment<3>(first_row(i)).maxCoeff();
    if (a > 0)
      largest = std::max(
          {largest, p.offset.segment<3>(first_row(i)).norm() / a, f.segment<3>(first_row(i)).norm()});
  }
  r.force.setConstant(std::max(scale * largest, least));
  return r;
}

// Counts operations of what is tried beyond the first guesses.
struct Counter {
  std::int64_t points = 0, operations = 0;
  void solved(std::int64_t times = 1) { operations += times * linear_operations(3 * points); }
  void swept() { operations += sweep_operations(points); }
};

// One scale per pair, so that bodies of very unlike masses meet the same thresholds: f = S f^, A^ = S A S.
VectorX scales(const CoulombProblem& p) {
  const std::size_t k = p.friction.size();
  VectorX s = VectorX::Ones(3 * static_cast<Eigen::Index>(k));
  for (std::size_t i = 0; i < k; ++i) {
    Real sum = 0;
    int count = 0;
    for (std::size_t j = 0; j < k; ++j) {
      if (p.pair[j] != p.pair[i]) continue;
      sum += p.response.diagonal().segment<3>(first_row(j)).mean();
      ++count;
    }
    if (sum > 0) s.segment<3>(first_row(i)).setConstant(1 / std::sqrt(sum / static_cast<Real>(count)));
  }
  return s;
}

Vector2 direction(const Vector2& u) {
  const Real length = u.norm();
  return length > 0 ? Vector2(u / length) : Vector2(Vector2::Zero());
}

// For points that slide in a direction that is sought, f_t + mu f_n u_t/|u_t| = 0 is solved together with the
// rest by Newton's method, J = d(residual)/df; f is improved in place, and the directions with it.
bool polish(const CoulombProblem& p, std::vector<Hold>& hold, VectorX& f, Counter& counter) {
  const Eigen::Index size = p.offset.size();
  bool sought = false;
  for (std::size_t i = 0; i < hold.size(); ++i) {
    sought = sought || (hold[i].grip == Grip::slides && !hold[i].given && is_rough(p, i));
  }
  if (!sought) return true;
  for (int iteration = 0; iteration < 20; ++iteration) {
    const VectorX u = p.response * f + p.offset;
    VectorX residual = VectorX::Zero(size);
    MatrixX jacobian = MatrixX::Zero(size, size);
    for (std::size_t i = 0; i < hold.size(); ++i) {
      const Eigen::Index n = first_row(i);
      Hold& h = hold[i];
      if (h.grip == Grip::parts) {
        residual.segment<3>(n) = f.segment<3>(n);
        jacobian.block<3, 3>(n, n).setIdentity();
        continue;
      }
      residual[n] = u[n];
      jacobian.row(n) = p.response.row(n);
      if (h.grip == Grip::sticks) {
        residual.segment<2>(n + 1) = u.segment<2>(n + 1);
        jacobian.middleRows<2>(n + 1) = p.response.middleRows<2>(n + 1);
        continue;
      }
      const Vector2 slip = u.segment<2>(n + 1);
      const Real speed = slip.norm();
      const Real edge = slip_edge(p, i, f[n]);
      if (!h.given && is_rough(p, i)) {
        if (!(speed > 0)) return false;
        h.slip = slip / speed;
        const Eigen::Matrix<Real, 2, 2> turn =
            (Eigen::Matrix<Real, 2, 2>::Identity() - h.slip * h.slip.transpose()) / speed;
        jacobian.middleRows<2>(n + 1) = edge * turn * p.response.middleRows<2>(n + 1);
      }
      residual.segment<2>(n + 1) = f.segment<2>(n + 1) + edge * h.slip;
      jacobian.block<2, 1>(n + 1, n) += p.friction[i] * h.slip;
      jacobian.block<2, 2>(n + 1, n + 1) += Eigen::Matrix<Real, 2, 2>::Identity();
    }
    counter.solved();
    const VectorX change = LeastNorm(jacobian, dependent_pivot()).solve(residual);
    f -= change;
    if (!(change.norm() <= 16 * epsilon * f.norm())) continue;
    return true;
  }
  return false;
}

// Takes back, one by one, points that would pull; takes in those that would be entered.  Ends after a fixed
// number of changes.
bool choose_pressed(const CoulombProblem& p, std::vector<Hold>& hold, VectorX& f, Counter& counter) {
  const std::vector<Hold> wanted = hold;
  for (std::size_t change = 0; change < 8 * hold.size() + 8; ++change) {
    counter.solved();
    f = held_force(p, hold);
    const Rounding r = rounding(p, f);
    std::size_t worst = hold.size();
    Real most = 0;
    for (std::size_t i = 0; i < hold.size(); ++i) {
      if (hold[i].grip == Grip::parts) continue;
      const Real pull = -f[first_row(i)] - r.force[static_cast<Eigen::Index>(i)];
      if (pull > most) most = pull, worst = i;
    }
    if (worst < hold.size()) {
      hold[worst].grip = Grip::parts;
      continue;
    }
    const VectorX u = p.response * f + p.offset;
    for (std::size_t i = 0; i < hold.size(); ++i) {
      if (hold[i].grip != Grip::parts) continue;
      const Real enters = -u[first_row(i)] - r.rate[static_cast<Eigen::Index>(i)];
      if (enters > most) most = enters, worst = i;
    }
    if (worst == hold.size()) return true;
    hold[worst] = wanted[worst];
  }
  return false;
}

// Gauss-Seidel over the points, each solved exactly with the others' forces as they are.
bool sweep(const CoulombProblem& p, int sweeps, VectorX& f, std::vector<Hold>& hold, Counter& counter) {
  for (int n = 0; n < sweeps; ++n) {
    counter.swept();
    Real change = 0;
    for (std::size_t i = 0; i < hold.size(); ++i) {
      const Matrix3 a = p.response.block<3, 3>(first_row(i), first_row(i));
      const Vector3 old = f.segment<3>(first_row(i));
      const Vector3 q =
          p.response.middleRows<3>(first_row(i)) * f - a * old + p.offset.segment<3>(first_row(i));
      const Hold start = hold[i].given ? p.hold[i] : Hold{};
      const PointForce now = is_dry(p, i) ? solve_dry(a(1, 1), q[1], p.bound[i], start)
                                          : solve_point(a, q, p.friction[i], start);
      f.segment<3>(first_row(i)) = now.force;
      hold[i] = now.hold;
      change = std::max(change, (now.force - old).norm());
    }
    if (change <= 4 * epsilon * f.norm()) return true;
  }
  return false;
}

// What the forces and velocities of an iteration that has not ended say about the holds.
std::vector<Hold> read_holds(const CoulombProblem& p, const VectorX& f, Real nearly,
                             bool press_when_in_doubt) {
  const VectorX u = p.response * f + p.offset;
  const Real f_scale = f.norm(), u_scale = p.offset.norm();
  std::vector<Hold> hold(p.friction.size());
  for (std::size_t i = 0; i < hold.size(); ++i) {
    hold[i].given = p.hold[i].given;
    const Real f_n = f[first_row(i)];
    const bool presses =
        is_dry(p, i) || (press_when_in_doubt ? u[first_row(i)] <= nearly * u_scale : f_n > nearly * f_scale);
    if (!presses) {
      hold[i].grip = Grip::parts;
    } else if (hold[i].given) {
      hold[i].grip = Grip::slides;
      hold[i].slip = p.hold[i].slip;
    } else if (!is_rough(p, i)) {
      hold[i].grip = Grip::slides;
    } else {
      const Vector2 slip = u.segment<2>(first_row(i) + 1);
      hold[i].grip = slip.norm() > nearly * u_scale ? Grip::slides : Grip::sticks;
      if (hold[i].grip == Grip::slides) hold[i].slip = direction(slip);
    }
  }
  return hold;
}

bool try_holds(const CoulombProblem& p, std::vector<Hold> hold, VectorX f, CoulombSolution& solution,
               Counter& counter) {
  counter.solved(2);
  const VectorX first = held_force(p, hold);
  if (obeys(p, hold, first)) {  // Newton's method cannot better directions of slips that are all but zero
    solution.force = first;
    solution.hold = hold;
    return true;
  }
  if (share_within_cones(p, hold, f, solution.force, counter.operations)) {
    solution.hold = hold;
    return true;
  }
  if (!polish(p, hold, f, counter)) return false;
  const VectorX even = held_force(p, hold);
  const bool even_obeys = obeys(p, hold, even);
  if (!even_obeys && !obeys(p, hold, f)) return false;
  solution.force = even_obeys ? even : f;
  solution.hold = hold;
  return true;
}

CoulombSolution solve_scaled(const CoulombProblem& p, Counter& counter) {
  CoulombSolution solution;
  solution.hold = p.hold;
  for (std::size_t i = 0; i < p.hold.size(); ++i) {
    if (!p.hold[i].given) solution.hold[i] = Hold{is_rough(p, i) ? Grip::sticks : Grip::slides};
  }
  // First guess: all that touches holds.
  std::vector<Hold> hold = solution.hold;
  VectorX f;
  Counter first = counter;
  const bool presses = choose_pressed(p, hold, f, first);
  solution.exact = presses && obeys(p, hold, f);
  if (solution.exact) {
    solution.force = f;
    solution.hold = hold;
    return solution;
  }
  // Or all that touches does, if the forces are shared in another way.
  const auto shares = [&](const std::vector<Hold>& held, const VectorX& force) {
    solution.exact = share_within_cones(p, held, force, solution.force, counter.operations);
    if (solution.exact) solution.hold = held;
    return solution.exact;
  };
  if (presses && shares(hold, f)) return solution;
  const std::vector<Hold> all_hold = solution.hold;
  const bool some_part = std::ranges::any_of(hold, [](const Hold& h) { return h.grip == Grip::parts; });
  if (some_part && shares(all_hold, held_force(p, all_hold))) return solution;
  // Second: those beyond their cones slide, or all do, against the friction that would have held them.
  for (const bool all : {false, true}) {
    std::vector<Hold> loose = hold;
    VectorX force = f;
    for (std::size_t i = 0; i < loose.size(); ++i) {
      const Vector2 pull = f.segment<2>(first_row(i) + 1);
      const bool beyond = pull.norm() > slip_edge(p, i, f[first_row(i)]);
      if (loose[i].grip != Grip::sticks || !(all || beyond) || !(pull.norm() > 0)) continue;
      loose[i].grip = Grip::slides;
      loose[i].slip = -direction(pull);
    }
    for (int turn = 0; turn < 8; ++turn) {
      if (!choose_pressed(p, loose, force, counter)) break;
      solution.exact = try_holds(p, loose, force, solution, counter);
      if (solution.exact) return solution;
      const VectorX u = p.response * force + p.offset;
      for (std::size_t i = 0; i < loose.size(); ++i) {
        const Vector2 slip = u.segment<2>(first_row(i) + 1);
        if (loose[i].grip != Grip::slides || loose[i].given || !(slip.norm() > 0)) continue;
        loose[i].slip = direction(slip);
      }
    }
  }
  VectorX swept = VectorX::Zero(p.offset.size());
  for (const int sweeps : {40, 200, 1000, 4000}) {
    if (sweeps > p.most_sweeps) break;
    const bool settled = sweep(p, sweeps, swept, solution.hold, counter);
    for (const Real nearly : {Real(1e-3), Real(1e-5), std::sqrt(epsilon), std::pow(epsilon, Real(0.75))}) {
      for (const bool press : {true, false}) {
        solution.exact = try_holds(p, read_holds(p, swept, nearly, press), swept, solution, counter);
        if (solution.exact) return solution;
      }
    }
    if (settled) break;
  }
  solution.force = swept;
  solution.exact = obeys(p, solution.hold, swept);
  return solution;
}

}  // namespace

VectorX relaxed_force(const CoulombProblem& p, int rounds) {
  VectorX f = VectorX::Zero(p.offset.size());
  for (int round = 0; round < rounds; ++round) {
    Real change = 0;
    for (std::size_t i = 0; i < p.friction.size(); ++i) {
      const Eigen::Index n = first_row(i);
      const Matrix3 a = p.response.block<3, 3>(n, n);
      if (!(a(0, 0) > 0) && !is_dry(p, i)) continue;
      const Vector3 old = f.segment<3>(n);
      if (a(0, 0) > 0) f[n] = std::max<Real>(0, old[0] - (p.response.row(n).dot(f) + p.offset[n]) / a(0, 0));
      const Real stiff = std::max(a(1, 1), a(2, 2)), edge = slip_edge(p, i, f[n]);
      const Vector2 u = p.response.middleRows<2>(n + 1) * f + p.offset.segment<2>(n + 1);
      const Vector2 held = stiff > 0 ? Vector2(old.tail<2>() - u / stiff) : Vector2(Vector2::Zero());
      const Real size = held.norm();
      f.segment<2>(n + 1) = size > edge ? Vector2(held * (edge / size)) : held;
      change = std::max(change, (f.segment<3>(n) - old).norm());
    }
    if (change <= 16 * epsilon * f.norm()) break;
  }
  return f;
}

bool obeys(const CoulombProblem& p, const std::vector<Hold>& hold, const VectorX& f) {
  if (!f.allFinite()) return false;
  const VectorX u = p.response * f + p.offset;
  const Rounding r = rounding(p, f);
  for (std::size_t i = 0; i < hold.size(); ++i) {
    const Real f_n = f[first_row(i)], u_n = u[first_row(i)];
    const Real f_small = r.force[static_cast<Eigen::Index>(i)],
               u_small = r.rate[static_cast<Eigen::Index>(i)];
    const Vector2 f_t = f.segment<2>(first_row(i) + 1), u_t = u.segment<2>(first_row(i) + 1);
    const Real edge = slip_edge(p, i, f_n);
    if (f_n < -f_small || u_n < -u_small) return false;
    switch (hold[i].grip) {
      case Grip::parts:
        if (is_dry(p, i) || f.segment<3>(first_row(i)).norm() > f_small) return false;
        break;
      case Grip::sticks:
        if (std::abs(u_n) > u_small || u_t.norm() > u_small || f_t.norm() > edge + f_small) return false;
        break;
      case Grip::slides: {
        if (std::abs(u_n) > u_small || (f_t + edge * hold[i].slip).norm() > (1 + p.friction[i]) * f_small) {
          return false;
        }
        const bool against = (u_t - u_t.norm() * hold[i].slip).norm() <= 2 * u_small;
        if (!hold[i].given && is_rough(p, i) && !against) return false;
        break;
      }
    }
  }
  return true;
}

CoulombSolution solve(const CoulombProblem& p) {
  const VectorX s = scales(p);
  CoulombProblem scaled = p;
  scaled.response = s.asDiagonal() * p.response * s.asDiagonal();
  scaled.offset = s.cwiseProduct(p.offset);
  for (std::size_t i = 0; i < p.bound.size(); ++i) scaled.bound[i] /= s[first_row(i)];
  for (std::size_t i = 0; i < p.error.size(); ++i) scaled.error[i] *= s[first_row(i)];
  scaled.start.resize(0);
  Counter counter{static_cast<std::int64_t>(p.friction.size())};
  if (!p.guess.empty()) {
    CoulombSolution guessed;
    for (const bool from_start : {false, true}) {
      if (from_start && p.start.size() == 0) break;
      if (from_start) scaled.start = p.start.cwiseQuotient(s);
      const VectorX force = held_force(scaled, p.guess);
      if (!obeys(scaled, p.guess, force)) continue;
      guessed.hold = p.guess;
      guessed.exact = true;
      guessed.force = s.cwiseProduct(force);
      guessed.rate = p.response * guessed.force + p.offset;
      return guessed;
    }
    scaled.start.resize(0);
    const bool seeks = std::any_of(p.guess.begin(), p.guess.end(), [](const Hold& h) {
      return h.grip == Grip::slides && !h.given && !h.slip.isZero(0);
    });
    if (seeks && try_holds(scaled, p.guess, held_force(scaled, p.guess), guessed, counter)) {
      guessed.exact = true;
      guessed.force = s.cwiseProduct(guessed.force);
      guessed.rate = p.response * guessed.force + p.offset;
      return guessed;
    }
  }
  CoulombSolution solution = solve_scaled(scaled, counter);
  solution.operations = counter.operations;
  solution.force = s.cwiseProduct(solution.force);
  solution.rate = p.response * solution.force + p.offset;
  if (!solution.exact) solution.violation = violation(p, solution.force);
  return solution;
}

}  // namespace cylon::engine
