#include "reference/simulators/simbody/simbody_world.h"

#include "reference/applied/blas_threads.h"
#include "reference/applied/forces.h"

#include <type_traits>
#include <utility>
#include <vector>

namespace cylon::simulators {
namespace {

using core::JointType;
using core::Scene;
using SimTK::MobilizedBody;
using SimTK::Rotation;
using SimTK::Transform;
using SimTK::UnitVec3;
using SimTK::Vec3;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Entry by entry: Simbody's own conversion normalises.
Rotation rotation(const core::Quaternion& q) {
  const core::Matrix3 m = q.toRotationMatrix();
  return Rotation(
      SimTK::Mat33(m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)), true);
}

// The pose at the start; the world, and with it what is locked, is at the origin.
Transform pose(const Scene& scene, int body) {
  if (body == core::world || scene.bodies[at(body)].locked) return {};
  const core::BodyState& start = scene.bodies[at(body)].initial;
  return {rotation(start.orientation), to_simbody(start.position)};
}

SimTK::Body::Rigid rigid(const core::Body& body) {
  const core::Matrix3& i = body.inertia;
  return SimTK::Body::Rigid(SimTK::MassProperties(
      body.mass, Vec3(0), SimTK::Inertia(i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2))));
}

class Law : public SimTK::Force::Custom::Implementation {
 public:
  explicit Law(SimbodyLaw law) : law_(std::move(law)) {}
  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& on_bodies,
                 SimTK::Vector_<Vec3>& /*on_particles*/, SimTK::Vector& /*on_coordinates*/) const override {
    law_(state, on_bodies);
  }
  SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0; }

 private:
  SimbodyLaw law_;
};

}  // namespace

SimbodyWorld::SimbodyWorld(const Scene& scene, const applied::Forest& forest, SimbodyLaw law)
    : indices_(scene.bodies.size(), SimTK::GroundIndex) {
  applied::use_one_blas_thread();
  for (const int root : forest.roots) hang(scene, forest, root);
  if (const core::Vector3 gravity = core::gravity(scene); !gravity.isZero(0)) {
    SimTK::Force::Gravity falls(forces_, matter_, to_simbody(gravity));
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
      if (scene.bodies[i].gravity && !scene.bodies[i].locked)
        falls.setDefaultBodyIsExcluded(indices_[i], true);
  }
  if (law) SimTK::Force::Custom(forces_, new Law(std::move(law)));  // which the subsystem deletes
  for (const std::size_t j : forest.loops) close(scene, scene.joints[j]);
  system_.realizeTopology();
}

// ---- The tree -----------------------------------------------------------------------------------------

// The frame of a joint where the scene starts, in the world.  A body turns about z, slides along z or, of a slider, x, and
// in a plane along x and y; that of a ball, gimbal or weld is the world's.  Of a universal joint x is fixed in the parent, y
// in the child: the other way round if the joint is `reversed`.
Transform frame_of(const core::Joint& joint, bool reversed) {
  const Vec3 place = to_simbody(joint.point);
  const core::JointKind& kind = core::kind_of(joint.type);
  if (!kind.has_axis() || joint.type == JointType::gimbal) return Transform(place);
  const UnitVec3 axis(to_simbody(joint.axis));
  if (joint.type == JointType::slider) return {Rotation(axis, SimTK::XAxis), place};
  if (!joint.axis_2) return {Rotation(axis, SimTK::ZAxis), place};
  const UnitVec3 second(to_simbody(*joint.axis_2));
  if (joint.type == JointType::planar) return {Rotation(axis, SimTK::ZAxis, second, SimTK::XAxis), place};
  return {reversed ? Rotation(second, SimTK::XAxis, axis, SimTK::YAxis)
                   : Rotation(axis, SimTK::XAxis, second, SimTK::YAxis),
          place};
}

