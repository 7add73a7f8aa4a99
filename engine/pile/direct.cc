#include "engine/pile/direct.h"

#include "engine/islands/unions.h"
#include "engine/operations.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine::pile {
namespace {

constexpr int most_rounds = 60, patience = 6, plain_rounds = 2, most_cuts = 20;
// Where rounds no longer help, rows get so many times as stiff, so often; powers of two, so that it is undone exactly.
constexpr int most_stiffenings = 8;
// Of what rounding leaves: below that the laws hold.  Two points that hold each other back as a body tilts share their friction
// in no way that rounds come to; after some tries that is good enough.
constexpr double solved = 1000;
constexpr int tries = 2;
// Impulses that are off by a violation times the stiffness leave the velocities off by up to that many times what it gives the
// row that yields most.  A root farther away is another one: mirrored loads, for one, may be equal or not.
constexpr double reach = 100;
constexpr double stiffening = 8, most_stiff = 4096;
// Of rows over the lightest mass: beyond that the digits of a light body are those of the rows.
constexpr double stiffest = 1e8;
// A row that is stiff on one side only makes the function all edges, and a step of Newton's ends at the next
// one: 67 where a pyramid under 300 times its boxes' mass is built up.  A round that is cut off before its
// least value gives impulses that balance nothing, and the next one runs away from them.
constexpr int most_newton_steps = 200;
// Of what the forces give in the step: slower than that is rest.
constexpr double at_rest = 1e-3;
constexpr double double_epsilon = std::numeric_limits<double>::epsilon();

// The inverse of a matrix that may be singular: what it cannot move becomes very heavy.  Only a
// preconditioner; the velocities are always those that the impulses give.
Eigen::Matrix3d heavy_inverse(const Eigen::Matrix3d& inverse) {
  const double size = inverse.cwiseAbs().maxCoeff();
  if (size == 0) return Eigen::Matrix3d::Identity() * 1e9;
  return Eigen::Matrix3d(inverse + 1e-9 * size * Eigen::Matrix3d::Identity()).inverse();
}

}  // namespace

// Those that move and that a row acts on: no row changes the others.
void Direct::place(const std::vector<Block>& blocks, const std::vector<Mover>& movers) {
  std::vector<char> bound(movers.size(), 0);
  for (const Block& block : blocks) {
    bound[index(block.a)] = 1;
    if (block.b != fixed_world) bound[index(block.b)] = 1;
  }
  place_.assign(movers.size(), -1);
  bodies_.clear();
  for (std::size_t i = 0; i < movers.size(); ++i) {
    if (!bound[i] || !moves(movers[i])) continue;
    place_[i] = 6 * static_cast<int>(bodies_.size());
    bodies_.push_back(static_cast<int>(i));
  }
}

