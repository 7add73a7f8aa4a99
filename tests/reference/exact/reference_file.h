// A reference file of tests/data/truth as a Scene and the states that it records.
#pragma once

#include "harness/core/scene.h"

#include "tests/conformance/accuracy/truth/truth_file.h"
#include "tests/paths.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace cylon::exact {

using nlohmann::json;

inline double number(const json& j) {
  return j.is_string() ? std::stod(j.get<std::string>()) : j.get<double>();
}
inline core::Vector3 vector(const json& j) { return {number(j[0]), number(j[1]), number(j[2])}; }
inline core::Quaternion quaternion(const json& j) {
  return {number(j[0]), number(j[1]), number(j[2]), number(j[3])};
}

struct ReferenceFile {
  explicit ReferenceFile(const std::string& name) {
    std::ifstream in(std::string(source_dir) + "/tests/data/truth/" + name + ".json");
    if (!in) throw std::runtime_error("no reference file " + name);
    data = json::parse(in);
    read_bodies();
    if (data.contains("trajectory")) read_forces();
    if (data.contains("trajectory")) read_constraints();
    for (const json& t : data["t"]) times.push_back(number(t));
    horizon = number(data["horizon"]);
    if (data.contains("conditioning"))
      conditioning = number(data["conditioning"]["amplification_max_over_horizon"]);
    data.contains("trajectory") ? read_states() : read_special();
  }

  json data;
  core::Scene scene;
  double horizon = 0, conditioning = 1;
  std::vector<double> times;
  std::vector<core::State> states;
  bool has_rotation = false;

 private:
  void read_bodies() {
    for (const json& b : data["bodies"]) {
      core::Body body;
      body.name = b["id"];
      body.mass = number(b["mass"]);
      body.initial.position = vector(b["position0"]);
      body.initial.velocity = vector(b["velocity0"]);
      if (b.contains("orientation0")) body.initial.orientation = quaternion(b["orientation0"]);
      if (b.contains("angular_velocity0")) body.initial.angular_velocity = vector(b["angular_velocity0"]);
      if (b.contains("inertia_body_com_diag")) body.inertia = vector(b["inertia_body_com_diag"]).asDiagonal();
      if (b.contains("radius")) {
        const double r = number(b["radius"]);
        body.shape = core::Sphere{r};
        body.inertia = core::Matrix3::Identity() * (0.4 * body.mass * r * r);
        body.collide = true;
      }
      scene.bodies.push_back(body);
    }
  }

  void read_forces() { scene.forces = accuracy::regular_scene(data).forces; }

  void read_constraints() {
    scene.joints = accuracy::regular_scene(data).joints;
    for (const json& c : data.value("contacts", json::array())) {
      scene.planes.push_back({"floor", vector(c["normal"]), number(c["offset"])});
      scene.materials.push_back(
          {{"*", "*"}, number(c["restitution"]), c.contains("friction") ? number(c["friction"]) : 0});
    }
    if (data["params"].contains("e") && scene.materials.empty()) {
      scene.materials.push_back({{"*", "*"}, number(data["params"]["e"]), 0});
    }
  }

  // Files in words of their own.
  void read_special() {
    const accuracy::TruthScene special = accuracy::truth_scenes(data["name"]).front();
    scene = special.scene;
    for (const accuracy::Sample& sample : special.samples) {
      states.push_back(core::initial_state(scene));
      for (const accuracy::Expected& e : sample.bodies) {
        core::BodyState& s = states.back()[static_cast<std::size_t>(e.body)];
        s.position = e.position.value_or(s.position);
        s.velocity = e.velocity.value_or(s.velocity);
      }
    }
  }

  void read_states() {
    states.resize(times.size());
    for (const json& b : data["bodies"]) {
      const json& track = data["trajectory"][b["id"].get<std::string>()];
      has_rotation = track.contains("orientation");
      for (std::size_t k = 0; k < times.size(); ++k) {
        core::BodyState s;
        s.position = vector(track["position"][k]);
        s.velocity = vector(track["velocity"][k]);
        if (has_rotation) s.orientation = quaternion(track["orientation"][k]);
        if (has_rotation) s.angular_velocity = vector(track["angular_velocity"][k]);
        states[k].push_back(s);
      }
    }
  }
};

inline double angle_between(const core::Quaternion& p, const core::Quaternion& q) {
  const double chord = std::min((p.coeffs() - q.coeffs()).norm(), (p.coeffs() + q.coeffs()).norm());
  return 4 * std::asin(std::min(1.0, chord / 2));
}

}  // namespace cylon::exact
