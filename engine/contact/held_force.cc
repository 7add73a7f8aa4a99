#include "engine/contact/held_force.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {

namespace {

// Friction below this, squared, shares forces as this does: a tangent must still count as one.
constexpr Real least_rough = Real(1e-6);

// A force that is sought: its row, in units of `share`, with the friction that it brings along.
struct Unknown {
  Eigen::Index row = 0;
  Real share = 1;
  Vector2 rub = Vector2::Zero();  // of the two rows after it
  bool rubs = false;
};

// u = M x at one row, M = A B, B the columns of the unknowns.
Real answer(const CoulombProblem& p, Eigen::Index row, const Unknown& x) {
  const Real own = x.share * p.response(row, x.row);
  return x.rubs ? own + x.rub.x() * p.response(row, x.row + 1) + x.rub.y() * p.response(row, x.row + 2) : own;
}

// One equation  (A f + q)_row = 0  goes with each.
void list_unknowns(const CoulombProblem& p, const std::vector<Hold>& hold, const VectorX& share,
                   std::vector<Unknown>& unknowns) {
  unknowns.clear();
  for (std::size_t i = 0; i < hold.size(); ++i) {
    if (hold[i].grip == Grip::parts) continue;
    const bool sticks = hold[i].grip == Grip::sticks;
    if (is_dry(p, i)) {
      if (sticks) unknowns.push_back({first_row(i) + 1});
    } else if (sticks) {
      unknowns.push_back({first_row(i)});
      for (Eigen::Index t = 1; t < 3; ++t)
        unknowns.push_back({first_row(i) + t, share[static_cast<Eigen::Index>(i)]});
    } else {
      unknowns.push_back({first_row(i), 1, -p.friction[i] * hold[i].slip, true});
    }
  }
}

// What the holds fix of a force: of the start what they do not forbid, and dry friction that slides.
VectorX fixed_part(const CoulombProblem& p, const std::vector<Hold>& hold, const VectorX& start) {
  VectorX from = VectorX::Zero(p.offset.size());
  for (std::size_t i = 0; start.size() > 0 && i < hold.size(); ++i) {
    if (hold[i].grip == Grip::parts) continue;
    from.segment<3>(first_row(i)) = start.segment<3>(first_row(i));
    if (hold[i].grip == Grip::slides)
      from.segment<2>(first_row(i) + 1) = -p.friction[i] * from[first_row(i)] * hold[i].slip;
  }
  for (std::size_t i = 0; i < hold.size(); ++i)
    if (is_dry(p, i) && hold[i].grip == Grip::slides)
      from.segment<2>(first_row(i) + 1) = -p.bound[i] * hold[i].slip;
  return from;
}

// Storage that is used again: this is asked in each stage of a step.
struct LeastNormScratch {
  std::vector<Unknown> unknowns;
  MatrixX system;
  VectorX wanted, left;
  LeastNorm decomposition;
};

// The matrix of the equations: how each unknown answers at the row of each.
void fill_system(const CoulombProblem& p, const std::vector<Unknown>& unknowns, MatrixX& system) {
  const auto count = static_cast<Eigen::Index>(unknowns.size());
  system.resize(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index j = 0; j < count; ++j)
      system(i, j) =
          answer(p, unknowns[static_cast<std::size_t>(i)].row, unknowns[static_cast<std::size_t>(j)]);
}

// f += B x
void add_unknowns(const std::vector<Unknown>& unknowns, const VectorX& x, VectorX& force) {
  for (std::size_t j = 0; j < unknowns.size(); ++j) {
    const Unknown& u = unknowns[j];
    const Real own = x[static_cast<Eigen::Index>(j)];
    force[u.row] += u.share * own;
    if (u.rubs) force.segment<2>(u.row + 1) += own * u.rub;
  }
}

// f = f' + B x with one equation per unknown; least |x| when the tangential unknowns of point i are measured in units of
// share_i; f' is what the holds fix, and `start`, if there is one, with what they forbid left out.
// `unique`: set to whether the equations leave one force only, whatever the shares.
VectorX least_norm(const CoulombProblem& p, const std::vector<Hold>& hold, const VectorX& share,
                   const VectorX& start = {}, bool* unique = nullptr) {
  thread_local LeastNormScratch scratch;
  auto& [unknowns, system, wanted, left, decomposition] = scratch;
  list_unknowns(p, hold, share, unknowns);
  VectorX force = fixed_part(p, hold, start);
  const auto count = static_cast<Eigen::Index>(unknowns.size());
  if (unique) *unique = count == 0;
  if (count == 0) return force;
  const bool departs = !force.isZero(0);
  fill_system(p, unknowns, system);
  wanted.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index row = unknowns[static_cast<std::size_t>(i)].row;
    wanted[i] = -p.offset[row];
    if (departs) wanted[i] -= p.response.row(row).dot(force);
  }
  decomposition.compute(system, dependent_pivot());
  VectorX x = decomposition.solve(wanted);
  if (unique) *unique = decomposition.rank() == count;
  left.noalias() = wanted - system * x;
  x += decomposition.solve(left);  // one refinement: rounding only is left
  add_unknowns(unknowns, x, force);
  return force;
}