void Direct::set_up(std::vector<Block>& blocks, const std::vector<Body>& bodies,
                    const std::vector<Mover>& movers) {
  place(blocks, movers);
  const auto count = static_cast<Eigen::Index>(6 * bodies_.size());
  free_.resize(count), v_.resize(count), gradient_.resize(count), way_.resize(count), push_.resize(count);
  masses_.assign(bodies_.size(), M6::Zero());
  inverses_ = loose_ = masses_;
  centre_ = free_;
  double mass = 0;
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const Mover& m = movers[index(bodies_[k])];
    mass += bodies[index(bodies_[k])].mass;
    inverses_[k].topLeftCorner<3, 3>() = M3::Identity() * static_cast<double>(m.inverse_mass);
    inverses_[k].bottomRightCorner<3, 3>() = m.inverse_inertia.cast<double>();
    masses_[k].bottomRightCorner<3, 3>() = heavy_inverse(m.inverse_inertia.cast<double>());
    free_.segment<3>(static_cast<Eigen::Index>(6 * k)) = m.v.cast<double>();
    free_.segment<3>(static_cast<Eigen::Index>(6 * k + 3)) = m.w.cast<double>();
  }
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const Mover& m = movers[index(bodies_[k])];
    masses_[k].topLeftCorner<3, 3>() =
        M3::Identity() * (m.inverse_mass > 0 ? 1 / static_cast<double>(m.inverse_mass) : 1e6 * mass);
    loose_[k].topLeftCorner<3, 3>() = masses_[k].topLeftCorner<3, 3>().inverse();
    loose_[k].bottomRightCorner<3, 3>() = masses_[k].bottomRightCorner<3, 3>().inverse();
  }
  std::vector<BlockFactor::Pair> couples;
  rows_.clear();
  for (Block& block : blocks) {
    Row row;
    row.block = &block;
    row.a = place_[index(block.a)];
    row.b = block.b == fixed_world ? -1 : place_[index(block.b)];
    if (row.a < 0 && row.b < 0) continue;
    row.arm = block.arm.cast<double>(), row.to_arm = block.to_arm.cast<double>();
    row.n = block.normal.cast<double>();
    row.space = block.space.cast<double>();
    row.lambda = block.impulse.cast<double>();
    row.best = row.before = row.change = row.skewed = V3::Zero();
    row.target = static_cast<double>(block.target), row.bias = block.bias.cast<double>();
    row.turn = -cross_matrix(row.arm), row.to_turn = -cross_matrix(row.to_arm);
    row.pitch = static_cast<double>(block.pitch);
    row.turn.diagonal().array() -= row.pitch, row.to_turn.diagonal().array() -= row.pitch;
    // An angular row's mass is an inertia: that of the masses at the length of the bodies' own.
    double scale = 1;
    if (block.angular) {
      const auto inertia = [&](int body) {
        return body == fixed_world ? 0. : static_cast<double>(bodies[index(body)].inertia.trace());
      };
      scale = std::max(inertia(block.a), inertia(block.b)) / mass;
    }
    row.stiffness = 100 * mass * scale;
    rows_.push_back(row);
    if (row.a >= 0 && row.b >= 0) couples.emplace_back(row.a / 6, row.b / 6);
  }
  matrix_.set_pattern(static_cast<int>(bodies_.size()), std::move(couples));
  for (Row& row : rows_)
    if (row.a >= 0 && row.b >= 0) row.where = matrix_.find(row.a / 6, row.b / 6);
}

// Whether bodies and the world hold each other in a loop: only there rows of joints may depend on each other.
bool Direct::holds_in_loops() const {
  const std::size_t world = bodies_.size();
  islands::Unions held(world + 1);
  const auto member = [&](int place) { return place < 0 ? world : index(place / 6); };
  const Block* last = nullptr;
  for (const Row& row : rows_) {
    if (row.block->kind != Block::Kind::hold) continue;
    const bool same_joint = last && last->a == row.block->a && last->b == row.block->b &&
                            (row.block->angular || row.block->offset || row.pitch != 0);
    last = row.block;
    if (same_joint) continue;
    const std::size_t a = member(row.a), b = member(row.b);
    if (held.find(a) == held.find(b)) return true;
    held.join(a, b);
  }
  return false;
}

// x, one per row, becomes the nearest P J v of holds:  v minimises sum d (P J v - x)^2 by rounds of the augmented Lagrangian.
// What rows would say against each other is left out, and so is what they would almost say, as where axes of a loop are
// parallel but for the rounding of the joints: eight rounds do not come to that.
void Direct::make_consistent(std::vector<V3>& x) {
  constexpr int rounds = 8;
  const auto holds = [&](std::size_t i) { return rows_[i].block->kind == Block::Kind::hold; };
  for (std::size_t i = 0; i < rows_.size(); ++i)
    rows_[i].slope = holds(i) ? M3(rows_[i].stiffness * rows_[i].space) : M3(M3::Zero());
  factor();
  std::vector<V3> lambda(rows_.size(), V3::Zero()), found(rows_.size(), V3::Zero());
  for (int round = 0; round < rounds; ++round) {
    way_.setZero();
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (holds(i)) add_impulse(rows_[i], rows_[i].space * (lambda[i] + rows_[i].stiffness * x[i]), way_);
    matrix_.solve(way_);
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (!holds(i)) continue;
      found[i] = rows_[i].space * (velocity(rows_[i], way_) - rows_[i].bias);
      lambda[i] -= rows_[i].stiffness * (found[i] - rows_[i].space * x[i]);
    }
  }
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (holds(i)) x[i] = found[i];
}

