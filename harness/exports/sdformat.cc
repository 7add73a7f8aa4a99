// A scene as a world of SDFormat 1.9: what moves is one model, in which links touch each other; each locked body and each
// plane is a static model.  A name "arm::hand" is a link of a nested model, so that what an import named comes back.
#include "harness/exports/sdformat.h"

#include "harness/exports/parts.h"
#include "harness/exports/xml.h"
#include "harness/exports/z_up.h"

#include "harness/core/collision_filter.h"
#include "harness/core/fields.h"
#include "harness/core/joint_coordinates.h"
#include "harness/core/overloaded.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace cylon::exports {
namespace {

using core::Joint;
using core::JointType;
using core::Quaternion;
using core::Vector3;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// As in gz-sim, whose engine is DART: the smaller friction and the product of the restitutions (reference/formats/sdformat).
constexpr PairRule rule = {[](double a, double b) { return std::min(a, b); }, true};

// What SDFormat calls a kind; null where it has none, or where its releases read the same numbers in different units.
const char* type_of(JointType type) {
  switch (type) {
    case JointType::ball:
      return "ball";
    case JointType::hinge:
      return "revolute";
    case JointType::fixed:
      return "fixed";
    case JointType::slider:
      return "prismatic";
    case JointType::universal:
      return "universal";
    default:
      return nullptr;
  }
}

void add_pose(Element& element, const Vector3& position, const Quaternion& turn) {
  Element& pose = add(element, "pose",
                      fmt::format("{} {} {} {} {}", text(position), turn.x(), turn.y(), turn.z(), turn.w()));
  set(pose, "rotation_format", "quat_xyzw");
}

void add_surface(Element& collision, const Surface& surface) {
  Element& made = add(collision, "surface");
  Element& ode = add(add(made, "friction"), "ode");
  add(ode, "mu", surface.friction), add(ode, "mu2", surface.friction);
  if (surface.restitution != 0) add(add(made, "bounce"), "restitution_coefficient", surface.restitution);
}

// Of names that SDFormat keeps for itself.
void require_free(const char* table, const std::string& name, const std::string& part) {
  if (part == "world" || (part.size() >= 4 && part.starts_with("__") && part.ends_with("__")))
    throw Unsayable{table, name, "name", fmt::format("SDFormat keeps the name '{}' for itself", part)};
}

// The parts of "arm::hand", which are names of models and at last of a link.
std::vector<std::string> parts_of_name(const char* table, const std::string& name) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= name.size();) {
    const std::size_t end = std::min(name.find("::", at), name.size());
    parts.push_back(name.substr(at, end - at));
    at = end + 2;
  }
  for (const std::string& part : parts) {
    if (parts.size() > 1 && part.empty())
      throw Unsayable{table, name, "name",
                      "'::' is between the names of models and links, and one of them is empty"};
    require_free(table, name, part);
  }
  return parts;
}

// A model and those that are nested in it.
struct Scope {
  Element* model = nullptr;
  std::string path;             ///< From the outermost, "" or "arm::".
  std::set<std::string> taken;  ///< Names of links, joints and models, which SDFormat counts as one kind.
  std::map<std::string, Scope> inner{};

  // The nested model of a name, made where it is not there.
  Scope& nested(const std::string& name) {
    const auto [found, is_new] = inner.try_emplace(name);
    Scope& scope = found->second;
    if (!is_new) return scope;
    const std::string own = unique(name, taken);
    scope.model = &add(*model, "model");
    scope.path = path + own + "::";
    set(*scope.model, "name", own), add(*scope.model, "self_collide", "true");
    return scope;
  }
};

class Writer {
 public:
  explicit Writer(const scenario::Scenario& scenario)
      : scenario_(scenario), scene_(scenario.scene), surfaces_(surfaces_of(scene_, rule)) {}

