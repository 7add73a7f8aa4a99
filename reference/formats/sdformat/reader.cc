#include "reference/formats/sdformat/reader.h"

#include "reference/formats/resources/gazebo.h"
#include "reference/formats/resources/resources.h"
#include "reference/formats/sdformat/includes.h"

#include <filesystem>
#include <utility>

namespace cylon::formats {
namespace {

using foreign::Place;
using foreign::Pose;
using foreign::Vector3;

Vector3 vector(const ignition::math::Vector3d& v) { return {v.X(), v.Y(), v.Z()}; }
Pose pose(const ignition::math::Pose3d& p) {
  return {vector(p.Pos()),
          foreign::Quaternion(p.Rot().W(), p.Rot().X(), p.Rot().Y(), p.Rot().Z()).normalized()};
}

constexpr double none = 1e15;  // what stands for "no limit" is 1e16, or infinity

// "file:line: message" of each, one a line.
std::string text_of(const sdf::Errors& errors) {
  std::string text;
  for (const sdf::Error& error : errors) {
    if (!text.empty()) text += '\n';
    if (error.LineNumber()) text += "line " + std::to_string(*error.LineNumber()) + ": ";
    text += error.Message();
  }
  return text;
}

void require(const sdf::Errors& errors) {
  if (!errors.empty()) throw Refused(text_of(errors));
}

Pose resolved(const sdf::SemanticPose& semantic) {
  ignition::math::Pose3d result;
  require(semantic.Resolve(result));
  return pose(result);
}

}  // namespace

SdfReader::SdfReader(std::string file, std::vector<std::string> roots)
    : file_(std::move(file)), roots_(std::move(roots)) {}

void SdfReader::lose(const char* what, Place where, std::string detail) {
  model_.losses.push_back({what, std::move(where), std::move(detail)});
}

Place SdfReader::place(const char* kind, const std::string& name, const sdf::ElementPtr& element) const {
  Place result{std::string(kind) + " '" + name + "'", "", 0};
  if (!element) return result;
  if (element->LineNumber()) result.line = *element->LineNumber();
  result.file = other_file(element->FilePath());
  return result;
}

// What an <include> brought stands in another file.
std::string SdfReader::other_file(const std::string& path) const {
  std::error_code ignored;
  return path.empty() || std::filesystem::equivalent(path, file_, ignored) ? "" : path;
}

foreign::Model SdfReader::read() {
  const auto find = [this](const std::string& uri) -> std::string {
    try {
      return resolve(uri, file_, roots_);
    } catch (const Refused&) {  // a folder of a model, or nothing: the library says so
      for (const std::string& root : roots_)
        if (const auto folder = std::filesystem::path(root) /
                                uri.substr(uri.find("://") == std::string::npos ? 0 : uri.find("://") + 3);
            std::filesystem::is_directory(folder))
          return folder.string();
      return "";
    }
  };
  require_no_circle(file_, find);
  sdf::ParserConfig config;
  config.SetFindCallback(find);
  read_file(config);
  check_warnings(config);
  add_meetings();
  return std::move(model_);
}

void SdfReader::read_file(const sdf::ParserConfig& config) {
  sdf::Root root;
  require(root.Load(file_, config));
  model_.library = "libsdformat " SDF_VERSION_FULL;
  if (root.WorldCount() > 0) {
    for (std::uint64_t i = 1; i < root.WorldCount(); ++i)
      lose("custom", place("world", root.WorldByIndex(i)->Name(), root.WorldByIndex(i)->Element()),
           "a second world");
    if (root.Model())
      lose("unread", place("model", root.Model()->Name(), root.Model()->Element()), "beside a world");
    read_world(*root.WorldByIndex(0));
  } else if (root.Model()) {
    lose("assumed", place("model", root.Model()->Name(), root.Model()->Element()), "gravity 9.81 m/s^2");
    read_model(*root.Model(), resolved(root.Model()->SemanticPose()), root.Model()->Name(),
               root.Model()->Static(), {});
  } else {
    throw Refused("it holds neither a world nor a model");
  }
  check_elements(root.Element(), 1);
}

void SdfReader::read_world(const sdf::World& world) {
  model_.gravity = vector(world.Gravity());
  windy_ = world.WindLinearVelocity() != ignition::math::Vector3d::Zero;
  if (const sdf::Physics* physics = world.PhysicsDefault()) model_.step = physics->MaxStepSize();
  for (std::uint64_t i = 0; i < world.PhysicsCount(); ++i)
    if (const sdf::Physics& physics = *world.PhysicsByIndex(i); &physics != world.PhysicsDefault())
      lose("solver", place("physics", physics.Name(), physics.Element()), "not the profile of the start");
  for (std::uint64_t i = 0; i < world.ActorCount(); ++i)
    lose("actor", place("actor", world.ActorByIndex(i)->Name(), world.ActorByIndex(i)->Element()));
  for (std::uint64_t i = 0; i < world.LightCount(); ++i)
    lose("presentation", place("light", world.LightByIndex(i)->Name(), world.LightByIndex(i)->Element()),
         "light");
  read_plugins(world.Element());
  for (std::uint64_t i = 0; i < world.ModelCount(); ++i) {
    const sdf::Model& model = *world.ModelByIndex(i);
    read_model(model, resolved(model.SemanticPose()), model.Name(), model.Static(),
               {.number = static_cast<int>(i)});
  }
}

void SdfReader::read_plugins(const sdf::ElementPtr& element) {
  if (!element || !element->HasElement("plugin")) return;
  for (sdf::ElementPtr plugin = element->GetElement("plugin"); plugin;
       plugin = plugin->GetNextElement("plugin")) {
    const auto name = plugin->Get<std::string>("name"), library = plugin->Get<std::string>("filename");
    lose(leaves_bodies_alone(library, name) ? "plugin" : "plugin_force", place("plugin", name, plugin));
  }
}

// Its plugins run in the server, where they reach all bodies.
void SdfReader::lose_sensor(const sdf::Sensor& sensor) {
  lose("sensor", place("sensor", sensor.Name(), sensor.Element()));
  read_plugins(sensor.Element());
}

// Links of a model touch each other only where it says so; nested models belong to the outermost.
void SdfReader::read_model(const sdf::Model& model, const Pose& frame, const std::string& scope, bool locked,
                           Own own) {
  own.self = own.self || model.SelfCollide();
  read_plugins(model.Element());
  for (std::uint64_t i = 0; i < model.LinkCount(); ++i)
    read_link(*model.LinkByIndex(i), frame, scope, locked, own);
  for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
    const sdf::Model& inner = *model.ModelByIndex(i);
    read_model(inner, frame * resolved(inner.SemanticPose()), scope + "::" + inner.Name(),
               locked || inner.Static(), own);
  }
  for (std::uint64_t i = 0; i < model.JointCount(); ++i) read_joint(*model.JointByIndex(i), frame, scope);
}

