#include "engine/bodies.h"

#include "engine/free_rotation.h"
#include "engine/joint.h"
#include "engine/turning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace cylon::engine {

Bodies::Bodies(Model model, bool account)
    : model_(std::move(model)), account_(account), masses_(model_.bodies), balanced_(model_) {
  const std::size_t n = model_.bodies.size();
  count_ = movable_end(model_.bodies);
  model_.forces.start_turns();
  for (std::size_t k = 0; k < model_.forces.coordinate_laws.size(); ++k)
    if (model_.forces.coordinate_laws[k].counts_turns()) turning_.push_back(k);
  angles_ = account_ ? model_.forces.count() : 0;
  extras_ = angles_ + turning_.size() + (masses_.any() ? 1 : 0);
  kinematics_.resize(n);
  loads_.resize(n);
  first_.resize(n);
  before_.resize(n);
  spin_.resize(n, 0);
  opened_ = upright_ = start_ = probe_ = model_.motions;
  powers_.resize(model_.forces.count());
  reads_velocities_ = model_.forces.read_velocities();
  affine_ = !any_force(model_.forces, [](const auto& force) {
    Features asked;
    force.add_features(asked);
    return !(asked & not_affine).empty();
  });
  rotors_ = std::ranges::any_of(model_.forces.coordinate_laws,
                                [](const CoordinateLaw& law) { return law.armature != 0; });
  int rows = 0;
  for (const Joint& joint : model_.joints) {
    rows += row_count(joint.type);
    arm_ = std::max({arm_, joint.anchor.norm(), joint.to == fixed_world ? 0 : joint.to_anchor.norm()});
  }
  rows_.rows.reserve(static_cast<std::size_t>(rows));
  change_.resize(static_cast<std::size_t>(rows));
  const std::vector<char> turning = bodies_that_turn(model_);
  for (std::size_t i = 0; i < n; ++i) model_.bodies[i].turns = turning[i] != 0;
  for (std::size_t i = count_; i < n; ++i) {
    kinematics_[i] = {rotation_matrix(model_.motions[i].orientation), Vector3::Zero(), Vector3::Zero()};
    length_ = std::max(length_, model_.motions[i].position.norm());
  }
  for (std::size_t w = 0; w < model_.forces.waters.size(); ++w) {
    if (model_.forces.waters[w].mode != WaterMode::step) continue;
    for (std::size_t i = 0; i < n; ++i) {
      if (!model_.bodies[i].locked) switches_.push_back({w, i});
    }
  }
}

// Height of a body's centre above a water surface.
Real Bodies::switch_value(std::size_t k, Time t, const Real* y) const {
  const Motion& motion = motions(y)[switches_[k].body];
  const Vector3 centre = motion.position + motion.orientation * model_.bodies[switches_[k].body].centre;
  return centre.y() - model_.forces.waters[switches_[k].water].surface(t, centre);
}

void Bodies::flip(std::size_t k) {
  char& inside = model_.forces.waters[switches_[k].water].inside[switches_[k].body];
  inside = inside ? 0 : 1;
}

void Bodies::watch(Time t, const Real* y) {
  for (std::size_t k = 0; k < switches_.size(); ++k) {
    std::vector<char>& inside = model_.forces.waters[switches_[k].water].inside;
    inside.resize(model_.bodies.size(), 0);
    inside[switches_[k].body] = switch_value(k, t, y) < 0;
  }
}

void Bodies::unwatch() {
  for (Water& water : model_.forces.waters) water.inside.clear();
}

std::vector<Real> Bodies::initial(Time start) const {
  std::vector<Real> y(extras_ + motion_size * model_.bodies.size(), 0);
  if (masses_.any()) y[extras_ - 1] = static_cast<Real>(start);
  std::copy(model_.motions.begin(), model_.motions.end(), motions(y.data()));
  for (std::size_t k = 0; k < turning_.size(); ++k)
    y[angles_ + k] = model_.forces.coordinate_laws[turning_[k]].at.near;
  count_turns(y.data());
  return y;
}

