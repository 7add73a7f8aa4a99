// The adapter of MuJoCo: a Scene in, motion out.
// Sees the simulator interface and MuJoCo's headers; never a scenario, a claim or another adapter.
#include "harness/core/simulator.h"
#include "reference/applied/forces.h"
#include "reference/applied/forest.h"
#include "reference/applied/masses.h"
#include "reference/simulators/mujoco/mujoco_contacts.h"
#include "reference/simulators/mujoco/mujoco_joints.h"
#include "reference/simulators/mujoco/mujoco_limits.h"
#include "reference/simulators/mujoco/mujoco_model.h"
#include "reference/simulators/mujoco/mujoco_settings.h"
#include "reference/simulators/mujoco/mujoco_world.h"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

namespace cylon::simulators {
namespace {

using core::BodyState;
using core::Quaternion;
using core::Scene;
using core::Setup;
using core::State;
using core::Vector3;

static_assert(sizeof(mjtNum) == sizeof(double), "this adapter states double precision");

std::size_t at(int i) { return static_cast<std::size_t>(i); }
Vector3 vector(const mjtNum* v) { return {v[0], v[1], v[2]}; }
Quaternion quaternion(const mjtNum* q) { return {q[0], q[1], q[2], q[3]}; }
void store(const Vector3& v, mjtNum* out) { std::copy(v.begin(), v.end(), out); }

// What the paths and the terms look at.  A body turns freely where it has no fixed axis and spins, or is pulled at a
// point beside its centre, or by a torque.
MujocoKind mujoco_kind(const Scene& scene, const applied::Forest& forest, bool rubs) {
  MujocoKind kind{core::scene_kind(scene)};
  kind.rubs = rubs;
  kind.loops = !forest.loops.empty();
  for (const core::Force& force : scene.forces) {
    if (const auto* spring = std::get_if<core::Spring>(&force))
      kind.turns |= !spring->anchor.isZero(0) || (spring->to != core::world && !spring->to_anchor.isZero(0));
    if (const auto* thrust = std::get_if<core::Thrust>(&force)) kind.changes |= thrust->mass_rate != 0;
    kind.turns |= std::holds_alternative<core::Water>(force);
  }
  for (const applied::Node& node : forest.nodes) {
    if (scene.bodies[at(node.body)].locked) continue;
    const bool spins = !scene.bodies[at(node.body)].initial.angular_velocity.isZero(0);
    const bool fixed_axis = node.joint >= 0 &&
                            !core::kind_of(scene.joints[at(node.joint)].type).turns_freely() &&
                            !core::kind_of(scene.joints[at(node.joint)].type).turns_between_axes();
    kind.turns |= node.joint < 0 ? spins || !node.children.empty() : !fixed_axis;
  }
  kind.turns |= core::has_fictitious_forces(scene);
  return kind;
}

class Mujoco final : public core::Simulator {
 public:
  Mujoco() {
    mujoco_handle_errors();
    mjcb_passive = [](const mjModel*, mjData*) {
      if (running_) running_->apply_forces();
    };
  }

  const core::Engine& engine() const override { return engine_; }

  std::optional<std::string> unsupported(const Scene& scene, const Setup& setup) const override {
    if (auto reason = applied::without_step("MuJoCo", setup)) return reason;
    if (auto reason = mujoco_limit(scene)) return reason;
    mujoco_settings(engine_, setup, MujocoKind());  // throws where the setup is impossible
    return std::nullopt;
  }

  core::Terms load(const Scene&, const Setup&) override;
  void step() override;
  void read(State&) const override;
  std::vector<std::string> remarks() const override { return remarks_; }
  std::vector<core::Contact> contacts() const override;

 private:
  // A body of the scene in MuJoCo's arrays.
  struct Place {
    int body = 0;       // 0: locked
    int position = -1;  // in qpos
    int speed = -1;     // in qvel
    bool free = false;
  };