  Exported write() {
    require_plain(scene_);
    require_no_masks();
    Element root;
    Element& sdf = add(root, "sdf");
    set(sdf, "version", "1.9");
    Element& world = add(sdf, "world");
    set(world, "name", scenario_.name);
    Element& physics = add(world, "physics");
    set(physics, "name", "default"), set(physics, "default", "true"), set(physics, "type", "ignored");
    add(physics, "max_step_size", scenario_.step), add(physics, "real_time_factor", "1");
    add(world, "gravity", z_up(core::gravity(scene_)));
    for (std::size_t i = 0; i < scene_.planes.size(); ++i) add_plane(i, world);
    for (const core::Plane& plane : scene_.planes) models_.insert(plane.name);
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i)
      if (scene_.bodies[i].locked) add_locked(i, world);
    const std::string whole = model_of_all();
    Element moving;
    moving_.model = &moving;
    set(moving, "name", unique(whole.empty() ? "scene" : whole, models_));
    add(moving, "self_collide", "true");
    references_.resize(scene_.bodies.size());
    bool any = false;
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i)
      if (!scene_.bodies[i].locked) any = true, add_moving(i, whole.empty() ? 0 : 1);
    for (const Joint& joint : scene_.joints) add_joint(joint, moving);
    if (any) add(world, "model") = moving;
    return {document(root), {}};
  }

 private:
  // A bitmask of SDFormat is one for both sides; a scene without groups needs none.
  void require_no_masks() const {
    for (const core::Body& body : scene_.bodies)
      if (!body.collision_groups.empty() || !body.collision_mask.empty())
        throw Unsayable{"body", body.name,
                        body.collision_groups.empty() ? "collision_mask" : "collision_groups",
                        "it has one mask for both sides of a pair"};
    for (const core::Plane& plane : scene_.planes)
      if (!plane.collision_groups.empty() || !plane.collision_mask.empty())
        throw Unsayable{"plane", plane.name,
                        plane.collision_groups.empty() ? "collision_mask" : "collision_groups",
                        "it has one mask for both sides of a pair"};
  }

  // The model that all moving bodies are in by their names, where no other has its name; "": none.
  std::string model_of_all() const {
    std::string model;
    for (const core::Body& body : scene_.bodies) {
      if (body.locked) continue;
      const std::vector<std::string> parts = parts_of_name("body", body.name);
      if (parts.size() < 2 || (!model.empty() && parts.front() != model)) return "";
      model = parts.front();
    }
    return models_.contains(model) ? "" : model;
  }

  // "box::link" is the link of the model 'box', and so is "box".
  void add_locked(std::size_t i, Element& world) {
    std::vector<std::string> parts = parts_of_name("body", scene_.bodies[i].name);
    if (parts.size() == 1) parts.emplace_back("link");
    const auto [found, is_new] = locked_.try_emplace(parts.front());
    Scope* scope = &found->second;
    if (is_new) {
      scope->model = &add(world, "model");
      set(*scope->model, "name", unique(parts.front(), models_)), add(*scope->model, "static", "true");
    }
    for (std::size_t k = 1; k + 1 < parts.size(); ++k) scope = &scope->nested(parts[k]);
    add_link(i, unique(parts.back(), scope->taken), *scope->model);
  }

  // Its link, in the models that its name tells from the part `first` on.
  void add_moving(std::size_t i, std::size_t first) {
    const std::vector<std::string> parts = parts_of_name("body", scene_.bodies[i].name);
    Scope* scope = &moving_;
    for (std::size_t k = first; k + 1 < parts.size(); ++k) scope = &scope->nested(parts[k]);
    const std::string name = unique(parts.back(), scope->taken);
    references_[i] = scope->path + name;
    add_link(i, name, *scope->model);
  }

  void add_plane(std::size_t i, Element& world) const {
    const core::Plane& plane = scene_.planes[i];
    if (parts_of_name("plane", plane.name).size() > 1)
      throw Unsayable{"plane", plane.name, "name", "'::' is between the names of a model and of its links"};
    Element& model = add(world, "model");
    set(model, "name", plane.name), add(model, "static", "true");
    Element& link = add(model, "link");
    set(link, "name", "link");
    Element& collision = add(link, "collision");
    set(collision, "name", "collision");
    const Vector3 normal = z_up(plane.normal);
    add_pose(collision, plane.offset * normal, Quaternion::Identity());
    add(add(add(collision, "geometry"), "plane"), "normal", normal);
    add_surface(collision, surfaces_.of_plane[i]);
  }

  void add_link(std::size_t i, const std::string& name, Element& model) const {
    const core::Body& body = scene_.bodies[i];
    if (!body.initial.velocity.isZero(0) || !body.initial.angular_velocity.isZero(0))
      throw Unsayable{"body", body.name, body.initial.velocity.isZero(0) ? "angular_velocity" : "velocity",
                      "its worlds begin at rest"};
    Element& link = add(model, "link");
    set(link, "name", name);
    add_pose(link, z_up(body.initial.position), z_up(body.initial.orientation));
    if (body.gravity && !body.locked) {
      if (!body.gravity->isZero(0))
        throw Unsayable{"body", body.name, "gravity", "a link has the gravity of the world, or none"};
      add(link, "gravity", "false");
    }
    if (!body.locked) {
      Element& inertial = add(link, "inertial");
      add(inertial, "mass", body.mass);
      Element& inertia = add(inertial, "inertia");
      const core::Matrix3 m = z_up(body.inertia);
      const char* const letters[] = {"x", "y", "z"};
      for (int r = 0; r < 3; ++r)
        for (int c = r; c < 3; ++c) add(inertia, fmt::format("i{}{}", letters[r], letters[c]), m(r, c));
    }
    int number = 0;
    for (const core::Part& part : parts_of(body)) {
      Element& solid = add(link, body.collide ? "collision" : "visual");
      set(solid, "name", fmt::format("part {}", ++number));
      add_pose(solid, z_up(part.position), z_up(part.orientation));
      add_shape(body, part, add(solid, "geometry"));
      if (body.collide) add_surface(solid, surfaces_.of_body[i]);
    }
  }

  static void add_shape(const core::Body& body, const core::Part& part, Element& geometry) {
    const auto round = [&](const char* kind, double radius, double length) {
      Element& made = add(geometry, kind);
      add(made, "radius", radius), add(made, "length", length);
    };
    std::visit(
        core::Overloaded{
            [&](const core::Sphere& s) { add(add(geometry, "sphere"), "radius", s.radius); },
            [&](const core::Box& s) {
              add(add(geometry, "box"), "size", Vector3(2 * z_up_extents(s.half_extents)));
            },
            [&](const core::Capsule& s) { round("capsule", s.radius, s.length); },
            [&](const core::Cylinder& s) { round("cylinder", s.radius, s.length); },
            [&]<class S>(const S&) {
              throw Unsayable{"body", body.name, "shape", "it has no such surface, but as a file of a mesh"};
            },
        },
        part.shape);
  }

  void add_joint(const Joint& joint, Element& model) {
    const std::string& name = name_of(scene_, joint.body);
    const char* type = type_of(core::is_ball(joint) ? JointType::ball : joint.type);
    if (!type)
      throw Unsayable{"joint", name, "type",
                      fmt::format("it has no {} joint", core::kind_of(joint.type).name)};
    require_plain(scene_, joint);
    const int to = other_end(scene_, joint);
    Element& made = add(model, "joint");
    const auto number = &joint - scene_.joints.data();
    const std::size_t last = joint.name.rfind("::");  // joints are all in the outermost model
    const std::string own = last == std::string::npos ? joint.name : joint.name.substr(last + 2);
    require_free("joint", name, own);
    set(made, "name", unique(own.empty() ? fmt::format("joint {}", number) : own, moving_.taken)),
        set(made, "type", type);
    add(made, "parent", to == core::world ? "world" : references_[at(to)]);
    add(made, "child", references_[at(joint.body)]);
    const core::BodyState& body = scene_.bodies[at(joint.body)].initial;
    add_pose(made, z_up(body.orientation).conjugate() * (z_up(joint.point) - z_up(body.position)),
             Quaternion::Identity());
    if (!core::kind_of(joint.type).has_axis()) return;
    const bool slides = joint.type == JointType::slider;
    add_axis(
        joint, "axis", joint.axis,
        slides ? find(joint.displacements, core::Ordinal::first) : find(joint.angles, core::Ordinal::first),
        made);
    if (joint.axis_2)
      add_axis(joint, "axis2", *joint.axis_2, find(joint.angles, core::Ordinal::second), made);
  }

  template <class Coordinate>
  static const core::JointCoordinate* find(const std::vector<Coordinate>& coordinates, core::Ordinal which) {
    const auto found = std::ranges::find(coordinates, which, &Coordinate::which);
    return found == coordinates.end() ? nullptr : &*found;
  }

  void add_axis(const Joint& joint, const char* which, const Vector3& axis, const core::JointCoordinate* c,
                Element& made) const {
    Element& element = add(made, which);
    set(add(element, "xyz", z_up(axis)), "expressed_in", "__model__");
    if (!c) return;
    const auto fail = [&](const char* why) {
      throw Unsayable{"joint", name_of(scene_, joint.body),
                      joint.type == JointType::slider ? "displacement" : "angle", why};
    };
    if (c->start != 0) fail("start: a coordinate is 0 in the pose of the model");
    if (c->force != 0) fail("force: it has no constant force in a joint");
    if (c->armature != 0) fail("armature: it has no rotors");
    if (c->lower || c->upper) {
      Element& limit = add(element, "limit");
      if (c->lower) add(limit, "lower", *c->lower);
      if (c->upper) add(limit, "upper", *c->upper);
    }
    Element& dynamics = add(element, "dynamics");
    add(dynamics, "damping", c->damping), add(dynamics, "friction", c->friction);
    add(dynamics, "spring_reference", c->target), add(dynamics, "spring_stiffness", c->stiffness);
  }

  const scenario::Scenario& scenario_;
  const core::Scene& scene_;
  Surfaces surfaces_;
  std::set<std::string> models_;         ///< Names of models of the world.
  std::map<std::string, Scope> locked_;  ///< Static models.
  Scope moving_;
  std::vector<std::string> references_;  ///< Of each moving body, from the model that moves.
};

}  // namespace

Exported to_sdformat(const scenario::Scenario& scenario) { return Writer(scenario).write(); }

}  // namespace cylon::exports