// Dry friction of a coordinate that the normals which are held keep by themselves, as a stop does: its rate follows
// from theirs, r_i = sum_j c_j n_j, so that with N the rows of these normals
//   A_ii = A_iN A_NN^+ A_Ni.
// Nothing says how the two share a force.  The normals take it, whose reaction has no bound: friction that took a part
// of it would come to its bound, and end and begin to hold without end although nothing moves.  Without force here
// (it slides nowhere); where the normals part it holds again.
// `result`: the holds, with those that are left; none where none is.
void leave_to_normals(const CoulombProblem& p, const std::vector<Hold>& hold, std::vector<Hold>& result) {
  result.clear();
  bool dry = false;
  for (std::size_t i = 0; i < hold.size(); ++i) dry = dry || (is_dry(p, i) && hold[i].grip == Grip::sticks);
  if (!dry) return;
  std::vector<Eigen::Index> normals;
  for (std::size_t i = 0; i < hold.size(); ++i)
    if (!is_dry(p, i) && hold[i].grip != Grip::parts) normals.push_back(first_row(i));
  if (normals.empty()) return;
  const LeastNorm among(p.response(normals, normals), dependent_pivot());
  result = hold;
  for (std::size_t i = 0; i < hold.size(); ++i) {
    if (!is_dry(p, i) || hold[i].grip != Grip::sticks) continue;
    const VectorX along = p.response(normals, first_row(i) + 1);
    const Real own = p.response(first_row(i) + 1, first_row(i) + 1),
               left = own - along.dot(among.solve(along));
    if (left <= dependent_pivot() * own) result[i] = Hold{Grip::slides};
  }
}

}  // namespace

VectorX nearest_held_force(const CoulombProblem& p, const std::vector<Hold>& hold, const VectorX& start,
                           bool* unique) {
  return least_norm(p, hold, VectorX::Ones(static_cast<Eigen::Index>(hold.size())), start, unique);
}

// A force B v of the kernel, M v = 0, changes nothing that the holds keep, and may change how what slides goes on.  Each
// unit vector, less what the equations see of it, is such a v; it is as long as the point that it relieves most allows.
Real undecided_rate(const CoulombProblem& p, const std::vector<Hold>& hold, const VectorX& force,
                    std::int64_t& operations) {
  std::vector<Unknown> unknowns;
  list_unknowns(p, hold, VectorX::Ones(static_cast<Eigen::Index>(hold.size())), unknowns);
  const auto count = static_cast<Eigen::Index>(unknowns.size());
  if (std::none_of(unknowns.begin(), unknowns.end(), [](const Unknown& u) { return u.rubs; })) return 0;
  operations += linear_operations(count);
  MatrixX system;
  fill_system(p, unknowns, system);
  const LeastNorm decomposition(system, dependent_pivot());
  if (decomposition.rank() == count) return 0;
  operations +=
      linear_operations(static_cast<std::int64_t>(force.size()));  // a product and a solution for each
  const Real rounding = std::sqrt(epsilon);                        // of a part of the kernel that is none
  Real most = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    VectorX v = -decomposition.solve(system.col(k));
    v[k] += 1;
    VectorX other = VectorX::Zero(force.size());
    add_unknowns(unknowns, v, other);
    Real room = std::numeric_limits<Real>::infinity(), scale = 0;
    for (std::size_t i = 0; i < hold.size(); ++i) {
      const Eigen::Index n = first_row(i);
      if (std::abs(other[n]) > rounding)
        room = std::min(room, std::max<Real>(0, force[n]) / std::abs(other[n]));
    }
    if (!std::isfinite(room)) continue;
    const VectorX rate = p.response * other;
    for (std::size_t i = 0; i < hold.size(); ++i)
      scale = std::max(scale, p.response(first_row(i), first_row(i)) * std::abs(other[first_row(i)]));
    for (std::size_t i = 0; i < hold.size(); ++i) {
      if (hold[i].grip != Grip::slides || is_dry(p, i)) continue;
      const Real change = rate.segment<2>(first_row(i) + 1).norm();
      if (change > rounding * scale) most = std::max(most, room * change);
    }
  }
  return most;
}

VectorX held_force(const CoulombProblem& p, const std::vector<Hold>& decided) {
  std::vector<Hold> left;
  leave_to_normals(p, decided, left);
  const std::vector<Hold>& hold = left.empty() ? decided : left;
  if (p.start.size() > 0) return nearest_held_force(p, hold, p.start, nullptr);
  const Eigen::Index k = static_cast<Eigen::Index>(hold.size());
  // Where normals can carry what friction could (a ball in a groove), friction leaves it to them.
  Real roughest = 0;
  for (const Real mu : p.friction) roughest = std::max(roughest, mu);
  VectorX rough(k);
  for (Eigen::Index i = 0; i < k; ++i)
    rough[i] =
        std::sqrt(std::clamp<Real>(p.friction[static_cast<std::size_t>(i)] * roughest, least_rough, 1));
  VectorX share = rough;
  bool unique = false;
  VectorX f = least_norm(p, hold, share, {}, &unique);
  const bool sticks =
      std::any_of(hold.begin(), hold.end(), [](const Hold& h) { return h.grip == Grip::sticks; });
  for (int pass = 0; sticks && !unique && k > 1 && pass < 3; ++pass) {
    Real mean = 0;
    for (Eigen::Index i = 0; i < k; ++i) mean += std::max<Real>(0, f[3 * i]) / static_cast<Real>(k);
    if (!(mean > 0)) break;
    for (Eigen::Index i = 0; i < k; ++i) {
      share[i] = rough[i] * std::sqrt(std::clamp<Real>(f[3 * i] / mean, Real(1e-4), Real(1e4)));
    }
    f = least_norm(p, hold, share);
  }
  return f;
}

}  // namespace cylon::engine
