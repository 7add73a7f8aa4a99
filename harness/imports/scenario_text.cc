#include "harness/imports/scenario_text.h"

#include "harness/core/joint_coordinates.h"
#include "harness/core/solid.h"
#include "harness/scenario/writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cylon::imports {
namespace {

// The size of what moves: the largest reach of a body from a joint of its own, or of its shape [m].
double size_of(const core::Scene& scene) {
  double size = 0;
  for (const core::Body& body : scene.bodies)
    if (!body.locked) size = std::max(size, core::bounding_radius(body.shape));
  for (const core::Joint& joint : scene.joints)
    size = std::max(
        size, (joint.point - scene.bodies[static_cast<std::size_t>(joint.body)].initial.position).norm());
  return size > 0 ? size : 1;
}

// Whether something other than contacts takes energy.
bool drags(const core::Scene& scene) {
  return std::ranges::any_of(scene.forces,
                             [](const core::Force& f) { return std::holds_alternative<core::Drag>(f); }) ||
         core::any_coordinate(scene, [](const core::JointCoordinate& c) {
           return core::has_limit(c) || c.damping != 0 || c.friction != 0;
         });
}

bool moves(const core::Scene& scene) {
  return std::ranges::any_of(scene.bodies, [](const core::Body& body) { return !body.locked; });
}

bool is_held(const core::Scene& scene, int body) {
  return body == core::world || scene.bodies[static_cast<std::size_t>(body)].locked;
}

// Whether anything but gravity pushes the bodies as a whole.
bool is_pushed(const core::Scene& scene) {
  const auto from_outside = [&](const core::Pair& pair) {
    return pair.plane >= 0 || is_held(scene, pair.body) || is_held(scene, pair.other);
  };
  return core::any_touching_pair(scene, from_outside) ||
         std::ranges::any_of(
             scene.joints,
             [&](const core::Joint& j) { return is_held(scene, j.body) || is_held(scene, j.to); }) ||
         std::ranges::any_of(scene.forces, [](const core::Force& f) {
           return !std::holds_alternative<core::UniformGravity>(f);
         });
}

// The components of momentum along which nothing pulls.
std::string momentum_of(const core::Scene& scene) {
  std::string text;
  if (is_pushed(scene)) return text;
  const char* const names[] = {"x", "y", "z"};
  for (int c = 0; c < 3; ++c)
    if (std::ranges::all_of(scene.bodies, [&](const core::Body& b) {
          return b.locked || core::gravity_of(scene, b)[c] == 0;
        }))
      text += fmt::format(R"(
[[claim]]
conserves  = "linear_momentum"
component  = "{}"
tolerance  = {{ relative = 1e-4, reason = "convention: a ten-thousandth" }}
)",
                          names[c]);
  return text;
}

bool keeps_a_direction(const core::Joint& joint) { return !core::kind_of(joint.type).turns_freely(); }

std::string claims_of(const core::Scene& scene) {
  std::string text;
  if (!scene.joints.empty()) {
    const double size = size_of(scene);
    text += fmt::format(R"(
[[claim]]
conserves  = "joint_gap"
sample     = "step"
tolerance  = {{ absolute = {}, reason = "convention: a thousandth of the largest part of {:.3g} m" }}
)",
                        scenario::toml_number(size / 1000), size);
  }
  if (std::ranges::any_of(scene.joints, keeps_a_direction))
    text += R"(
[[claim]]
conserves  = "angular_joint_gap"
sample     = "step"
tolerance  = { absolute = 0.001, reason = "convention: a thousandth of a radian" }
)";
  if (!moves(scene)) return text;
  const bool touches = core::any_touching_pair(scene, [](const core::Pair&) { return true; });
  const bool loses = touches || drags(scene);
  text += fmt::format(R"(
[[claim]]
conserves  = "energy"{}
tolerance  = {{ relative = 0.01, reason = "convention: a hundredth" }}
)",
                      loses ? "\nmeasure    = \"increase\"" : "");
  return text + momentum_of(scene);
}

// A step that divides the duration, which is a whole number of steps and at least what was asked for.
double duration_of(double step, double asked) { return std::max(1.0, std::ceil(asked / step - 1e-9)) * step; }

// A comment must stay one line.
std::string in_one_line(std::string text) {
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 127; }, ' ');
  return text;
}

}  // namespace

std::string scenario_text(const foreign::Model& model, const core::Scene& scene,
                          const std::filesystem::path& file, double duration,
                          std::span<const std::string> left_out) {
  std::string text =
      in_one_line(fmt::format("# From {}, as {} reads it.", file.filename().string(), model.library));
  for (const std::string& line : left_out) text += "\n# Left out: " + in_one_line(line);
  text += fmt::format(
      "\ntitle    = {}\nduration = {}\nstep     = {}\n", scenario::toml_text(file.stem().string()),
      scenario::toml_number(duration_of(model.step, duration)), scenario::toml_number(model.step));
  return text + scenario::to_toml(scene) + claims_of(scene);
}

}  // namespace cylon::imports
