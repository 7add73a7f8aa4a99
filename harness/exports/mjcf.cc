// A scene as MJCF: trees of bodies with hinges, slides and balls; what closes loops are equality constraints.  Contacts
// and limits are MuJoCo's own, which yield.  Angles in radians, all inertias stated.
#include "harness/exports/mjcf.h"

#include "harness/exports/parts.h"
#include "harness/exports/tree.h"
#include "harness/exports/xml.h"
#include "harness/exports/z_up.h"

#include "harness/core/collision_filter.h"
#include "harness/core/joint_coordinates.h"
#include "harness/core/overloaded.h"
#include "harness/core/surfaces.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

namespace cylon::exports {
namespace {

using core::Joint;
using core::JointCoordinate;
using core::JointType;
using core::Quaternion;
using core::Vector3;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::string text_of(const Quaternion& q) { return fmt::format("{} {} {} {}", q.w(), q.x(), q.y(), q.z()); }

// MuJoCo's engine_collision_driver.c, mj_contactParam: the larger friction; impacts have no restitution.
constexpr PairRule rule = {[](double a, double b) { return std::max(a, b); }, false};

// One of the joints that MJCF makes a joint of: about or along an axis, and which coordinate of the scene's joint it is.
struct Motion {
  const char* type;  // "hinge", "slide", "ball"
  Vector3 axis = Vector3::Zero();
  core::Ordinal which = core::Ordinal::first;
  std::optional<Vector3> point = {};  // where it is not the joint's

  bool slides() const { return std::string_view(type) == "slide"; }
};

template <class Coordinate>
const JointCoordinate* find(const std::vector<Coordinate>& coordinates, core::Ordinal which) {
  const auto found = std::ranges::find(coordinates, which, &Coordinate::which);
  return found == coordinates.end() ? nullptr : &*found;
}

// What acts along it; null where nothing does.
const JointCoordinate* acting(const Joint& joint, const Motion& m) {
  return m.slides() ? find(joint.displacements, m.which) : find(joint.angles, m.which);
}

// From `to` to `body`; none: MJCF has no such joint.
std::vector<Motion> motions_of(const Joint& joint) {
  using enum core::Ordinal;
  if (core::is_ball(joint)) return {{"ball"}};
  switch (joint.type) {
    case JointType::hinge:
      return {{"hinge", joint.axis}};
    case JointType::slider:
      return {{"slide", joint.axis}};
    case JointType::cylindrical:
      return {{"slide", joint.axis}, {"hinge", joint.axis}};
    case JointType::universal:
      return {{"hinge", joint.axis}, {"hinge", *joint.axis_2, second}};
    case JointType::offset_universal:
      return {{"hinge", joint.axis}, {"hinge", *joint.axis_2, second, core::held_point_of_body(joint)}};
    case JointType::rectangular:
      return {{"slide", *joint.axis_2}, {"slide", joint.axis.cross(*joint.axis_2), second}};
    case JointType::gimbal:
      return {{"hinge", joint.axis},
              {"hinge", joint.axis.cross(*joint.axis_2).normalized(), third},
              {"hinge", *joint.axis_2, second}};
    case JointType::planar:
      return {{"slide", *joint.axis_2},
              {"slide", joint.axis.cross(*joint.axis_2), second},
              {"hinge", joint.axis}};
    default:
      return {};
  }
}

class Writer {
 public:
  explicit Writer(const scenario::Scenario& scenario)
      : scenario_(scenario),
        scene_(scenario.scene),
        tree_(tree_of(scene_)),
        surfaces_(surfaces_of(scene_, rule)),
        filters_(scene_) {}

  Exported write() {
    require_plain(scene_);
    require_masks();
    set(root_, "model", scenario_.title);
    Element& compiler = add(root_, "compiler");
    set(compiler, "angle", "radian"), set(compiler, "autolimits", "false");
    set(compiler, "inertiafromgeom", "false");
    Element& option = add(root_, "option");
    set(option, "timestep", scenario_.step), set(option, "gravity", z_up(core::gravity(scene_)));
    Element& world = add(root_, "worldbody");
    for (std::size_t i = 0; i < scene_.planes.size(); ++i) add_plane(i, world);
    add_bodies(world);
    for (const int joint : tree_.loops) add_loop(scene_.joints[at(joint)]);
    if (!excluded_.empty()) add(root_, "contact") = excluded_;
    if (!equality_.empty()) add(root_, "equality") = equality_;
    if (!actuators_.empty()) add(root_, "actuator") = actuators_;
    Exported result;
    if (moves_) {
      Element& key = add(add(root_, "keyframe"), "key");
      set(key, "name", "start");
      set(key, "qpos", fmt::format("{}", fmt::join(positions_, " ")));
      set(key, "qvel", fmt::format("{}", fmt::join(velocities_, " ")));
      result.notes.push_back(
          "its velocities are those of the keyframe 'start': cylon import --keyframe start");
    }
    Element whole;
    add(whole, "mujoco") = root_;
    result.xml = document(whole);
    return result;
  }

