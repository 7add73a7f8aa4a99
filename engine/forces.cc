#include "engine/forces.h"

#include "engine/scratch.h"
#include "engine/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {

namespace {

// The bodies as the forces see them, and where their pushes go.
struct Scene {
  const std::vector<Body>& bodies;
  std::size_t count;  // the others are locked
  const Motion* motion;
  const Kinematics* kinematics;
  Load* load;
  Time time;
  const Vector3& gravity;
  Real power = 0;  // of the force at work [W]

  // A force at an arm from the reference point.
  void push(int body, const Vector3& arm, const Vector3& force) {
    if (body == fixed_world || bodies[index(body)].locked) return;
    load[index(body)].force += force;
    twist(body, arm.cross(force));
    power += force.dot(kinematics[index(body)].velocity);
  }
  // A force and its torque about the reference point.
  void wrench(int body, const Vector3& force, const Vector3& torque) {
    if (body == fixed_world || bodies[index(body)].locked) return;
    load[index(body)].force += force;
    twist(body, torque);
    power += force.dot(kinematics[index(body)].velocity);
  }
  void twist(int body, const Vector3& torque) {
    load[index(body)].torque += torque;
    power += torque.dot(kinematics[index(body)].angular_velocity);
  }
  // The centre of mass from the reference point, world axes.
  Vector3 centre(std::size_t i) const {
    return bodies[i].pinned || bodies[i].guide ? Vector3(kinematics[i].rotation * bodies[i].centre)
                                               : Vector3(Vector3::Zero());
  }
};

// A body's anchor: its arm from the reference point, where it is, and how fast it moves; seed eq. 65, 66 with
// the arm rotated (errata 8, 14).
struct End {
  Vector3 arm, place, velocity;
};

End end_of(const Scene& scene, int body, const Vector3& anchor) {
  if (body == fixed_world) return {Vector3::Zero(), anchor, Vector3::Zero()};
  const std::size_t i = index(body);
  const Kinematics& k = scene.kinematics[i];
  if (anchor.isZero(0)) return {Vector3::Zero(), scene.motion[i].position, k.velocity};
  const Vector3 arm = k.rotation * anchor;
  return {arm, scene.motion[i].position + arm, k.velocity + k.angular_velocity.cross(arm)};
}

void apply(const Spring& spring, Scene& scene) {
  const End a = end_of(scene, spring.body, spring.anchor);
  const End b = end_of(scene, spring.to, spring.to_anchor);
  const Vector3 d = b.place - a.place;
  Vector3 force = spring.stiffness * d;  // all of it where the rest length and the damping are zero
  if (spring.rest_length != 0 || spring.damping != 0) {
    const Real length = d.norm();
    if (length == 0) return;
    const Vector3 u = d / length;
    force =
        (spring.stiffness * (length - spring.rest_length) + spring.damping * u.dot(b.velocity - a.velocity)) *
        u;
  }
  scene.push(spring.body, a.arm, force);
  scene.push(spring.to, b.arm, -force);
}

// About the centre of mass: L_spin = L - r x m v, where the reference point is the pivot v = w x r.
Vector3 spin_momentum(const Scene& scene, std::size_t i) {
  const Vector3 arm = scene.centre(i);
  return scene.motion[i].angular_momentum -
         arm.cross(scene.bodies[i].mass * scene.kinematics[i].angular_velocity.cross(arm));
}

void apply(const Drag& drag, Scene& scene) {
  const std::size_t i = index(drag.body);
  const Kinematics& k = scene.kinematics[i];
  const Vector3 arm = scene.centre(i);
  if (drag.linear != 0) {
    scene.push(drag.body, arm, -drag.linear * (k.velocity + k.angular_velocity.cross(arm)));
  }
  if (drag.angular == 0 && drag.momentum == 0) return;
  scene.twist(drag.body, -drag.angular * k.angular_velocity - drag.momentum * spin_momentum(scene, i));
}

void apply(const Thrust& thrust, Scene& scene) {
  const std::size_t i = index(thrust.body);
  const Kinematics& k = scene.kinematics[i];
  const Vector3 arm = scene.centre(i);
  Vector3 force = k.rotation * thrust.force;
  if (thrust.mass_rate != 0) {
    const Vector3 exchanged =
        thrust.relative ? Vector3(k.velocity + k.angular_velocity.cross(arm) + k.rotation * thrust.exchanged)
                        : thrust.exchanged;
    force += thrust.mass_rate * exchanged;
  }
  scene.push(thrust.body, arm, force);
}

void apply(const Drive& drive, Scene& scene) {
  const Real phase =
      static_cast<Real>(std::fmod(static_cast<double>(drive.frequency) * scene.time, 2 * M_PI));
  scene.push(drive.body, scene.centre(index(drive.body)), drive.force * std::cos(phase));
}

void apply(const Attraction& pull, Scene& scene) {
  const std::size_t a = index(pull.body), b = index(pull.to);
  const Vector3 arm_a = scene.centre(a), arm_b = scene.centre(b);
  const Vector3 d = scene.motion[b].position + arm_b - scene.motion[a].position - arm_a;
  const Real distance = d.norm();
  if (distance == 0) return;
  const Vector3 force =
      pull.strength * scene.bodies[a].mass * scene.bodies[b].mass / (distance * distance * distance) * d;
  scene.push(pull.body, arm_a, force);
  scene.push(pull.to, arm_b, -force);
}

void apply(const Water& water, Scene& scene) {
  for (std::size_t i = 0; i < scene.count; ++i) {
    if (scene.bodies[i].locked) continue;
    const int body = static_cast<int>(i);
    const Kinematics& k = scene.kinematics[i];
    const Vector3 arm = scene.centre(i), centre = scene.motion[i].position + arm;
    const Vector3 velocity = k.velocity + k.angular_velocity.cross(arm);
    if (water.mode == WaterMode::step) {
      if (!water.under(i, scene.time, centre)) continue;
      scene.push(body, arm, water.buoyancy * Vector3::UnitY() - water.drag * velocity);
      scene.twist(body, -spin_momentum(scene, i));
      continue;
    }
    const Submerged part =
        submerged(water.shapes[i], scene.motion[i].position, k.rotation, water.surface(scene.time, centre));
    if (part.volume <= 0) continue;
    scene.push(body, part.centroid - scene.motion[i].position, -water.buoyancy * part.volume * scene.gravity);
    scene.push(body, arm, -water.drag * part.volume / part.whole * velocity);
  }
}

// Summed over a body: m its mass, c its centre from the reference point at r, J its second moments about that, w its
// spin; with  A(v) = a + 2 W x v + W' x r + W x (W x r)  and  sum dm x (x.W) = (tr(J)/2 - J) W  over its arms x,
//   F      = -m (A(v) + 2 W x (w x c) + W' x c + W x (W x c))
//   torque = -m c x A(v) + (J W) x W + 2 (J W) x w - tr(J) W x w - J W'
void apply(const FrameForce& frame, Scene& scene) {
  const Real phase =
      static_cast<Real>(std::fmod(static_cast<double>(frame.frequency) * scene.time, 2 * M_PI));
  const Vector3 push = std::cos(phase) * frame.acceleration, &faster = frame.angular_acceleration;
  const Vector3 turn = frame.turning(scene.time);
  const auto of_place = [&](const Vector3& r) {
    return Vector3(faster.cross(r) + turn.cross(turn.cross(r)));
  };
  for (std::size_t i = 0; i < scene.count; ++i) {
    const Body& body = scene.bodies[i];
    if (body.locked) continue;
    const Kinematics& k = scene.kinematics[i];
    const Vector3 c = scene.centre(i), &spin = k.angular_velocity;
    const Vector3 at_point = push + 2 * turn.cross(k.velocity) + of_place(scene.motion[i].position);
    const Vector3 of_arm = 2 * turn.cross(spin.cross(c)) + of_place(c);
    Vector3 torque = -body.mass * c.cross(at_point);
    if (frame.turns()) {
      const Matrix3 inertia = k.rotation * body.inertia * k.rotation.transpose();
      const Vector3 along = inertia * turn;
      torque +=
          along.cross(turn) + 2 * along.cross(spin) - inertia.trace() * turn.cross(spin) - inertia * faster;
    }
    scene.wrench(static_cast<int>(i), -body.mass * (at_point + of_arm), torque);
  }
}

void apply(const CoordinateLaw& law, Scene& scene) {
  if (law.held) return;
  const JointEnd a = end_of(law.at.body, law.at.anchor, scene.motion, scene.kinematics);
  const JointEnd b = end_of(law.at.to, law.at.to_anchor, scene.motion, scene.kinematics);
  const Row row = row_of(law.at, a, b);
  const Real rate = rate_of(row, scene.kinematics);
  const Target::Now target = law.target.at(scene.time);
  const Real force = law.force - law.stiffness * (row.offset - target.value) -
                     law.damping * (rate - target.rate) - law.quadratic_damping * rate * std::abs(rate);
  scene.wrench(row.body, force * row.direction, force * row.lever);
  scene.wrench(row.to, -force * row.direction, -force * row.to_lever);
}

void apply(const UserForce& user, Scene& scene) {
  if (!user.law) return;
  Scratch<SeenBody> seen;
  Scratch<Load> loads;
  for (const int body : user.bodies) {
    const std::size_t i = index(body);
    const Kinematics& k = scene.kinematics[i];
    const Vector3 arm = scene.centre(i);
    seen->push_back({scene.bodies[i].mass, scene.motion[i].position + arm, scene.motion[i].orientation,
                     k.velocity + k.angular_velocity.cross(arm), k.angular_velocity});
  }
  loads->assign(user.bodies.size(), Load{});
  user.law->apply(scene.time, *seen, *loads);
  for (std::size_t k = 0; k < user.bodies.size(); ++k) {
    const auto& [force, torque] = (*loads)[k];
    scene.wrench(user.bodies[k], force, torque + scene.centre(index(user.bodies[k])).cross(force));
  }
}

// ---- How fast a force alone can make bodies react -------------------------------------------------------

struct Rates {
  Real square = 0;   // k/m [1/s^2]
  Real damping = 0;  // c/m [1/s]
};

Real inverse_mass(const std::vector<Body>& bodies, int body) {
  return body == fixed_world ? Real(0) : bodies[index(body)].inverse_mass;
}
Real largest_inverse_moment(const Body& body) { return body.inverse_moments.maxCoeff(); }

Rates rates(const Spring& s, const std::vector<Body>& bodies) {
  const Real mobility = inverse_mass(bodies, s.body) + inverse_mass(bodies, s.to);
  return {s.stiffness * mobility, s.damping * mobility};
}
Rates rates(const Drag& d, const std::vector<Body>& bodies) {
  const Body& body = bodies[index(d.body)];
  return {0, std::max({d.linear * body.inverse_mass, d.angular * largest_inverse_moment(body), d.momentum})};
}
Rates rates(const Thrust&, const std::vector<Body>&) { return {}; }      // no more than the mass changes
Rates rates(const Drive&, const std::vector<Body>&) { return {}; }       // of time alone
Rates rates(const Attraction&, const std::vector<Body>&) { return {}; }  // as the distance is
Rates rates(const Water& w, const std::vector<Body>& bodies) {
  Real mobility = 0;
  for (const Body& body : bodies) mobility = std::max(mobility, body.inverse_mass);
  return {0, std::max(w.drag * mobility, w.mode == WaterMode::step ? Real(1) : Real(0))};
}

// Not known: steps of a pile, which ask for this, do not take them.
Rates rates(const UserForce&, const std::vector<Body>&) { return {}; }
// What Coriolis turns in a time, 2 W, an explicit step must resolve as it must a decay.
Rates rates(const FrameForce& frame, Time t) { return {0, 2 * frame.turning(t).norm()}; }

// No more than what the other joints of the bodies let the coordinate move: the axis of an angle is known in one
// of them.
Rates rates(const CoordinateLaw& law, const std::vector<Body>& bodies) {
  if (law.held) return {};
  const Coordinate& q = law.at;
  const auto end = [&](int body, bool carries) -> Real {
    if (body == fixed_world) return 0;
    const Body& b = bodies[index(body)];
    if (q.kind == Coordinate::Kind::displacement) return b.inverse_mass;
    return carries ? q.axis.dot(b.inverse_inertia * q.axis) : b.inverse_moments.minCoeff();
  };
  const Real mobility = end(q.body, q.on_body) + end(q.to, !q.on_body);
  return {law.stiffness * mobility, law.damping * mobility};
}

// Sums over the forces on each body.
class RateSums {
 public:
  RateSums(const std::vector<Body>& bodies, Time t) : bodies_(bodies), time_(t), rates_(bodies.size()) {}

