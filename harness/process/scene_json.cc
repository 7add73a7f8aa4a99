#include "harness/process/scene_json.h"

#include "harness/process/json_fields.h"
#include "harness/process/shape_json.h"

#include <fmt/format.h>

#include <array>
#include <stdexcept>
#include <unordered_map>

namespace cylon::process {
namespace {

using core::Scene;
using core::Vector3;
using nlohmann::json;

constexpr std::array joint_types = {"ball", "hinge", "distance", "fixed"};  // in the order of JointType
constexpr std::array impact_rules = {"sequential", "simultaneous"};         // in the order of Impacts

// ---- Scene to JSON ------------------------------------------------------------------------------

json body_json(const core::Body& body) {
  json inertia = json::array();
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) inertia.push_back(body.inertia(row, column));
  json result = {{"name", body.name},
                 {"mass", body.mass},
                 {"inertia", std::move(inertia)},
                 {"position", vector_json(body.initial.position)},
                 {"orientation", quaternion_json(body.initial.orientation)},
                 {"velocity", vector_json(body.initial.velocity)},
                 {"angular_velocity", vector_json(body.initial.angular_velocity)},
                 {"locked", body.locked},
                 {"collide", body.collide},
                 {"color", body.color}};
  if (!std::holds_alternative<std::monostate>(body.shape)) result["shape"] = shape_json(body.shape);
  return result;
}

class Writer {
 public:
  explicit Writer(const Scene& scene) : scene_(scene) {
    for (const char* key : {"spring", "drag", "thrust", "drive", "attraction", "water"})
      out_[key] = json::array();
    std::unordered_map<std::string, int> seen;
    for (const core::Body& body : scene.bodies)
      if (++seen[body.name] > 1)
        throw std::invalid_argument(fmt::format("two bodies are named '{}'", body.name));
  }

  json write() {
    json& bodies = out_["body"] = json::array();
    for (const core::Body& body : scene_.bodies) bodies.push_back(body_json(body));
    for (const core::Force& force : scene_.forces) std::visit([&](const auto& f) { add(f); }, force);
    out_["gravity"] = vector_json(gravity_.value_or(Vector3::Zero()));
    json& joints = out_["joint"] = json::array();
    for (const core::Joint& joint : scene_.joints) {
      joints.push_back({{"type", joint_types[static_cast<std::size_t>(joint.type)]},
                        {"body", name(joint.body)},
                        {"point", vector_json(joint.point)},
                        {"axis", vector_json(joint.axis)},
                        {"length", joint.length}});
      if (joint.to != core::world) joints.back()["to"] = name(joint.to);
    }
    json& planes = out_["plane"] = json::array();
    for (const core::Plane& plane : scene_.planes)
      planes.push_back(
          {{"name", plane.name}, {"normal", vector_json(plane.normal)}, {"offset", plane.offset}});
    json& materials = out_["material"] = json::array();
    for (const core::Material& m : scene_.materials)
      materials.push_back({{"between", {m.between[0], m.between[1]}},
                           {"restitution", m.restitution},
                           {"friction", m.friction}});
    if (scene_.frame)
      out_["frame"] = {{"velocity", vector_json(scene_.frame->velocity)},
                       {"angular_velocity", vector_json(scene_.frame->angular_velocity)}};
    out_["impacts"] = impact_rules[static_cast<std::size_t>(scene_.impacts)];
    return std::move(out_);
  }

 private:
  const std::string& name(int body) const { return scene_.bodies.at(static_cast<std::size_t>(body)).name; }

  void add(const core::UniformGravity& force) {
    gravity_ = gravity_ ? Vector3(*gravity_ + force.acceleration) : force.acceleration;
  }

  void add(const core::Spring& s) {
    json row = {{"body", name(s.body)},
                {"anchor", vector_json(s.anchor)},
                {"stiffness", s.stiffness},
                {"rest_length", s.rest_length},
                {"damping", s.damping}};
    if (s.to == core::world) {
      row["pin"] = vector_json(s.to_anchor);
    } else {
      row["to"] = name(s.to);
      row["to_anchor"] = vector_json(s.to_anchor);
    }
    out_["spring"].push_back(std::move(row));
  }

  void add(const core::Drag& d) {
    out_["drag"].push_back(
        {{"body", name(d.body)}, {"linear", d.linear}, {"angular", d.angular}, {"momentum", d.momentum}});
  }

  void add(const core::Thrust& t) {
    json row = {{"body", name(t.body)}, {"force", vector_json(t.force)}, {"mass_rate", t.mass_rate}};
    if (t.exhaust_velocity) row["exhaust_velocity"] = vector_json(*t.exhaust_velocity);
    if (t.exchanged_velocity) row["exchanged_velocity"] = vector_json(*t.exchanged_velocity);
    out_["thrust"].push_back(std::move(row));
  }

  void add(const core::Drive& d) {
    out_["drive"].push_back(
        {{"body", name(d.body)}, {"force", vector_json(d.force)}, {"frequency", d.frequency}});
  }

  void add(const core::Attraction& a) {
    if (a.to == core::world) throw std::invalid_argument("an attraction needs two bodies");
    out_["attraction"].push_back({{"body", name(a.body)}, {"to", name(a.to)}, {"strength", a.strength}});
  }

  void add(const core::Water& w) {
    out_["water"].push_back({{"level", w.level},
                             {"wave", w.wave},
                             {"speed", w.speed},
                             {"buoyancy", w.buoyancy},
                             {"drag", w.drag},
                             {"mode", w.mode}});
  }

