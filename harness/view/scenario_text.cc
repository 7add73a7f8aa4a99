#include "harness/view/scenario_text.h"

#include "harness/core/overloaded.h"

#include <fmt/format.h>

#include <iterator>

namespace cylon::view {
namespace {

using core::Vector3;

std::string number(double x) {
  std::string text = fmt::format("{}", x);
  // TOML's floats need a point or an exponent; integers would do, but not beyond 64 bits.
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}
std::string vector(const Vector3& v) {
  return fmt::format("[{}, {}, {}]", number(v.x()), number(v.y()), number(v.z()));
}
std::string quaternion(const core::Quaternion& q) {
  return fmt::format("[{}, {}, {}, {}]", number(q.w()), number(q.x()), number(q.y()), number(q.z()));
}
std::string vertices(const std::vector<Vector3>& points) {
  std::string text = "[";
  for (const Vector3& p : points) text += vector(p) + ", ";
  return text + "]";
}

// "type = …, …" without braces: a part of a compound has more keys beside.
std::string primitive(const core::Primitive& shape) {
  const auto with = [](const char* type, const std::string& rest) {
    return fmt::format("type = \"{}\", {}", type, rest);
  };
  const auto round = [&](const char* type, double radius, double length) {
    return with(type, fmt::format("radius = {}, length = {}", number(radius), number(length)));
  };
  return std::visit(
      core::Overloaded{
          [](std::monostate) { return std::string(); },
          [&](const core::Sphere& s) { return with("sphere", "radius = " + number(s.radius)); },
          [&](const core::Box& s) { return with("box", "half_extents = " + vector(s.half_extents)); },
          [&](const core::Capsule& s) { return round("capsule", s.radius, s.length); },
          [&](const core::Cylinder& s) { return round("cylinder", s.radius, s.length); },
          [&](const core::Cone& s) { return round("cone", s.radius, s.length); },
          [&](const core::Rod& s) { return with("rod", "length = " + number(s.length)); },
          [&](const core::Disc& s) { return with("disc", "radius = " + number(s.radius)); },
          [&](const core::Hull& s) { return with("hull", "vertices = " + vertices(s.vertices)); },
          [&](const core::Mesh& s) {
            std::string faces = "[";
            for (const auto& f : s.faces) faces += fmt::format("[{}, {}, {}], ", f[0], f[1], f[2]);
            return with("mesh", fmt::format("vertices = {}, faces = {}]", vertices(s.vertices), faces));
          }},
      shape);
}

std::string shape(const core::Shape& any) {
  if (const auto* compound = std::get_if<core::Compound>(&any)) {
    std::string parts;
    for (const core::Part& part : compound->parts)
      parts += fmt::format("{{ {}, mass = {}, position = {}, orientation = {} }}, ", primitive(part.shape),
                           number(part.mass), vector(part.position), quaternion(part.orientation));
    return fmt::format("{{ type = \"compound\", parts = [{}] }}", parts);
  }
  return std::visit(core::Overloaded{[](const core::Compound&) { return std::string(); },
                                     [](const auto& s) { return fmt::format("{{ {} }}", primitive(s)); }},
                    any);
}

class Writer {
 public:
  explicit Writer(const core::Scene& scene) : scene_(scene) {}

  std::string write() {
    Vector3 gravity = Vector3::Zero();
    for (const core::Force& force : scene_.forces)
      if (const auto* uniform = std::get_if<core::UniformGravity>(&force)) gravity += uniform->acceleration;
    if (!gravity.isZero(0)) line("gravity", vector(gravity));
    if (scene_.impacts == core::Impacts::simultaneous) line("impacts", toml_text("simultaneous"));
    if (scene_.frame) {
      table("[frame]");
      line("velocity", vector(scene_.frame->velocity));
      line("angular_velocity", vector(scene_.frame->angular_velocity));
    }
    for (const core::Body& body : scene_.bodies) add(body);
    for (const core::Force& force : scene_.forces) std::visit([this](const auto& f) { add(f); }, force);
    for (const core::Joint& joint : scene_.joints) add(joint);
    for (const core::Plane& plane : scene_.planes) add(plane);
    for (const core::Material& material : scene_.materials) add(material);
    return std::move(text_);
  }