// Where rows depend on each other, J V = -b has a solution only if b depends in the same way, which what bends the path
// does but for O(dt^2).
void Direct::reconcile_biases() {
  std::vector<V3> x;
  for (const Row& row : rows_) x.emplace_back(-row.bias);
  make_consistent(x);
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i].block->kind == Block::Kind::hold) rows_[i].bias = -x[i];
}

// Impulses of rows that depend on each other may balance and grow from step to step, and as the arms turn they would do
// work: they go on without what moves nothing.
void Direct::leave_out_balanced() {
  std::vector<V3> x;
  for (const Row& row : rows_) x.emplace_back(row.lambda / row.stiffness);
  make_consistent(x);
  for (std::size_t i = 0; i < rows_.size(); ++i)
    if (rows_[i].block->kind == Block::Kind::hold) rows_[i].lambda = rows_[i].stiffness * x[i];
}

Direct::V3 Direct::velocity(const Row& row, const Vector& v) const {
  V3 u = row.bias;
  const bool align = row.block->angular;
  const auto at = [&](int body, const V3& arm) -> V3 {
    const V3 w = v.segment<3>(body + 3);
    if (align) return w;
    const V3 there = v.segment<3>(body) + w.cross(arm);
    return row.pitch == 0 ? there : V3(there - row.pitch * w);
  };
  if (row.a >= 0) u += at(row.a, row.arm);
  if (row.b >= 0) u -= at(row.b, row.to_arm);
  return u;
}

void Direct::add_impulse(const Row& row, const V3& j, Vector& to) const {
  const bool align = row.block->angular;
  const auto torque = [&](const V3& arm) -> V3 {
    if (align) return j;
    return row.pitch == 0 ? V3(arm.cross(j)) : V3(arm.cross(j) - row.pitch * j);
  };
  if (row.a >= 0) {
    if (!align) to.segment<3>(row.a) += j;
    to.segment<3>(row.a + 3) += torque(row.arm);
  }
  if (row.b >= 0) {
    if (!align) to.segment<3>(row.b) -= j;
    to.segment<3>(row.b + 3) -= torque(row.to_arm);
  }
}

// f and, if asked, its slopes; coupled: with the limits that its own normal parts set.
void Direct::forces(const Vector& v, bool slopes, bool coupled) {
  for (Row& row : rows_) {
    const V3 u = velocity(row, v);
    const double d = row.stiffness;
    if (row.block->is_along_normal()) {
      if (row.block->kind == Block::Kind::soft) {
        const auto drag = static_cast<double>(row.block->drag);
        row.f = (static_cast<double>(row.block->push) - drag * row.n.dot(u)) * row.n;
        if (slopes) row.slope = drag * row.n * row.n.transpose();
        continue;
      }
      const double y_n = row.n.dot(row.lambda - d * u) + d * row.target;
      const double most = row.block->kind == Block::Kind::rub ? static_cast<double>(row.block->limit)
                                                              : std::numeric_limits<double>::infinity();
      const double f_n = std::clamp(y_n, row.block->kind == Block::Kind::rub ? -most : 0., most);
      row.f = f_n * row.n;
      if (slopes) row.slope = f_n == y_n ? M3(d * row.n * row.n.transpose()) : M3(M3::Zero());
      continue;
    }
    if (row.block->kind == Block::Kind::hold) {
      row.f = row.space * (row.lambda - d * u);
      if (slopes) row.slope = d * row.space;
      continue;
    }
    const V3& n = row.n;
    const V3 y = row.lambda - d * u;
    const double y_n = n.dot(y) + d * row.target, normal = std::max(y_n, 0.);
    const V3 y_t = y - n.dot(y) * n;
    const double length = y_t.norm();
    if (coupled) row.limit = static_cast<double>(row.block->friction) * normal;
    const bool slips = length > row.limit;
    row.f = normal * n + (slips ? V3(row.limit / length * y_t) : y_t);
    if (!slopes) continue;
    const M3 nn = n * n.transpose();
    row.slope = M3::Zero(), row.skewed = V3::Zero();
    if (y_n > 0) row.slope += d * nn;
    if (!slips)
      row.slope += d * (M3::Identity() - nn);
    else if (row.limit > 0)
      row.slope += d * row.limit / length * (M3::Identity() - nn - y_t * y_t.transpose() / (length * length));
    if (coupled && slips && normal > 0)
      row.skewed = d * static_cast<double>(row.block->friction) / length * y_t;
  }
}