// The rates of a joint's coordinates, in Simbody's order, from the motion of the child against the parent at the point of
// the joint.
std::vector<double> rates_of(const core::Joint& joint, const Rotation& frame, const core::Vector3& spin,
                             const core::Vector3& velocity) {
  const auto along = [&](int k, const core::Vector3& v) { return SimTK::dot(frame.col(k), to_simbody(v)); };
  switch (joint.type) {
    case JointType::ball:
    case JointType::gimbal:  // of which the angles are counted
      return {spin.x(), spin.y(), spin.z()};
    case JointType::hinge:
    case JointType::screw:
      return {along(2, spin)};
    case JointType::slider:
      return {along(0, velocity)};
    case JointType::cylindrical:
      return {along(2, spin), along(2, velocity)};
    case JointType::planar:
      return {along(2, spin), along(0, velocity), along(1, velocity)};
    case JointType::universal:
      return {along(0, spin), along(1, spin)};
    case JointType::fixed:
    case JointType::distance:
    case JointType::rectangular:  // which simbody_settings.cc does not say it knows
    case JointType::offset_universal:
      return {};
  }
  return {};
}

SimTK::MobilizedBodyIndex hang_by(const core::Joint& joint, MobilizedBody& parent, const Transform& on_parent,
                                  const SimTK::Body::Rigid& mass, const Transform& on_body) {
  const auto by = [&]<class Kind>(std::type_identity<Kind>, auto... more) {
    return Kind(parent, on_parent, mass, on_body, more...).getMobilizedBodyIndex();
  };
  switch (joint.type) {
    case JointType::ball:
    case JointType::gimbal:  // of which the angles are counted
      return by(std::type_identity<MobilizedBody::Ball>());
    case JointType::hinge:
      return by(std::type_identity<MobilizedBody::Pin>());
    case JointType::slider:
      return by(std::type_identity<MobilizedBody::Slider>());
    case JointType::cylindrical:
      return by(std::type_identity<MobilizedBody::Cylinder>());
    case JointType::planar:
      return by(std::type_identity<MobilizedBody::Planar>());
    case JointType::universal:
      return by(std::type_identity<MobilizedBody::Universal>());
    case JointType::screw:
      return by(std::type_identity<MobilizedBody::Screw>(), joint.pitch);
    case JointType::fixed:
    case JointType::distance:
    case JointType::rectangular:  // which simbody_settings.cc does not say it knows
    case JointType::offset_universal:
      break;
  }
  return by(std::type_identity<MobilizedBody::Weld>());
}

// Of the material point of a body that is at `point`.
core::Vector3 velocity_at(const core::BodyState& body, const core::Vector3& point) {
  return body.velocity + body.angular_velocity.cross(point - body.position);
}

bool is_reversed(const core::Joint& joint, int child) { return joint.body != child; }

void SimbodyWorld::hang(const Scene& scene, const applied::Forest& forest, int body) {
  const applied::Node& node = forest.nodes[at(body)];
  const SimTK::Body::Rigid mass = rigid(scene.bodies[at(body)]);
  MobilizedBody& parent =
      node.parent == core::world ? matter_.updGround() : matter_.updMobilizedBody(indices_[at(node.parent)]);
  if (node.joint < 0) {
    indices_[at(body)] = MobilizedBody::Free(parent, mass).getMobilizedBodyIndex();
  } else {
    const core::Joint& joint = scene.joints[at(node.joint)];
    const Transform here = pose(scene, body);
    const Transform place = frame_of(joint, is_reversed(joint, body));
    const Transform on_parent = ~pose(scene, node.parent) * place, on_body = ~here * place;
    indices_[at(body)] = hang_by(joint, parent, on_parent, mass, on_body);
  }
  for (const int child : node.children) hang(scene, forest, child);
}

// ---- What closes loops --------------------------------------------------------------------------------

