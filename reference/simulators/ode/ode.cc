// The adapter of ODE (Open Dynamics Engine), double precision: a Scene in, motion out.
// Sees the simulator interface and ODE's headers; never a scenario, a claim or another adapter.
#include "harness/core/collision_filter.h"
#include "harness/core/simulator.h"
#include "reference/applied/forces.h"
#include "reference/applied/masses.h"
#include "reference/simulators/ode/ode_limits.h"
#include "reference/simulators/ode/ode_settings.h"
#include "reference/simulators/ode/ode_shapes.h"
#include "reference/simulators/ode/ode_slip.h"
#include "reference/simulators/ode/ode_springs.h"
#include "reference/simulators/ode/ode_stops.h"
#include "reference/simulators/ode/ode_world.h"

#include <fmt/format.h>
#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace cylon::simulators {
namespace {

using core::Body;
using core::BodyState;
using core::Engine;
using core::Joint;
using core::JointType;
using core::Scene;
using core::Setup;
using core::State;
using core::Terms;
using core::Vector3;

static_assert(sizeof(dReal) == sizeof(double), "this adapter states double precision");

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// ---- The world -----------------------------------------------------------------------------------

// Whom a geom belongs to: a body of the scene, or one of its planes.
struct Owner {
  int body = core::world;
  int plane = -1;
};

struct Surface {
  double friction = 0, restitution = 0;
};

// A contact joint of the step, and what ODE tells of its force.
struct Touch {
  core::Contact contact;
  Vector3 normal = Vector3::Zero();  // ODE's, into the joint's first body
  bool turned = false;               // whether the contact's first body is the joint's second
  bool on_first = true;  // whether ODE's first geom has a body, to which the feedback then belongs
  dJointFeedback feedback{};
};

// A joint of the scene, and what ODE tells of its force.
struct Held {
  std::size_t joint = 0;
  bool on_first = true;  // whether the joint's first body is ODE's first
  dJointFeedback feedback{};
};

class Ode final : public core::Simulator {
 public:
  Ode() { Library::enter(); }

  const Engine& engine() const override { return engine_; }
  std::optional<std::string> unsupported(const Scene&, const Setup&) const override;
  Terms load(const Scene&, const Setup&) override;
  void step() override;
  void read(State&) const override;
  void keep_contacts(bool keep) override { keep_ = keep; }
  std::vector<core::Contact> contacts() const override { return contacts_; }
  std::optional<std::vector<core::Reaction>> reactions() const override { return reactions_; }

 private:
  void add_body(const Body&);
  void add_joint(std::size_t);
  void apply_forces();
  void apply_own_gravity();
  bool may_touch(const Owner&, const Owner&) const;
  void collide(dGeomID, dGeomID);
  void note_contacts();
  void note_reactions();
  const Surface& surface(const Owner&, const Owner&);
  dBodyID body(int i) const { return i == core::world ? nullptr : bodies_[at(i)]; }

