#include "harness/core/joint_force.h"

#include "harness/core/anchor.h"
#include "harness/core/golden.h"
#include "harness/core/held_joint.h"
#include "harness/core/joint_coordinates.h"
#include "harness/core/loads.h"
#include "harness/core/recording.h"
#include "harness/core/worst.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

namespace cylon::core {
namespace {

std::size_t at(int body) { return static_cast<std::size_t>(body); }

bool moves(const Scene& scene, int body) { return body != world && !scene.bodies[at(body)].locked; }

bool asked(const Observable& q, const Scene& scene, std::size_t j) {
  if (q.joint) return at(*q.joint) == j;
  return moves(scene, scene.joints[j].body) || moves(scene, scene.joints[j].to);
}

Eigen::Vector4d entry(const Observable& q, const Vector3& force, const Vector3& torque) {
  const Vector3 v = only(q.quantity == Quantity::joint_torque ? torque : force, q.component);
  return {v.x(), v.y(), v.z(), 0};
}

// ---- What a joint alone holds ---------------------------------------------------------------------------

struct Hanging {
  std::vector<bool> has;  // by body
  double sign = 1;        // -1: it hangs on the joint's other end
};

constexpr const char *loop = "joints close a loop, so that the motion leaves its share open",
                     *touch = "contacts may bear what it holds";

// The bodies that hang on one end of the joint; why something else holds them too, or null.
const char* hang_on(const Scene& scene, std::size_t j, bool of_body, Hanging& part) {
  const Joint& joint = scene.joints[j];
  const int from = of_body ? joint.body : joint.to, beyond = of_body ? joint.to : joint.body;
  part.has.assign(scene.bodies.size(), false);
  part.sign = of_body ? 1 : -1;
  std::vector<int> open = {from};
  part.has[at(from)] = true;
  while (!open.empty()) {
    const int body = open.back();
    open.pop_back();
    for (std::size_t k = 0; k < scene.joints.size(); ++k) {
      const Joint& other = scene.joints[k];
      if (k == j || (other.body != body && other.to != body)) continue;
      const int next = other.body == body ? other.to : other.body;
      if (!moves(scene, next) || next == beyond) return loop;
      if (!part.has[at(next)]) open.push_back(next);
      part.has[at(next)] = true;
    }
  }
  const auto in = [&](int body) { return body != world && part.has[at(body)]; };
  if (any_touching_pair(scene, [&](const Pair& pair) { return in(pair.body) != in(pair.other); }))
    return touch;
  return nullptr;
}

// The part that the motion shows the joint to hold, or why there is none.
std::optional<std::string> find_part(const Scene& scene, std::size_t j, Hanging& part) {
  const Joint& joint = scene.joints[j];
  const bool first = moves(scene, joint.body), second = moves(scene, joint.to);
  if (!first && !second) return "neither of its ends can move";
  if (acted_on(joint)) return "something acts along its own coordinate";
  const char* of_first = first ? hang_on(scene, j, true, part) : loop;
  if (!of_first) return std::nullopt;
  const char* of_second = second ? hang_on(scene, j, false, part) : loop;
  if (!of_second) return std::nullopt;
  return of_first == touch ? of_first : of_second;  // a way to the ground is a loop on the other side alone
}

std::string named(const Scene& scene, std::size_t j) {
  const std::string& name = scene.joints[j].name;
  return name.empty() ? "joint " + std::to_string(j + 1) : "joint '" + name + "'";
}

// ---- Momenta of the part --------------------------------------------------------------------------------

class Held {
 public:
  Held(const Scene& scene, std::size_t j, const StateError& error)
      : scene_(scene), joint_(held_joint(scene, scene.joints[j])), error_(error) {
    if (const auto why = find_part(scene, j, part_)) throw std::logic_error(*why);
  }

  double sign() const { return part_.sign; }