  void place_bodies(const applied::Forest&);
  void set_speeds(const applied::Forest&);
  void set_masses();
  void apply_forces();
  void see_warnings();
  void read_current(State&) const;

  // MuJoCo's callback has no room for whose it is.
  static thread_local Mujoco* running_;

  core::Engine engine_ = mujoco_engine(mj_versionString());
  MujocoSettings settings_;
  Scene scene_;
  double dt_ = 0;
  std::int64_t steps_ = 0;
  MujocoWorld world_;
  std::vector<Place> places_;
  std::vector<int> owners_;  // of MuJoCo's bodies: of the scene's
  std::optional<applied::Forces> forces_;
  bool trees_ = false;  // some body hangs from another or from the world
  State state_;
  std::exception_ptr thrown_;  // by a callback: it may not pass through MuJoCo
  bool lost_ = false;          // MuJoCo has reset itself
  std::vector<std::string> remarks_;
};

thread_local Mujoco* Mujoco::running_ = nullptr;

// ---- Loading ----------------------------------------------------------------------------------------

core::Terms Mujoco::load(const Scene& scene, const Setup& setup) {
  const applied::Forest forest = applied::forest_of(scene);
  const MujocoContacts contacts = mujoco_contacts(scene);
  const MujocoKind kind = mujoco_kind(scene, forest, contacts.rubs);
  settings_ = mujoco_settings(engine_, setup, kind);
  scene_ = scene, dt_ = setup.dt, steps_ = 0;
  lost_ = false, thrown_ = nullptr, remarks_.clear();
  world_ = mujoco_compile(mujoco_xml(scene_, forest, contacts, settings_, dt_));
  place_bodies(forest);
  set_speeds(forest);
  forces_.emplace(scene_);
  return mujoco_terms(settings_, kind);
}

void Mujoco::place_bodies(const applied::Forest& forest) {
  const mjModel& m = *world_.model;
  places_.assign(scene_.bodies.size(), {});
  owners_.assign(at(m.nbody), core::world);
  trees_ = false;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const int id = mj_name2id(&m, mjOBJ_BODY, mujoco_body_name(static_cast<int>(i)).c_str());
    if (id < 0) throw std::logic_error("MuJoCo lacks a body");
    owners_[at(id)] = static_cast<int>(i);
    if (scene_.bodies[i].locked) continue;
    Place& place = places_[i];
    place.body = id;
    place.free = forest.nodes[i].joint < 0;
    trees_ = trees_ || !place.free;
    if (m.body_jntnum[id] == 0) continue;  // fixed
    place.position = m.jnt_qposadr[m.body_jntadr[id]];
    place.speed = m.jnt_dofadr[m.body_jntadr[id]];
  }
}

// A free body: v of the world, w of the body; a ball joint: w against the parent, in body axes; others: the rate of
// each coordinate.
void Mujoco::set_speeds(const applied::Forest& forest) {
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (places_[i].speed < 0) continue;
    const BodyState& start = scene_.bodies[i].initial;
    const applied::Node& node = forest.nodes[i];
    mjtNum* const speed = world_.data->qvel + places_[i].speed;
    Vector3 spin = start.angular_velocity;
    if (node.parent != core::world) spin -= scene_.bodies[at(node.parent)].initial.angular_velocity;
    if (places_[i].free) {
      store(start.velocity, speed);
      store(start.orientation.conjugate() * spin, speed + 3);
    } else if (core::is_ball(scene_.joints[at(node.joint)])) {
      store(start.orientation.conjugate() * spin, speed);
    } else {
      const core::Joint& joint = scene_.joints[at(node.joint)];
      mjtNum* next = speed;
      for (const MujocoAxis& one : mujoco_axes(scene_, joint, joint.body != static_cast<int>(i)))
        *next++ = one.rate;
    }
  }
}

// ---- A step -----------------------------------------------------------------------------------------