void Direct::velocities_of_impulses() {
  push_.setZero();
  for (const Row& row : rows_) add_impulse(row, row.lambda, push_);
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(6 * k);
    v_.segment<6>(at) = free_.segment<6>(at) + inverses_[k] * push_.segment<6>(at);
    centre_.segment<6>(at) = v_.segment<6>(at) - loose_[k] * push_.segment<6>(at);
  }
}

// M (V - c) - J^T f
void Direct::fill_gradient() {
  gradient_.setZero();
  for (const Row& row : rows_) add_impulse(row, -row.f, gradient_);
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    const auto at = static_cast<Eigen::Index>(6 * k);
    gradient_.segment<6>(at) += masses_[k] * (v_.segment<6>(at) - centre_.segment<6>(at));
  }
}

// J_i^T slope J_k of two of its bodies, J = (1  turn); angular J = (0  1).
Direct::M6 Direct::part(const Row& row, const M3& turn, const M3& other) {
  M6 sum = M6::Zero();
  if (row.block->angular) {
    sum.bottomRightCorner<3, 3>() = row.slope;
    return sum;
  }
  const M3 turned = turn.transpose() * row.slope;
  sum << row.slope, row.slope * other, turned, turned * other;
  return sum;
}

// M - J^T df/dV, of the symmetric slopes.
void Direct::factor() {
  matrix_.clear();
  for (std::size_t k = 0; k < bodies_.size(); ++k) matrix_.diagonal(static_cast<int>(k)) = masses_[k];
  for (const Row& row : rows_) {
    if (row.slope.isZero(0)) continue;
    if (row.a >= 0) matrix_.diagonal(row.a / 6) += part(row, row.turn, row.turn);
    if (row.b >= 0) matrix_.diagonal(row.b / 6) += part(row, row.to_turn, row.to_turn);
    if (row.a < 0 || row.b < 0) continue;
    matrix_.at(row.where) -= matrix_.is_later(row.a / 6, row.b / 6) ? part(row, row.turn, row.to_turn)
                                                                    : part(row, row.to_turn, row.turn);
  }
  matrix_.factor();
  operations_ += row_operations(matrix_.work());
}

// The slope of the function along `way` at v; leaves its gradient there.
double Direct::slope_along(const Vector& way) {
  forces(v_, false);
  fill_gradient();
  return way.dot(gradient_);
}

// Newton's method; the function is convex, so along the step its slope rises, and a step is cut where it has
// passed the least value: to where the slope is a tenth of what it was.
void Direct::minimise() {
  double before = std::numeric_limits<double>::infinity();
  for (int step = 0; step < most_newton_steps && operations_ <= last_; ++step) {
    forces(v_, true);
    fill_gradient();
    factor();
    way_ = -gradient_;
    matrix_.solve(way_);
    start_ = v_;
    const double steepest = way_.dot(gradient_);
    v_ = start_ + way_;
    double share = 1, low = 0, low_slope = steepest, high = 1, high_slope = slope_along(way_);
    for (int cut = 0; cut < most_cuts && high_slope > 0 && low_slope < 0; ++cut) {
      const double at = std::abs(share == low ? low_slope : high_slope);
      if (at <= 0.1 * std::abs(steepest)) break;
      // Where the slope would be zero on a straight line, but not at the ends.
      const double guess = low - low_slope * (high - low) / (high_slope - low_slope),
                   room = 0.1 * (high - low);
      share = std::clamp(guess, low + room, high - room);
      v_ = start_ + share * way_;
      const double here = slope_along(way_);
      if (here > 0)
        high = share, high_slope = here;
      else
        low = share, low_slope = here;
    }
    // A step below the rounding, cut or not, is rounding; of bodies at rest that is what their impulses
    // leave.  So is a small one that gets no smaller.
    const double longest = way_.cwiseAbs().maxCoeff();
    if (longest <= rounding_ || (longest <= 4 * rounding_ && longest >= before) ||
        (longest <= 1e-10 * v_.cwiseAbs().maxCoeff() && (share == 1 || longest >= before / 2)))
      break;
    before = longest;
  }
  forces(v_, false);
}