  void add(const Spring& s) {
    const Real shared = s.body != fixed_world && s.to != fixed_world ? Real(2) : Real(1);
    add(s.body, s.anchor, shared * s.stiffness, shared * s.damping);
    add(s.to, s.to_anchor, shared * s.stiffness, shared * s.damping);
  }
  void add(const Drag& d) { rates_[index(d.body)].damping += rates(d, bodies_).damping; }
  void add(const Thrust&) {}
  void add(const Drive&) {}
  void add(const Attraction&) {}
  void add(const UserForce&) {}
  void add(const FrameForce& frame) {
    for (Rates& r : rates_) r.damping += rates(frame, time_).damping;
  }
  void add(const Water& w) {
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      if (!bodies_[i].locked) rates_[i].damping += rates(w, bodies_).damping;
  }
  void add(const CoordinateLaw& law) {
    if (law.held) return;
    const bool shared = law.at.body != fixed_world && law.at.to != fixed_world;
    const Real stiffness = (shared ? 2 : 1) * law.stiffness, damping = (shared ? 2 : 1) * law.damping;
    if (law.at.kind == Coordinate::Kind::displacement) {
      add(law.at.body, law.at.anchor, stiffness, damping);
      add(law.at.to, law.at.to_anchor, stiffness, damping);
      return;
    }
    for (const int body : {law.at.body, law.at.to}) {
      if (body == fixed_world || bodies_[index(body)].locked) continue;
      rates_[index(body)].square += stiffness * largest_inverse_moment(bodies_[index(body)]);
      rates_[index(body)].damping += damping * largest_inverse_moment(bodies_[index(body)]);
    }
  }
  const std::vector<Rates>& all() const { return rates_; }

