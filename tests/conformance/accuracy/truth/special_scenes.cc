// Files that hold several cases, or that use keys of their own.
#include "tests/conformance/accuracy/truth/truth_file.h"

#include <cmath>
#include <functional>
#include <map>
#include <numbers>

namespace cylon::accuracy {
namespace {

using core::Quaternion;
using core::Vector3;

constexpr int samples_per_run = 32;

core::Body sphere(const std::string& name, double mass, double radius, const Vector3& position,
                  const Vector3& velocity) {
  core::Body body;
  body.name = name;
  body.mass = mass;
  body.shape = core::Sphere{radius};
  body.inertia = core::Matrix3::Identity() * (0.4 * mass * radius * radius);
  body.initial.position = position;
  body.initial.velocity = velocity;
  body.collide = true;
  return body;
}

// I = m/3 (b^2 + c^2, c^2 + a^2, a^2 + b^2) for half extents a, b, c.
core::Body box(const std::string& name, double mass, const Vector3& half) {
  core::Body body;
  body.name = name;
  body.mass = mass;
  body.shape = core::Box{half};
  const Vector3 square = half.cwiseAbs2();
  body.inertia = (mass / 3 * (Vector3::Constant(square.sum()) - square)).asDiagonal();
  body.collide = true;
  return body;
}

core::UniformGravity gravity(const json& file) {
  return core::UniformGravity{{0, -number(file["params"]["g"]), 0}};
}

Quaternion about_z(double angle) { return Quaternion(std::cos(angle / 2), 0, 0, std::sin(angle / 2)); }

double radians(const json& degrees) { return number(degrees) * std::numbers::pi / 180; }

std::string case_name(const std::string& name, std::size_t index) {
  return name + "/" + std::to_string(index + 1);
}

// ---- Inclines: d = (cos th, -sin th, 0) downhill, n = (sin th, cos th, 0); the body's x axis along d ----

struct Incline {
  Vector3 down, normal;
  Quaternion turned;