void SimbodyWorld::close(const Scene& scene, const core::Joint& joint) {
  using SimTK::Constraint;
  const auto mobilized = [&](int body) -> MobilizedBody& {
    return body == core::world ? matter_.updGround() : matter_.updMobilizedBody(indices_[at(body)]);
  };
  MobilizedBody &first = mobilized(joint.body), &second = mobilized(joint.to);
  if (core::kind_of(joint.type).joins_centres()) {
    const auto centre = [&](int body) {
      if (body == core::world) return to_simbody(joint.point);
      const core::Body& one = scene.bodies[at(body)];
      return one.locked ? to_simbody(one.initial.position) : Vec3(0);
    };
    Constraint::Rod(first, centre(joint.body), second, centre(joint.to), joint.length);
    return;
  }
  const Transform from_first = ~pose(scene, joint.body), from_second = ~pose(scene, joint.to);
  const Vec3 point = to_simbody(joint.point);
  if (joint.type == JointType::fixed) {
    const Transform place(point);
    Constraint::Weld(first, from_first * place, second, from_second * place);
    return;
  }
  Constraint::Ball(first, from_first * point, second, from_second * point);
  if (joint.type != JointType::hinge) return;
  // The axis in one body stays across two directions that lie across it in the other.
  const core::Vector3 across = joint.axis.unitOrthogonal();
  const UnitVec3 axis(from_first.R() * to_simbody(joint.axis));
  for (const core::Vector3& one : {across, core::Vector3(joint.axis.cross(across))})
    Constraint::ConstantAngle(first, axis, second, UnitVec3(from_second.R() * to_simbody(one)));
}

// ---- States -------------------------------------------------------------------------------------------

SimTK::State SimbodyWorld::start(const Scene& scene, const applied::Forest& forest) {
  SimTK::State state = system_.getDefaultState();
  system_.realizeModel(state);
  for (std::size_t i = 0; i < indices_.size(); ++i) {
    if (scene.bodies[i].locked) continue;
    const MobilizedBody& body = mobilized(i);
    const applied::Node& node = forest.nodes[i];
    const core::BodyState& start = scene.bodies[i].initial;
    if (node.joint < 0) {
      // Quaternion and place; angular velocity in world axes, and velocity.
      const core::Quaternion& q = start.orientation;
      const double coordinates[] = {
          q.w(), q.x(), q.y(), q.z(), start.position.x(), start.position.y(), start.position.z()};
      for (int k = 0; k < 7; ++k) body.setOneQ(state, k, coordinates[k]);
      for (int k = 0; k < 3; ++k)
        body.setOneU(state, k, start.angular_velocity[k]), body.setOneU(state, 3 + k, start.velocity[k]);
      continue;
    }
    const core::Joint& joint = scene.joints[at(node.joint)];
    core::Vector3 spin = start.angular_velocity, velocity = velocity_at(start, joint.point);
    if (node.parent != core::world) {
      const core::BodyState& parent = scene.bodies[at(node.parent)].initial;
      spin -= parent.angular_velocity, velocity -= velocity_at(parent, joint.point);
    }
    const Rotation frame = frame_of(joint, is_reversed(joint, static_cast<int>(i))).R();
    const std::vector<double> rates = rates_of(joint, frame, spin, velocity);
    for (std::size_t k = 0; k < rates.size(); ++k) body.setOneU(state, static_cast<int>(k), rates[k]);
  }
  return state;
}

void SimbodyWorld::set_mass(std::size_t body, double mass) {
  MobilizedBody& one = matter_.updMobilizedBody(indices_[body]);
  const SimTK::MassProperties& before = one.getDefaultMassProperties();
  one.setDefaultMassProperties(SimTK::MassProperties(mass, Vec3(0), before.getInertia()));
}

SimTK::State SimbodyWorld::moved(const SimTK::State& before) {
  SimTK::State state = system_.realizeTopology();
  system_.realizeModel(state);
  state.updTime() = before.getTime();
  state.updQ() = before.getQ();
  state.updU() = before.getU();
  return state;
}

}  // namespace cylon::simulators
