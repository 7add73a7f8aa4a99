// What acts along the coordinates of joints, as core/scene.h defines it:
//   Q = force - k (q - target(t)) - c (q' - target'(t)).
// A displacement is a function of the places.  An angle that a spring pulls at is a state of its own, with q' as its
// rate, and so counts whole turns.  A target that swings, A cos(f t + phase), is two states:  x' = -f y, y' = f x.
#include "harness/core/joint_coordinates.h"
#include "reference/certified/angle.h"
#include "reference/certified/builder.h"

namespace cylon::certified {
namespace {

struct End {
  const Motion* at = nullptr;     // now; absent: the world
  const Motion* start = nullptr;  // at t = 0
};

struct JointForces {
  const Builder& b;
  std::vector<Motion>& motions;
  std::vector<Extra>& extras;
  std::vector<Ball>& initial;

  End end(int body) const {
    if (body == core::world) return {};
    const auto i = static_cast<std::size_t>(body);
    return {&motions[i], &b.start[i]};
  }

  // A direction of the world at t = 0 as it is carried.
  Vector carried(const End& e, const core::Vector3& direction) const {
    const Vector world = b.vector(direction);
    return e.at ? e.at->rotation * (transposed(e.start->rotation) * world) : world;
  }
  Vector spin(const End& e) const { return e.at ? e.at->rotation * e.at->spin : b.zero(); }

  // Where a point is that was at `point` at t = 0.
  struct Place {
    Vector position, velocity;
  };
  Place place(const End& e, const core::Vector3& point) const {
    const Vector world = b.vector(point);
    if (!e.at) return {world, b.zero()};
    const Vector arm = transposed(e.start->rotation) * (world - e.start->position);
    return {e.at->position + e.at->rotation * arm, e.at->velocity + e.at->rotation * cross(e.at->spin, arm)};
  }

  Expr new_state(const Expr& start) {
    initial.push_back(b.graph.value(start.node));
    return {&b.graph, b.graph.state()};
  }

  // Q of a coordinate; `value` makes q, where it is needed.
  template <class Value>
  Expr law(const core::JointCoordinate& c, const Value& value, const Expr& rate) {
    Expr target = b.number(c.target), target_rate = b.exact(0);
    if (c.target_amplitude != 0 && (c.stiffness != 0 || c.damping != 0)) {
      // cos and sin of the phase, of the double as it stands.
      Ball cosine, sine;
      arb_sin_cos(sine.get(), cosine.get(), b.numbers(c.target_phase).get(), b.graph.bits());
      const Expr amplitude = b.number(c.target_amplitude), f = b.number(c.target_frequency);
      const Expr x0 = amplitude * Expr{&b.graph, b.graph.constant(cosine)},
                 y0 = amplitude * Expr{&b.graph, b.graph.constant(sine)};
      if (c.target_frequency == 0) {
        target = target + x0;
      } else {
        const Expr x = new_state(x0), y = new_state(y0);
        extras.push_back({-(f * y)});
        extras.push_back({f * x});
        target = target + x, target_rate = -(f * y);
      }
    }
    Expr q = b.number(c.force);
    if (c.stiffness != 0) q = q - b.number(c.stiffness) * (value() - target);
    if (c.damping != 0) q = q - b.number(c.damping) * (rate - target_rate);
    return q;
  }

  void add(const core::Joint& joint, const core::JointDisplacement& c) {
    const End body = end(joint.body), to = end(joint.to);
    const Vector n = carried(to, core::direction_of(joint, c.which));
    const Place a = place(body, joint.point), o = place(to, joint.point);
    const Vector d = a.position - o.position;
    const Expr rate = dot(n, a.velocity - o.velocity - cross(spin(to), d));
    const Vector force = law(
                             c, [&] { return b.number(c.start) + dot(n, d); }, rate) *
                         n;
    // Both at the point of `body`: the power is Q q'.
    push(joint.body, a.position, force);
    push(joint.to, a.position, -force);
  }

  void add(const core::Joint& joint, const core::JointAngle& c) {
    const End body = end(joint.body), to = end(joint.to);
    const Axes axes{.h = carried(to, joint.axis), .u = carried(body, joint.axis_2.value_or(joint.axis))};
    const Vector n = angle_direction(core::kind_of(joint.type), c.which, axes);
    const Expr rate = dot(n, spin(body) - spin(to));
    const auto angle = [&] {
      const Expr state = new_state(b.number(c.start));
      extras.push_back({rate});
      return state;
    };
    const Vector torque = law(c, angle, rate) * n;
    twist(joint.body, torque);
    twist(joint.to, -torque);
  }

  void push(int body, const Vector& at, const Vector& force) {
    if (body == core::world) return;
    Motion& m = motions[static_cast<std::size_t>(body)];
    m.force = m.force + force;
    m.torque = m.torque + transposed(m.rotation) * cross(at - m.position, force);
  }
  void twist(int body, const Vector& torque) {
    if (body == core::world) return;
    Motion& m = motions[static_cast<std::size_t>(body)];
    m.torque = m.torque + transposed(m.rotation) * torque;
  }
};

}  // namespace

void add_joint_forces(const Builder& b, std::vector<Motion>& motions, std::vector<Extra>& extras,
                      std::vector<Ball>& initial) {
  JointForces forces{b, motions, extras, initial};
  for (const core::Joint& joint : b.scene.joints) {
    for (const core::JointDisplacement& c : joint.displacements) forces.add(joint, c);
    for (const core::JointAngle& c : joint.angles) forces.add(joint, c);
  }
}

}  // namespace cylon::certified