 private:
  void add(int body, const Vector3& anchor, Real stiffness, Real damping) {
    if (body == fixed_world || bodies_[index(body)].locked) return;
    const Real mobility = bodies_[index(body)].inverse_mass +
                          anchor.squaredNorm() * largest_inverse_moment(bodies_[index(body)]);
    rates_[index(body)].square += stiffness * mobility;
    rates_[index(body)].damping += damping * mobility;
  }

  const std::vector<Body>& bodies_;
  Time time_;
  std::vector<Rates> rates_;
};

}  // namespace

void apply(const Forces& forces, Time time, const std::vector<Body>& bodies, std::size_t count,
           const Motion* motion, const Kinematics* kinematics, Load* load, Real* powers) {
  Scene scene{bodies, count, motion, kinematics, load, time, forces.gravity};
  const auto account = [&] {
    if (powers) *powers++ = scene.power;
    scene.power = 0;
  };
  const bool weight = !forces.gravity.isZero(0);
  for (std::size_t i = 0; i < count; ++i) {
    load[i] = {};
    if ((weight || bodies[i].gravity) && !bodies[i].locked) {
      scene.push(static_cast<int>(i), scene.centre(i),
                 bodies[i].mass * bodies[i].gravity.value_or(forces.gravity));
    }
  }
  account();
  each_force(forces, [&](const auto& force) { apply(force, scene), account(); });
}

