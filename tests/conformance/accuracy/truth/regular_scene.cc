// Files with `bodies` and `trajectory`: their keys have the same names as in a scene.
#include "tests/conformance/accuracy/truth/truth_file.h"
#include "tests/paths.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <stdexcept>

namespace cylon::accuracy {
namespace {

const std::filesystem::path folder = std::filesystem::path(source_dir) / "tests/data/truth";

const json& list(const json& file, const char* key) {
  static const json none = json::array();
  const auto found = file.find(key);
  return found == file.end() ? none : *found;
}

int index_of(const core::Scene& scene, const json& id) {
  const auto found = std::ranges::find(scene.bodies, id.get<std::string>(), &core::Body::name);
  if (found == scene.bodies.end()) throw std::runtime_error("no body " + id.dump());
  return static_cast<int>(found - scene.bodies.begin());
}

core::Body body_of(const json& b, bool touches) {
  core::Body body;
  body.name = b["id"];
  body.mass = number(b["mass"]);
  body.initial.position = vector(b["position0"]);
  body.initial.velocity = vector(b["velocity0"]);
  if (b.contains("orientation0")) body.initial.orientation = quaternion(b["orientation0"]);
  if (b.contains("angular_velocity0")) body.initial.angular_velocity = vector(b["angular_velocity0"]);
  if (b.contains("radius")) {
    const double r = number(b["radius"]);
    body.shape = core::Sphere{r};
    body.inertia = core::Matrix3::Identity() * (0.4 * body.mass * r * r);
  }
  if (b.contains("half_extents")) body.shape = core::Box{vector(b["half_extents"])};
  if (b.contains("inertia_body_com_diag")) body.inertia = vector(b["inertia_body_com_diag"]).asDiagonal();
  body.collide = touches;
  return body;
}

// ---- Forces ------------------------------------------------------------------------------------------

core::Vector3 vector_or_zero(const json& j, const char* key) {
  return j.contains(key) ? vector(j[key]) : core::Vector3::Zero();
}

void add_spring(core::Scene& scene, const json&, const json& f) {
  core::Spring spring;
  spring.stiffness = number(f["k"]);
  spring.rest_length = number(f["rest_length"]);
  if (f.contains("pin")) {
    spring.body = index_of(scene, f["body"]);
    spring.to_anchor = vector(f["pin"]);
  } else {
    spring.body = index_of(scene, f["body_a"]);
    spring.to = index_of(scene, f["body_b"]);
    spring.anchor = vector_or_zero(f, "anchor_a");
    spring.to_anchor = vector_or_zero(f, "anchor_b");
  }
  scene.forces.emplace_back(spring);
}

// A rocket's gas leaves against the thrust; accretion takes up matter at rest.
void add_exhaust(core::Scene& scene, const json& file, const json& f) {
  core::Thrust thrust;
  thrust.mass_rate = number(file["bodies"][0]["mass_rate"]);
  thrust.exhaust_velocity = -number(f["u_ex"]) * vector(f["direction_of_thrust"]);
  scene.forces.emplace_back(thrust);
}

void add_drag(core::Scene& scene, const core::Drag& drag) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    core::Drag own = drag;
    own.body = static_cast<int>(i);
    scene.forces.emplace_back(own);
  }
}

using Adder = std::function<void(core::Scene&, const json& file, const json& entry)>;

const std::map<std::string, Adder>& forces() {
  static const std::map<std::string, Adder> table = {
      {"gravity",
       [](core::Scene& s, const json&, const json& f) {
         s.forces.emplace_back(core::UniformGravity{{0, -number(f["g"]), 0}});
       }},
      {"spring", add_spring},
      {"linear_drag",
       [](core::Scene& s, const json&, const json& f) {
         add_drag(s, {0, number(f["gamma"]), 0, 0});
       }},
      {"angular_drag_omega",
       [](core::Scene& s, const json&, const json& f) {
         add_drag(s, {0, 0, number(f["c"]), 0});
       }},
      {"angular_drag_L",
       [](core::Scene& s, const json&, const json& f) {
         add_drag(s, {0, 0, 0, number(f["gamma"])});
       }},
      {"harmonic",
       [](core::Scene& s, const json&, const json& f) {
         s.forces.emplace_back(core::Drive{0, vector(f["F0"]), number(f["Omega"])});
       }},
      {"exhaust", add_exhaust},
  };
  return table;
}