  // p and L, as a load over a time [N s], [N m s].
  //   |dL| <= sum m (|x - o| |dv| + |v| (|dx| + |do|)) + I (|dw| + 2 |w| |dtheta|)
  Load momenta(const State& state) const {
    const Carried o = carried(state);
    Load sum;
    each(state, [&](const Body& body, const BodyState& s, std::size_t) {
      const Vector3 arm = s.position - o.point, p = body.mass * s.velocity;
      sum.force += p, sum.force_error += body.mass * error_.velocity;
      sum.torque += arm.cross(p) + world_inertia(body, s.orientation) * s.angular_velocity;
      sum.torque_error +=
          body.mass * (arm.norm() * error_.velocity + s.velocity.norm() * (error_.position + o.off)) +
          largest_moment(body) *
              (error_.angular_velocity + 2 * s.angular_velocity.norm() * error_.orientation);
    });
    return sum;
  }

  // F_a and M_a - v x p.
  Load applied(double t, const State& state) const {
    const Carried o = carried(state);
    const std::vector<Load> all = loads(scene_, t, state, error_);
    const Load momentum = momenta(state);
    Load sum;
    each(state, [&](const Body&, const BodyState& s, std::size_t i) {
      const Vector3 arm = s.position - o.point;
      sum.force += all[i].force, sum.force_error += all[i].force_error;
      sum.torque += all[i].torque + arm.cross(all[i].force);
      sum.torque_error += all[i].torque_error + arm.norm() * all[i].force_error +
                          all[i].force.norm() * (error_.position + o.off);
    });
    sum.torque -= o.velocity.cross(momentum.force);
    sum.torque_error += o.velocity.norm() * momentum.force_error + momentum.force.norm() * o.velocity_off;
    return sum;
  }

 private:
  // The joint's point, as `body` carries it.
  struct Carried {
    Vector3 point, velocity = Vector3::Zero();
    double off = 0, velocity_off = 0;
  };
  Carried carried(const State& state) const {
    Carried o{anchor(state, joint_.body, joint_.anchor)};
    if (!moves(scene_, joint_.body)) return o;
    const BodyState& s = state[at(joint_.body)];
    const double r = joint_.anchor.norm();
    o.velocity = s.velocity + s.angular_velocity.cross(s.orientation * joint_.anchor);
    o.off = error_.position + r * error_.orientation;
    o.velocity_off =
        error_.velocity + r * (error_.angular_velocity + s.angular_velocity.norm() * error_.orientation);
    return o;
  }

  template <class Use>
  void each(const State& state, Use use) const {
    for (std::size_t i = 0; i < state.size(); ++i)
      if (part_.has[i]) use(scene_.bodies[i], state[i], i);
  }