void Mujoco::step() {
  ++steps_;
  if (lost_) return;
  mjData& d = *world_.data;
  d.time = static_cast<double>(steps_ - 1) * dt_;
  if (!forces_->changing().empty()) set_masses();
  running_ = forces_->any() || core::states_own_gravity(scene_) ? this : nullptr;
  mj_step(world_.model.get(), &d);
  running_ = nullptr;
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
  see_warnings();
}

// For the whole step: MuJoCo has its matrix of masses before it asks for forces.  The inertia stays.
void Mujoco::set_masses() {
  read_current(state_);
  forces_->at(world_.data->time, state_);
  const mjModel& m = *world_.model;
  for (const std::size_t i : forces_->changing()) {
    const double gained = forces_->mass(i) - m.body_mass[places_[i].body];
    const int body = places_[i].body;
    m.body_mass[body] += gained;
    // What a simple body resists (its axes are the principal ones) is not summed but taken from here: mj_crb in
    // engine_core_smooth.c.
    for (int k = m.body_jntadr[body], end = k + m.body_jntnum[body]; k < end; ++k) {
      const int ways = m.jnt_type[k] == mjJNT_FREE ? 3 : m.jnt_type[k] == mjJNT_SLIDE ? 1 : 0;
      for (int way = 0; way < ways; ++way) m.dof_M0[m.jnt_dofadr[k] + way] += gained;
    }
    for (int id = body;; id = m.body_parentid[id]) {
      m.body_subtreemass[id] += gained;
      if (id == 0) break;
    }
  }
}

// Called in each evaluation of the acceleration, at its own time and state.
void Mujoco::apply_forces() try {
  const mjModel* const m = world_.model.get();
  mjData* const d = world_.data.get();
  state_.resize(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Place& place = places_[i];
    if (place.body == 0) {
      const BodyState& start = scene_.bodies[i].initial;
      state_[i] = {start.position, start.orientation, Vector3::Zero(), Vector3::Zero()};
      continue;
    }
    mjtNum speed[6];  // of rotation first
    mj_objectVelocity(m, d, mjOBJ_BODY, place.body, speed, 0);
    state_[i] = {vector(d->xipos + 3 * std::ptrdiff_t{place.body}),
                 quaternion(d->xquat + 4 * std::ptrdiff_t{place.body}), vector(speed + 3), vector(speed)};
    if (!place.free) continue;
    state_[i].velocity = vector(d->qvel + place.speed);
    state_[i].angular_velocity = state_[i].orientation * vector(d->qvel + place.speed + 3);
  }
  const std::vector<applied::Wrench>& wrenches = forces_->at(d->time, state_);
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Place& place = places_[i];
    Vector3 f = wrenches[i].force;
    const Vector3& t = wrenches[i].torque;
    // MuJoCo's own gravity, and the difference to it.
    if (const auto& gravity = scene_.bodies[i].gravity)
      f += m->body_mass[place.body] * (*gravity - core::gravity(scene_));
    if (place.body == 0 || (f.isZero(0) && t.isZero(0))) continue;
    if (!place.free) {
      mj_applyFT(m, d, f.data(), t.data(), d->xipos + 3 * std::ptrdiff_t{place.body}, place.body,
                 d->qfrc_passive);
      continue;
    }
    const Vector3 turning = state_[i].orientation.conjugate() * t;
    for (int k = 0; k < 3; ++k) {
      d->qfrc_passive[place.speed + k] += f[k];
      d->qfrc_passive[place.speed + 3 + k] += turning[k];
    }
  }
} catch (...) {
  thrown_ = std::current_exception();
}

// MuJoCo goes on from rest in the initial pose after a bad number, and without the contacts for which it has no room.
void Mujoco::see_warnings() {
  const auto warned = [&](mjtWarning warning) { return world_.data->warning[warning].number > 0; };
  if (warned(mjWARN_BADQPOS) || warned(mjWARN_BADQVEL) || warned(mjWARN_BADQACC)) {
    lost_ = true;
    remarks_.push_back(fmt::format(
        "MuJoCo reset itself to the initial pose in step {}: a coordinate, velocity or acceleration was not "
        "finite or beyond 1e10; all states since then are shown as not finite",
        steps_));
  }
  if (warned(mjWARN_CONTACTFULL) || warned(mjWARN_CNSTRFULL))
    throw std::runtime_error(fmt::format("MuJoCo has no room for more than {} contacts and {} constraints",
                                         world_.model->nconmax, world_.model->njmax));
}