void SdfReader::read_link(const sdf::Link& link, const Pose& frame, const std::string& scope, bool locked,
                          Own own) {
  const std::string name = scope + "::" + link.Name();
  bodies_[name] = static_cast<int>(model_.bodies.size());
  foreign::Body& body = model_.bodies.emplace_back();
  body.name = name;
  body.place = place("link", name, link.Element());
  body.locked = locked;
  const ignition::math::Inertiald& inertial = link.Inertial();
  const Pose centre{vector(inertial.Pose().Pos()), foreign::Quaternion::Identity()};
  body.mass = inertial.MassMatrix().Mass();
  const ignition::math::Matrix3d moi = inertial.Moi();  // about the centre of mass, axes of the link
  for (std::size_t r = 0; r < 3; ++r)
    for (std::size_t c = 0; c < 3; ++c) body.inertia(static_cast<int>(r), static_cast<int>(c)) = moi(r, c);
  body.pose = frame * resolved(link.SemanticPose()) * centre;
  const sdf::ElementPtr element = link.Element();
  own.self = own.self || (element && element->Get<bool>("self_collide", false).first);
  if (element && !element->Get<bool>("gravity", true).first) body.gravity = Vector3::Zero();
  if (element && element->Get<bool>("kinematic", false).first)
    lose("mocap", body.place, "kinematic"), body.locked = true;
  if (element && element->HasElement("velocity_decay") && !locked) {
    const sdf::ElementPtr decay = element->GetElement("velocity_decay");
    if (decay->Get<double>("linear", 0).first != 0 || decay->Get<double>("angular", 0).first != 0)
      lose("free_drag", body.place, "velocity_decay");
  }
  for (std::uint64_t i = 0; i < link.SensorCount(); ++i) lose_sensor(*link.SensorByIndex(i));
  if (link.VisualCount() > 0) lose("visual", body.place);
  for (std::uint64_t i = 0; i < link.VisualCount(); ++i) read_plugins(link.VisualByIndex(i)->Element());
  for (std::uint64_t i = 0; i < link.LightCount(); ++i)
    lose("presentation", place("light", link.LightByIndex(i)->Name(), link.LightByIndex(i)->Element()),
         "light");
  for (std::uint64_t i = 0; i < link.CollisionCount(); ++i)
    read_collision(*link.CollisionByIndex(i), name, centre, own, body);
}

int SdfReader::body_of(const std::string& scope, const std::string& name, const Place& at) const {
  if (name == "world") return -1;
  const auto found = bodies_.find(scope + "::" + name);
  if (found == bodies_.end()) throw Refused(at.element + ": there is no link '" + name + "'");
  return found->second;
}

