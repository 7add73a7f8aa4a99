#include "reference/simulators/mujoco/mujoco_model.h"

#include "harness/core/overloaded.h"
#include "harness/core/surfaces.h"
#include "reference/applied/forces.h"
#include "reference/applied/parts.h"
#include "reference/simulators/mujoco/mujoco_joints.h"
#include "reference/simulators/mujoco/mujoco_limits.h"
#include "reference/simulators/mujoco/mujoco_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <variant>

namespace cylon::simulators {
namespace {

using core::Quaternion;
using core::Vector3;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// MuJoCo's axis of revolution is z, ours y: a turn by -90 degrees about x.
const Quaternion z_to_y(std::sqrt(0.5), -std::sqrt(0.5), 0, 0);

// The turn from z, MuJoCo's normal of a plane, to a unit normal n, of any length:  (1 + z.n, z x n),  or, where that
// cancels, half a turn about x and then the turn from -z.  MuJoCo normalises it, so that a normal along an axis has exactly
// its direction: a stack on a plane whose normal is off by one rounding falls.
Quaternion turn_to(const Vector3& n) {
  if (n.z() > -0.5) return {1 + n.z(), -n.y(), n.x(), 0};
  return {-n.y(), 1 - n.z(), 0, n.x()};
}

std::string text(double x) { return fmt::format("{:.17g}", x); }
std::string text(const Vector3& v) { return fmt::format("{:.17g} {:.17g} {:.17g}", v.x(), v.y(), v.z()); }
std::string text(const Quaternion& q) {
  return fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}", q.w(), q.x(), q.y(), q.z());
}

std::string geom_name(int body, std::size_t part) { return fmt::format("g{}_{}", body, part); }
std::string plane_name(int plane) { return fmt::format("p{}", plane); }

class Writer {
 public:
  Writer(const core::Scene& scene, const applied::Forest& forest, const MujocoContacts& contacts,
         const MujocoSettings& settings, double dt)
      : scene_(scene), forest_(forest), contacts_(contacts), settings_(settings), dt_(dt) {}

  std::string xml() {
    put("<mujoco>\n");
    put("<compiler angle=\"radian\" coordinate=\"local\" inertiafromgeom=\"false\"/>\n");
    write_options();
    write_defaults();
    put("<worldbody>\n");
    for (std::size_t i = 0; i < scene_.planes.size(); ++i) write_plane(static_cast<int>(i));
    for (const core::Body& body : scene_.bodies)
      if (body.locked) write_locked(index_of(body));
    for (const int root : forest_.roots) write_moving(root);
    write_ends_in_world();
    put("</worldbody>\n");
    write_assets();
    write_contacts();
    write_loops();
    put("</mujoco>\n");
    return std::move(out_);
  }

 private:
  template <class... Arguments>
  void put(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Arguments>(arguments)...);
  }
  int index_of(const core::Body& body) const { return static_cast<int>(&body - scene_.bodies.data()); }
  const core::Body& body(int i) const { return scene_.bodies[at(i)]; }
  bool moves(int i) const { return i != core::world && !body(i).locked; }

  void write_options() {
    const MujocoMemory memory = mujoco_memory(scene_, contacts_.points);
    put("<size njmax=\"{}\" nconmax=\"{}\" nstack=\"{}\"/>\n", std::max(1, static_cast<int>(memory.rows)),
        std::max(1, static_cast<int>(contacts_.points)), static_cast<int>(memory.numbers));
    put("<option timestep=\"{}\" gravity=\"{}\" integrator=\"{}\" collision=\"{}\"", text(dt_),
        text(core::gravity(scene_)),
        settings_.integrator == "rk4"     ? "RK4"
        : settings_.integrator == "euler" ? "Euler"
                                          : "implicit",
        contacts_.uniform ? "dynamic" : "predefined");
    write_attributes(MujocoPlace::option);
    put("><flag filterparent=\"disable\"");
    write_attributes(MujocoPlace::flag);
    put("/></option>\n");
  }

  void write_attributes(int place) {
    for (const applied::Option& option : mujoco_options().rows())
      if (option.place == place)
        put(" {}=\"{}\"", option.setting, applied::text(option, settings_.at(option.name)));
  }

  // The softness of contacts, listed or not, and of constraints.
  void write_defaults() {
    const std::string soft =
        fmt::format("solref=\"{} {}\" solimp=\"{} {} {}\"", text(settings_.at("solref-time")),
                    text(settings_.at("solref-damping")), text(settings_.at("solimp-least")),
                    text(settings_.at("solimp-most")), text(settings_.at("solimp-width")));
    const double mu = contacts_.friction;
    put("<default><geom {0} condim=\"{1}\" friction=\"{2} 0 0\"/><pair {0}/><equality {0}/></default>\n",
        soft, condim(mu), text(mu));
  }

  // Without friction a contact has its normal alone.
  static int condim(double friction) { return friction > 0 ? 3 : 1; }

  // ---- Bodies ---------------------------------------------------------------------------------------