  Engine engine_ = ode_engine(dODE_VERSION);
  OdeSettings settings_;
  Scene scene_;
  double dt_ = 0;
  std::int64_t steps_ = 0;
  State state_;  // before the step
  std::unique_ptr<World> world_;
  std::vector<dBodyID> bodies_;            // nullptr for a locked body
  std::optional<applied::Forces> forces_;  // of scene_, those that are no joints
  std::deque<Owner> owners_;               // geoms point at them
  std::unordered_map<std::uint64_t, Surface> surfaces_;
  std::optional<core::ContactRules> may_touch_;
  bool keep_ = false;          // feedback of the contacts of the next step
  std::deque<Touch> touches_;  // while it is kept; joints point at the feedback
  std::vector<core::Contact> contacts_;
  std::deque<Held> held_;  // joints of the scene; they point at the feedback
  std::vector<core::Reaction> reactions_;
};

// What the path "as-expert" looks at; the others look at nothing.
OdeKind ode_kind(const Scene& scene, const Setup& setup) {
  if (setup.path != "as-expert") return {};
  OdeKind kind{core::scene_kind(scene)};
  kind.stacked = kind.piles && ode_stacked(scene);
  return kind;
}

std::optional<std::string> Ode::unsupported(const Scene& scene, const Setup& setup) const {
  if (auto reason = applied::without_step("ODE", setup)) return reason;
  if (auto reason = ode_limit(scene)) return reason;
  return ode_settings(engine_, setup, ode_kind(scene, setup)).refused;
}

Terms Ode::load(const Scene& scene, const Setup& setup) {
  settings_ = ode_settings(engine_, setup, ode_kind(scene, setup));
  Library::enter();
  if (settings_.quick) dRandSetSeed(0);

  scene_ = scene, dt_ = setup.dt, steps_ = 0;
  may_touch_.emplace(scene_);
  bodies_.clear(), owners_.clear(), surfaces_.clear(), held_.clear();
  world_ = std::make_unique<World>();
  dWorldSetERP(world_->id, settings_.erp);
  dWorldSetCFM(world_->id, settings_.cfm);
  dWorldSetQuickStepNumIterations(world_->id, settings_.iterations);
  dWorldSetQuickStepW(world_->id, settings_.over_relaxation);
  dWorldSetDamping(world_->id, 0, 0);
  dWorldSetContactSurfaceLayer(world_->id, settings_.surface_layer);
  dWorldSetContactMaxCorrectingVel(world_->id, dInfinity);

  const Vector3 gravity = core::gravity(scene_);
  dWorldSetGravity(world_->id, gravity.x(), gravity.y(), gravity.z());

  for (const Body& body : scene_.bodies) add_body(body);
  for (std::size_t i = 0; i < scene_.planes.size(); ++i) {
    const core::Plane& plane = scene_.planes[i];
    owners_.push_back({core::world, static_cast<int>(i)});
    dGeomSetData(
        dCreatePlane(world_->space, plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.offset),
        &owners_.back());
  }
  for (std::size_t j = 0; j < scene_.joints.size(); ++j) add_joint(j);
  std::vector<std::size_t> soft_joints;
  for (std::size_t k = 0; k < scene_.forces.size(); ++k) {
    const auto* spring = std::get_if<core::Spring>(&scene_.forces[k]);
    if (!spring) continue;
    if (!settings_.all_springs && !(settings_.stiff_springs && ode_stiff(*spring, scene_, dt_))) continue;
    ode_add_spring(world_->id, *spring, scene_, bodies_, dt_);
    soft_joints.push_back(k);
  }
  forces_.emplace(scene_, soft_joints);

  return ode_terms(settings_);
}

// A locked body is geoms without a body: nothing can move it.
void Ode::add_body(const Body& body) {
  dBodyID id = nullptr;
  if (!body.locked) {
    const core::Matrix3& i = body.inertia;
    dMass mass;
    dMassSetParameters(&mass, body.mass, 0, 0, 0, i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2));
    id = dBodyCreate(world_->id);
    dBodySetMass(id, &mass);
    dBodySetAutoDisableFlag(id, 0);
    dBodySetGyroscopicMode(id, settings_.gyro ? 1 : 0);
    dBodySetFiniteRotationMode(id, settings_.finite_rotation ? 1 : 0);
    dBodySetGravityMode(id, body.gravity ? 0 : 1);  // its own is a force: apply_own_gravity
    const BodyState& s = body.initial;
    dBodySetPosition(id, s.position.x(), s.position.y(), s.position.z());
    const dQuaternion q = {s.orientation.w(), s.orientation.x(), s.orientation.y(), s.orientation.z()};
    dBodySetQuaternion(id, q);
    dBodySetLinearVel(id, s.velocity.x(), s.velocity.y(), s.velocity.z());
    dBodySetAngularVel(id, s.angular_velocity.x(), s.angular_velocity.y(), s.angular_velocity.z());
  }
  owners_.push_back({static_cast<int>(bodies_.size()), -1});
  bodies_.push_back(id);
  if (body.collide) ode_add_shape(world_->space, world_->surfaces, body, id, &owners_.back());
}