// ---- Constraints -------------------------------------------------------------------------------------

const std::map<std::string, core::JointType> joint_types = {{"ball_joint", core::JointType::ball},
                                                            {"hinge", core::JointType::hinge},
                                                            {"distance", core::JointType::distance}};

void add_joint(core::Scene& scene, const json& c) {
  core::Joint joint;
  joint.type = joint_types.at(c["type"]);
  joint.body = index_of(scene, c.contains("body") ? c["body"] : c["body_a"]);
  if (c.contains("body_b")) joint.to = index_of(scene, c["body_b"]);
  if (c.contains("point_world")) joint.point = vector(c["point_world"]);
  if (c.contains("anchor_a")) {
    const core::BodyState& at = scene.bodies[static_cast<std::size_t>(joint.body)].initial;
    joint.point = at.position + at.orientation * vector(c["anchor_a"]);
  }
  if (c.contains("axis_world")) joint.axis = vector(c["axis_world"]);
  if (c.contains("length")) joint.length = number(c["length"]);
  scene.joints.push_back(joint);
}

void add_contact(core::Scene& scene, const json& c) {
  const std::string name = "plane" + std::to_string(scene.planes.size());
  scene.planes.push_back({name, vector(c["normal"]), number(c["offset"])});
  scene.materials.push_back(
      {{"*", name}, number(c["restitution"]), c.contains("friction") ? number(c["friction"]) : 0});
}

}  // namespace

json read_truth(const std::string& name) {
  std::ifstream in(folder / (name + ".json"));
  if (!in) throw std::runtime_error("no reference file " + name);
  return json::parse(in);
}

core::Scene regular_scene(const json& file) {
  core::Scene scene;
  const bool spheres_meet = file["bodies"].size() > 1 && file["params"].contains("e");
  for (const json& b : file["bodies"])
    scene.bodies.push_back(body_of(b, spheres_meet || file.contains("contacts")));
  for (const json& f : list(file, "forces")) forces().at(f["type"])(scene, file, f);
  for (const json& b : file["bodies"])
    if (file["name"] == "accretion")
      scene.forces.emplace_back(
          core::Thrust{0, {0, 0, 0}, number(b["mass_rate"]), std::nullopt, core::Vector3::Zero()});
  for (const json& c : list(file, "constraints")) add_joint(scene, c);
  for (const json& c : list(file, "contacts")) add_contact(scene, c);
  if (spheres_meet) scene.materials.push_back({{"*", "*"}, number(file["params"]["e"]), 0});
  return scene;
}

std::vector<Sample> regular_samples(const json& file) {
  std::vector<Sample> samples(file["t"].size());
  for (std::size_t k = 0; k < samples.size(); ++k) {
    samples[k].time = number(file["t"][k]);
    for (std::size_t b = 0; b < file["bodies"].size(); ++b) {
      const json& track = file["trajectory"][file["bodies"][b]["id"].get<std::string>()];
      Expected e{static_cast<int>(b), vector(track["position"][k]), vector(track["velocity"][k]), {}, {}};
      if (track.contains("orientation")) e.orientation = quaternion(track["orientation"][k]);
      if (track.contains("angular_velocity")) e.angular_velocity = vector(track["angular_velocity"][k]);
      samples[k].bodies.push_back(e);
    }
  }
  return samples;
}

std::vector<std::string> truth_names() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().stem().string());
  std::ranges::sort(names);
  return names;
}

std::vector<TruthScene> truth_scenes(const std::string& name) {
  const json file = read_truth(name);
  if (auto special = special_scenes(name, file); !special.empty() || file["kind"] == "static") return special;
  TruthScene scene{name, regular_scene(file), regular_samples(file)};
  if (file.contains("conditioning"))
    scene.conditioning = number(file["conditioning"]["amplification_max_over_horizon"]);
  return {scene};
}

}  // namespace cylon::accuracy
