// A scene reaches a worker unchanged: every field and every double, bit by bit.
#include "harness/process/scene_json.h"
#include "harness/process/json_fields.h"
#include "harness/process/messages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>

namespace cylon::process {
namespace {

using namespace core;
using nlohmann::json;

// ---- The bytes of a scene.  Structured bindings: a field that is added and forgotten here does not compile.

using Bytes = std::string;

template <class T>
requires std::is_arithmetic_v<T> || std::is_enum_v<T>
void put(Bytes& out, T value) { out.append(reinterpret_cast<const char*>(&value), sizeof value); }
void put(Bytes& out, const std::string& text) {
  put(out, text.size());
  out += text;
}
template <int R, int C>
void put(Bytes& out, const Eigen::Matrix<double, R, C>& m) {
  for (int i = 0; i < R; ++i)
    for (int j = 0; j < C; ++j) put(out, m(i, j));
}
void put(Bytes& out, const Quaternion& q) {
  for (const double c : {q.w(), q.x(), q.y(), q.z()}) put(out, c);
}
void put(Bytes&, std::monostate) {}

template <class T, std::size_t N>
void put(Bytes& out, const std::array<T, N>& values) {
  for (const T& value : values) put(out, value);
}

#define CYLON_FIELDS(Type, ...)             \
  void put(Bytes& out, const Type& value) { \
    const auto& [__VA_ARGS__] = value;      \
    each(out, __VA_ARGS__);                 \
  }
template <class... T>
void each(Bytes& out, const T&... values);
template <class T>
void put(Bytes& out, const std::vector<T>& values);
template <class T>
void put(Bytes& out, const std::optional<T>& value);
template <class... T>
void put(Bytes& out, const std::variant<T...>& value);

CYLON_FIELDS(Sphere, a)
CYLON_FIELDS(Box, a)
CYLON_FIELDS(Capsule, a, b)
CYLON_FIELDS(Cylinder, a, b)
CYLON_FIELDS(Cone, a, b)
CYLON_FIELDS(Rod, a)
CYLON_FIELDS(Disc, a)
CYLON_FIELDS(Hull, a)
CYLON_FIELDS(Mesh, a, b)
CYLON_FIELDS(Part, a, b, c, d)
CYLON_FIELDS(Compound, a)
CYLON_FIELDS(BodyState, a, b, c, d)
CYLON_FIELDS(Body, a, b, c, d, e, f, g, h, i, j, k)
CYLON_FIELDS(UniformGravity, a)
CYLON_FIELDS(Spring, a, b, c, d, e, f, g)
CYLON_FIELDS(Drag, a, b, c, d)
CYLON_FIELDS(Thrust, a, b, c, d, e)
CYLON_FIELDS(Drive, a, b, c)
CYLON_FIELDS(Attraction, a, b, c)
CYLON_FIELDS(Water, a, b, c, d, e, f)
void put(Bytes& out, const NamedNumbers& values) {
  for (const auto& [name, value] : values) put(out, name), put(out, value);
}
CYLON_FIELDS(PluginForce, a, b, c, d)
CYLON_FIELDS(JointDisplacement, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q)
CYLON_FIELDS(JointAngle, a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q)
CYLON_FIELDS(Joint, a, b, c, d, e, f, g, h, i, j, k)
CYLON_FIELDS(Plane, a, b, c, d, e)
CYLON_FIELDS(Frame, a, b, c, d, e)
void put(Bytes& out, const Material& value) {
  const auto& [between, restitution, friction] = value;
  each(out, between[0], between[1], restitution, friction);
}
CYLON_FIELDS(Scene, a, b, c, d, e, f, g)
#undef CYLON_FIELDS

template <class T>
void put(Bytes& out, const std::vector<T>& values) {
  put(out, values.size());
  for (const T& value : values) put(out, value);
}
template <class T>
void put(Bytes& out, const std::optional<T>& value) {
  put(out, value.has_value());
  if (value) put(out, *value);
}
template <class... T>
void put(Bytes& out, const std::variant<T...>& value) {
  put(out, value.index());
  std::visit([&](const auto& v) { put(out, v); }, value);
}
template <class... T>
void each(Bytes& out, const T&... values) {
  (put(out, values), ...);
}

Bytes bytes_of(const Scene& scene) {
  Bytes out;
  put(out, scene);
  return out;
}

// ---- Random scenes with every kind of everything -------------------------------------------------

class Dice {
 public:
  explicit Dice(unsigned seed) : bits_(seed) {}