void SdfReader::read_joint(const sdf::Joint& from, const Pose& frame, const std::string& scope) {
  foreign::Joint joint;
  joint.name = scope + "::" + from.Name();
  joint.place = place("joint", joint.name, from.Element());
  std::string parent, child;
  require(from.ResolveParentLink(parent));
  require(from.ResolveChildLink(child));
  joint.body = body_of(scope, child, joint.place), joint.to = body_of(scope, parent, joint.place);
  ignition::math::Pose3d at;
  require(from.SemanticPose().Resolve(at, "__model__"));
  const Pose own = frame * pose(at);
  joint.point = own.position;
  switch (from.Type()) {
    case sdf::JointType::FIXED:
      break;
    case sdf::JointType::BALL:
      joint.freedoms = {{.kind = "ball"}};
      break;
    case sdf::JointType::REVOLUTE:
    case sdf::JointType::CONTINUOUS:
      joint.freedoms = {{.kind = "turn"}};
      break;
    case sdf::JointType::PRISMATIC:
      joint.freedoms = {{.kind = "slide"}};
      break;
    case sdf::JointType::UNIVERSAL:
    case sdf::JointType::REVOLUTE2:
      joint.freedoms = {{.kind = "turn"}, {.kind = "turn"}};
      break;
    case sdf::JointType::SCREW:
      lose("joint_kind", joint.place, "screw: releases and engines read thread_pitch in different units");
      break;
    default:
      lose("joint_kind", joint.place, "gearbox");
      break;
  }
  // Without <axis> it is z of the joint's own frame.
  for (foreign::Freedom& freedom : joint.freedoms) freedom.axis = own.turn * Vector3::UnitZ();
  for (std::size_t i = 0; i < joint.freedoms.size(); ++i)
    if (const sdf::JointAxis* axis = from.Axis(static_cast<unsigned>(i));
        axis && joint.freedoms[i].kind != "ball") {
      const std::string kind = joint.freedoms[i].kind;
      joint.freedoms[i] = freedom_of(*axis, frame, joint.place);
      joint.freedoms[i].kind = kind;
      if (from.Type() == sdf::JointType::CONTINUOUS) {
        if (joint.freedoms[i].lower || joint.freedoms[i].upper)
          lose("unused", joint.place, "limits of a continuous joint");
        joint.freedoms[i].lower = joint.freedoms[i].upper = std::nullopt;
      }
    }
  const char* const names[] = {"<axis>", "<axis2>"};
  for (const unsigned i : {0u, 1u})
    if (const sdf::JointAxis* axis = from.Axis(i);
        axis && (i >= joint.freedoms.size() || joint.freedoms[i].kind == "ball"))
      lose_axis(*axis, names[i], from.Type(), joint.place);
  for (std::uint64_t i = 0; i < from.SensorCount(); ++i) lose_sensor(*from.SensorByIndex(i));
  model_.joints.push_back(std::move(joint));
}

foreign::Freedom SdfReader::freedom_of(const sdf::JointAxis& axis, const Pose& frame, const Place& at) {
  foreign::Freedom freedom;
  ignition::math::Vector3d xyz;
  require(axis.ResolveXyz(xyz, "__model__"));
  freedom.axis = (frame.turn * vector(xyz)).normalized();
  if (axis.Lower() > -none) freedom.lower = axis.Lower();
  if (axis.Upper() < none) freedom.upper = axis.Upper();
  freedom.stiffness = axis.SpringStiffness(), freedom.rest = axis.SpringReference();
  freedom.damping = axis.Damping(), freedom.friction = axis.Friction();
  lose_drive(axis, at);
  return freedom;
}

void SdfReader::lose_drive(const sdf::JointAxis& axis, const Place& at) {
  if (axis.Effort() > 0 && axis.Effort() < none) lose("effort", at);
  if (axis.MaxVelocity() >= 0 && axis.MaxVelocity() < none) lose("effort", at, "velocity");
}

void SdfReader::lose_axis(const sdf::JointAxis& axis, const char* which, sdf::JointType type,
                          const Place& at) {
  lose("unused", at, which);
  lose_drive(axis, at);
  if (type != sdf::JointType::BALL) return;
  // The format does not say about which of its axes.
  const char* const ball = "a ball joint";
  if (axis.Damping() != 0) lose("joint_damping", at, ball);
  if (axis.Friction() != 0) lose("joint_friction", at, ball);
  if (axis.SpringStiffness() != 0) lose("joint_spring", at, ball);
  if (axis.Lower() > -none || axis.Upper() < none) lose("joint_limit", at, ball);
}

}  // namespace cylon::formats