Time Forces::next_kink(Time t) const {
  Time next = std::numeric_limits<Time>::infinity();
  for (const CoordinateLaw& law : coordinate_laws) next = std::min(next, law.target.next_kink(t));
  return next;
}

bool Forces::jumps_within(Time from, Time to) const {
  return std::ranges::any_of(coordinate_laws, [&](const CoordinateLaw& law) {
    return law.damping != 0 && law.target.next_kink(std::nextafter(from, -1)) <= to;
  });
}

bool Forces::jumps_in_space() const {
  return std::ranges::any_of(waters, [](const Water& water) { return water.mode == WaterMode::step; });
}

void Forces::start_turns() {
  for (CoordinateLaw& law : coordinate_laws) law.at.near = law.at.start.value_or(law.at.origin);
}

void Forces::read_turns(std::vector<Real>& turns) const {
  turns.clear();
  for (const CoordinateLaw& law : coordinate_laws) turns.push_back(law.at.near);
}

void Forces::follow_turns(const std::vector<Body>& bodies, const Motion* motion, Real h) {
  for (CoordinateLaw& law : coordinate_laws) {
    if (!law.counts_turns()) continue;
    law.at.near += h * speed_of(row_of(law.at, bodies, motion), bodies, motion);
    law.at.near = row_of(law.at, bodies, motion).offset;
  }
}

void Forces::start_piece(Time t) {
  for (CoordinateLaw& law : coordinate_laws) law.target.start_piece(t);
}

//   h = (sqrt(c^2 + 4 k/m) - c)/(k/m) = 4/(sqrt(c^2 + 4 k/m) + c),  c here per mass
StepLimit longest_step(const Forces& forces, const std::vector<Body>& bodies, Time t) {
  StepLimit limit{std::numeric_limits<Real>::infinity(), ""};
  each_force(forces, [&](const auto& force) {
    Rates r;
    if constexpr (std::is_same_v<std::decay_t<decltype(force)>, FrameForce>)
      r = rates(force, t);
    else
      r = rates(force, bodies);
    const Real step = 4 / (std::sqrt(r.damping * r.damping + 4 * r.square) + r.damping);
    if (step < limit.step) limit = {step, force.one};
  });
  return limit;
}

//   h = 2/(sqrt(c^2 + 4 k) + c)
Real steady_step(const Forces& forces, const std::vector<Body>& bodies, Time t) {
  RateSums sums(bodies, t);
  each_force(forces, [&](const auto& force) { sums.add(force); });
  Real least = std::numeric_limits<Real>::infinity();
  for (const Rates& r : sums.all())
    least = std::min(least, 2 / (std::sqrt(r.damping * r.damping + 4 * r.square) + r.damping));
  return least;
}

}  // namespace cylon::engine