// ---- Reading ----------------------------------------------------------------------------------------

void Mujoco::read(State& out) const {
  read_current(out);
  if (!lost_) return;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector3 none = Vector3::Constant(nan);
  for (std::size_t i = 0; i < out.size(); ++i)
    if (places_[i].body != 0) out[i] = {none, Quaternion(nan, nan, nan, nan), none, none};
}

// A free body is what MuJoCo integrates.  Of others the pose follows from the coordinates, which are left as they
// are: mj_kinematics() normalises their quaternions.
void Mujoco::read_current(State& out) const {
  const mjModel* const m = world_.model.get();
  mjData* const d = world_.data.get();
  if (trees_) {
    const std::vector<mjtNum> coordinates(d->qpos, d->qpos + m->nq);
    mj_kinematics(m, d);
    mj_comPos(m, d);
    mj_comVel(m, d);
    std::copy(coordinates.begin(), coordinates.end(), d->qpos);
  }
  out.resize(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Place& place = places_[i];
    const BodyState& start = scene_.bodies[i].initial;
    if (place.body == 0) {
      out[i] = {start.position, start.orientation, Vector3::Zero(), Vector3::Zero()};
    } else if (place.free) {
      const Quaternion q = quaternion(d->qpos + place.position + 3).normalized();
      out[i] = {vector(d->qpos + place.position), q, vector(d->qvel + place.speed),
                q * vector(d->qvel + place.speed + 3)};
    } else {
      mjtNum speed[6];  // of rotation first
      mj_objectVelocity(m, d, mjOBJ_BODY, place.body, speed, 0);
      out[i] = {vector(d->xipos + 3 * std::ptrdiff_t{place.body}),
                quaternion(d->xquat + 4 * std::ptrdiff_t{place.body}), vector(speed + 3), vector(speed)};
    }
  }
}

// The forces of the one evaluation that a step of Euler and of the implicit scheme has.  Of Runge-Kutta 4 only those of
// the last of four are left, which is nobody's impulse: nothing is told.
std::vector<core::Contact> Mujoco::contacts() const {
  std::vector<core::Contact> told;
  if (lost_ || settings_.integrator == "rk4") return told;
  const mjModel* const m = world_.model.get();
  const mjData* const d = world_.data.get();
  for (int i = 0; i < d->ncon; ++i) {
    const mjContact& contact = d->contact[i];
    mjtNum force[6];  // normal first, in the axes of the contact
    mj_contactForce(m, d, i, force);
    if (!(force[0] > 0)) continue;
    const int first = m->geom_bodyid[contact.geom1], second = m->geom_bodyid[contact.geom2];
    // MuJoCo's normal points from its first geom into its second.
    const bool turned = second == 0;
    const double sign = turned ? -1 : 1;
    const int other = turned ? second : first;
    const int plane = (turned ? contact.geom2 : contact.geom1) - m->body_geomadr[0];
    core::Contact one;
    one.pair = {owners_[at(turned ? first : second)], owners_[at(other)], other == 0 ? plane : -1};
    one.point = vector(contact.pos);
    one.normal = sign * vector(contact.frame);
    one.impulse = dt_ * force[0];
    one.friction = sign * dt_ * (force[1] * vector(contact.frame + 3) + force[2] * vector(contact.frame + 6));
    told.push_back(one);
  }
  return told;
}

}  // namespace
}  // namespace cylon::simulators

namespace cylon::core {

std::unique_ptr<Simulator> make_simulator() { return std::make_unique<simulators::Mujoco>(); }

}  // namespace cylon::core
