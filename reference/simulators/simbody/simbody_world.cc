#include "reference/simulators/simbody/simbody_world.h"

#include "reference/applied/forces.h"

#include <utility>

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
  const core::Vector3 gravity = core::gravity(scene);
  if (!gravity.isZero(0)) SimTK::Force::Gravity(forces_, matter_, to_simbody(gravity));
  if (law) SimTK::Force::Custom(forces_, new Law(std::move(law)));  // which the subsystem deletes
  for (const int root : forest.roots) hang(scene, forest, root);
  for (const std::size_t j : forest.loops) close(scene, scene.joints[j]);
  system_.realizeTopology();
}

// ---- The tree -----------------------------------------------------------------------------------------

// The frames of a joint agree where the scene starts; a hinge turns about their z, those of others are the world's.
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
    const Vec3 point = to_simbody(joint.point);
    const Transform place = joint.type == JointType::hinge
                                ? Transform(Rotation(UnitVec3(to_simbody(joint.axis)), SimTK::ZAxis), point)
                                : Transform(point);
    const Transform on_parent = ~pose(scene, node.parent) * place, on_body = ~here * place;
    if (joint.type == JointType::hinge)
      indices_[at(body)] = MobilizedBody::Pin(parent, on_parent, mass, on_body).getMobilizedBodyIndex();
    else if (joint.type == JointType::ball)
      indices_[at(body)] = MobilizedBody::Ball(parent, on_parent, mass, on_body).getMobilizedBodyIndex();
    else
      indices_[at(body)] = MobilizedBody::Weld(parent, on_parent, mass, on_body).getMobilizedBodyIndex();
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
    core::Vector3 spin = start.angular_velocity;
    if (node.parent != core::world) spin -= scene.bodies[at(node.parent)].initial.angular_velocity;
    if (node.joint < 0) {
      // Quaternion and place; angular velocity in world axes, and velocity.
      const core::Quaternion& q = start.orientation;
      const double coordinates[] = {
          q.w(), q.x(), q.y(), q.z(), start.position.x(), start.position.y(), start.position.z()};
      for (int k = 0; k < 7; ++k) body.setOneQ(state, k, coordinates[k]);
      for (int k = 0; k < 3; ++k)
        body.setOneU(state, k, spin[k]), body.setOneU(state, 3 + k, start.velocity[k]);
    } else if (scene.joints[at(node.joint)].type == JointType::hinge) {
      body.setOneU(state, 0, scene.joints[at(node.joint)].axis.dot(spin));
    } else if (scene.joints[at(node.joint)].type == JointType::ball) {
      for (int k = 0; k < 3; ++k) body.setOneU(state, k, spin[k]);
    }
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