void Bodies::find_kinematics(const Motion* motion) {
  for (std::size_t i = 0; i < count_; ++i) {
    const Body& body = model_.bodies[i];
    Kinematics& k = kinematics_[i];
    k.velocity = velocity(body, motion[i]);
    k.rotation = rotation_matrix(motion[i].orientation);
    if (body.turns) {
      k.angular_velocity =
          k.rotation * (body.inverse_inertia * (k.rotation.transpose() * motion[i].angular_momentum));
    } else {
      k.angular_velocity.setZero();
    }
  }
}

void Bodies::find_loads(Time t, const Motion* motion, Real* powers) {
  now_ = t;
  apply(model_.forces, t, model_.bodies, count_, motion, kinematics_.data(), loads_.data(), powers);
  keep_what_moves();
}

// Of the loads on bodies with one axis or a guide.
void Bodies::keep_what_moves() {
  for (std::size_t i = 0; i < count_; ++i) {
    const Body& body = model_.bodies[i];
    if (body.one_axis) {
      const Vector3 axis = kinematics_[i].rotation * body.axis;
      loads_[i].torque = axis.dot(loads_[i].torque) * axis;
    }
    if (body.guide) loads_[i].force = *body.guide * loads_[i].force;
  }
}

void Bodies::load(Time t, const Real* y) {
  const Motion* motion = upright(y, false);
  set_turns(y);
  masses_.set(t, model_.bodies);
  find_kinematics(motion);
  find_loads(t, motion, nullptr);
}

// The conditions of joints, and the rows of what moves with them.
void Bodies::gather(const Motion* motion, bool rotors) {
  rows_.rows.clear();
  for (const Joint& joint : model_.joints) add_rows(joint, model_.bodies, motion, rows_.rows);
  if (rotors) add_rotor_rows(model_, motion, rows_.rows);
}

Real Bodies::weakest_alike(const Real* y) {
  const Motion* motion = upright(y, true);
  if (equals_.empty())
    for (Body body : model_.bodies) {
      const Real inverse = arm_ > 0 ? 1 / (arm_ * arm_) : Real(1);
      if (body.inverse_mass > 0) body.inverse_mass = 1;
      if (body.one_axis)
        body.inverse_inertia = inverse * body.axis * body.axis.transpose();
      else if (!body.locked)
        body.inverse_inertia = inverse * Matrix3::Identity();
      body.inverse_moments = body.one_axis ? Vector3(inverse, 0, 0) : Vector3(Vector3::Constant(inverse));
      equals_.push_back(body);
    }
  gather(motion);
  alike_.rows = rows_.rows;
  alike_.measure(equals_, motion);
  return alike_.weakest();
}

// The motions of all bodies, from a state that need not have those that are locked; `turned`: with unit
// quaternions.  The stages of an integrator leave them, and the rows of joints take them as such.
const Motion* Bodies::upright(const Real* y, bool turned) {
  const Motion* motion = motions(y);
  if (!turned && count_ == model_.bodies.size()) return motion;
  for (std::size_t i = 0; i < count_; ++i) {
    upright_[i] = motion[i];
    if (turned) upright_[i].orientation = motion[i].orientation.normalized();
  }
  return upright_.data();
}

// The same to be changed; close() puts the change back.
Motion* Bodies::open(Real* y) {
  if (count_ == model_.bodies.size()) return motions(y);
  std::copy_n(motions(y), count_, opened_.data());
  return opened_.data();
}

void Bodies::close(const Motion* motion, Real* y) {
  if (motion != motions(y)) std::copy_n(motion, count_, motions(y));
}

