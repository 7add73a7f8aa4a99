#include "reference/certified/model.h"

#include "reference/certified/builder.h"

#include <algorithm>

namespace cylon::certified {
namespace {

using core::Scene;

// Inverse of a symmetric matrix by cofactors; a diagonal one stays diagonal.
Matrix inverse_of(const Matrix& m) {
  const Vector c0 = cross(m[1], m[2]), c1 = cross(m[2], m[0]), c2 = cross(m[0], m[1]);
  const Expr determinant = dot(m[0], c0);
  Matrix result = transposed({c0, c1, c2});
  for (Vector& row : result)
    for (Expr& x : row) x = x / determinant;
  return result;
}

bool is_joined(const Scene& scene, int body) {
  return std::ranges::any_of(scene.joints, [&](const core::Joint& j) {
    return !core::kind_of(j.type).joins_centres() && (j.body == body || j.to == body);
  });
}

bool is_pulled_off_centre(const Scene& scene, int body) {
  return std::ranges::any_of(scene.forces, [&](const core::Force& force) {
    const auto* spring = std::get_if<core::Spring>(&force);
    return spring && ((spring->body == body && !spring->anchor.isZero(0)) ||
                      (spring->to == body && !spring->to_anchor.isZero(0)));
  });
}

bool has_turning_frame(const Scene& scene) { return scene.frame && scene.frame->turns(); }

bool turns(const Scene& scene, int body) {
  const core::BodyState& s = scene.bodies[static_cast<std::size_t>(body)].initial;
  return !s.angular_velocity.isZero(0) || is_joined(scene, body) || is_pulled_off_centre(scene, body) ||
         has_turning_frame(scene);
}

Expr mass_of(const Builder& b, std::size_t body) {
  Expr mass = b.number(b.scene.bodies[body].mass);
  for (const core::Force& force : b.scene.forces)
    if (const auto* thrust = std::get_if<core::Thrust>(&force);
        thrust && static_cast<std::size_t>(thrust->body) == body && thrust->mass_rate != 0)
      mass = mass + b.number(thrust->mass_rate) * Expr{&b.graph, b.graph.time()};
  return mass;
}

// A joint that keeps a point of the body in what does not move; in a turning frame or with changing mass
// bodies keep their own centre.
int pin_of(const Scene& scene, int body) {
  const auto still = [&](int other) {
    return other == core::world || scene.bodies[static_cast<std::size_t>(other)].locked;
  };
  const bool varies = std::ranges::any_of(scene.forces, [&](const core::Force& force) {
    const auto* thrust = std::get_if<core::Thrust>(&force);
    return thrust && thrust->body == body && thrust->mass_rate != 0;
  });
  if (has_turning_frame(scene) || varies || still(body)) return -1;
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    const core::Joint& j = scene.joints[i];
    if (core::kind_of(j.type).place == core::JointPlace::together &&
        ((j.body == body && still(j.to)) || (j.to == body && still(j.body))))
      return static_cast<int>(i);
  }
  return -1;
}

// I + m (|c|^2 - c c^T) about a pivot from which c leads to the centre.
Matrix about_pivot(const Builder& b, const Frozen& f) {
  Matrix result = f.inertia;
  const Expr square = dot(f.arm, f.arm);
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c)
      result[r][c] = result[r][c] + f.mass * ((r == c ? square : b.exact(0)) - f.arm[r] * f.arm[c]);
  return result;
}

void freeze(Builder& b, std::size_t i) {
  const core::Body& body = b.scene.bodies[i];
  Frozen f;
  f.locked = body.locked;
  f.turns = !body.locked && turns(b.scene, static_cast<int>(i));
  f.mass = mass_of(b, i);
  const auto row = [&](int r) { return b.vector(body.inertia.row(r).transpose()); };
  f.inertia = {row(0), row(1), row(2)};
  f.inverse = f.turns ? inverse_of(f.inertia) : f.inertia;
  f.pin = pin_of(b.scene, static_cast<int>(i));
  b.bodies.push_back(f);
}

Motion motion_at_start(const Builder& b, std::size_t i) {
  const core::BodyState& s = b.scene.bodies[i].initial;
  Motion m;
  m.position = b.vector(s.position);
  m.velocity = b.bodies[i].locked ? b.zero() : b.vector(s.velocity);
  std::array<Expr, 4> q = {b.number(s.orientation.w()), b.number(s.orientation.x()),
                           b.number(s.orientation.y()), b.number(s.orientation.z())};
  const Expr norm = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  for (Expr& x : q) x = x / norm;
  m.orientation = q;
  m.rotation = rotation(q);
  m.spin = b.bodies[i].locked ? b.zero() : transposed(m.rotation) * b.vector(s.angular_velocity);
  return m;
}