// The moving body comes first: ODE reverses a joint whose first body is the world.
void Ode::add_joint(std::size_t index) {
  const Joint& joint = scene_.joints[index];
  dBodyID a = body(joint.body), b = body(joint.to);
  if (!a && !b) return;  // both ends are locked
  const auto attach = [&](dJointID id) {
    a ? dJointAttach(id, a, b) : dJointAttach(id, b, nullptr);
    Held& held = held_.emplace_back();
    held.joint = index, held.on_first = a != nullptr;
    dJointSetFeedback(id, &held.feedback);
    return id;
  };
  const Vector3& p = joint.point;
  switch (joint.type) {
    case JointType::ball:
    case JointType::gimbal:  // of which the angles are counted
      dJointSetBallAnchor(attach(dJointCreateBall(world_->id, nullptr)), p.x(), p.y(), p.z());
      return;
    case JointType::hinge: {
      dJointID id = attach(dJointCreateHinge(world_->id, nullptr));
      dJointSetHingeAnchor(id, p.x(), p.y(), p.z());
      dJointSetHingeAxis(id, joint.axis.x(), joint.axis.y(), joint.axis.z());
      ode_limit_hinge(id, joint, a == nullptr, settings_.stop_erp);
      return;
    }
    case JointType::distance: {
      dJointID id = attach(dJointCreateDBall(world_->id, nullptr));
      Vector3 first = scene_.bodies[at(joint.body)].initial.position;
      Vector3 second = joint.to == core::world ? p : scene_.bodies[at(joint.to)].initial.position;
      if (!a) std::swap(first, second);
      dJointSetDBallAnchor1(id, first.x(), first.y(), first.z());
      dJointSetDBallAnchor2(id, second.x(), second.y(), second.z());
      dJointSetDBallDistance(id, joint.length);
      return;
    }
    case JointType::fixed:
      dJointSetFixed(attach(dJointCreateFixed(world_->id, nullptr)));
      return;
    case JointType::slider: {
      dJointID id = attach(dJointCreateSlider(world_->id, nullptr));
      dJointSetSliderAxis(id, joint.axis.x(), joint.axis.y(), joint.axis.z());
      ode_limit_slider(id, joint, a == nullptr, settings_.stop_erp);
      return;
    }
    case JointType::cylindrical: {
      dJointID id = attach(dJointCreatePiston(world_->id, nullptr));
      dJointSetPistonAnchor(id, p.x(), p.y(), p.z());
      dJointSetPistonAxis(id, joint.axis.x(), joint.axis.y(), joint.axis.z());
      ode_limit_piston(id, joint, a == nullptr, settings_.stop_erp);
      return;
    }
    case JointType::universal: {  // ODE's first axis is fixed in its first body
      dJointID id = attach(dJointCreateUniversal(world_->id, nullptr));
      const Vector3 &of_to = joint.axis, &of_body = *joint.axis_2;
      const Vector3 &first = a ? of_body : of_to, &second = a ? of_to : of_body;
      dJointSetUniversalAnchor(id, p.x(), p.y(), p.z());
      dJointSetUniversalAxis1(id, first.x(), first.y(), first.z());
      dJointSetUniversalAxis2(id, second.x(), second.y(), second.z());
      ode_limit_universal(id, joint, a == nullptr, settings_.stop_erp);
      return;
    }
    case JointType::planar:
    case JointType::screw:
    case JointType::rectangular:
    case JointType::offset_universal:
      break;
  }
  throw std::logic_error("ODE was asked for a joint that it does not say it knows");
}

// ---- A step --------------------------------------------------------------------------------------