void Bodies::rates(Time t, const Real* y, Real* rate) {
  const Motion* motion = upright(y, holder_ || constrained());
  masses_.set(t, model_.bodies);
  set_turns(y);
  find_kinematics(motion);
  find_loads(t, motion, account_ ? rate : nullptr);
  for (std::size_t k = 0; k < turning_.size(); ++k)
    rate[angles_ + k] = rate_of(row_of(model_.forces.coordinate_laws[turning_[k]].at, model_.bodies, motion),
                                kinematics_.data());
  if (masses_.any()) rate[extras_ - 1] = 1;
  rate += extras_;
  if (holder_) {
    holder_->hold(t, model_.bodies, motion, kinematics_.data(), loads_.data());
    keep_what_moves();
  } else if (constrained()) {
    for (std::size_t i = 0; i < count_; ++i)
      pull_ = std::max(pull_, loads_[i].force.norm() / model_.bodies[i].mass);
    gather(motion, true);
    rows_.constrain_accelerations(model_.bodies, motion, kinematics_.data(), loads_.data());
    keep_what_moves();  // what joints bear among themselves grows without bound where they come to say the same
  }
  const bool turning = model_.frame.has_value();
  const Vector3 frame = turning ? model_.frame->angular_velocity : Vector3(Vector3::Zero());
  for (std::size_t i = 0; i < count_; ++i, rate += motion_size) {
    Eigen::Map<Vector3> dp(rate), dk(rate + 3), dl(rate + 10);
    Eigen::Map<Eigen::Matrix<Real, 4, 1>> dq(rate + 6);
    const Body& body = model_.bodies[i];
    if (body.locked) {
      dp.setZero(), dk.setZero(), dq.setZero(), dl.setZero();
      continue;
    }
    const Kinematics& k = kinematics_[i];
    dp = k.velocity;
    dk = body.pinned ? Vector3(Vector3::Zero()) : loads_[i].force;
    dq.setZero(), dl.setZero();
    if (body.turns) {
      const Vector3 half = (k.angular_velocity - frame) / 2;
      dq = (Quaternion(0, half.x(), half.y(), half.z()) * motion[i].orientation).coeffs();
      dl = loads_[i].torque;
    }
    if (turning) {
      dp -= frame.cross(motion[i].position);
      dk -= frame.cross(motion[i].momentum);
      dl -= frame.cross(motion[i].angular_momentum);
    }
  }
}

// K' = F, L' = torque with the configuration frozen.  Forces are affine in the momenta z,  z' = A z + b,  so
//   z(h) = z + sum_k h/(k+1)! (h A)^k f,   A u = f(z + u) - f(z),
// the exact flow; without forces that read velocities the first term is all.  With joints f is what they
// leave of the forces, P f:  the momenta that drag reads then never leave the joints.  (Forces that read none
// may push against them; the drift takes that back.)  Strong drag takes the flow in parts, each so short that
// the series ends: twice as many until it does.  Forces that are not affine are taken as they are at the start,
// which is of first order: only the strides of EventStepper, of first order too, take them so.
void Bodies::kick(Time t, Real h, Real* y) {
  Motion* motion = open(y);
  masses_.set(t, model_.bodies);
  set_turns(y);
  find_kinematics(motion);
  find_loads(t, motion, account_ ? powers_.data() : nullptr);
  const auto account = [&] {
    if (!account_) return;
    for (std::size_t i = 0; i < powers_.size(); ++i) y[i] += h / 2 * powers_[i];
  };
  account();
  if (holder_) {
    holder_->hold(t, model_.bodies, motion, kinematics_.data(), loads_.data());
    add_momenta(h, loads_, motion);
  } else if (!affine_ || (!reads_velocities_ && !rotors_)) {
    if (rotors_) {
      gather(motion, true);
      rows_.measure(model_.bodies, motion);
      rows_.project_loads(model_.bodies, loads_.data());
    }
    add_momenta(h, loads_, motion);
  } else {
    if (constrained()) {
      gather(motion, true);
      rows_.measure(model_.bodies, motion);
    }
    constexpr int most_halvings = 20;
    kicked_.assign(motion, motion + count_);
    int parts = 1;
    for (int halved = 0; halved <= most_halvings; ++halved, parts *= 2) {
      bool ends = true;
      for (int k = 0; k < parts && ends; ++k) {
        if (k > 0 || halved > 0) {
          find_kinematics(motion);
          find_loads(t, motion, nullptr);
        }
        ends = kick_by_series(t, h / static_cast<Real>(parts), motion);
      }
      if (ends) break;
      if (halved < most_halvings) {
        std::copy(kicked_.begin(), kicked_.end(), motion);
        continue;
      }
      // Not a number rather than a kick that stopped on its way.
      log_.note(DiagnosticKind::series_not_ended, t, parts);
      for (std::size_t i = 0; i < count_; ++i)
        motion[i].momentum.setConstant(std::numeric_limits<Real>::quiet_NaN());
    }
  }
  if (account_) {  // trapezoid: exact for forces that do not read velocities
    find_kinematics(motion);
    find_loads(t, motion, powers_.data());
    account();
  }
  close(motion, y);
}