  explicit Incline(double theta)
      : down(std::cos(theta), -std::sin(theta), 0),
        normal(std::sin(theta), std::cos(theta), 0),
        turned(about_z(-theta)) {}
};

TruthScene on_incline(const std::string& name, const json& file, const json& c, const core::Body& body,
                      double height) {
  const Incline incline(radians(c["theta"]));
  TruthScene result{name, {}, {}};
  result.scene.bodies = {body};
  result.scene.bodies[0].initial.position = height * incline.normal;
  result.scene.forces.emplace_back(gravity(file));
  result.scene.planes.push_back({"incline", incline.normal, 0});
  result.scene.materials.push_back({{"*", "*"}, 0, number(c["mu"])});
  for (std::size_t k = 0; k < c["t"].size(); ++k) {
    Expected e;
    e.position = height * incline.normal + number(c["s"][k]) * incline.down;
    e.velocity = number(c["v"][k]) * incline.down;
    result.samples.push_back({number(c["t"][k]), {e}});
  }
  return result;
}

std::vector<TruthScene> block_on_incline(const std::string& name, const json& file) {
  std::vector<TruthScene> result;
  const Vector3 half = vector(file["params"]["half_extents"]);
  for (const json& c : file["cases"]) {
    const Incline incline(radians(c["theta"]));
    core::Body block = box("block", number(file["params"]["m"]), half);
    block.initial.orientation = incline.turned;
    block.initial.velocity = number(c["v0"]) * incline.down;
    result.push_back(on_incline(case_name(name, result.size()), file, c, block, half.y()));
    for (Sample& sample : result.back().samples) {
      sample.bodies[0].orientation = incline.turned;
      sample.bodies[0].angular_velocity = Vector3::Zero();
    }
  }
  return result;
}

std::vector<TruthScene> rolling_sphere_incline(const std::string& name, const json& file) {
  std::vector<TruthScene> result;
  for (const json& c : file["cases"]) {
    const double radius = number(c["r"]);
    const core::Body ball = sphere("ball", number(file["params"]["m"]), radius, {0, 0, 0}, {0, 0, 0});
    result.push_back(on_incline(case_name(name, result.size()), file, c, ball, radius));
    for (std::size_t k = 0; k < c["t"].size(); ++k) {
      Expected& e = result.back().samples[k].bodies[0];
      e.orientation = quaternion(c["orientation"][k]);
      e.angular_velocity = Vector3(0, 0, -number(c["omega"][k]));
    }
  }
  return result;
}

// ---- A stack that stands ---------------------------------------------------------------------------

std::vector<TruthScene> cube_stack(const std::string& name, const json& file) {
  std::vector<TruthScene> result;
  for (const json& c : file["cases"]) {
    TruthScene one{case_name(name, result.size()), {}, {}};
    const double half = number(c["half"]);
    std::vector<Expected> rest;
    for (std::size_t i = 0; i < c["masses"].size(); ++i) {
      core::Body cube = box("cube" + std::to_string(i), number(c["masses"][i]), Vector3::Constant(half));
      cube.initial.position.y() = number(c["y"][i]);
      rest.push_back({static_cast<int>(i), cube.initial.position, Vector3::Zero(), Quaternion::Identity(),
                      Vector3::Zero()});
      one.scene.bodies.push_back(cube);
    }
    one.scene.forces.emplace_back(gravity(file));
    one.scene.planes.push_back({"floor", Vector3::UnitY(), 0});
    one.scene.materials.push_back({{"*", "*"}, 0, number(c["mu"])});
    for (int k = 0; k <= samples_per_run; ++k)
      one.samples.push_back({number(c["T"]) * k / samples_per_run, rest});
    result.push_back(one);
  }
  return result;
}

// ---- Uniform motion between blows ------------------------------------------------------------------

struct Blow {
  double time = 0;
  int body = 0;
  Vector3 velocity_after = Vector3::Zero();
  std::optional<Vector3> angular_velocity_after;
};

/// p and v of every body at the samples of [0, horizon], from the initial velocities and the blows in order
/// of time.  Samples within a ten-thousandth of the horizon of a blow are left out: there v has two values.
void follow(TruthScene& scene, const std::vector<Blow>& blows, double horizon) {
  for (int k = 0; k <= samples_per_run; ++k) {
    const double t = horizon * k / samples_per_run;
    Sample sample{t, {}};
    bool clear = true;
    for (std::size_t b = 0; b < scene.scene.bodies.size(); ++b) {
      const core::BodyState& initial = scene.scene.bodies[b].initial;
      Vector3 p = initial.position, v = initial.velocity, w = initial.angular_velocity;
      double since = 0;
      for (const Blow& blow : blows) {
        if (static_cast<std::size_t>(blow.body) != b) continue;
        if (std::abs(blow.time - t) < 1e-4 * horizon) clear = false;
        if (blow.time > t) break;
        p += (blow.time - since) * v, since = blow.time;
        v = blow.velocity_after;
        if (blow.angular_velocity_after) w = *blow.angular_velocity_after;
      }
      sample.bodies.push_back({static_cast<int>(b), Vector3(p + (t - since) * v), v, {}, w});
    }
    if (clear) scene.samples.push_back(sample);
  }
}

Vector3 along_x(const json& x) { return {number(x), 0, 0}; }

std::vector<TruthScene> two_sphere_head_on(const std::string& name, const json& file) {
  std::vector<TruthScene> result;
  for (const json& e : file["events"]) {
    TruthScene one{case_name(name, result.size()), {}, {}};
    for (const json& b : file["bodies"])
      one.scene.bodies.push_back(sphere(b["id"], number(b["mass"]), number(b["radius"]),
                                        vector(b["position0"]), vector(b["velocity0"])));
    one.scene.materials.push_back({{"*", "*"}, number(e["restitution"]), 0});
    const double time = number(e["t"]);
    follow(one, {{time, 0, along_x(e["vA_after"]), {}}, {time, 1, along_x(e["vB_after"]), {}}}, 1);
    result.push_back(one);
  }
  return result;
}

// The incoming balls start half a metre before a row that touches.
TruthScene touching_cradle(const std::string& name, const json& file, const json& e) {
  TruthScene one{name, {}, {}};
  const double radius = number(file["params"]["r"]), speed = number(e["v"]), way = 0.5;
  std::vector<Blow> blows;
  for (int i = 0; i < file["params"]["n"].get<int>(); ++i) {
    const bool incoming = i < e["balls_incoming"].get<int>();
    one.scene.bodies.push_back(sphere("ball" + std::to_string(i), number(file["params"]["m"]), radius,
                                      {2 * radius * i - (incoming ? way : 0), 0, 0},
                                      {incoming ? speed : 0, 0, 0}));
    blows.push_back({way / speed, i, along_x(e["final_vx"][static_cast<std::size_t>(i)]), {}});
  }
  one.scene.materials.push_back({{"*", "*"}, number(e["restitution"]), 0});
  follow(one, blows, 2);
  return one;
}

TruthScene gapped_cradle(const std::string& name, const json& file, const json& g) {
  TruthScene one{name, {}, {}};
  std::vector<Blow> blows;
  for (std::size_t i = 0; i < g["positions0_x"].size(); ++i)
    one.scene.bodies.push_back(sphere("ball" + std::to_string(i), number(file["params"]["m"]),
                                      number(file["params"]["r"]), along_x(g["positions0_x"][i]),
                                      {i == 0 ? number(g["v"]) : 0, 0, 0}));
  for (const json& c : g["collisions"])
    for (std::size_t side = 0; side < 2; ++side)
      blows.push_back({number(c["t"]), c["pair"][side].get<int>(), along_x(c["v_after"][side]), {}});
  one.scene.materials.push_back({{"*", "*"}, number(g["e"]), 0});
  follow(one, blows, number(g["T"]));
  for (std::size_t i = 0; i < one.scene.bodies.size(); ++i) {  // as the file has them
    one.samples.back().bodies[i].position = along_x(g["final_x_at_T"][i]);
    one.samples.back().bodies[i].velocity = along_x(g["final_vx"][i]);
  }
  return one;
}

std::vector<TruthScene> newtons_cradle(const std::string& name, const json& file) {
  std::vector<TruthScene> result;
  for (const json& e : file["events"])
    result.push_back(touching_cradle(case_name(name, result.size()), file, e));
  result.push_back(gapped_cradle(case_name(name, result.size()), file, file["gapped"]));
  return result;
}

std::vector<TruthScene> rod_offcentre_hit(const std::string& name, const json& file) {
  TruthScene one{name, {}, {}};
  const json &s = file["bodies"][0], &r = file["bodies"][1], &e = file["events"][0],
             &end = file["final_state_at_T"];
  one.scene.bodies.push_back(sphere(s["id"], number(s["mass"]), number(s["radius"]), vector(s["position0"]),
                                    vector(s["velocity0"])));
  one.scene.bodies.push_back(box(r["id"], number(r["mass"]), vector(r["half_extents"])));
  one.scene.bodies[1].inertia = vector(r["inertia_body_com_diag"]).asDiagonal();
  one.scene.materials.push_back({{"*", "*"}, number(file["params"]["e"]), 0});
  follow(one,
         {{number(e["t"]), 0, vector(e["sphere_velocity_after"]), {}},
          {number(e["t"]), 1, vector(e["rod_velocity_after"]), vector(e["rod_angular_velocity_after"])}},
         number(file["horizon"]));
  Sample& last = one.samples.back();
  last.bodies[0].position = vector(end["sphere_position"]);
  last.bodies[1].position = vector(end["rod_position"]);
  last.bodies[1].orientation = quaternion(end["rod_orientation"]);
  last.bodies[1].angular_velocity = vector(end["rod_angular_velocity"]);
  return {one};
}

// Without gravity, from a height that the ball falls through in a quarter of a second.
std::vector<TruthScene> rough_ball_bounce(const std::string& name, const json& file) {
  std::vector<TruthScene> result;
  const double radius = number(file["params"]["r"]), time = 0.25;
  for (const json& e : file["events"]) {
    TruthScene one{case_name(name, result.size()), {}, {}};
    const Vector3 velocity = vector(e["velocity_before"]);
    core::Body ball = sphere("ball", number(file["params"]["m"]), radius,
                             Vector3(0.1, radius, -0.2) - time * velocity, velocity);
    ball.initial.angular_velocity = vector(e["angular_velocity_before"]);
    one.scene.bodies = {ball};
    one.scene.planes.push_back({"floor", Vector3::UnitY(), 0});
    one.scene.materials.push_back({{"*", "*"}, number(e["restitution"]), number(e["mu"])});
    follow(one, {{time, 0, vector(e["velocity_after"]), vector(e["angular_velocity_after"])}}, 1);
    result.push_back(one);
  }
  return result;
}

// ---- A box on its edge: up to the second blow, a twentieth of a second after the first -------------

std::vector<TruthScene> box_drop_edge(const std::string& name, const json& file) {
  TruthScene one{name, {}, {}};
  const json &p = file["params"], &e = file["events"][0];
  const double tilt = radians(p["tilt"]), g = number(p["g"]), y0 = number(p["y0"]), time = number(e["t"]),
               v = number(e["vy_after"]), w = number(e["wz_after"]);
  core::Body falling = box("box", number(p["m"]), vector(p["half"]));
  falling.initial.position.y() = y0;
  falling.initial.orientation = about_z(tilt);
  one.scene.bodies = {falling};
  one.scene.forces.emplace_back(gravity(file));
  one.scene.planes.push_back({"floor", Vector3::UnitY(), 0});
  one.scene.materials.push_back({{"*", "*"}, number(p["e"]), 0});
  for (const double t : {0.2, 0.4, 0.5, 0.56, 0.58, 0.6}) {
    const bool after = t > time;
    const double since = after ? t - time : t;
    Expected x;
    x.position = Vector3(0, (after ? y0 - g * time * time / 2 + v * since : y0) - g * since * since / 2, 0);
    x.velocity = Vector3(0, (after ? v : 0) - g * since, 0);
    x.orientation = about_z(tilt + (after ? w * since : 0));
    x.angular_velocity = Vector3(0, 0, after ? w : 0);
    one.samples.push_back({t, {x}});
  }
  return {one};
}

// ---- The seed's water: level + wave/2 sin(speed t + i) + wave/2 sin(i j / 2) over its cell (i, j) -------

std::vector<TruthScene> water_step_force(const std::string& name, const json& file) {
  TruthScene one{name, {}, {}};
  const json& p = file["params"];
  core::Body body;
  body.name = "body";
  body.mass = number(p["m"]);
  body.initial.position = Vector3(number(p["x"]), number(p["y0"]), number(p["z"]));
  one.scene.bodies = {body};
  one.scene.forces.emplace_back(gravity(file));
  one.scene.forces.emplace_back(core::Water{number(p["level"]), number(p["wave"]), number(p["speed"]),
                                            number(p["b"]), number(p["gamma"]), "step"});
  for (std::size_t k = 0; k < file["t"].size(); ++k) {
    Expected e;
    e.position = Vector3(number(p["x"]), number(file["y"][k]), number(p["z"]));
    e.velocity = Vector3(0, number(file["vy"][k]), 0);
    one.samples.push_back({number(file["t"][k]), {e}});
  }
  return {one};
}

}  // namespace

std::vector<TruthScene> special_scenes(const std::string& name, const json& file) {
  using Builder = std::function<std::vector<TruthScene>(const std::string&, const json&)>;
  static const std::map<std::string, Builder> builders = {
      {"block_on_incline", block_on_incline},
      {"rolling_sphere_incline", rolling_sphere_incline},
      {"cube_stack", cube_stack},
      {"two_sphere_head_on", two_sphere_head_on},
      {"newtons_cradle", newtons_cradle},
      {"rod_offcentre_hit", rod_offcentre_hit},
      {"rough_ball_bounce", rough_ball_bounce},
      {"box_drop_edge", box_drop_edge},
      {"water_step_force", water_step_force},
  };
  const auto found = builders.find(name);
  return found == builders.end() ? std::vector<TruthScene>{} : found->second(name, file);
}

}  // namespace cylon::accuracy