  void write_plane(int i) {
    const core::Plane& plane = scene_.planes[at(i)];
    put("<geom name=\"{}\" type=\"plane\" size=\"0 0 1\" pos=\"{}\" quat=\"{}\"/>\n", plane_name(i),
        text(Vector3(plane.offset * plane.normal)), text(turn_to(plane.normal)));
  }

  void write_locked(int i) {
    const core::BodyState& start = body(i).initial;
    put("<body name=\"{}\" pos=\"{}\" quat=\"{}\">\n", mujoco_body_name(i), text(start.position),
        text(start.orientation));
    write_geoms(i);
    write_ends(i);
    put("</body>\n");
  }

  // In the frame of its parent; the joints are at zero where the scene starts.
  void write_moving(int i) {
    const applied::Node& node = forest_.nodes[at(i)];
    const core::Body& one = body(i);
    Vector3 position = one.initial.position;
    Quaternion orientation = one.initial.orientation;
    if (node.parent != core::world) {
      const core::BodyState& parent = body(node.parent).initial;
      position = parent.orientation.conjugate() * (position - parent.position);
      orientation = parent.orientation.conjugate() * orientation;
    }
    put("<body name=\"{}\" pos=\"{}\" quat=\"{}\">\n", mujoco_body_name(i), text(position),
        text(orientation));
    const core::PrincipalAxes axes = core::principal_axes(one.inertia);
    put("<inertial pos=\"0 0 0\" mass=\"{}\" quat=\"{}\" diaginertia=\"{}\"/>\n", text(one.mass),
        text(axes.rotation), text(mujoco_moments(axes.moments)));
    if (node.joint < 0)
      put("<freejoint/>\n");
    else
      write_joint(one, scene_.joints[at(node.joint)], scene_.joints[at(node.joint)].body != i);
    write_geoms(i);
    write_ends(i);
    for (const int child : node.children) write_moving(child);
    put("</body>\n");
  }

  // A fixed joint is none: the body is part of its parent.
  void write_joint(const core::Body& one, const core::Joint& joint, bool reversed) {
    const Quaternion back = one.initial.orientation.conjugate();
    const auto local = [&](const Vector3& point) {
      return text(Vector3(back * (point - one.initial.position)));
    };
    if (core::is_ball(joint)) put("<joint type=\"ball\" pos=\"{}\"/>\n", local(joint.point));
    if (core::is_ball(joint) || joint.type == core::JointType::fixed) return;
    for (const MujocoAxis& coordinate : mujoco_axes(scene_, joint, reversed))
      put("<joint type=\"{}\" pos=\"{}\" axis=\"{}\"{}/>\n", coordinate.slides ? "slide" : "hinge",
          local(coordinate.point), text(Vector3(back * coordinate.axis)), stops(coordinate.acts));
  }

  // A limit on one side alone has the other beyond every coordinate that MuJoCo takes.
  static std::string stops(const core::JointCoordinate& c) {
    constexpr double far = 1e10;  // mjMAXVAL
    std::string words;
    if (core::has_limit(c))
      words += fmt::format(" limited=\"true\" range=\"{} {}\"", text(c.lower ? *c.lower - c.start : -far),
                           text(c.upper ? *c.upper - c.start : far));
    if (c.friction != 0) words += fmt::format(" frictionloss=\"{}\"", text(c.friction));
    if (core::has_rotor(c)) words += fmt::format(" armature=\"{}\"", text(c.armature));
    return words;
  }

  // ---- Shapes ---------------------------------------------------------------------------------------