void Bodies::add_momenta(Real factor, const std::vector<Load>& loads, Motion* motion) const {
  for (std::size_t i = 0; i < count_; ++i) {
    const Body& body = model_.bodies[i];
    if (body.locked) continue;
    if (!body.pinned) motion[i].momentum += factor * loads[i].force;
    if (body.turns) motion[i].angular_momentum += factor * loads[i].torque;
  }
}

// The series of kick(), from the loads at its start; false where it has not ended.
bool Bodies::kick_by_series(Time t, Real h, Motion* motion) {
  constexpr int terms = 12;
  const Real tiny = epsilon / 4;
  const auto project = [&] {
    if (constrained()) rows_.project_loads(model_.bodies, loads_.data());
  };
  // Forces and torques each against their own kind: in no unit is one of them small beside the other.  What is locked takes
  // reactions, and moves by none.
  const auto sizes = [&](const std::vector<Load>& loads) {
    std::array<Real, 2> largest = {0, 0};
    for (std::size_t i = 0; i < count_; ++i) {
      if (model_.bodies[i].locked) continue;
      largest[0] = std::max(largest[0], loads[i].force.lpNorm<Eigen::Infinity>());
      largest[1] = std::max(largest[1], loads[i].torque.lpNorm<Eigen::Infinity>());
    }
    return largest;
  };
  // Where joints take the whole of a load, what they leave is its rounding, of which no series ends: a term of rounding is
  // below 1/12! of it, 2e-9, and 64 sqrt(epsilon), 1e-6, is far above what that leaves to be resolved.
  const std::array<Real, 2> given = sizes(loads_);
  project();
  first_ = loads_;   // f(z)
  before_ = loads_;  // (h A)^k f
  std::copy_n(motion, count_, start_.data());
  std::copy_n(motion, count_, probe_.data());
  Real factor = h;
  std::array<Real, 2> whole = sizes(loads_);
  for (std::size_t kind = 0; kind < whole.size(); ++kind)
    whole[kind] = std::max(whole[kind], 64 * std::sqrt(epsilon) * given[kind]);
  add_momenta(factor, before_, motion);
  for (int k = 1; k < terms; ++k) {
    factor /= static_cast<Real>(k + 1);
    for (std::size_t i = 0; i < count_; ++i) {
      if (!model_.bodies[i].pinned) probe_[i].momentum = start_[i].momentum + h * before_[i].force;
      probe_[i].angular_momentum = start_[i].angular_momentum + h * before_[i].torque;
    }
    find_kinematics(probe_.data());
    find_loads(t, probe_.data(), nullptr);
    project();
    for (std::size_t i = 0; i < count_; ++i) {
      before_[i].force = loads_[i].force - first_[i].force;
      before_[i].torque = loads_[i].torque - first_[i].torque;
    }
    add_momenta(factor, before_, motion);
    const std::array<Real, 2> term = sizes(before_);
    const auto negligible = [&](std::size_t kind) {
      return std::abs(factor) * term[kind] <= tiny * std::abs(h) * whole[kind];
    };
    if (negligible(0) && negligible(1)) return true;
  }
  return false;
}