void pin_at_start(Builder& b, std::size_t i) {
  Frozen& f = b.bodies[i];
  if (f.pin < 0) return;
  Motion& m = b.start[i];
  f.pivot = b.vector(b.scene.joints[static_cast<std::size_t>(f.pin)].point);
  f.arm = transposed(m.rotation) * (m.position - f.pivot);
  const Matrix inertia = about_pivot(b, f);
  const core::Joint& pin = b.scene.joints[static_cast<std::size_t>(f.pin)];
  f.one_axis = core::kind_of(pin.type).turns_about_axis();
  if (f.one_axis) {
    // About an axis a alone: w' = a (a . torque)/(a . I_p a), and so for whatever else pulls.
    const Vector a = transposed(m.rotation) * b.vector(pin.axis);
    const Expr moment = dot(a, inertia * a);
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) f.inverse[r][c] = a[r] * a[c] / moment;
    m.spin = (dot(a, m.spin) / dot(a, a)) * a;
  } else {
    f.inverse = inverse_of(inertia);
  }
  place_on_pin(f, m);
}

// Initial velocities without what the joints forbid.
void make_consistent(Builder& b) {
  std::vector<Vector> linear, angular;
  for (const Motion& m : b.start) linear.push_back(m.velocity), angular.push_back(m.spin);
  solve_joints(b, joint_rows(b, b.start), linear, angular, false);
  for (std::size_t i = 0; i < b.start.size(); ++i)
    b.start[i].velocity = linear[i], b.start[i].spin = angular[i];
  for (std::size_t i = 0; i < b.start.size(); ++i)
    if (b.bodies[i].pin >= 0) place_on_pin(b.bodies[i], b.start[i]);
}

template <std::size_t N>
void make_states(Graph& graph, std::array<Expr, N>& values, std::vector<Ball>& initial) {
  for (Expr& x : values) {
    initial.push_back(graph.value(x.node));
    x.node = graph.state();
  }
}

// States in the order p, v, q, w of each body; of a pinned one q, w.
std::vector<Motion> moving(const Builder& b, std::vector<Ball>& initial) {
  std::vector<Motion> motions = b.start;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    Motion& m = motions[i];
    m.force = m.torque = m.acceleration = m.turning = b.zero();
    if (b.bodies[i].locked) continue;
    const bool pinned = b.bodies[i].pin >= 0;
    if (!pinned) make_states(b.graph, m.position, initial), make_states(b.graph, m.velocity, initial);
    if (!b.bodies[i].turns) continue;
    make_states(b.graph, m.orientation, initial);
    make_states(b.graph, m.spin, initial);
    m.rotation = rotation(m.orientation);
    if (pinned) place_on_pin(b.bodies[i], m);
  }
  return motions;
}

// The frame's angular velocity  W = W_0 + W' t,  its change W' and the acceleration  a cos(f t)  of its origin.
struct FrameMotion {
  Vector turning, faster, push;
};

FrameMotion frame_motion(const Builder& b) {
  FrameMotion f{b.zero(), b.zero(), b.zero()};
  if (!b.scene.frame) return f;
  const core::Frame& frame = *b.scene.frame;
  f.turning = b.vector(frame.angular_velocity), f.faster = b.vector(frame.angular_acceleration);
  if (!frame.angular_acceleration.isZero(0))
    f.turning = f.turning + Expr{&b.graph, b.graph.time()} * f.faster;
  f.push = b.vector(frame.acceleration);
  if (frame.frequency != 0) f.push = Expr{&b.graph, b.graph.cosine(b.numbers(frame.frequency))} * f.push;
  return f;
}

// Newton and Euler, in the scene's frame: with W and W' the frame's angular velocity and its change in body axes, w' =
// I^-1 (torque - (w + W) x I (w + W)) + w x W - W' and v' = F/m - a - 2 W x v - W' x p - W x (W x p) in its own axes.
void accelerate(const Builder& b, std::vector<Motion>& motions) {
  const bool frame = has_turning_frame(b.scene), pushes = core::has_fictitious_forces(b.scene);
  const auto [w, faster, push] = frame_motion(b);
  for (std::size_t i = 0; i < motions.size(); ++i) {
    Motion& m = motions[i];
    const Frozen& f = b.bodies[i];
    if (f.locked) continue;
    if (f.pin >= 0) {  // about the pivot, I_p w' = torque + c x R^T F - w x I_p w
      Vector force = m.force;
      if (pushes) force = force - f.mass * push;
      const Vector torque = m.torque + cross(f.arm, transposed(m.rotation) * force);
      m.turning = f.inverse * (torque - cross(m.spin, about_pivot(b, f) * m.spin));
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k) m.acceleration[k] = m.force[k] / f.mass;
    if (pushes) m.acceleration = m.acceleration - push;
    if (frame)
      m.acceleration = m.acceleration - b.exact(2) * cross(w, m.velocity) - cross(faster, m.position) -
                       cross(w, cross(w, m.position));
    if (!f.turns) continue;
    const Vector body_frame = frame ? transposed(m.rotation) * w : b.zero();
    const Vector total = m.spin + body_frame;
    m.turning = f.inverse * (m.torque - cross(total, f.inertia * total)) + cross(m.spin, body_frame);
    if (frame) m.turning = m.turning - transposed(m.rotation) * faster;
  }
}