 private:
  void table(const char* head) { text_ += fmt::format("\n{}\n", head); }
  void line(const char* key, const std::string& value) { text_ += fmt::format("{} = {}\n", key, value); }
  std::string name(int body) const { return toml_text(scene_.bodies[static_cast<std::size_t>(body)].name); }

  void add(const core::Body& b) {
    table("[[body]]");
    line("name", toml_text(b.name));
    if (!std::holds_alternative<core::Compound>(b.shape)) {
      line("mass", number(b.mass));
      std::string inertia;
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) inertia += number(b.inertia(row, column)) + ", ";
      line("inertia", "[" + inertia + "]");
    }
    line("position", vector(b.initial.position));
    line("orientation", quaternion(b.initial.orientation));
    if (!b.initial.velocity.isZero(0)) line("velocity", vector(b.initial.velocity));
    if (!b.initial.angular_velocity.isZero(0)) line("angular_velocity", vector(b.initial.angular_velocity));
    if (!std::holds_alternative<std::monostate>(b.shape)) {
      line("shape", shape(b.shape));
      line("collide", b.collide ? "true" : "false");
    }
    if (b.locked) line("locked", "true");
    if (!b.color.empty()) line("color", toml_text(b.color));
  }
  void add(const core::UniformGravity&) {}  // stands at the top
  void add(const core::Spring& s) {
    table("[[spring]]");
    line("body", name(s.body));
    line("anchor", vector(s.anchor));
    if (s.to == core::world) {
      line("pin", vector(s.to_anchor));
    } else {
      line("to", name(s.to));
      line("to_anchor", vector(s.to_anchor));
    }
    line("stiffness", number(s.stiffness));
    line("rest_length", number(s.rest_length));
    line("damping", number(s.damping));
  }
  void add(const core::Drag& d) {
    table("[[drag]]");
    line("body", name(d.body));
    line("linear", number(d.linear));
    line("angular", number(d.angular));
    line("momentum", number(d.momentum));
  }
  void add(const core::Thrust& t) {
    table("[[thrust]]");
    line("body", name(t.body));
    if (!t.force.isZero(0)) line("force", vector(t.force));
    if (t.mass_rate != 0) line("mass_rate", number(t.mass_rate));
    if (t.exhaust_velocity) line("exhaust_velocity", vector(*t.exhaust_velocity));
    if (t.exchanged_velocity) line("exchanged_velocity", vector(*t.exchanged_velocity));
  }
  void add(const core::Drive& d) {
    table("[[drive]]");
    line("body", name(d.body));
    line("force", vector(d.force));
    line("frequency", number(d.frequency));
  }
  void add(const core::Attraction& a) {
    table("[[attraction]]");
    line("body", name(a.body));
    line("to", name(a.to));
    line("strength", number(a.strength));
  }
  void add(const core::Water& w) {
    table("[[water]]");
    line("level", number(w.level));
    line("wave", number(w.wave));
    line("speed", number(w.speed));
    line("buoyancy", number(w.buoyancy));
    line("drag", number(w.drag));
    line("mode", toml_text(w.mode));
  }
  void add(const core::Joint& j) {
    constexpr const char* types[] = {"ball", "hinge", "distance", "fixed"};  // in the order of JointType
    table("[[joint]]");
    line("type", toml_text(types[static_cast<std::size_t>(j.type)]));
    line("body", name(j.body));
    if (j.to != core::world) line("to", name(j.to));
    const bool distance = j.type == core::JointType::distance;
    if (!distance || j.to == core::world) line("point", vector(j.point));
    if (j.type == core::JointType::hinge) line("axis", vector(j.axis));
    if (distance) line("length", number(j.length));
  }
  void add(const core::Plane& p) {
    table("[[plane]]");
    line("name", toml_text(p.name));
    line("normal", vector(p.normal));
    line("offset", number(p.offset));
  }
  void add(const core::Material& m) {
    table("[[material]]");
    line("between", fmt::format("[{}, {}]", toml_text(m.between[0]), toml_text(m.between[1])));
    line("restitution", number(m.restitution));
    line("friction", number(m.friction));
  }

  const core::Scene& scene_;
  std::string text_;
};

}  // namespace

std::string toml_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      result += fmt::format("\\{}", c);
    else if (byte < ' ' || byte == 127)
      result += fmt::format("\\u{:04X}", byte);
    else
      result += c;
  }
  return result + '"';
}

std::string scene_toml(const core::Scene& scene) { return Writer(scene).write(); }

}  // namespace cylon::view