// Free motion: p along a line, R by the free rotation; seen from the turning frame, turned back.
void Bodies::free_drift(Real h, Real* y) {
  Motion* motion = motions(y);
  Real* clock = masses_.any() ? y + extras_ - 1 : nullptr;
  for (std::size_t i = 0; i < count_; ++i) {
    const Body& body = model_.bodies[i];
    Motion& m = motion[i];
    if (body.mass_rate != 0) {  // p' = K/m(t):  the integral of 1/m is ln(m_1/m_0)/m'
      const Real m0 = masses_.at_start(i) + *clock * body.mass_rate;
      m.position += std::log1p(h * body.mass_rate / m0) / body.mass_rate * m.momentum;
    } else {
      m.position += h * velocity(body, m);
    }
    if (body.turns) m.orientation = free_flow(body, m.orientation, m.angular_momentum, h);
  }
  if (masses_.any()) *clock += h;
  if (model_.frame) turn_frame(h, motion);
}

void Bodies::turn_frame(Real h, Motion* motion) {
  const Quaternion back = exponential(-h * model_.frame->angular_velocity);
  for (std::size_t i = 0; i < count_; ++i) {
    if (model_.bodies[i].locked) continue;
    Motion& m = motion[i];
    m.position = back * m.position;
    m.momentum = back * m.momentum;
    m.angular_momentum = back * m.angular_momentum;
    m.orientation = renormalised(back * m.orientation);
  }
}

// The turns made meanwhile are known by their mean rate, to less than half of one.
//
// With joints: SHAKE.  The momenta get impulses along the constraints at the start such that the drift ends
// on them,  c(q(h)) = 0;  Newton's method with the matrix of the start.  J.-P. Ryckaert, G. Ciccotti, H.
// Berendsen, J. Comput. Phys. 23 (1977) 327; H. Andersen, J. Comput. Phys. 52 (1983) 24 (RATTLE).
void Bodies::drift(Real h, Real* y) {
  const std::vector<Real> before = turn_rates(y);
  move(h, y);
  const std::vector<Real> after = turn_rates(y);
  for (std::size_t k = 0; k < turning_.size(); ++k) y[angles_ + k] += h * (before[k] + after[k]) / 2;
  count_turns(y);
}

void Bodies::move(Real h, Real* y) {
  if (!constrained() || holder_ || h == 0) return free_drift(h, y);
  constexpr int most = 60;
  std::copy_n(motions(y), count_, start_.data());
  const Real clock = masses_.any() ? y[extras_ - 1] : 0;
  gather(start_.data());
  rows_.measure(model_.bodies, start_.data());
  Rows reached;
  reached.rows.reserve(rows_.rows.size());
  bool closed = false;
  for (int i = 0; i < most; ++i) {
    std::copy_n(start_.data(), count_, motions(y));
    if (masses_.any()) y[extras_ - 1] = clock;
    free_drift(h, y);
    reached.rows.clear();
    const Motion* end = upright(y, false);
    for (const Joint& joint : model_.joints) add_rows(joint, model_.bodies, end, reached.rows);
    closed = reached.closed();
    if (closed) break;
    for (std::size_t k = 0; k < change_.size(); ++k) change_[k] = reached.rows[k].offset;
    rows_.push(change_, h, model_.bodies, start_.data());
  }
  // What the rounding of the iteration leaves is closed by project().
  if (const Real open = closed ? Real(0) : reached.opening(); open != 0)
    log_.note(DiagnosticKind::drift_open, now_, most, static_cast<double>(open));
  if (!reads_velocities_) return;  // else the kick must find momenta that the joints allow
  set_masses(y);
  Motion* motion = open(y);
  gather(motion);
  rows_.project_velocities(model_.bodies, motion);
  close(motion, y);
}

// Those of the instant of y: the stages of an integrator end elsewhere.
void Bodies::set_masses(const Real* y) {
  if (masses_.any()) masses_.set(static_cast<Time>(y[extras_ - 1]), model_.bodies);
}

void Bodies::project(Real* y) {
  set_masses(y);
  Motion* motion = open(y);
  project(motion);
  close(motion, y);
  count_turns(y);
}