 private:
  // MuJoCo asks for one of the two masks to fit, a scene for both.
  void require_masks() const {
    const core::ContactRules rules(scene_);
    const auto meet = [](const core::CollisionFilter& a, const core::CollisionFilter& b) {
      return (a.groups & b.mask) != 0 || (b.groups & a.mask) != 0;
    };
    const auto fail = [](const std::string& name) {
      throw Unsayable{"body", name, "collision_mask",
                      "one of two masks that fits is enough in MuJoCo, and here both must"};
    };
    if (filters_.names.size() > 31)
      throw Unsayable{"body", "", "collision_groups", "it has 31 groups, without a sign"};
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      const core::CollisionFilter& mine = filters_.of_body[i];
      if (!scene_.bodies[i].collide) continue;
      for (std::size_t k = 0; k < i; ++k)
        if (scene_.bodies[k].collide &&
            meet(mine, filters_.of_body[k]) != core::may_meet(mine, filters_.of_body[k]))
          fail(scene_.bodies[i].name);
      for (const core::CollisionFilter& plane : filters_.of_plane)
        if (meet(mine, plane) != core::may_meet(mine, plane)) fail(scene_.bodies[i].name);
    }
  }

  void set_contact(Element& geom, const Surface& surface, const core::CollisionFilter& filter,
                   bool touches) const {
    const std::uint32_t known = (std::uint32_t{1} << filters_.names.size()) - 1;
    set(geom, "contype", touches ? static_cast<int>(filter.groups) : 0);
    set(geom, "conaffinity", touches ? static_cast<int>(filter.mask & known) : 0);
    if (touches) set(geom, "friction", fmt::format("{} 0 0", surface.friction));
  }

  void add_plane(std::size_t i, Element& world) const {
    const core::Plane& plane = scene_.planes[i];
    Element& geom = add(world, "geom");
    set(geom, "name", plane.name), set(geom, "type", "plane"), set(geom, "size", "0 0 1");
    const Vector3 normal = z_up(plane.normal);
    set(geom, "pos", Vector3(plane.offset * normal));
    set(geom, "quat", text_of(core::turn_between(Vector3::UnitZ(), normal)));
    set_contact(geom, surfaces_.of_plane[i], filters_.of_plane[i], true);
  }

  // Depth first, as MuJoCo counts bodies and coordinates; no recursion, however long the chain.
  void add_bodies(Element& world) {
    std::vector<std::pair<int, Element*>> waiting;
    const auto wait = [&](const std::vector<int>& bodies, Element* inside) {
      for (auto b = bodies.rbegin(); b != bodies.rend(); ++b) waiting.emplace_back(*b, inside);
    };
    wait(tree_.roots, &world);
    while (!waiting.empty()) {
      const auto [body, inside] = waiting.back();
      waiting.pop_back();
      Element& element = add(*inside, "body");
      write_body(body, element);
      wait(tree_.links[at(body)].children, &element);
    }
  }

  void write_body(int i, Element& element) {
    const core::Body& body = scene_.bodies[at(i)];
    const Link& link = tree_.links[at(i)];
    const Vector3 position = z_up(body.initial.position);
    const Quaternion turn = z_up(body.initial.orientation);
    set(element, "name", body.name);
    if (link.parent == core::world) {
      set(element, "pos", position), set(element, "quat", text_of(turn));
    } else {
      const core::BodyState& parent = scene_.bodies[at(link.parent)].initial;
      const Quaternion back = z_up(parent.orientation).conjugate();
      set(element, "pos", Vector3(back * (position - z_up(parent.position))));
      set(element, "quat", text_of(back * turn));
    }
    set_gravity(body, element);
    if (link.joint >= 0)
      add_joints(link.joint, element);
    else if (!body.locked)
      add_free(body, element);
    add_inertia(body, element);
    for (const core::Part& part : parts_of(body)) add_geom(body, i, part, element);
  }