  const Scene& scene_;
  HeldJoint joint_;
  StateError error_;
  Hanging part_;
};

// ---- The step -------------------------------------------------------------------------------------------

struct Known {
  double time = 0, weight = 0;  // [s]; of the quadrature over the whole step, in steps
  State state;
};

// The motion at the ends of a step and at the nodes of Gauss and Legendre's rule of five points (exact to degree 9), of
// the whole step and of its halves.
struct Step {
  Step(const Truth& truth, double from, double h) : length(h) {
    first = {from, 0, truth.state(from)};
    last = {from + h, 0, truth.state(from + h)};
    constexpr std::array x = {0.0, 0.538469310105683091, 0.906179845938663993};
    constexpr std::array w = {0.284444444444444444, 0.239314335249683234, 0.118463442528094544};
    const auto add = [&](double begin, double size, std::vector<Known>& nodes) {
      for (const int i : {-2, -1, 0, 1, 2}) {
        const auto k = static_cast<std::size_t>(std::abs(i));
        const double t = begin + size * h * (1 + (i < 0 ? -x[k] : x[k])) / 2;
        nodes.push_back({t, size * w[k], truth.state(t)});
      }
    };
    add(from, 1, whole);
    add(from, 0.5, halves);
    add(from + h / 2, 0.5, halves);
  }
  double length;
  Known first, last;
  std::vector<Known> whole, halves;
};

Load mean(const Held& held, const std::vector<Known>& nodes) {
  Load sum;
  for (const Known& node : nodes) {
    const Load load = held.applied(node.time, node.state);
    sum.force += node.weight * load.force, sum.torque += node.weight * load.torque;
    sum.force_error += node.weight * load.force_error, sum.torque_error += node.weight * load.torque_error;
  }
  return sum;
}

Load exerted(const Held& held, const Step& step) {
  const Load before = held.momenta(step.first.state), now = held.momenta(step.last.state);
  const Load applied = mean(held, step.halves), rough = mean(held, step.whole);
  const double h = step.length;
  return {
      held.sign() * ((now.force - before.force) / h - applied.force),
      held.sign() * ((now.torque - before.torque) / h - applied.torque),
      (now.force_error + before.force_error) / h + applied.force_error + (applied.force - rough.force).norm(),
      (now.torque_error + before.torque_error) / h + applied.torque_error +
          (applied.torque - rough.torque).norm()};
}

std::vector<Held> all_held(const Observable& q, const Scene& scene, const StateError& error) {
  std::vector<Held> all;
  for (std::size_t j = 0; j < scene.joints.size(); ++j)
    if (asked(q, scene, j)) all.emplace_back(scene, j, error);
  return all;
}

RequiredForces required(const Observable& q, const std::vector<Held>& all, const Step& step) {
  RequiredForces result;
  for (const Held& held : all) {
    const Load load = exerted(held, step);
    result.values.push_back(entry(q, load.force, load.torque));
    result.error =
        worst(q.quantity == Quantity::joint_torque ? load.torque_error : load.force_error, result.error);
  }
  return result;
}

}  // namespace

std::optional<std::string> joint_force_undefined(const Observable& q, const Scene& scene) {
  if (auto why = loads_unknown(scene)) return why;
  bool found = false;
  Hanging part;
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    if (!asked(q, scene, j)) continue;
    found = true;
    if (const auto why = find_part(scene, j, part)) return "of " + named(scene, j) + ": " + *why;
  }
  if (!found) return "no joint of the scene has an end that can move";
  return std::nullopt;
}

std::optional<std::string> joint_force_untold(const Observable& q, const Scene& scene,
                                              const Recording& recording) {
  if (!recording.reactions) return "the engine tells no forces of joints";
  for (std::size_t j = 0; j < scene.joints.size(); ++j)
    if (asked(q, scene, j) && std::ranges::count(*recording.reactions, j, &Reaction::joint) != 1)
      return "the engine tells no force of " + named(scene, j) + " in the last step";
  return std::nullopt;
}

Values told_joint_forces(const Observable& q, const Scene& scene, const Recording& recording) {
  Values values;
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    if (!asked(q, scene, j)) continue;
    const Reaction& r = *std::ranges::find(*recording.reactions, j, &Reaction::joint);
    const HeldJoint joint = held_joint(scene, scene.joints[j]);
    const Vector3 point = anchor(recording.states.back(), joint.body, joint.anchor);
    values.push_back(
        entry(q, r.impulse / recording.dt, (r.moment + (r.point - point).cross(r.impulse)) / recording.dt));
  }
  return values;
}

RequiredForces required_joint_forces(const Observable& q, const Scene& scene, const Truth& truth, double end,
                                     double h) {
  return required(q, all_held(q, scene, truth.error), Step(truth, std::max(0.0, end - h), h));
}

// A force that turns within a part has no mean there, so that short ones are looked at too, at times that no period
// divides.
double largest_joint_force(const Observable& q, const Scene& scene, const Truth& truth, double until) {
  constexpr int parts = 256;
  const double instant = until / 65536;
  const std::vector<Held> all = all_held(q, scene, truth.error);
  double most = 0;
  const auto look = [&](double from, double span) {
    most = worst(magnitude(q, required(q, all, Step(truth, from, span)).values), most);
  };
  for (int i = 0; i < parts; ++i) {
    look(until * i / parts, until / parts);
    look((until - instant) * golden_part(i), instant);
  }
  return most;
}

}  // namespace cylon::core
