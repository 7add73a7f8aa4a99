// Joints, and initial velocities that they allow.
#include "harness/core/joint_coordinates.h"
#include "harness/scenario/read_element.h"

#include <fmt/format.h>

#include <cmath>
#include <set>
#include <string>

namespace cylon::scenario {
namespace {

using core::Vector3;

// Velocities are compared within this fraction of the speeds involved: what six typed digits leave.
constexpr double typed = 1e-6;

// Velocity of the point of a body (or of the world) that is at `point` now: v + w x (point - p).
Vector3 velocity_at(const core::Scene& scene, int body, const Vector3& point) {
  if (body == core::world) return Vector3::Zero();
  const core::BodyState& s = scene.bodies[static_cast<std::size_t>(body)].initial;
  return s.velocity + s.angular_velocity.cross(point - s.position);
}

// Of what velocity_at adds up, which may be the rounding of much more than it comes to.
double speed_at(const core::Scene& scene, int body, const Vector3& point) {
  if (body == core::world) return 0;
  const core::BodyState& s = scene.bodies[static_cast<std::size_t>(body)].initial;
  return s.velocity.norm() + s.angular_velocity.norm() * (point - s.position).norm();
}

// What rounding makes of the fastest motion of a scene: as little of any other is no speed.  A turn moves what is a radius
// of gyration away; a speed is as much of a turn as it is at the largest such radius, so that a needle loosens no other.
constexpr double rounding = 1e-14;
double gyration(const core::Body& body) {
  return body.mass > 0 ? std::sqrt(body.inertia.trace() / (2 * body.mass)) : 0;
}
struct Fastest {
  double speed = 0, spin = 0;  // [m/s], [rad/s]
};
Fastest fastest(const core::Scene& scene) {
  Fastest most;
  double speed = 0, radius = 0;
  for (const core::Body& body : scene.bodies) {
    const double v = body.initial.velocity.norm(), w = body.initial.angular_velocity.norm(),
                 r = gyration(body);
    speed = std::max(speed, v), radius = std::max(radius, r);
    most.speed = std::max(most.speed, v + r * w), most.spin = std::max(most.spin, w);
  }
  if (radius > 0) most.spin += speed / radius;
  return most;
}

Vector3 spin_of(const core::Scene& scene, int body) {
  return body == core::world ? Vector3::Zero()
                             : scene.bodies[static_cast<std::size_t>(body)].initial.angular_velocity;
}

void check_velocity(const Table& t, Draft& draft, const core::Joint& joint, const Vector3& from,
                    const Vector3& end) {
  core::BodyState& s = draft.scene.bodies[static_cast<std::size_t>(joint.body)].initial;
  const Table& origin = draft.origin[static_cast<std::size_t>(joint.body)];
  const core::RelativeMotion motion{
      velocity_at(draft.scene, joint.body, from) - velocity_at(draft.scene, joint.to, end),
      s.angular_velocity - spin_of(draft.scene, joint.to)};
  const core::RelativeMotion forbidden = core::forbidden(joint, from - end, motion);
  const Vector3& excess = forbidden.velocity;
  const double speeds = speed_at(draft.scene, joint.body, from) + speed_at(draft.scene, joint.to, end);
  const Vector3 consistent = s.velocity - excess;
  const Fastest most = fastest(draft.scene);
  if (excess.norm() > std::max(typed * speeds, rounding * most.speed))
    origin.fail("velocity", fmt::format("velocity = {} breaks the {} joint of '{}' by {} m/s; consistent: {}",
                                        written(s.velocity), t.text("type"), t.text("body"), excess.norm(),
                                        written(consistent)));
  // Digits that were not typed: the joint of one body with the world decides them.
  if (joint.to == core::world && excess.norm() > 1e-12 * speeds) s.velocity = consistent;

  const Vector3& twist = forbidden.spin;
  const double spins = s.angular_velocity.norm() + spin_of(draft.scene, joint.to).norm();
  if (twist.norm() > std::max(typed * spins, rounding * most.spin))
    origin.fail("angular_velocity",
                fmt::format("angular_velocity = {} breaks the {} joint of '{}' by {} rad/s; consistent: {}",
                            written(s.angular_velocity), t.text("type"), t.text("body"), twist.norm(),
                            written(s.angular_velocity - twist)));
}

void refuse(const Table& t, std::initializer_list<const char*> keys, bool when, const char* why) {
  for (const char* key : keys)
    if (when && t.has(key)) t.fail(key, fmt::format("{} {}", key, why));
}

// Of `target_times` and `target_values`.
void check_table(const Table& t, const core::JointCoordinate& c) {
  if (t.has("target_times") != t.has("target_values"))
    t.fail(t.has("target_times") ? "target_times" : "target_values",
           "target_times and target_values belong together");
  if (!t.has("target_times")) return;
  if (c.target_times.size() < 2 || c.target_times.size() != c.target_values.size())
    t.fail("target_values", fmt::format("{} target_values for {} target_times: two at least, and as many",
                                        c.target_values.size(), c.target_times.size()));
  for (std::size_t k = 1; k < c.target_times.size(); ++k)
    if (!(c.target_times[k - 1] < c.target_times[k]))
      t.fail("target_times", fmt::format("target_times[{}] = {}: must be later than {}", k, c.target_times[k],
                                         c.target_times[k - 1]));
}

// A coordinate must be one that the joint leaves free, said once, and every key must do something.
template <class Coordinate>
void check_coordinates(const Table& t, const std::vector<Coordinate>& coordinates, int count) {
  const std::vector<Table> tables = t.tables(core::Element<Coordinate>::name);
  std::set<core::Ordinal> seen;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const Table& table = tables[i];
    const core::JointCoordinate& c = coordinates[i];
    const std::string_view which = core::Words<core::Ordinal>::list[static_cast<std::size_t>(c.which)];
    if (static_cast<int>(c.which) >= count)
      table.fail("which", fmt::format("which = \"{}\", but a {} joint has {} {}{}", which, t.text("type"),
                                      count == 1 ? "one" : "two", core::Element<Coordinate>::name,
                                      count == 1 ? "" : "s"));
    if (!seen.insert(c.which).second)
      table.fail("which", fmt::format("the {} {} is stated twice", which, core::Element<Coordinate>::name));
    const double lower = c.lower.value_or(-HUGE_VAL), upper = c.upper.value_or(HUGE_VAL);
    if (!(lower < upper)) table.fail("upper", fmt::format("upper = {}: must be > lower = {}", upper, lower));
    if (!(lower <= c.start && c.start <= upper))
      table.fail("start", fmt::format("start = {}: outside of the limits {} and {}", c.start, lower, upper));
    refuse(table, {"restitution"}, !core::has_limit(c), "belongs to 'lower' and 'upper'");
    refuse(
        table,
        {"target", "target_amplitude", "target_frequency", "target_phase", "target_times", "target_values"},
        c.stiffness == 0 && c.damping == 0, "belongs to 'stiffness' and 'damping'");
    refuse(table, {"target", "target_amplitude", "target_frequency", "target_phase"},
           table.has("target_times"), "does not go with 'target_times'");
    refuse(table, {"target_frequency", "target_phase"}, !table.has("target_amplitude"),
           "belongs to 'target_amplitude'");
    check_table(table, c);
  }
}

core::Joint read_joint(const Table& t, Draft& draft) {
  auto joint = read_element<core::Joint>(t, draft);
  if (joint.to == joint.body) t.fail("to", "a joint joins two different bodies, or one with the world");
  const core::JointKind& kind = core::kind_of(joint.type);
  const bool distance = kind.joins_centres();
  if (distance && t.has("point") && t.has("to"))
    t.fail("point", "point: a distance between two bodies joins their centres");
  if (distance && !t.has("point") && !t.has("to"))
    t.fail("a distance joint needs 'to' (a body) or 'point' (of the world)");
  if (kind.has_axis()) {
    if (!(joint.axis.cwiseAbs().maxCoeff() > 0)) t.fail("axis", "axis = [0, 0, 0] has no direction");
    make_unit(joint.axis);
  }
  if (kind.has_second_axis()) {
    Vector3& second = *joint.axis_2;
    if (!(second.cwiseAbs().maxCoeff() > 0)) t.fail("axis_2", "axis_2 = [0, 0, 0] has no direction");
    make_unit(second);
    const bool square = kind.has_square_axes();
    if (square ? std::abs(second.dot(joint.axis)) > typed : second.cross(joint.axis).norm() < typed)
      t.fail("axis_2", fmt::format("axis_2 = {} is {} to axis = {}", written(t.vector("axis_2")),
                                   square ? "not square" : "parallel", written(t.vector("axis"))));
    if (square) second = (second - second.dot(joint.axis) * joint.axis).normalized();
  }
  if (kind.has_length() && !distance && !(joint.length > 0))
    t.fail("length", "an offset universal joint needs a length > 0: without one it is a universal joint");
  if (kind.screws && joint.pitch == 0) t.fail("pitch", "pitch = 0: a screw without pitch is a hinge");
  check_coordinates(t, joint.displacements, kind.displacements());
  check_coordinates(t, joint.angles, kind.angles());

  const auto& bodies = draft.scene.bodies;
  Vector3 from = core::held_point_of_body(joint), end = from;
  if (distance) {
    from = bodies[static_cast<std::size_t>(joint.body)].initial.position;
    if (joint.to != core::world) end = bodies[static_cast<std::size_t>(joint.to)].initial.position;
    const double apart = (end - from).norm();
    if (!(apart > 0)) t.fail("a distance joint needs its two ends apart, but both start at " + written(from));
    joint.length = t.number("length", apart);
    if (std::abs(joint.length - apart) > 1e-9 * apart)
      t.fail("length", fmt::format("length = {}, but the ends start {} m apart", joint.length, apart));
  }
  check_velocity(t, draft, joint, from, end);
  return joint;
}

}  // namespace

void read_joints(const Table& root, Draft& draft) {
  std::set<std::string> names;
  for (const Table& t : root.tables("joint")) {
    draft.scene.joints.push_back(read_joint(t, draft));
    const std::string& name = draft.scene.joints.back().name;
    if (!name.empty() && !names.insert(name).second)
      t.fail("name", fmt::format("two joints are named '{}'", name));
  }
}

}  // namespace cylon::scenario