  // Of a free body: place and velocity of its centre of mass, turn, spin in its own axes.
  void add_free(const core::Body& body, Element& element) {
    add(element, "freejoint");
    const Vector3 p = z_up(body.initial.position), v = z_up(body.initial.velocity);
    const Quaternion q = z_up(body.initial.orientation);
    const Vector3 w = q.conjugate() * z_up(body.initial.angular_velocity);
    positions_.insert(positions_.end(), {p.x(), p.y(), p.z(), q.w(), q.x(), q.y(), q.z()});
    add_velocity(v), add_velocity(w);
  }

  void add_velocity(const Vector3& v) {
    velocities_.insert(velocities_.end(), v.begin(), v.end());
    moves_ = moves_ || !v.isZero(0);
  }

  void set_gravity(const core::Body& body, Element& element) const {
    if (!body.gravity || body.locked) return;
    const Vector3 g = core::gravity(scene_), own = *body.gravity;
    const double share = g.isZero(0) ? 0 : own.dot(g) / g.squaredNorm();
    if ((own - share * g).norm() > 1e-15 * (own.norm() + g.norm()))
      throw Unsayable{"body", body.name, "gravity",
                      "it takes a share of the scene's gravity, not another direction"};
    if (share != 1) set(element, "gravcomp", 1 - share);
  }

  void add_inertia(const core::Body& body, Element& element) const {
    Element& inertial = add(element, "inertial");
    set(inertial, "pos", "0 0 0"), set(inertial, "mass", body.mass);
    const core::Matrix3 i = z_up(body.inertia);
    if (i.isDiagonal(0)) {
      set(inertial, "diaginertia", Vector3(i.diagonal()));
      return;
    }
    // I = R diag(moments) R^T, moments ascending.  Not fullinertia: where moments are nearly equal, mju_eig3 of MuJoCo
    // 2.2.2 stops at off-diagonals of a millionth.
    const Eigen::SelfAdjointEigenSolver<core::Matrix3> axes(i);
    core::Matrix3 r = axes.eigenvectors();
    if (r.determinant() < 0) r.col(0) = -r.col(0);
    Vector3 moments = axes.eigenvalues();
    moments[2] =
        std::min(moments[2], moments[0] + moments[1]);  // of a flat body the sum, for MuJoCo to the last bit
    set(inertial, "diaginertia", moments), set(inertial, "quat", text_of(Quaternion(r).normalized()));
  }

  void add_geom(const core::Body& body, int number, const core::Part& part, Element& element) const {
    Element& geom = add(element, "geom");
    const auto size = [&](const char* type, const std::string& numbers) {
      set(geom, "type", type), set(geom, "size", numbers);
    };
    std::visit(
        core::Overloaded{
            [&](const core::Sphere& s) { size("sphere", text(s.radius)); },
            [&](const core::Box& s) { size("box", text(z_up_extents(s.half_extents))); },
            [&](const core::Capsule& s) { size("capsule", fmt::format("{} {}", s.radius, s.length / 2)); },
            [&](const core::Cylinder& s) { size("cylinder", fmt::format("{} {}", s.radius, s.length / 2)); },
            [&]<class S>(const S&) {
              throw Unsayable{"body", body.name, "shape",
                              "it has no such surface, or keeps its points in single precision"};
            },
        },
        part.shape);
    set(geom, "pos", z_up(part.position)), set(geom, "quat", text_of(z_up(part.orientation)));
    set_contact(geom, surfaces_.of_body[at(number)], filters_.of_body[at(number)], body.collide);
  }