  void write_geoms(int i) {
    if (!core::collides(body(i))) return;
    const std::vector<core::Part> parts = applied::parts_of(body(i).shape);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      const bool round = std::holds_alternative<core::Capsule>(parts[k].shape) ||
                         std::holds_alternative<core::Cylinder>(parts[k].shape);
      const Quaternion turn = round ? Quaternion(parts[k].orientation * z_to_y) : parts[k].orientation;
      const std::string shape = shape_of(parts[k].shape, geom_name(i, k));
      if (shape.empty()) continue;
      put("<geom name=\"{}\" {} pos=\"{}\" quat=\"{}\"/>\n", geom_name(i, k), shape, text(parts[k].position),
          text(turn));
    }
  }

  // mujoco_limit() refuses those that have none.
  std::string shape_of(const core::Primitive& shape, const std::string& name) {
    return std::visit(
        core::Overloaded{
            [](const core::Sphere& s) { return fmt::format("type=\"sphere\" size=\"{}\"", text(s.radius)); },
            [](const core::Box& s) { return fmt::format("type=\"box\" size=\"{}\"", text(s.half_extents)); },
            [](const core::Capsule& s) {
              return fmt::format("type=\"capsule\" size=\"{} {}\"", text(s.radius), text(s.length / 2));
            },
            [](const core::Cylinder& s) {
              return fmt::format("type=\"cylinder\" size=\"{} {}\"", text(s.radius), text(s.length / 2));
            },
            [&](const core::Hull& s) {
              std::string vertices;
              for (const Vector3& v : s.vertices) vertices += text(v) + ' ';
              assets_ += fmt::format("<mesh name=\"{}\" vertex=\"{}\"/>\n", name, vertices);
              return fmt::format("type=\"mesh\" mesh=\"{}\"", name);
            },
            [](const auto&) { return std::string(); }},
        shape);
  }

  void write_assets() {
    if (!assets_.empty()) put("<asset>\n{}</asset>\n", assets_);
  }

  // ---- Contacts -------------------------------------------------------------------------------------

  void write_contacts() {
    put("<contact>\n");
    // Neighbours on a joint do not touch; where pairs are listed, they are none of them.
    if (contacts_.uniform)
      for (const auto& [a, b] : core::jointed_pairs(scene_))
        if (moves(a) || moves(b))
          put("<exclude body1=\"{}\" body2=\"{}\"/>\n", mujoco_body_name(a), mujoco_body_name(b));
    for (const MujocoPair& one : contacts_.pairs)
      for (const std::string& mine : geoms_of(one.pair.body))
        for (const std::string& other :
             one.pair.plane >= 0 ? std::vector{plane_name(one.pair.plane)} : geoms_of(one.pair.other))
          put("<pair geom1=\"{}\" geom2=\"{}\" condim=\"{}\" friction=\"{} {} 0 0 0\"/>\n", mine, other,
              condim(one.friction), text(one.friction), text(one.friction));
    put("</contact>\n");
  }

  std::vector<std::string> geoms_of(int i) const {
    std::vector<std::string> names;
    const std::vector<core::Part> parts = applied::parts_of(body(i).shape);
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (!std::holds_alternative<std::monostate>(parts[k].shape)) names.push_back(geom_name(i, k));
    return names;
  }

  // ---- Joints that are constraints ------------------------------------------------------------------

  static constexpr bool is_distance(const core::Joint& joint) {
    return core::kind_of(joint.type).joins_centres();
  }

  // The ends of distances are sites: centres of mass, and points of the world.
  void write_ends(int i) {
    for (const std::size_t j : forest_.loops) {
      const core::Joint& joint = scene_.joints[j];
      if (!is_distance(joint)) continue;
      if (joint.body == i) put("<site name=\"s{}_0\"/>\n", j);
      if (joint.to == i) put("<site name=\"s{}_1\"/>\n", j);
    }
  }

  void write_ends_in_world() {
    for (const std::size_t j : forest_.loops)
      if (is_distance(scene_.joints[j]) && scene_.joints[j].to == core::world)
        put("<site name=\"s{}_1\" pos=\"{}\"/>\n", j, text(scene_.joints[j].point));
  }

  void write_loops() {
    if (forest_.loops.empty()) return;
    std::string tendons, equalities;
    for (const std::size_t j : forest_.loops) {
      const core::Joint& joint = scene_.joints[j];
      if (is_distance(joint)) {
        tendons += fmt::format(
            "<spatial name=\"t{0}\"><site site=\"s{0}_0\"/><site site=\"s{0}_1\"/></spatial>\n", j);
        equalities += fmt::format("<tendon tendon1=\"t{}\" polycoef=\"{} 0 0 0 0\"/>\n", j,
                                  text(joint.length - distance_at_start(joint)));
        continue;
      }
      equalities += joint.type == core::JointType::fixed ? weld(joint) : connect(joint, joint.point);
      // A hinge is held in two points of its axis, a metre apart.
      if (joint.type == core::JointType::hinge) equalities += connect(joint, joint.point + joint.axis);
    }
    if (!tendons.empty()) put("<tendon>\n{}</tendon>\n", tendons);
    put("<equality>\n{}</equality>\n", equalities);
  }

  double distance_at_start(const core::Joint& joint) const {
    const Vector3 end = joint.to == core::world ? joint.point : body(joint.to).initial.position;
    return (end - body(joint.body).initial.position).norm();
  }

  // The body that moves comes first; the world is left out.
  std::string bodies(const core::Joint& joint) const {
    const int first = moves(joint.body) ? joint.body : joint.to;
    const int second = first == joint.body ? joint.to : joint.body;
    return fmt::format("body1=\"{}\"{}", mujoco_body_name(first),
                       moves(second) ? fmt::format(" body2=\"{}\"", mujoco_body_name(second)) : "");
  }

  std::string connect(const core::Joint& joint, const Vector3& point) const {
    const core::BodyState& start = body(moves(joint.body) ? joint.body : joint.to).initial;
    return fmt::format("<connect {} anchor=\"{}\"/>\n", bodies(joint),
                       text(Vector3(start.orientation.conjugate() * (point - start.position))));
  }

  // In the pose of the start, which MuJoCo takes where none is given.
  std::string weld(const core::Joint& joint) const { return fmt::format("<weld {}/>\n", bodies(joint)); }

  const core::Scene& scene_;
  const applied::Forest& forest_;
  const MujocoContacts& contacts_;
  const MujocoSettings& settings_;
  double dt_;
  std::string out_, assets_;
};

}  // namespace

std::string mujoco_body_name(int i) { return fmt::format("b{}", i); }

std::string mujoco_xml(const core::Scene& scene, const applied::Forest& forest,
                       const MujocoContacts& contacts, const MujocoSettings& settings, double dt) {
  return Writer(scene, forest, contacts, settings, dt).xml();
}

}  // namespace cylon::simulators
