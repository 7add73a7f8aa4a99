// The adapter of ODE (Open Dynamics Engine), double precision: a Scene in, motion out.
// Sees the simulator interface and ODE's headers; never a scenario, a claim or another adapter.
#include "harness/core/input_error.h"
#include "harness/core/simulator.h"

#include <fmt/format.h>
#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <deque>
#include <stdexcept>
#include <system_error>
#include <unordered_map>
#include <utility>

namespace cylon::simulators {
namespace {

using core::Body;
using core::BodyState;
using core::Engine;
using core::Joint;
using core::JointType;
using core::Path;
using core::Quaternion;
using core::Scene;
using core::Setting;
using core::Setup;
using core::State;
using core::Terms;
using core::Vector3;

static_assert(sizeof(dReal) == sizeof(double), "this adapter states double precision");

constexpr const char* scheme_name = "semi-implicit-euler";
constexpr int contacts_per_pair = 8;  // a box's face on a box's face has eight corners at most

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// ---- What a run may choose -----------------------------------------------------------------------

struct Choice {
  bool quick = false;  // dWorldQuickStep (projected SOR) in place of dWorldStep (Dantzig's LCP)
  bool gyro = true;
  bool finite_rotation = true;
  double erp = 0.2;     // share of a constraint's error corrected per step
  double cfm = 1e-10;   // softness of a constraint [1/kg/s]
  int iterations = 20;  // of QuickStep
};

std::string text(double x) { return fmt::format("{}", x); }

std::vector<Setting> settings_of(const Choice& choice) {
  std::vector<Setting> settings = {
      {"solver", choice.quick ? "dWorldQuickStep" : "dWorldStep", "none: the caller's choice", "the path"},
      {"rotation", choice.finite_rotation ? "finite" : "infinitesimal", "infinitesimal",
       "finite turns a body by |w| dt; the default turns it by 2 atan(|w| dt/2)"},
      {"gyro", choice.gyro ? "on" : "off", "on", "off leaves out w x L: a wrong motion of conserved energy"},
      {"erp", text(choice.erp), "0.2", "set before any joint exists: a joint copies it when it is made"},
      {"cfm", text(choice.cfm), "1e-10", "set before any joint exists: a joint copies it when it is made"},
      {"auto_disable", "off", "off", "bodies of a scene never sleep"},
      {"damping", "0", "0", "only the scene's own drag may take energy"},
      {"contact_mode", "dContactApprox1 | dContactBounce", "0",
       "without Approx1 the friction coefficient is a force limit; without Bounce there is no restitution"},
      {"mu, bounce", "of the pair", "none: the caller's",
       "ODE takes both per contact: the material as stated"},
      {"bounce_vel", "0", "none: the caller's", "no speed below which restitution is dropped"},
      {"contact_surface_layer", "0", "0", "no depth at which contacts rest"},
      {"contact_max_correcting_velocity", "inf", "inf", "the engine's own"},
      {"contacts_per_pair", std::to_string(contacts_per_pair), "none: the caller's",
       "a box on a box has eight"},
      {"broad_phase", "dHashSpace", "none: the caller's", "the engine's own for many bodies"},
      {"threading", "self-threaded, one per world", "one shared by all worlds",
       "two worlds that share one abort when stepped by two threads"},
  };
  if (choice.quick) {
    settings.push_back({"iterations", std::to_string(choice.iterations), "20", "the engine's own"});
    settings.push_back({"over_relaxation", "1.3", "1.3", "the engine's own"});
    settings.push_back(
        {"random_seed", "0 at load", "continues from the last world",
         "the order of rows is shuffled; reseeding makes a repeated run equal to the last bit"});
  }
  return settings;
}

std::vector<std::string> unforceable_in(bool quick) {
  std::vector<std::string> sentences = {
      "Friction is a pyramid along two fixed tangents of the contact normal, not a cone.",
      "The gyroscopic term is an implicit form that loses energy; it can be left out, not made exact.",
      "A contact is found from the state at the start of a step, so an impact is felt up to one step late.",
      "Restitution reflects the approach speed from before the step's forces act.",
      "There is no continuous collision detection: what crosses a body within one step is not felt.",
      "Impacts at one instant are one complementarity problem, whatever order the scene asks for.",
  };
  if (quick) {
    sentences.push_back("QuickStep stops after a fixed number of iterations, whatever the residual.");
    sentences.push_back(
        "Its random sequence is one per process: worlds stepped in turns disturb each other.");
  } else {
    sentences.push_back(
        "Dantzig's solver gives up on redundant or exactly touching contacts ('LCP internal error, s <= 0') "
        "and drops their impulses.");
  }
  return sentences;
}

Path path_of(bool quick) {
  Choice choice;
  choice.quick = quick;
  return {quick ? "quick" : "step",
          quick ? "projected successive over-relaxation, for piles"
                : "Dantzig's direct LCP, for few contacts and joints",
          settings_of(choice), unforceable_in(quick)};
}

const Engine& self() {
  static const Engine engine = {
      "ode",
      dODE_VERSION,
      "double",
      {path_of(false), path_of(true)},
      "always 'step'",
      {{scheme_name, 1, "linear momentum; of a linear spring a nearby energy"}},
      {{"gyro", {"on", "off"}, "on", "the implicit gyroscopic torque"},
       {"rotation", {"finite", "infinitesimal"}, "infinitesimal", "how an orientation follows from w dt"},
       {"erp", {}, "0.2", "share of a constraint's error corrected per step, in [0, 1]"},
       {"cfm", {}, "1e-10", "softness of a constraint, >= 0"},
       {"iterations", {}, "20", "of path 'quick', >= 1"}}};
  return engine;
}

[[noreturn]] void unknown(const char* kind, const std::string& given, std::span<const std::string> valid) {
  throw std::invalid_argument(
      fmt::format("ode: unknown {} '{}'{}", kind, given, core::did_you_mean(given, valid)));
}

double number(const std::string& option, const std::string& given, double least, double most) {
  double x = 0;
  const auto [end, error] = std::from_chars(given.data(), given.data() + given.size(), x);
  if (error != std::errc() || end != given.data() + given.size() || !(x >= least && x <= most))
    throw std::invalid_argument(
        fmt::format("ode: option {} = '{}' is not a number in [{}, {}]", option, given, least, most));
  return x;
}

// One of an option's two words; true for the first.
bool first_of(const core::Option& option, const std::string& given) {
  const auto found = std::find(option.values.begin(), option.values.end(), given);
  if (found == option.values.end()) unknown(("value of " + option.name).c_str(), given, option.values);
  return found == option.values.begin();
}

Choice choice_of(const Setup& setup) {
  Choice choice;
  std::vector<std::string> names;
  for (const Path& path : self().paths) names.push_back(path.name);
  if (!setup.path.empty() && std::ranges::find(names, setup.path) == names.end())
    unknown("path", setup.path, names);
  choice.quick = setup.path == "quick";

  const std::array<std::string, 1> schemes = {scheme_name};
  if (!setup.integrator.empty() && setup.integrator != scheme_name)
    unknown("integrator", setup.integrator, schemes);

  for (const auto& [name, value] : setup.options) {
    const auto option = std::ranges::find(self().options, name, &core::Option::name);
    if (option == self().options.end()) {
      names.clear();
      for (const core::Option& known : self().options) names.push_back(known.name);
      unknown("option", name, names);
    }
    if (name == "gyro") choice.gyro = first_of(*option, value);
    if (name == "rotation") choice.finite_rotation = first_of(*option, value);
    if (name == "erp") choice.erp = number(name, value, 0, 1);
    if (name == "cfm") choice.cfm = number(name, value, 0, 1e300);
    if (name == "iterations") {
      if (!choice.quick) throw std::invalid_argument("ode: option iterations belongs to path 'quick'");
      choice.iterations = static_cast<int>(number(name, value, 1, 1e9));
    }
  }
  return choice;
}

// ---- What ODE cannot express ---------------------------------------------------------------------

// ODE's primitives: a word for each shape that it lacks, nullptr for those that it has.
template <class Variant>
const char* missing_shape(const Variant& shape) {
  return std::visit(Overloaded{[](const core::Cone&) { return "a cone"; },
                               [](const core::Rod&) { return "a rod without thickness"; },
                               [](const core::Disc&) { return "a disc without thickness"; },
                               [](const core::Hull&) { return "a convex hull without its faces"; },
                               [](const core::Mesh&) { return "a solid mesh (its meshes are shells)"; },
                               [](const auto&) -> const char* { return nullptr; }},
                    shape);
}

const char* missing_in(const core::Shape& shape) {
  if (const auto* compound = std::get_if<core::Compound>(&shape)) {
    for (const core::Part& part : compound->parts)
      if (const char* missing = missing_shape(part.shape)) return missing;
  }
  return missing_shape(shape);
}

std::optional<std::string> reason_against(const Scene& scene, const core::Force& force) {
  const auto name = [&](int body) -> const std::string& { return scene.bodies[at(body)].name; };
  if (const auto* thrust = std::get_if<core::Thrust>(&force); thrust && thrust->mass_rate != 0)
    return fmt::format("ODE has no body of changing mass, as '{}' with its mass_rate is.",
                       name(thrust->body));
  if (std::holds_alternative<core::Water>(force)) return "ODE has no water.";
  return std::nullopt;
}

std::optional<std::string> reason_against(const Body& body) {
  if (body.locked) return std::nullopt;
  // dMassCheck aborts the process on either.
  if (!(body.mass > 0))
    return fmt::format("ODE needs a mass above zero; '{}' has {} kg.", body.name, body.mass);
  const Vector3 moments = core::principal_axes(body.inertia).moments;
  if (!(moments.minCoeff() > 0))
    return fmt::format("ODE needs principal moments above zero; '{}' has one of {} kg m^2.", body.name,
                       moments.minCoeff());
  return std::nullopt;
}

std::optional<std::string> reason_against(const Scene& scene, const core::Pair& pair) {
  for (const int i : {pair.body, pair.other})
    if (i != core::world)
      if (const char* missing = missing_in(scene.bodies[at(i)].shape))
        return fmt::format("ODE cannot collide {}, the shape of '{}'.", missing, scene.bodies[at(i)].name);
  if (!core::material_of(scene, pair))
    return fmt::format("'{}' may touch something without a material between them.",
                       scene.bodies[at(pair.body)].name);
  return std::nullopt;
}

// ---- The world -----------------------------------------------------------------------------------

// Global state of the library, from the first simulator to the end of the program.
struct Library {
  Library() { dInitODE2(0); }
  ~Library() { dCloseODE(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  static void enter() {
    static const Library library;
    dAllocateODEDataForThread(dAllocateMaskAll);  // once per thread; later calls cost nothing
  }
};

// Owns what ODE allocates for one world.
struct World {
  dWorldID id = dWorldCreate();
  dSpaceID space = dHashSpaceCreate(nullptr);
  dJointGroupID contacts = dJointGroupCreate(0);
  dThreadingImplementationID threading = dThreadingAllocateSelfThreadedImplementation();

  World() {
    dWorldSetStepThreadingImplementation(id, dThreadingImplementationGetFunctions(threading), threading);
  }
  ~World() {
    dJointGroupDestroy(contacts);
    dSpaceDestroy(space);
    dWorldDestroy(id);
    dThreadingFreeImplementation(threading);
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;
};

// Whom a geom belongs to: a body of the scene, or one of its planes.
struct Owner {
  int body = core::world;
  int plane = -1;
};

struct Surface {
  double friction = 0, restitution = 0;
};

std::array<double, 4> quaternion(const Quaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }
Vector3 vector(const dReal* v) { return {v[0], v[1], v[2]}; }

class Ode final : public core::Simulator {
 public:
  Ode() { Library::enter(); }

  const Engine& engine() const override { return self(); }
  std::optional<std::string> unsupported(const Scene&, const Setup&) const override;
  Terms load(const Scene&, const Setup&) override;
  void step() override;
  void read(State&) const override;

 private:
  struct Point {
    Vector3 position, velocity;
  };

  void add_body(const Body&, const Choice&);
  void add_shape(const Body&, dBodyID, Owner*);
  void add_geom(const core::Primitive&, const Body&, dBodyID, Owner*, const Vector3& position, Quaternion);
  void add_joint(const Joint&);
  void collide(dGeomID, dGeomID);
  const Surface& surface(const Owner&, const Owner&);
  void apply(const core::Force&) const;
  void pull(int body, const Vector3& force, const Vector3& anchor) const;
  Point point(int body, const Vector3& anchor) const;
  BodyState state(std::size_t body) const;
  dBodyID body(int i) const { return i == core::world ? nullptr : bodies_[at(i)]; }

  Scene scene_;
  Choice choice_;
  double dt_ = 0;
  std::int64_t steps_ = 0;
  std::unique_ptr<World> world_;
  std::vector<dBodyID> bodies_;  // nullptr for a locked body
  std::deque<Owner> owners_;     // geoms point at them
  std::unordered_map<std::uint64_t, Surface> surfaces_;
};

std::optional<std::string> Ode::unsupported(const Scene& scene, const Setup& setup) const {
  if (!(setup.dt > 0)) return fmt::format("ODE steps forward only; dt = {} s.", setup.dt);
  if (scene.frame) return "ODE's world is an inertial frame; the scene is given in a moving one.";
  for (const Body& body : scene.bodies)
    if (auto reason = reason_against(body)) return reason;
  for (const core::Force& force : scene.forces)
    if (auto reason = reason_against(scene, force)) return reason;
  for (const core::Pair& pair : core::touching_pairs(scene))
    if (auto reason = reason_against(scene, pair)) return reason;
  return std::nullopt;
}

Terms Ode::load(const Scene& scene, const Setup& setup) {
  const Choice choice = choice_of(setup);
  Library::enter();
  if (choice.quick) dRandSetSeed(0);

  scene_ = scene, choice_ = choice, dt_ = setup.dt, steps_ = 0;
  bodies_.clear(), owners_.clear(), surfaces_.clear();
  world_ = std::make_unique<World>();
  dWorldSetERP(world_->id, choice.erp);
  dWorldSetCFM(world_->id, choice.cfm);
  dWorldSetQuickStepNumIterations(world_->id, choice.iterations);
  dWorldSetQuickStepW(world_->id, 1.3);
  dWorldSetDamping(world_->id, 0, 0);
  dWorldSetContactSurfaceLayer(world_->id, 0);
  dWorldSetContactMaxCorrectingVel(world_->id, dInfinity);

  Vector3 gravity = Vector3::Zero();
  for (const core::Force& force : scene_.forces)
    if (const auto* uniform = std::get_if<core::UniformGravity>(&force)) gravity += uniform->acceleration;
  dWorldSetGravity(world_->id, gravity.x(), gravity.y(), gravity.z());

  for (const Body& body : scene_.bodies) add_body(body, choice);
  for (std::size_t i = 0; i < scene_.planes.size(); ++i) {
    const core::Plane& plane = scene_.planes[i];
    owners_.push_back({core::world, static_cast<int>(i)});
    dGeomSetData(
        dCreatePlane(world_->space, plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.offset),
        &owners_.back());
  }
  for (const Joint& joint : scene_.joints) add_joint(joint);

  const Path& path = self().paths[choice.quick ? 1 : 0];
  return {path.name,           scheme_name,     1, choice.gyro ? "implicit" : "none",
          settings_of(choice), path.unforceable};
}

// A locked body is geoms without a body: nothing can move it.
void Ode::add_body(const Body& body, const Choice& choice) {
  dBodyID id = nullptr;
  if (!body.locked) {
    const core::Matrix3& i = body.inertia;
    dMass mass;
    dMassSetParameters(&mass, body.mass, 0, 0, 0, i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2));
    id = dBodyCreate(world_->id);
    dBodySetMass(id, &mass);
    dBodySetAutoDisableFlag(id, 0);
    dBodySetGyroscopicMode(id, choice.gyro ? 1 : 0);
    dBodySetFiniteRotationMode(id, choice.finite_rotation ? 1 : 0);
    const BodyState& s = body.initial;
    dBodySetPosition(id, s.position.x(), s.position.y(), s.position.z());
    dBodySetQuaternion(id, quaternion(s.orientation).data());
    dBodySetLinearVel(id, s.velocity.x(), s.velocity.y(), s.velocity.z());
    dBodySetAngularVel(id, s.angular_velocity.x(), s.angular_velocity.y(), s.angular_velocity.z());
  }
  owners_.push_back({static_cast<int>(bodies_.size()), -1});
  bodies_.push_back(id);
  if (body.collide) add_shape(body, id, &owners_.back());
}

void Ode::add_shape(const Body& body, dBodyID id, Owner* owner) {
  const auto single = [&](const auto& shape) {
    add_geom(core::Primitive(shape), body, id, owner, Vector3::Zero(), Quaternion::Identity());
  };
  const auto compound = [&](const core::Compound& shape) {
    for (const core::Part& part : shape.parts)
      add_geom(part.shape, body, id, owner, part.position, part.orientation);
  };
  std::visit(Overloaded{single, compound}, body.shape);
}

// One primitive at a place in the body frame.  ODE's axis of revolution is z, ours y.
void Ode::add_geom(const core::Primitive& shape, const Body& body, dBodyID id, Owner* owner,
                   const Vector3& position, Quaternion orientation) {
  const Quaternion z_to_y(Eigen::AngleAxisd(-std::acos(0.0), Vector3::UnitX()));
  dSpaceID space = world_->space;
  dGeomID geom = std::visit(
      Overloaded{[&](const core::Sphere& s) { return dCreateSphere(space, s.radius); },
                 [&](const core::Box& s) {
                   return dCreateBox(space, 2 * s.half_extents.x(), 2 * s.half_extents.y(),
                                     2 * s.half_extents.z());
                 },
                 [&](const core::Capsule& s) {
                   orientation = orientation * z_to_y;
                   return dCreateCapsule(space, s.radius, s.length);
                 },
                 [&](const core::Cylinder& s) {
                   orientation = orientation * z_to_y;
                   return dCreateCylinder(space, s.radius, s.length);
                 },
                 [](const auto&) -> dGeomID { return nullptr; }},  // in no touching pair, or unsupported
      shape);
  if (!geom) return;
  dGeomSetData(geom, owner);
  if (id) {
    dGeomSetBody(geom, id);
    if (!position.isZero(0)) dGeomSetOffsetPosition(geom, position.x(), position.y(), position.z());
    if (orientation.vec().any()) dGeomSetOffsetQuaternion(geom, quaternion(orientation).data());
  } else {
    const BodyState& s = body.initial;
    const Vector3 p = s.position + s.orientation * position;
    dGeomSetPosition(geom, p.x(), p.y(), p.z());
    dGeomSetQuaternion(geom, quaternion(s.orientation * orientation).data());
  }
}

// The moving body comes first: ODE reverses a joint whose first body is the world.
void Ode::add_joint(const Joint& joint) {
  dBodyID a = body(joint.body), b = body(joint.to);
  if (!a && !b) return;  // both ends are locked
  const auto attach = [&](dJointID id) {
    return a ? dJointAttach(id, a, b) : dJointAttach(id, b, nullptr), id;
  };
  const Vector3& p = joint.point;
  switch (joint.type) {
    case JointType::ball:
      dJointSetBallAnchor(attach(dJointCreateBall(world_->id, nullptr)), p.x(), p.y(), p.z());
      return;
    case JointType::hinge: {
      dJointID id = attach(dJointCreateHinge(world_->id, nullptr));
      dJointSetHingeAnchor(id, p.x(), p.y(), p.z());
      dJointSetHingeAxis(id, joint.axis.x(), joint.axis.y(), joint.axis.z());
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
  }
}

// ---- A step --------------------------------------------------------------------------------------

void Ode::step() {
  for (const core::Force& force : scene_.forces) apply(force);  // held over the step, then cleared by ODE
  dSpaceCollide(world_->space, this,
                [](void* me, dGeomID a, dGeomID b) { static_cast<Ode*>(me)->collide(a, b); });
  const int done = choice_.quick ? dWorldQuickStep(world_->id, dt_) : dWorldStep(world_->id, dt_);
  if (!done) throw std::runtime_error("ODE found no memory for the step");
  dJointGroupEmpty(world_->contacts);
  ++steps_;
}

void Ode::collide(dGeomID a, dGeomID b) {
  dBodyID first = dGeomGetBody(a), second = dGeomGetBody(b);
  if (first == second) return;  // both fixed, or two parts of one body
  std::array<dContactGeom, contacts_per_pair> found;
  const int n = dCollide(a, b, contacts_per_pair, found.data(), sizeof(dContactGeom));
  if (n == 0) return;
  const Surface& s = surface(*static_cast<Owner*>(dGeomGetData(a)), *static_cast<Owner*>(dGeomGetData(b)));
  dContact contact{};
  contact.surface.mode = dContactApprox1 | dContactBounce;
  contact.surface.mu = s.friction;
  contact.surface.bounce = s.restitution;
  contact.surface.bounce_vel = 0;
  for (int i = 0; i < n; ++i) {
    contact.geom = found[at(i)];
    dJointAttach(dJointCreateContact(world_->id, world_->contacts, &contact), first, second);
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

// Forces of the scene at the start of the step, as scene.h states them.
void Ode::apply(const core::Force& force) const {
  std::visit(Overloaded{
                 [](const core::UniformGravity&) {},  // given to the world
                 [&](const core::Spring& s) {
                   const Point p = point(s.body, s.anchor), q = point(s.to, s.to_anchor);
                   const Vector3 d = q.position - p.position;
                   const double length = d.norm();
                   if (length == 0) return;
                   const double rate = d.dot(q.velocity - p.velocity) / length;
                   const Vector3 f = (s.stiffness * (length - s.rest_length) + s.damping * rate) / length * d;
                   pull(s.body, f, s.anchor);
                   pull(s.to, -f, s.to_anchor);
                 },
                 [&](const core::Drag& s) {
                   dBodyID id = body(s.body);
                   if (!id) return;
                   const BodyState now = state(at(s.body));
                   const Vector3 spin =
                       core::world_inertia(scene_.bodies[at(s.body)], now.orientation) * now.angular_velocity;
                   const Vector3 f = -s.linear * now.velocity,
                                 torque = -s.angular * now.angular_velocity - s.momentum * spin;
                   dBodyAddForce(id, f.x(), f.y(), f.z());
                   dBodyAddTorque(id, torque.x(), torque.y(), torque.z());
                 },
                 [&](const core::Thrust& s) {
                   if (dBodyID id = body(s.body)) dBodyAddRelForce(id, s.force.x(), s.force.y(), s.force.z());
                 },
                 [&](const core::Drive& s) {
                   pull(s.body, s.force * std::cos(s.frequency * (static_cast<double>(steps_) * dt_)),
                        Vector3::Zero());
                 },
                 [&](const core::Attraction& s) {
                   const Vector3 d = state(at(s.to)).position - state(at(s.body)).position;
                   const double masses = scene_.bodies[at(s.body)].mass * scene_.bodies[at(s.to)].mass;
                   const Vector3 f = s.strength * masses / std::pow(d.norm(), 3) * d;
                   pull(s.body, f, Vector3::Zero());
                   pull(s.to, -f, Vector3::Zero());
                 },
                 [](const core::Water&) {},  // unsupported
             },
             force);
}

// Adds a force [N, world axes] at an anchor [m, body axes]; locked bodies and the world do not feel it.
void Ode::pull(int i, const Vector3& f, const Vector3& anchor) const {
  if (dBodyID id = body(i))
    dBodyAddForceAtRelPos(id, f.x(), f.y(), f.z(), anchor.x(), anchor.y(), anchor.z());
}

Ode::Point Ode::point(int i, const Vector3& anchor) const {
  if (i == core::world) return {anchor, Vector3::Zero()};
  const BodyState s = state(at(i));
  const Vector3 arm = s.orientation * anchor;
  return {s.position + arm, s.velocity + s.angular_velocity.cross(arm)};
}

BodyState Ode::state(std::size_t i) const {
  dBodyID id = bodies_[i];
  if (!id) return scene_.bodies[i].initial;
  const dReal* q = dBodyGetQuaternion(id);
  return {vector(dBodyGetPosition(id)), Quaternion(q[0], q[1], q[2], q[3]), vector(dBodyGetLinearVel(id)),
          vector(dBodyGetAngularVel(id))};
}

void Ode::read(State& out) const {
  out.resize(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) out[i] = state(i);
}

}  // namespace
}  // namespace cylon::simulators

namespace cylon::core {

std::unique_ptr<Simulator> make_simulator() { return std::make_unique<simulators::Ode>(); }

}  // namespace cylon::core