  void add_joints(int number, Element& element) {
    const Joint& joint = scene_.joints[at(number)];
    require_plain(scene_, joint);
    other_end(scene_, joint);
    const core::BodyState& body = scene_.bodies[at(joint.body)].initial;
    const std::vector<Motion> motions = motions_of(joint);
    if (motions.empty())
      throw Unsayable{"joint", name_of(scene_, joint.body), "type",
                      fmt::format("it has no {} joint", core::kind_of(joint.type).name)};
    const core::HeldJoint held = core::held_joint(scene_, joint);
    const core::State start = core::initial_state(scene_);
    const Quaternion back = z_up(body.orientation).conjugate();
    for (std::size_t k = 0; k < motions.size(); ++k) {
      const Motion& m = motions[k];
      const JointCoordinate* acts = acting(joint, m);
      Element& made = add(element, "joint");
      // One name a joint of a scene, but for what an actuator must name.
      const bool is_named = k == 0 || (acts && acts->force != 0);
      const std::string name =
          is_named ? unique(joint.name.empty() ? fmt::format("joint {}", number) : joint.name, names_) : "";
      if (is_named) set(made, "name", name);
      set(made, "type", m.type);
      set(made, "pos", Vector3(back * (z_up(m.point.value_or(joint.point)) - z_up(body.position))));
      if (std::string_view(m.type) == "ball") {
        positions_.insert(positions_.end(), {1, 0, 0, 0});
        add_velocity(back * z_up(spin_at(joint)));
        continue;
      }
      set(made, "axis", Vector3(back * z_up(m.axis)));
      positions_.push_back(acts ? acts->start : 0);
      velocities_.push_back(m.slides() ? core::joint_displacement_rate(held, m.which, start)
                                       : core::joint_angle_rate(held, m.which, start));
      moves_ = moves_ || velocities_.back() != 0;
      if (acts) set_coordinate(joint, *acts, name, made);
    }
  }

  // Of `body` against `to`.
  Vector3 spin_at(const Joint& joint) const {
    const auto spin = [&](int body) -> Vector3 {
      return body == core::world ? Vector3::Zero() : scene_.bodies[at(body)].initial.angular_velocity;
    };
    return spin(joint.body) - spin(joint.to);
  }

  // Q = force - stiffness (q - target) - damping q', limits and dry friction; a constant force is an actuator's bias.
  void set_coordinate(const Joint& joint, const JointCoordinate& c, const std::string& name, Element& made) {
    set(made, "ref", c.start);
    if (c.lower.has_value() != c.upper.has_value())
      throw Unsayable{"joint", name_of(scene_, joint.body),
                      joint.displacements.empty() ? "angle" : "displacement",
                      "a limit on one side: a range has two"};
    if (c.lower) set(made, "limited", "true"), set(made, "range", fmt::format("{} {}", *c.lower, *c.upper));
    if (c.stiffness != 0) set(made, "stiffness", c.stiffness), set(made, "springref", c.target);
    if (c.damping != 0) set(made, "damping", c.damping);
    if (c.friction != 0) set(made, "frictionloss", c.friction);
    if (c.armature != 0) set(made, "armature", c.armature);
    if (c.force == 0) return;
    Element& actuator = add(actuators_, "general");
    set(actuator, "joint", name);
    set(actuator, "gainprm", "0"), set(actuator, "biastype", "affine");
    set(actuator, "biasprm", fmt::format("{} 0 0", c.force));
  }

  void add_loop(const Joint& joint) {
    const std::string& name = name_of(scene_, joint.body);
    if (!core::is_ball(joint) && joint.type != JointType::fixed)
      throw Unsayable{"joint", name, "type",
                      fmt::format("a {} joint that closes a loop, or is the second that carries its body",
                                  core::kind_of(joint.type).name)};
    const core::BodyState& body = scene_.bodies[at(joint.body)].initial;
    const int to = other_end(scene_, joint);
    Element& made = add(equality_, core::is_ball(joint) ? "connect" : "weld");
    if (!joint.name.empty()) set(made, "name", unique(joint.name, equalities_));
    set(made, "body1", name);
    if (to != core::world) set(made, "body2", name_of(scene_, to));
    if (core::is_ball(joint))
      set(made, "anchor",
          Vector3(z_up(body.orientation).conjugate() * (z_up(joint.point) - z_up(body.position))));
    if (to == core::world) return;
    Element& apart = add(excluded_, "exclude");  // bodies that a joint ties do not touch
    set(apart, "body1", name), set(apart, "body2", name_of(scene_, to));
  }

  const scenario::Scenario& scenario_;
  const core::Scene& scene_;
  Tree tree_;
  Surfaces surfaces_;
  core::CollisionFilters filters_;
  Element root_, equality_, excluded_, actuators_;
  std::set<std::string> names_, equalities_;
  std::vector<double> positions_, velocities_;
  bool moves_ = false;
};

}  // namespace

Exported to_mjcf(const scenario::Scenario& scenario) { return Writer(scenario).write(); }

}  // namespace cylon::exports