  /// Any finite double: random bits, so that exponents are uniform and denormals and -0 occur.
  double number() {
    if (int_below(16) == 0) return -0.0;
    for (;;) {
      const std::uint64_t word = bits_();
      double value = 0;
      std::memcpy(&value, &word, sizeof value);
      if (std::isfinite(value)) return value;
    }
  }
  int int_below(int n) { return static_cast<int>(bits_() % static_cast<unsigned>(n)); }
  bool flag() { return int_below(2) == 1; }
  Vector3 vector() { return {number(), number(), number()}; }
  Quaternion quaternion() { return {number(), number(), number(), number()}; }
  std::vector<Vector3> vectors(int n) {
    std::vector<Vector3> result;
    for (int i = 0; i < n; ++i) result.push_back(vector());
    return result;
  }

  template <class Any>
  Any primitive(int kind) {
    switch (kind) {
      case 1:
        return Sphere{number()};
      case 2:
        return Box{vector()};
      case 3:
        return Capsule{number(), number()};
      case 4:
        return Cylinder{number(), number()};
      case 5:
        return Cone{number(), number()};
      case 6:
        return Rod{number()};
      case 7:
        return Disc{number()};
      case 8:
        return Hull{vectors(5)};
      case 9:
        return Mesh{vectors(4), {{0, 1, 2}, {3, 2, 1}}};
      default:
        return std::monostate{};
    }
  }
  Shape shape(int kind) {
    if (kind < 10) return primitive<Shape>(kind);
    Compound compound;
    for (int part = 0; part < 10; ++part)
      compound.parts.push_back({primitive<Primitive>(part), number(), vector(), quaternion()});
    return compound;
  }

  Scene scene() {
    Scene scene;
    const int bodies = 11;  // one of each shape
    for (int i = 0; i < bodies; ++i) {
      Body body;
      body.name = i == 0 ? "a \"quoted\" name, \xC3\xA4" : "body" + std::to_string(i);
      body.mass = number();
      body.inertia << number(), number(), number(), number(), number(), number(), number(), number(),
          number();
      body.initial = {vector(), quaternion(), vector(), vector()};
      body.shape = shape(i);
      body.locked = flag(), body.collide = flag();
      if (flag()) body.gravity = vector();
      if (flag()) body.collision_groups = {"wheels", "an odd \"name\""};
      if (flag()) body.collision_mask = {"default"};
      body.color = flag() ? "#12ab9f" : "";
      scene.bodies.push_back(body);
    }
    const auto body = [&] { return int_below(bodies); };
    scene.forces.emplace_back(UniformGravity{{number(), 9.81, number()}});
    scene.forces.emplace_back(Spring{body(), vector(), world, vector(), number(), number(), number()});
    scene.forces.emplace_back(Spring{body(), vector(), body(), vector(), number(), number(), number()});
    scene.forces.emplace_back(Drag{body(), number(), number(), number()});
    scene.forces.emplace_back(Thrust{body(), vector(), number(), {}, {}});
    scene.forces.emplace_back(Thrust{body(), vector(), number(), vector(), {}});
    scene.forces.emplace_back(Thrust{body(), vector(), number(), {}, vector()});
    scene.forces.emplace_back(Drive{body(), vector(), number()});
    scene.forces.emplace_back(Attraction{body(), body(), number()});
    scene.forces.emplace_back(
        Water{number(), number(), number(), number(), number(), flag() ? "step" : "volume"});
    if (flag())
      scene.forces.emplace_back(PluginForce{
          "mine", "an odd \"law\"", {body(), body()}, {{"k", number()}, {"an odd \"name\"", number()}}});
    const auto coordinate = [&] {
      JointCoordinate c{flag() ? Ordinal::first : Ordinal::second,
                        number(),
                        {},
                        {},
                        number(),
                        number(),
                        number(),
                        number(),
                        number(),
                        number(),
                        number(),
                        number(),
                        number(),
                        number(),
                        {},
                        {}};
      if (flag()) c.lower = number();
      if (flag()) c.upper = number();
      if (flag()) c.target_times = {number(), number()}, c.target_values = {number(), number()};
      return c;
    };
    for (const JointKind& kind : joint_kinds) {
      scene.joints.push_back({kind.type, body(), flag() ? world : body(), vector(), vector(), number()});
      Joint& joint = scene.joints.back();
      if (flag()) joint.name = "elbow";
      if (kind.has_second_axis()) joint.axis_2 = vector();
      if (kind.screws) joint.pitch = number();
      if (flag()) joint.displacements = {{coordinate()}, {coordinate()}};
      if (flag()) joint.angles = {{coordinate()}};
    }
    scene.planes = {{"floor", vector(), number()}, {"wall", vector(), number(), {"walls"}, {"wheels"}}};
    scene.materials = {{{"body1", "floor"}, number(), number()}, {{"*", "*"}, number(), number()}};
    if (flag()) scene.frame = Frame{vector(), vector(), vector(), number(), vector()};
    scene.impacts = flag() ? Impacts::simultaneous : Impacts::sequential;
    return scene;
  }

