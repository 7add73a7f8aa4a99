// Words and numbers of a file in the format truth/1.
#pragma once

#include "tests/conformance/accuracy/truth/truth_scene.h"

#include <nlohmann/json.hpp>

#include <string>

namespace cylon::accuracy {

using nlohmann::json;

/// tests/data/truth/NAME.json
json read_truth(const std::string& name);

/// Numbers of physics are decimal strings.
inline double number(const json& j) {
  return j.is_string() ? std::stod(j.get<std::string>()) : j.get<double>();
}
inline core::Vector3 vector(const json& j) { return {number(j[0]), number(j[1]), number(j[2])}; }
inline core::Quaternion quaternion(const json& j) {
  return core::Quaternion(number(j[0]), number(j[1]), number(j[2]), number(j[3])).normalized();
}

/// `bodies`, `forces`, `constraints`, `contacts` as a scene; what a file leaves out is absent.
core::Scene regular_scene(const json& file);

/// `trajectory` as samples.
std::vector<Sample> regular_samples(const json& file);

/// Scenes of the files that say what happens in words of their own; empty where `name` is none of them.
std::vector<TruthScene> special_scenes(const std::string& name, const json& file);

}  // namespace cylon::accuracy