  const Scene& scene_;
  json out_ = json::object();
  std::optional<Vector3> gravity_;  // no sum with zero: -0 stays -0
};

// ---- JSON to Scene ------------------------------------------------------------------------------

class Reader {
 public:
  explicit Reader(const json& value) : top_(value, "") {}

  Scene read() {
    top_.each("body", [&](const json& row, const std::string& place) { body(row, place); });
    if (const Vector3 g = top_.vector("gravity"); g != Vector3::Zero())
      scene_.forces.emplace_back(core::UniformGravity{g});
    rows("spring", [&](Fields& f) { return spring(f); });
    rows("drag", [&](Fields& f) {
      return core::Drag{index(f, "body"), f.number("linear"), f.number("angular"), f.number("momentum")};
    });
    rows("thrust", [&](Fields& f) { return thrust(f); });
    rows("drive", [&](Fields& f) {
      return core::Drive{index(f, "body"), f.vector("force"), f.number("frequency")};
    });
    rows("attraction", [&](Fields& f) {
      return core::Attraction{index(f, "body"), index(f, "to"), f.number("strength")};
    });
    rows("water", [&](Fields& f) { return water(f); });
    each("joint", [&](Fields& f) { joint(f); });
    each("plane", [&](Fields& f) {
      scene_.planes.push_back({f.text("name"), f.vector("normal"), f.number("offset")});
    });
    each("material", [&](Fields& f) { material(f); });
    if (const json* value = top_.find("frame")) {
      Fields f(*value, "frame");
      scene_.frame = core::Frame{f.vector("velocity"), f.vector("angular_velocity")};
      f.finish();
    }
    scene_.impacts = static_cast<core::Impacts>(word(top_, "impacts", impact_rules));
    top_.finish();
    return std::move(scene_);
  }

 private:
  // Every element of an array as an object whose keys are all read.
  template <class Row>
  void each(const char* key, Row row) {
    top_.each(key, [&](const json& value, const std::string& place) {
      Fields fields(value, place);
      row(fields);
      fields.finish();
    });
  }
  template <class Row>
  void rows(const char* key, Row row) {
    each(key, [&](Fields& fields) { scene_.forces.emplace_back(row(fields)); });
  }

  template <std::size_t N>
  static std::size_t word(Fields& fields, const char* key, const std::array<const char*, N>& words) {
    const std::string text = fields.text(key);
    for (std::size_t i = 0; i < N; ++i)
      if (text == words[i]) return i;
    fields.fail(key, fmt::format("unknown value '{}'", text));
  }

  int index(Fields& fields, const char* key) const {
    const std::string name = fields.text(key);
    const auto found = index_.find(name);
    if (found == index_.end()) fields.fail(key, fmt::format("no body is named '{}'", name));
    return found->second;
  }

  void body(const json& row, const std::string& place) {
    Fields f(row, place);
    core::Body body;
    body.name = f.text("name");
    if (!index_.emplace(body.name, static_cast<int>(scene_.bodies.size())).second)
      f.fail("name", fmt::format("two bodies are named '{}'", body.name));
    body.mass = f.number("mass");
    const std::vector<double> inertia = f.numbers("inertia", 9);
    for (int i = 0; i < 9; ++i) body.inertia(i / 3, i % 3) = inertia[static_cast<std::size_t>(i)];
    body.initial = {f.vector("position"), f.quaternion("orientation"), f.vector("velocity"),
                    f.vector("angular_velocity")};
    body.locked = f.flag("locked");
    body.collide = f.flag("collide");
    body.color = f.text("color");
    if (const json* shape = f.find("shape")) body.shape = shape_from_json(*shape, f.place_of("shape"));
    f.finish();
    scene_.bodies.push_back(std::move(body));
  }

  core::Spring spring(Fields& f) const {
    core::Spring s;
    s.body = index(f, "body");
    s.anchor = f.vector("anchor");
    if (f.find("pin")) {
      s.to_anchor = f.vector("pin");
    } else {
      s.to = index(f, "to");
      s.to_anchor = f.vector("to_anchor");
    }
    s.stiffness = f.number("stiffness");
    s.rest_length = f.number("rest_length");
    s.damping = f.number("damping");
    return s;
  }

  core::Thrust thrust(Fields& f) const {
    core::Thrust t{index(f, "body"), f.vector("force"), f.number("mass_rate"), {}, {}};
    if (f.find("exhaust_velocity")) t.exhaust_velocity = f.vector("exhaust_velocity");
    if (f.find("exchanged_velocity")) t.exchanged_velocity = f.vector("exchanged_velocity");
    return t;
  }

  static core::Water water(Fields& f) {
    return {f.number("level"),    f.number("wave"), f.number("speed"),
            f.number("buoyancy"), f.number("drag"), f.text("mode")};
  }

  void joint(Fields& f) {
    core::Joint joint;
    joint.type = static_cast<core::JointType>(word(f, "type", joint_types));
    joint.body = index(f, "body");
    if (f.find("to")) joint.to = index(f, "to");
    joint.point = f.vector("point");
    joint.axis = f.vector("axis");
    joint.length = f.number("length");
    scene_.joints.push_back(joint);
  }

  void material(Fields& f) {
    const json& between = f.at("between");
    if (!between.is_array() || between.size() != 2 || !between[0].is_string() || !between[1].is_string())
      f.fail("between", "expected two names");
    scene_.materials.push_back({{between[0].get<std::string>(), between[1].get<std::string>()},
                                f.number("restitution"),
                                f.number("friction")});
  }

  Fields top_;
  Scene scene_;
  std::unordered_map<std::string, int> index_;
};

}  // namespace

json to_json(const Scene& scene) { return Writer(scene).write(); }

Scene scene_from_json(const json& value) { return Reader(value).read(); }

}  // namespace cylon::process