void Bodies::project(Motion* motion) {
  for (std::size_t i = 0; i < count_; ++i) {
    if (!model_.bodies[i].turns) continue;
    Quaternion& q = motion[i].orientation;
    const Real error = q.squaredNorm() - 1;
    q = std::abs(error) < Real(1e-8) ? renormalised(q) : Quaternion(q.normalized());
  }
  if (holder_) return holder_->project(model_.bodies, motion);
  if (!constrained()) return;
  constexpr int sweeps = 4;  // of Newton's method: each leaves the square of a drift that is small already
  bool closed = false;
  for (int sweep = 0; sweep < sweeps && !closed; ++sweep) {
    gather(motion);
    closed = rows_.closed();
    if (!closed) rows_.project_positions(model_.bodies, motion);
  }
  gather(motion);
  if (const Real open = closed ? Real(0) : rows_.opening(); open != 0)
    log_.note(DiagnosticKind::joints_open, now_, sweeps, static_cast<double>(open));
  rows_.project_velocities(model_.bodies, motion);
}

// Positions against the largest distance from the origin so far, momenta of a body against its mass times the
// largest speed so far, quaternions against 1, spins against the body's inertia times the largest rate of
// turn so far; what has been zero always, against 1.
void Bodies::scales(const Real* y, Real* scale, Real tolerance) {
  const Motion* motion = motions(y);
  for (std::size_t i = 0; i < count_; ++i) {
    const Body& body = model_.bodies[i];
    length_ = std::max({length_, motion[i].position.norm(), body.centre.norm()});
    speed_ = std::max(speed_, velocity(body, motion[i]).norm());
    if (body.turns) turn_ = std::max(turn_, angular_velocity(body, motion[i]).norm());
    spin_[i] = std::max(spin_[i], motion[i].angular_momentum.norm());
  }
  // Joints that carry weight shake bodies at rest by the rounding of their forces, which no step makes
  // smooth: a speed is small against what gravity gives over the scene's length, sqrt(g L), not against
  // nothing.
  // So do other forces than gravity; what moves at more than the rounding of their speed is measured by
  // itself.
  Real at_rest = model_.joints.empty() ? 0 : std::sqrt(model_.strongest_gravity() * length_);
  const Real shaken = std::sqrt(epsilon * pull_ * length_);
  if (at_rest == 0 && speed_ > 0 && speed_ < shaken) at_rest = std::sqrt(pull_ * length_);
  // And what turns on a joint about its own centre moves by the rounding of its rim's speed alone, of which the sums of a
  // step leave less than a thousand units.
  const auto or_rounding_of = [](Real whole, Real x) { return x < 1000 * epsilon * whole ? whole : x; };
  const Real speed = balanced_.speed(or_rounding_of(turn_ * arm_, std::max(speed_, at_rest)), tolerance);
  const Real length = balanced_.length(or_rounding_of(arm_, length_), tolerance);
  const Real turn = std::max(turn_, length_ > 0 ? at_rest / length_ : 0);
  Real passed_on = 0;
  if (!model_.joints.empty())
    for (std::size_t i = 0; i < count_; ++i) passed_on = std::max(passed_on, 1000 * epsilon * spin_[i]);
  const auto or_one = [](Real x) { return x > 0 ? x : Real(1); };
  std::fill_n(scale, extras_, uncontrolled);  // works, turns and the clock are not controlled
  scale += extras_;
  for (std::size_t i = 0; i < count_; ++i, scale += motion_size) {
    const Body& body = model_.bodies[i];
    std::fill(scale, scale + 3, or_one(length));
    std::fill(scale + 3, scale + 6, or_one(body.mass * speed));
    std::fill(scale + 6, scale + 10, Real(1));
    const Real inertia = body.inertia.diagonal().maxCoeff();
    Real spin = spin_[i] > 0 ? std::max(spin_[i], inertia * (at_rest > 0 ? turn : 0)) : inertia * turn;
    // Forces that pass through the centre turn a body by the rounding of their torque, eps m v sqrt(I/m):
    // such a spin is measured by what the same momentum at the body's radius of gyration would be.
    const Real orbital = speed * std::sqrt(body.mass * inertia);
    if (spin < 1000 * epsilon * orbital) spin = orbital;
    // So do the torques of joints: they pass on what turns others, and balance on a body that they hold to the rounding
    // of those spins.
    if (spin < passed_on) spin = inertia * turn;
    std::fill(scale + 10, scale + 13, or_one(spin));
  }
}

}  // namespace cylon::engine