// lambda <- f, or on from there by as much as the last two rounds tell, with r = f - lambda:
//   lambda <- f - (r.dr/dr.dr) df
// Bodies that slide on many faces at once share their loads in some way that the velocities hardly resist, or
// even ask for: a round leaves 1/(1 + D g) of an error there, where g is small or negative.  It would creep,
// or leave the solution in which mirrored loads are equal for one in which one side bears all.
// D. G. Anderson, J. ACM 12 (1965) 547, of depth one.
void Direct::take(bool extrapolated) {
  double along = 0, square = 0;
  for (const Row& row : rows_) {
    const V3 r = row.f - row.lambda, d = r - row.change;
    along += r.dot(d) / row.stiffness, square += d.squaredNorm() / row.stiffness;
  }
  const double share = extrapolated && square > 0 ? along / square : 0;
  for (Row& row : rows_) {
    const V3 way = row.f - row.before;
    row.before = row.f, row.change = row.f - row.lambda;
    row.lambda = row.f - share * way;
    row.limit = static_cast<double>(row.block->friction) * std::max(row.n.dot(row.lambda), 0.);
  }
}

// The velocity there that an impulse of 1 gives, at most.
double Direct::yielding(const Row& row) const {
  double sum = 0;
  const auto add = [&](int body, const M3& turn) {
    if (body < 0) return;
    const M6& inverse = inverses_[index(body / 6)];
    sum += inverse(0, 0) + (turn * inverse.bottomRightCorner<3, 3>() * turn.transpose()).norm();
  };
  add(row.a, row.turn), add(row.b, row.to_turn);
  return sum;
}

// Coulomb's law may have more than one solution, and what is at rest may have one in which it stays so and one in which it parts:
// the first is looked for first, from friction without limits.  From friction without impulses rounds come to the other,
// with much friction as with little.
bool Direct::begins_at_rest() const {
  const double fastest = free_.size() > 0 ? free_.cwiseAbs().maxCoeff() : 0;
  return std::all_of(rows_.begin(), rows_.end(), [&](const Row& row) {
    return row.lambda.isZero(0) && static_cast<double>(row.block->before.norm()) <= at_rest * fastest;
  });
}

double Direct::unsure() const {
  return std::max(2 * std::min(residual_, solved * allowed_), 64 * static_cast<double>(epsilon) * fastest_);
}