// q' = q (0, w)/2, w in body axes.
std::array<Expr, 4> quaternion_rate(const Builder& b, const Motion& m) {
  const auto& [w, x, y, z] = m.orientation;
  const Vector h = b.exact(0.5) * m.spin;
  return {-(x * h[0] + y * h[1] + z * h[2]), w * h[0] + y * h[2] - z * h[1], w * h[1] + z * h[0] - x * h[2],
          w * h[2] + x * h[1] - y * h[0]};
}

void start(Builder& b) {
  for (std::size_t i = 0; i < b.scene.bodies.size(); ++i) {
    freeze(b, i);
    b.start.push_back(motion_at_start(b, i));
    pin_at_start(b, i);
  }
  make_consistent(b);
}

Gram gram_of(const Scene& scene, slong bits, const Numbers& numbers) {
  Gram gram(bits);
  Builder b{scene, gram.graph, numbers, {}, {}};
  start(b);
  std::vector<Ball> initial;
  gram.entries = products(b, joint_rows(b, moving(b, initial)));
  return gram;
}

template <std::size_t N>
std::array<int, N> nodes(const std::array<Expr, N>& values) {
  std::array<int, N> result;
  std::ranges::transform(values, result.begin(), &Expr::node);
  return result;
}

}  // namespace

Vector centripetal(const Motion& m, const Vector& r) { return m.rotation * cross(m.spin, cross(m.spin, r)); }

void place_on_pin(const Frozen& f, Motion& m) {
  m.position = f.pivot + m.rotation * f.arm;
  m.velocity = m.rotation * cross(m.spin, f.arm);
}

// With q = (w, x, y, z): R = 1 + 2 (w [u] + [u]^2), u = (x, y, z).
Matrix rotation(const std::array<Expr, 4>& q) {
  const auto& [w, x, y, z] = q;
  const Expr one{w.graph, w.graph->constant(1)};
  const Expr xx = x * x, yy = y * y, zz = z * z, xy = x * y, xz = x * z, yz = y * z, wx = w * x, wy = w * y,
             wz = w * z;
  return {Vector{one - 2 * (yy + zz), 2 * (xy - wz), 2 * (xz + wy)},
          Vector{2 * (xy + wz), one - 2 * (xx + zz), 2 * (yz - wx)},
          Vector{2 * (xz - wy), 2 * (yz + wx), one - 2 * (xx + yy)}};
}

Model make_model(const Scene& scene, double horizon, slong bits, const Numbers& numbers, Blows blows) {
  check_domain(scene, horizon, blows);
  Model model{Graph(bits), {}, {}, {}, Gram(bits), {}};
  Builder b{scene, model.graph, numbers, {}, {}};
  start(b);
  if (std::ranges::all_of(b.bodies, &Frozen::locked)) refuse("no body moves");
  std::vector<Motion> motions = moving(b, model.initial);
  add_forces(b, motions);
  std::vector<Extra> extras;
  add_joint_forces(b, motions, extras, model.initial);
  accelerate(b, motions);

  std::vector<Vector> linear, angular;
  for (const Motion& m : motions) linear.push_back(m.acceleration), angular.push_back(m.turning);
  std::vector<Row> rows = joint_rows(b, motions);
  constexpr std::size_t few = 3;  // of one point: as they come they are as good, and cheaper
  if (rows.size() > few) {
    model.gram = gram_of(scene, bits, numbers);
    rows = combined(b, rows, model.combinations);
  }
  for (Row& row : rotor_rows(b, motions)) rows.push_back(std::move(row));
  solve_joints(b, rows, linear, angular, true);

  const auto changes = [&](const auto& rates) {
    for (const Expr& x : rates) model.graph.rates.push_back(x.node);
  };
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Motion& m = motions[i];
    if (!b.bodies[i].locked && b.bodies[i].pin < 0) changes(m.velocity), changes(linear[i]);
    if (b.bodies[i].turns) changes(quaternion_rate(b, m)), changes(angular[i]);
    model.bodies.push_back(
        {nodes(m.position), nodes(m.velocity), nodes(m.orientation), nodes(m.rotation * m.spin)});
  }
  for (const Extra& extra : extras) model.graph.rates.push_back(extra.rate.node);
  if (blows == Blows::described) add_contacts(b, motions, model.contacts);
  return model;
}

}  // namespace cylon::certified
