// cylon-import-urdf FILE ROOT…: lets urdfdom read a file and prints it as a foreign model (harness/imports/model).
//
// urdfdom and not libsdformat, which takes links that a fixed joint ties for one link, drops links without inertia, and
// in 12.3 has no switch against either.
#include "harness/imports/model/model_json.h"
#include "reference/formats/resources/resources.h"
#include "reference/formats/urdf/tags.h"

#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace {

namespace foreign = cylon::foreign;
namespace formats = cylon::formats;
using foreign::Matrix3;
using foreign::Pose;
using foreign::Quaternion;
using foreign::Vector3;

Vector3 vector(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }
Pose pose(const urdf::Pose& p) {
  return {vector(p.position),
          Quaternion(p.rotation.w, p.rotation.x, p.rotation.y, p.rotation.z).normalized()};
}

// What urdfdom calls an error it leaves out and goes on: a link's inertia, and all that stands behind it in the link.
class Errors : public console_bridge::OutputHandler {
 public:
  Errors() { console_bridge::useOutputHandler(this); }
  ~Errors() override { console_bridge::restorePreviousOutputHandler(); }
  Errors(const Errors&) = delete;
  Errors& operator=(const Errors&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR) return;
    told_ += (told_.empty() ? "" : "; ") + text;
  }
  void refuse_any() const {
    if (!told_.empty()) throw formats::Refused("urdfdom: " + told_);
  }

 private:
  std::string told_;
};

class Reader {
 public:
  Reader(std::string file, std::vector<std::string> roots)
      : file_(std::move(file)), roots_(std::move(roots)) {}

  foreign::Model read() {
    formats::require_tree(file_);
    const Errors errors;
    const urdf::ModelInterfaceSharedPtr urdf = urdf::parseURDFFile(file_);
    errors.refuse_any();
    if (!urdf) throw formats::Refused("urdfdom refuses it");
    tags_ = formats::tags_of(file_);
    model_.losses = tags_.losses;
    model_.library = "urdfdom 3";
    model_.losses.push_back(
        {"assumed",
         {"robot '" + urdf->getName() + "'", "", 0},
         "gravity 9.81 m/s^2, friction 1, no restitution, no contact of its links with each other"});
    add_links(urdf->getRoot());
    hold_root();
    return std::move(model_);
  }

 private:
  void lose(const char* what, const std::string& element, std::string detail = "") {
    model_.losses.push_back({what, {element, "", 0}, std::move(detail)});
  }

  // A root without mass, and without a link of mass that is fixed to it, is a base that does not move: no force moves it
  // in any other reading.
  void hold_root() {
    std::vector<bool> one(model_.bodies.size());
    one[0] = true;
    double mass = model_.bodies[0].mass;
    for (const foreign::Joint& joint : model_.joints)  // parents come first
      if (joint.freedoms.empty() && one[static_cast<std::size_t>(joint.to)]) {
        one[static_cast<std::size_t>(joint.body)] = true;
        mass += model_.bodies[static_cast<std::size_t>(joint.body)].mass;
      }
    foreign::Body& root = model_.bodies[0];
    if (mass > 0 || root.locked) return;
    root.locked = true;
    lose("assumed", root.place.element, "a root without mass does not move");
  }

  // Parents before children, so that a link's place follows from its parent's; no recursion, however long the chain.
  void add_links(const urdf::LinkConstSharedPtr& root) {
    std::vector<std::pair<urdf::LinkConstSharedPtr, Pose>> waiting = {{root, Pose()}};
    while (!waiting.empty()) {
      const auto [link, frame] = waiting.back();
      waiting.pop_back();
      numbers_[link->name] = static_cast<int>(model_.bodies.size());
      add_link(*link, frame);
      if (link->parent_joint) add_joint(*link->parent_joint, frame);
      for (const urdf::LinkSharedPtr& child : link->child_links)
        waiting.emplace_back(child, frame * pose(child->parent_joint->parent_to_joint_origin_transform));
    }
  }

  void add_link(const urdf::Link& link, const Pose& frame) {
    foreign::Body& body = model_.bodies.emplace_back();
    body.name = link.name;
    body.place.element = "link '" + link.name + "'";
    // The convention of ROS: a root of this name is the world itself.
    body.locked = !link.parent_joint && link.name == "world";
    Pose centre;
    if (link.inertial) {
      const urdf::Inertial& i = *link.inertial;
      const Pose origin = pose(i.origin);
      centre.position = origin.position;
      body.mass = i.mass;
      Matrix3 own;
      own << i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz;
      const Matrix3 r = origin.turn.toRotationMatrix();
      body.inertia = r * own * r.transpose();
    }
    if (const auto inertial = tags_.inertials.find(link.name);
        !link.inertial && inertial != tags_.inertials.end())
      throw formats::Refused("line " + std::to_string(inertial->second) + ": " + body.place.element +
                             ": urdfdom does not read its inertial");
    body.pose = frame * centre;
    for (const urdf::CollisionSharedPtr& collision : link.collision_array)
      if (collision && collision->geometry) add_solid(link, *collision, centre, body);
    if (!link.visual_array.empty()) lose("visual", body.place.element);
  }