bool Direct::solve(std::vector<Block>& blocks, const std::vector<Body>& bodies, std::vector<Mover>& movers) {
  set_up(blocks, bodies, movers);
  const bool loops = holds_in_loops();
  if (loops) reconcile_biases();
  const bool rest = begins_at_rest();
  for (Row& row : rows_)
    row.limit = rest ? std::numeric_limits<double>::infinity()
                     : static_cast<double>(row.block->friction) * std::max(row.n.dot(row.lambda), 0.);
  double best = std::numeric_limits<double>::infinity();
  int best_round = 0, stiffenings = 0;
  double stiff = 1, lightest = std::numeric_limits<double>::infinity(), stiffness = 0, yields = 0;
  for (const int body : bodies_)
    if (const Mover& m = movers[index(body)]; m.inverse_mass > 0)
      lightest = std::min(lightest, 1 / static_cast<double>(m.inverse_mass));
  for (const Row& row : rows_)
    if (!row.block->angular)
      stiffness = std::max(stiffness, row.stiffness), yields = std::max(yields, yielding(row));
  const double stiff_limit = std::min(most_stiff, stiffest * lightest / stiffness);
  for (int round = 0;; ++round) {
    operations_ += static_cast<std::int64_t>(rows_.size());
    velocities_of_impulses();
    forces(v_, false);
    // What rounding leaves of V* + M^-1 J^T lambda.
    fastest_ = free_.size() > 0 ? free_.cwiseAbs().maxCoeff() : 0;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(6 * k);
      const Eigen::Matrix<double, 6, 1> size = inverses_[k].cwiseAbs() * push_.segment<6>(at).cwiseAbs();
      fastest_ = std::max(fastest_, size.maxCoeff());
    }
    rounding_ = double_epsilon * fastest_;
    allowed_ = 256 * std::max(double_epsilon, static_cast<double>(epsilon) / 64) * fastest_;
    residual_ = 0;
    for (const Row& row : rows_) {
      const V3 u = velocity(row, v_);
      // the violation, as the velocity that it takes to end it
      residual_ = std::max(residual_, ((row.f - row.lambda) / row.stiffness).norm());
      if (row.block->is_one_sided() && row.f.dot(row.n) > 0)
        residual_ = std::max(residual_, row.target - row.n.dot(u));
    }
    if (!v_.allFinite()) residual_ = std::numeric_limits<double>::infinity();
    if (round == 0 && residual_ > 4 * (free_.size() > 0 ? free_.cwiseAbs().maxCoeff() : 0)) {
      for (Row& row : rows_)
        row.lambda.setZero(), row.limit = 0;  // worse than nothing: the contacts have changed
      continue;
    }
    const bool helps = residual_ < best / 2;
    if (residual_ < best) {
      best = residual_, best_round = round;
      for (Row& row : rows_) row.best = row.lambda;
    }
    // Where rounds no longer help, what is left is rounding, or friction that has no solution.
    if (residual_ <= allowed_ || round == most_rounds || !(round < best_round + patience) ||
        (!helps && residual_ <= (stiffenings < tries ? 100 : solved) * allowed_) || operations_ > last_)
      break;
    // Four corners of a face, of which one presses less than it seems to, go on at a pace of the violation times the
    // stiffness, and bodies on long arms resist angular rows by more than their inertia.  Stiffer rows end both.  Where
    // those only add rounding, rows are as they were.
    const bool worse = stiff > 1 && residual_ > 4 * best;
    const bool stiffer = !helps && !worse && round > plain_rounds && stiffenings < most_stiffenings &&
                         stiff * stiffening <= stiff_limit;
    const bool softer = stiff > 1 && !helps && !stiffer;
    if (stiffer) ++stiffenings;
    if (stiffer || softer) best_round = round;
    if (softer) stiff = 1;
    if (stiffer) stiff *= stiffening;
    for (Row& row : rows_) row.stiffness *= stiff;
    if (round < plain_rounds || !couple(reach * best * stiffness * yields)) minimise();
    take(round > plain_rounds + 1 && !stiffer && !softer);
    // The next violation is measured by the rows as they were: stiff ones hide that they press what parts.
    for (Row& row : rows_) row.stiffness /= stiff;
  }
  if (!(residual_ <= best) || !std::isfinite(residual_)) {
    for (Row& row : rows_) row.lambda = row.best;
    velocities_of_impulses();
    residual_ = best;
  }
  if (loops && std::isfinite(residual_)) leave_out_balanced();
  for (Row& row : rows_) row.block->impulse = row.lambda.cast<Real>();
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    Mover& m = movers[index(bodies_[k])];
    m.v = v_.segment<3>(static_cast<Eigen::Index>(6 * k)).cast<Real>();
    m.w = v_.segment<3>(static_cast<Eigen::Index>(6 * k + 3)).cast<Real>();
  }
  return residual_ <= solved * allowed_;
}

}  // namespace cylon::engine::pile