// ODE holds a force over the step and then clears it.
void Ode::apply_forces() {
  if (!forces_->any()) return;
  read(state_);
  const std::vector<applied::Wrench>& wrenches = forces_->at(static_cast<double>(steps_) * dt_, state_);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i]) continue;
    const Vector3 &f = wrenches[i].force, &t = wrenches[i].torque;
    dBodyAddForce(bodies_[i], f.x(), f.y(), f.z());
    dBodyAddTorque(bodies_[i], t.x(), t.y(), t.z());
  }
  for (const std::size_t i : forces_->changing()) {
    dMass mass;
    dBodyGetMass(bodies_[i], &mass);
    mass.mass = forces_->mass(i);
    dBodySetMass(bodies_[i], &mass);
  }
}

// m g of the step's mass, as ODE adds the world's.
void Ode::apply_own_gravity() {
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const auto& own = scene_.bodies[i].gravity;
    if (!own || !bodies_[i]) continue;
    dMass mass;
    dBodyGetMass(bodies_[i], &mass);
    dBodyAddForce(bodies_[i], mass.mass * own->x(), mass.mass * own->y(), mass.mass * own->z());
  }
}

void Ode::step() {
  apply_forces();
  apply_own_gravity();
  dSpaceCollide(world_->space, this,
                [](void* me, dGeomID a, dGeomID b) { static_cast<Ode*>(me)->collide(a, b); });
  const int done = settings_.quick ? dWorldQuickStep(world_->id, dt_) : dWorldStep(world_->id, dt_);
  if (!done) throw std::runtime_error("ODE could not allocate memory for the step");
  if (keep_) note_contacts(), note_reactions();
  dJointGroupEmpty(world_->contacts);
  ++steps_;
}

// Neighbours on a joint do not, and groups and masks decide.  ODE's own category and collide bits ask for one of the
// two masks where the scene's rule asks for both (collision_kernel.cpp, collideAABBs), so they stay as they are.
bool Ode::may_touch(const Owner& a, const Owner& b) const {
  if (a.plane >= 0) return may_touch_->body_and_plane(b.body, a.plane);
  if (b.plane >= 0) return may_touch_->body_and_plane(a.body, b.plane);
  return may_touch_->bodies(a.body, b.body);
}

void Ode::collide(dGeomID a, dGeomID b) {
  dBodyID first = dGeomGetBody(a), second = dGeomGetBody(b);
  if (first == second) return;  // both fixed, or two parts of one body
  const Owner &owner = *static_cast<Owner*>(dGeomGetData(a)), &other = *static_cast<Owner*>(dGeomGetData(b));
  if (!may_touch(owner, other)) return;
  std::array<dContactGeom, ode_most_contacts> found;
  const int n = dCollide(a, b, settings_.contacts, found.data(), sizeof(dContactGeom));
  if (n == 0) return;
  const Surface& s = surface(owner, other);
  dContact contact{};
  contact.surface.mode = dContactBounce;
  if (settings_.coulomb) contact.surface.mode |= dContactApprox1;
  if (settings_.contact_cfm) contact.surface.mode |= dContactSoftCFM;
  contact.surface.soft_cfm = settings_.contact_cfm.value_or(0);
  if (settings_.contact_erp) contact.surface.mode |= dContactSoftERP;
  contact.surface.soft_erp = settings_.contact_erp.value_or(0);
  contact.surface.mu = s.friction;
  contact.surface.bounce = s.restitution;
  contact.surface.bounce_vel = settings_.bounce_velocity;
  for (int i = 0; i < n; ++i) {
    contact.geom = found[at(i)];
    if (settings_.along_slip) ode_turn_along_slip(contact, first, second);
    dJointID joint = dJointCreateContact(world_->id, world_->contacts, &contact);
    dJointAttach(joint, first, second);
    if (!keep_) continue;
    // ODE's normal points into the first geom.
    const Owner &one = *static_cast<Owner*>(dGeomGetData(a)), &two = *static_cast<Owner*>(dGeomGetData(b));
    const dContactGeom& geom = found[at(i)];
    Touch& touch = touches_.emplace_back();
    const bool turned = touch.turned = one.body == core::world;
    touch.contact.pair = {turned ? two.body : one.body, turned ? one.body : two.body,
                          turned ? one.plane : two.plane};
    touch.contact.point = {geom.pos[0], geom.pos[1], geom.pos[2]};
    touch.normal = {geom.normal[0], geom.normal[1], geom.normal[2]};
    touch.contact.normal = turned ? Vector3(-touch.normal) : touch.normal;
    touch.on_first = first != nullptr;
    dJointSetFeedback(joint, &touch.feedback);
  }
}