  void add_solid(const urdf::Link& link, const urdf::Collision& collision, const Pose& centre,
                 foreign::Body& body) {
    foreign::Solid& solid = body.solids.emplace_back();
    solid.place.element = "collision of link '" + link.name + "'";
    solid.pose = centre.inverse() * pose(collision.origin);
    const urdf::Geometry& geometry = *collision.geometry;
    switch (geometry.type) {
      case urdf::Geometry::SPHERE:
        solid.kind = "sphere";
        solid.size.x() = dynamic_cast<const urdf::Sphere&>(geometry).radius;
        break;
      case urdf::Geometry::BOX:
        solid.kind = "box";
        solid.size = vector(dynamic_cast<const urdf::Box&>(geometry).dim) / 2;
        break;
      case urdf::Geometry::CYLINDER: {
        const auto& cylinder = dynamic_cast<const urdf::Cylinder&>(geometry);
        solid.kind = "cylinder";
        solid.size = {cylinder.radius, cylinder.length, 0};
        break;
      }
      default: {
        const auto& mesh = dynamic_cast<const urdf::Mesh&>(geometry);
        solid.kind = "mesh";
        try {
          formats::load_mesh(formats::resolve(mesh.filename, file_, roots_), vector(mesh.scale), solid);
        } catch (const formats::Refused& error) {
          throw formats::Refused(solid.place.element + ": " + error.what());
        }
      }
    }
  }

  static const char* kind_of(const urdf::Joint& joint) {
    return joint.type == urdf::Joint::CONTINUOUS ? "continuous"
           : joint.type == urdf::Joint::PLANAR   ? "planar"
           : joint.type == urdf::Joint::FLOATING ? "floating"
                                                 : "fixed";
  }

  void add_joint(const urdf::Joint& from, const Pose& frame) {
    foreign::Joint joint;
    joint.name = from.name;
    joint.place.element = "joint '" + from.name + "'";
    joint.body = numbers_.at(from.child_link_name), joint.to = numbers_.at(from.parent_link_name);
    joint.point = frame.position;
    if (from.mimic) lose("mimic", joint.place.element, "joint '" + from.mimic->joint_name + "'");
    if (from.safety) lose("transmission", joint.place.element, "safety controller");
    const bool is_limited = from.type == urdf::Joint::REVOLUTE || from.type == urdf::Joint::PRISMATIC;
    if (from.limits) {
      if (from.limits->effort != 0 || from.limits->velocity != 0) lose("effort", joint.place.element);
      if (!is_limited && (from.limits->lower != 0 || from.limits->upper != 0))
        lose("unused", joint.place.element, std::string("limits of a ") + kind_of(from) + " joint");
    }
    if (from.type == urdf::Joint::FIXED && from.dynamics &&
        (from.dynamics->damping != 0 || from.dynamics->friction != 0))
      lose("unused", joint.place.element, "dynamics of a fixed joint");
    if (from.type == urdf::Joint::FLOATING) {
      if (from.dynamics && from.dynamics->damping != 0)
        lose("joint_damping", joint.place.element, "a floating joint");
      if (from.dynamics && from.dynamics->friction != 0)
        lose("joint_friction", joint.place.element, "a floating joint");
      return;
    }
    const Vector3 axis = frame.turn * vector(from.axis);
    if (from.type != urdf::Joint::FIXED && !(axis.norm() > 0))
      throw formats::Refused(joint.place.element + ": its axis has no direction");
    switch (from.type) {
      case urdf::Joint::REVOLUTE:
      case urdf::Joint::CONTINUOUS:
        joint.freedoms = {{.kind = "turn", .axis = axis.normalized()}};
        break;
      case urdf::Joint::PRISMATIC:
        joint.freedoms = {{.kind = "slide", .axis = axis.normalized()}};
        break;
      case urdf::Joint::PLANAR: {
        const Vector3 along = axis.unitOrthogonal();
        joint.freedoms = {{.kind = "slide", .axis = along},
                          {.kind = "slide", .axis = axis.normalized().cross(along)},
                          {.kind = "turn", .axis = axis.normalized()}};
        break;
      }
      case urdf::Joint::FIXED:
        break;
      default:
        lose("joint_kind", joint.place.element, "unknown");
    }
    if (from.limits && is_limited)
      joint.freedoms.front().lower = from.limits->lower, joint.freedoms.front().upper = from.limits->upper;
    if (from.dynamics)
      for (foreign::Freedom& freedom : joint.freedoms)
        freedom.damping = from.dynamics->damping, freedom.friction = from.dynamics->friction;
    model_.joints.push_back(std::move(joint));
  }

  std::string file_;
  std::vector<std::string> roots_;
  std::map<std::string, int> numbers_;
  formats::Tags tags_;
  foreign::Model model_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return formats::refuse("usage: cylon-import-urdf FILE ROOT…");
  try {
    foreign::Model model = Reader(argv[1], {argv + 2, argv + argc}).read();
    // Every link touches what is not of this robot: in a file of one robot nothing.
    const std::string text = to_json(model).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
    std::fwrite(text.data(), 1, text.size(), stdout);
    std::fflush(stdout);
    std::_Exit(0);  // a chain of 1e5 links would be taken apart by recursion
  } catch (const std::exception& error) {
    return formats::refuse(error.what());
  }
}