 private:
  std::mt19937_64 bits_;
};

TEST(SceneJson, RoundTripsEveryFieldBitByBit) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    const Scene scene = Dice(seed).scene();
    const Scene back = scene_from_json(json::parse(line(to_json(scene))));
    ASSERT_EQ(bytes_of(back), bytes_of(scene)) << "seed " << seed;
  }
}

TEST(SceneJson, ComparisonDetectsOneBit) {  // the test's own negative control
  const Scene scene = Dice(1).scene();
  Scene other = scene;
  other.bodies[4].initial.velocity.z() = std::nextafter(other.bodies[4].initial.velocity.z(), 1.0);
  EXPECT_NE(bytes_of(other), bytes_of(scene));
}

TEST(SceneJson, DefaultsAreWrittenOut) {
  Scene scene;
  scene.bodies.push_back({});
  scene.bodies[0].name = "a";
  const json text = to_json(scene);
  EXPECT_EQ(text.at("gravity"), json({0.0, 0.0, 0.0}));
  EXPECT_EQ(text.at("body").at(0).at("inertia").size(), 9u);
  for (const char* key :
       {"spring", "drag", "thrust", "drive", "attraction", "water", "joint", "plane", "material"})
    EXPECT_EQ(text.at(key), json::array()) << key;
  EXPECT_FALSE(text.contains("plugin_force"));  // which older workers do not know
  EXPECT_TRUE(scene_from_json(text).forces.empty());
  for (const char* key : {"collision_groups", "collision_mask"}) EXPECT_FALSE(text["body"][0].contains(key));
}

// The message when `edit` has been at the JSON of a sound scene.
std::string complaint(const std::function<void(json&)>& edit) {
  json text = to_json(Dice(3).scene());
  edit(text);
  try {
    scene_from_json(text);
  } catch (const MalformedMessage& error) {
    return error.what();
  }
  return "accepted";
}

TEST(SceneJson, ErrorsNameTheKey) {
  EXPECT_EQ(complaint([](json&) {}), "accepted");
  EXPECT_EQ(complaint([](json& s) { s.erase("gravity"); }), "gravity: missing");
  EXPECT_EQ(complaint([](json& s) { s["gravty"] = 1; }), "gravty: unknown key");
  EXPECT_EQ(complaint([](json& s) { s["plane"][0]["collision_groups"] = {1}; }),
            "plane[0].collision_groups[0]: expected a name");
  EXPECT_EQ(complaint([](json& s) { s["plane"][0]["collision_mask"] = json::array(); }),
            "plane[0].collision_mask: expected one name at least");
  EXPECT_EQ(complaint([](json& s) { s["body"][3]["mass"] = "1 kg"; }), "body[3].mass: expected a number");
  EXPECT_EQ(complaint([](json& s) { s["body"][3]["mass"] = nullptr; }), "body[3].mass: expected a number");
  EXPECT_EQ(complaint([](json& s) { s["body"][2]["masss"] = 1; }), "body[2].masss: unknown key");
  EXPECT_EQ(complaint([](json& s) {
              s["body"][2]["inertia"] = {1, 2, 3};
            }),
            "body[2].inertia: expected 9 numbers");
  EXPECT_EQ(complaint([](json& s) { s["body"][2]["name"] = "body1"; }),
            "body[2].name: two bodies are named 'body1'");
  EXPECT_EQ(complaint([](json& s) { s["body"][1]["shape"]["type"] = "blob"; }),
            "body[1].shape.type: unknown shape 'blob'");
  EXPECT_EQ(complaint([](json& s) { s["body"][9]["shape"]["faces"][0][1] = 4; }),
            "body[9].shape.faces[0]: a vertex is an index below 4");
  EXPECT_EQ(complaint([](json& s) { s["body"][10]["shape"]["parts"][1]["shape"]["radius"] = true; }),
            "body[10].shape.parts[1].shape.radius: expected a number");
  EXPECT_EQ(complaint([](json& s) { s["spring"][0]["body"] = "nobody"; }),
            "spring[0].body: no body is named 'nobody'");
  EXPECT_EQ(complaint([](json& s) { s["joint"][0]["type"] = "weld"; }),
            "joint[0].type: unknown value 'weld'");
  EXPECT_EQ(complaint([](json& s) { s["plane"] = 3; }), "plane: expected an array");
  EXPECT_EQ(complaint([](json& s) { s["plane"][0] = 3; }), "plane[0]: expected an object");
}

TEST(SceneJson, TwoBodiesOfOneNameAreRefusedAtTheSender) {
  Scene scene;
  scene.bodies.resize(2);
  EXPECT_THROW(to_json(scene), std::invalid_argument);
}

}  // namespace
}  // namespace cylon::process
