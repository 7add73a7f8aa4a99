#include "harness/imports/mjcf/mjcf.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cylon::imports {
namespace {

using foreign::Place;

// A kind of element that a model has, whatever it says.
struct Presence {
  const char* kind;
  const char* what;
};
constexpr Presence presences[] = {
    {"site", "presentation"}, {"camera", "presentation"}, {"light", "presentation"},
    {"skin", "presentation"}, {"sensor", "sensor"},       {"key", "keyframe"},
    {"flex", "soft_body"},    {"plugin", "plugin_force"},
};

// What a tendon does by itself, as a kind of loss, and why.  Its limit acts from `margin` before an end of its range.
std::pair<const char*, const char*> role_of(const Compiled& m, int tendon) {
  for (const char* force : {"tendon_stiffness", "tendon_stiffnesspoly", "tendon_damping",
                            "tendon_dampingpoly", "tendon_frictionloss", "tendon_armature"})
    if (m.any(force, tendon, m.size("ntendon"))) return {"tendon_force", ""};
  if (m.integer("tendon_limited", tendon) == 0 || m.disabled("limit") || m.disabled("constraint"))
    return {"tendon", ""};
  const double length = m.start("ten_length", tendon), margin = m.number("tendon_margin", tendon);
  const bool acts = length < m.number("tendon_range", 2 * tendon) + margin ||
                    length > m.number("tendon_range", 2 * tendon + 1) - margin;
  if (acts) return {"tendon_force", "its limit acts at the start"};
  return {"tendon_limit", ""};
}

// The share of gravity that is compensated at a body.  MuJoCo skips it with the other passive forces where there is
// neither spring nor damper.  Along joints with actuatorgravcomp it is a force of their actuators, which there is none of
// without any actuator, and which the joint's range of such forces cuts.
double compensated(const Compiled& m, int body, foreign::Model& model) {
  const double share = m.number("body_gravcomp", body);
  if (share == 0 || (m.disabled("spring") && m.disabled("damper"))) return 0;
  const bool acts = !m.disabled("actuation") && m.count("actuator") > 0;
  bool any = false, all = true, is_cut = false;
  for (int b = body; b > 0; b = m.integer("body_parentid", b))
    for (int j = m.integer("body_jntadr", b), end = j + m.integer("body_jntnum", b); j < end; ++j) {
      const bool actuated = m.integer("jnt_actgravcomp", j) != 0;
      any = any || actuated, all = all && actuated;
      is_cut = is_cut || (actuated && m.integer("jnt_actfrclimited", j) != 0);
    }
  if (!any || (acts && !is_cut)) return share;
  if (!acts && all) return 0;
  model.losses.push_back(
      {"actuator_force", m.place("body", body), "gravity is compensated along some of its joints alone"});
  return share;
}

}  // namespace

foreign::Model model_of_mjcf(const Compiled& m, const std::string& keyframe) {
  foreign::Model model;
  model.library = m.library();
  model.step = m.option("timestep");
  model.gravity = m.disabled("gravity") ? foreign::Vector3::Zero() : m.gravity();
  model.bodies = bodies_of(m, model);
  add_joints(m, model);
  add_surfaces(m, model);
  add_losses(m, keyframe, model);
  return model;
}

// A frame at the inertial centre of each body; the world, body 0, is a locked one.
std::vector<foreign::Body> bodies_of(const Compiled& m, foreign::Model& model) {
  std::vector<foreign::Body> bodies;
  for (int i = 0; i < m.size("nbody"); ++i) {
    foreign::Body& body = bodies.emplace_back();
    body.place = m.place("body", i);
    body.name = i == 0 ? "ground" : m.name("body", i);  // a scene's "world" has no shape
    if (body.name.empty()) body.name = fmt::format("body {}", i);
    body.locked = m.integer("body_weldid", i) == 0;
    body.mass = m.number("body_mass", i);
    // I = R diag(moments) R^T, from the principal axes to the body's.
    const foreign::Matrix3 r = m.quaternion("body_iquat", i).toRotationMatrix();
    body.inertia = r * m.vector("body_inertia", i).asDiagonal() * r.transpose();
    body.inertia = (body.inertia + body.inertia.transpose()).eval() / 2;
    body.pose = {m.start_vector("xipos", i), m.start_quaternion("xquat", i)};
    body.spin = m.start_vector("velocities", 2 * i);
    body.velocity = m.start_vector("velocities", 2 * i + 1);
    if (const double share = body.locked ? 0 : compensated(m, i, model); share != 0)
      body.gravity = (1 - share) * model.gravity + foreign::Vector3::Zero();  // no -0
    if (m.integer("body_mocapid", i, -1) >= 0) model.losses.push_back({"mocap", body.place, ""});
  }
  return bodies;
}

void add_losses(const Compiled& m, const std::string& keyframe, foreign::Model& model) {
  const auto lose = [&](const char* what, Place place, std::string detail = "") {
    model.losses.push_back({what, std::move(place), std::move(detail)});
  };
  const auto is_used = [&](const std::string& what, const char* kind, int i) {
    return what == "keyframe" && !keyframe.empty() && m.name(kind, i) == keyframe;
  };
  for (const auto& [kind, what] : presences)
    for (int i = 0; i < m.count(kind); ++i)
      if (!is_used(what, kind, i)) lose(what, m.place(kind, i), kind);
  for (int i = 0; i < m.size("ntendon"); ++i) {
    const auto [what, why] = role_of(m, i);
    lose(what, m.place("tendon", i), why);
  }
  for (const std::string& picture : m.absent())
    lose("presentation", {fmt::format("picture '{}'", picture), "", 0}, "it is not there");
  for (const std::string& text : m.warnings())
    lose(text.find("NaN") == std::string::npos ? "warning" : "unread", {"model", "", 0}, text);
  if (m.option("density") != 0 || m.option("viscosity") != 0)
    lose("fluid", {"option", "", 0},
         fmt::format("density {}, viscosity {}", m.option("density"), m.option("viscosity")));
  for (const std::string& name : m.solver_options()) lose("solver", {"option", "", 0}, name);
  if (const double asleep = m.option("asleep", 0); asleep > 0)
    lose("unread", {"option", "", 0}, fmt::format("bodies that begin asleep: {}", asleep));
  else if (m.option("sleep", 0) != 0)
    lose("sleep", {"option", "", 0});
  if (m.size("njnt") + m.size("neq") + m.size("ngeom") > 0) lose("soft_constraints", {"model", "", 0});
}

}  // namespace cylon::imports