// The force along the normal and across it, over the step.  A joint whose first body is the world is turned round
// by ODE: the first place of its feedback is that of the one body that it has.
void Ode::note_contacts() {
  contacts_.clear();
  for (Touch& touch : touches_) {
    const dReal* f = touch.feedback.f1;
    const double sign = touch.on_first ? 1 : -1;
    const Vector3 on_first = sign * dt_ * Vector3(f[0], f[1], f[2]);
    const double impulse = touch.normal.dot(on_first);
    if (!(impulse > 0)) continue;
    touch.contact.impulse = impulse;
    const Vector3 across = on_first - impulse * touch.normal;
    touch.contact.friction = touch.turned ? Vector3(-across) : across;
    contacts_.push_back(touch.contact);
  }
  touches_.clear();
}

// The force on the joint's first body or, where that is locked, the opposite of the force on the second; the
// torque of the feedback is about the centre of mass of the body that ODE has first.
void Ode::note_reactions() {
  reactions_.clear();
  for (const Held& held : held_) {
    const Joint& joint = scene_.joints[held.joint];
    const dReal *f = held.feedback.f1, *t = held.feedback.t1;
    const dReal* x = dBodyGetPosition(body(held.on_first ? joint.body : joint.to));
    const double over = held.on_first ? dt_ : -dt_;
    reactions_.push_back(
        {held.joint, {x[0], x[1], x[2]}, over * Vector3(f[0], f[1], f[2]), over * Vector3(t[0], t[1], t[2])});
  }
}

// The pair's material; its names are compared once per pair, not once per contact.
const Surface& Ode::surface(const Owner& a, const Owner& b) {
  core::Pair pair = {std::min(a.body, b.body), std::max(a.body, b.body), std::max(a.plane, b.plane)};
  if (pair.plane >= 0) std::swap(pair.body, pair.other);
  const bool plane = pair.plane >= 0;
  const std::uint64_t key = static_cast<std::uint64_t>(pair.body) << 33 |
                            static_cast<std::uint64_t>(plane) << 32 |
                            static_cast<std::uint64_t>(plane ? pair.plane : pair.other);
  const auto [entry, is_new] = surfaces_.try_emplace(key);
  if (is_new) {
    const std::optional<core::Material> material = core::material_of(scene_, pair);
    if (material) entry->second = {material->friction, material->restitution};
  }
  return entry->second;
}

void Ode::read(State& out) const {
  const auto vector = [](const dReal* v) { return Vector3(v[0], v[1], v[2]); };
  out.resize(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const BodyState& start = scene_.bodies[i].initial;
    dBodyID b = bodies_[i];
    out[i] = {start.position, start.orientation, Vector3::Zero(), Vector3::Zero()};
    if (!b) continue;  // locked
    const dReal* q = dBodyGetQuaternion(b);
    out[i] = {vector(dBodyGetPosition(b)), core::Quaternion(q[0], q[1], q[2], q[3]),
              vector(dBodyGetLinearVel(b)), vector(dBodyGetAngularVel(b))};
  }
}

}  // namespace
}  // namespace cylon::simulators

namespace cylon::core {

std::unique_ptr<Simulator> make_simulator() { return std::make_unique<simulators::Ode>(); }

}  // namespace cylon::core
