// Every solution refuses what it cannot serve and says which condition failed: one scene per condition.
#include "reference/exact/catalogue.h"
#include "tests/reference/exact/random_scenes.h"
#include "tests/reference/exact/reference_file.h"
#include "tests/reference/exact/smooth_scenes.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>

namespace cylon::exact {
namespace {

core::Truth make(std::string_view name, const core::Scene& scene, double horizon = 1) {
  for (const Solution& solution : catalogue()) {
    if (solution.name == name) return solution.make(scene, horizon);
  }
  throw std::runtime_error("no solution " + std::string(name));
}

// Names of the catalogue that mean another one's solution.
std::string same_as(const std::string& name) {
  static const std::map<std::string, std::string> other = {
      {"constant_spin", "projectile"},         {"damped_spring_critical", "damped_spring"},
      {"damped_spring_over", "damped_spring"}, {"damped_spring_under", "damped_spring"},
      {"dzhanibekov", "free_asymmetric_top"},
  };
  const auto found = other.find(name);
  return found == other.end() ? name : found->second;
}

// What a solution serves besides gravity; everything else it must refuse.
bool serves(const std::string& name, const std::string& word) {
  static const std::set<std::pair<std::string, std::string>> rows = {
      {"accretion", "thrust"},
      {"rotating_frame", "frame"},
      {"seed_airplane", "thrust"},
      {"rotating_frame", "spring"},
      {"rotating_frame", "attraction"},
      {"rotating_frame", "turning"},
      {"water_step_force", "water"},
      {"water_step_force", "no spin"},
      {"accretion", "no spin"},
      {"rocket", "no spin"},
      {"damped_free_top", "drag"},
      {"damped_free_top", "turning"},
      {"kepler", "attraction"},
      {"kepler", "locked"},
      {"physical_pendulum", "joint"},
      {"physical_pendulum", "turning"},
      {"spherical_pendulum", "joint"},
      {"spring_chain", "spring"},
      {"bouncing_sphere", "contact"},
      {"two_sphere_oblique", "contact"},
      {"two_sphere_oblique", "turning"},
      {"damped_spring", "drag"},
      {"damped_spring", "spring"},
      {"driven_spring", "drag"},
      {"driven_spring", "drive"},
      {"driven_spring", "spring"},
      {"heavy_top", "joint"},
      {"heavy_top", "turning"},
      {"free_asymmetric_top", "turning"},
      {"free_symmetric_top", "turning"},
      {"projectile_drag", "drag"},
      {"rocket", "thrust"},
      {"spring_orbit", "spring"},
      {"spring_zero_length", "spring"},
  };
  return rows.contains({same_as(name), word});
}

void expect_refused(std::string_view name, const core::Scene& scene, const std::string& reason,
                    double horizon = 1) {
  try {
    make(name, scene, horizon);
    ADD_FAILURE() << name << " accepted a scene with: " << reason;
  } catch (const core::OutOfDomain& refusal) {
    EXPECT_NE(std::string(refusal.what()).find(reason), std::string::npos) << refusal.what();
    EXPECT_EQ(std::string(refusal.what()).find(same_as(std::string(name))), 0u) << refusal.what();
  }
}

// Solutions with contacts have tests of their own.
bool smooth(const std::string& name) {
  const std::string one = same_as(name);
  return SmoothScenes::knows(one) || RandomScenes::knows(one) || one == "bouncing_sphere" ||
         one == "two_sphere_oblique";
}

core::Scene valid(const std::string& name) {
  if (name == "bouncing_sphere" || name == "two_sphere_oblique") return ReferenceFile(name).scene;
  const std::string one = same_as(name);
  return SmoothScenes::knows(one) ? SmoothScenes(5).scene(one) : RandomScenes(5).scene(one);
}

TEST(Domain, catalogue_is_sorted_and_complete) {
  std::string before;
  for (const Solution& solution : catalogue()) {
    EXPECT_LT(before, solution.name);
    EXPECT_FALSE(solution.domain.empty());
    const std::string name(solution.name);
    if (smooth(name)) {
      EXPECT_NO_THROW(make(name, valid(name))) << name;
    }
    before = solution.name;
  }
}

// What no solution serves.
TEST(Domain, common_conditions) {
  for (const Solution& solution : catalogue()) {
    const std::string name(solution.name);
    if (!smooth(name)) continue;
    const core::Scene good = valid(name);
    const auto with = [&](auto&& change) {
      core::Scene scene = good;
      change(scene);
      return scene;
    };
    const std::string body = "body '" + good.bodies[0].name + "'";
    expect_refused(name, good, "horizon", 0);
    expect_refused(name, with([](core::Scene& s) { s.bodies.clear(); }), "no body");
    if (!serves(name, "locked")) {
      expect_refused(name, with([](core::Scene& s) { s.bodies[0].locked = true; }), body + " is locked");
    }
    expect_refused(name, with([](core::Scene& s) { s.bodies[0].mass = 0; }), body + " has no positive mass");
    if (!serves(name, "frame")) {
      expect_refused(name, with([](core::Scene& s) {
                       s.frame = core::Frame{{0, 0, 0}, {0, 1, 0}};
                     }),
                     "frame that turns or accelerates");
    }
    const std::pair<const char*, core::Force> forces[] = {{"drag on ", core::Drag{0, 1, 0, 0}},
                                                          {"thrust on ", core::Thrust{}},
                                                          {"drive on ", core::Drive{}},
                                                          {"spring on ", core::Spring{}},
                                                          {"attraction on ", core::Attraction{}},
                                                          {"water", core::Water{}},
                                                          {"plugin_force", core::PluginForce{.bodies = {0}}}};
    for (const auto& [reason, force] : forces) {
      if (serves(name, std::string(reason).substr(0, std::string(reason).find(' ')))) continue;
      core::Scene scene = good;
      scene.forces.push_back(force);
      expect_refused(name, scene, reason + (std::string(reason).ends_with(' ') ? body : ""));
    }
    if (!serves(name, "joint"))
      expect_refused(name, with([](core::Scene& s) { s.joints.emplace_back(); }), "joint");
    if (!serves(name, "contact")) {
      expect_refused(name, with([](core::Scene& s) {
                       s.bodies[0].shape = core::Sphere{0.1};
                       s.bodies[0].collide = true;
                       s.planes.push_back({"floor", {0, 1, 0}, -50});
                     }),
                     body + " may touch plane 'floor'");
    }
    if (!serves(name, "turning")) {
      expect_refused(name, with([](core::Scene& s) {
                       s.bodies[0].inertia = core::Vector3(1, 2, 2.5).asDiagonal();
                       s.bodies[0].initial.angular_velocity = {1, 2, 3};
                     }),
                     body + (serves(name, "no spin") ? " turns" : " does not turn about a principal axis"));
    }
  }
}

TEST(Domain, springs) {
  for (const char* name : {"spring_zero_length", "spring_orbit"}) {
    const auto with = [&](auto&& change) {
      core::Scene scene = valid(name);
      for (core::Force& force : scene.forces) {
        if (auto* spring = std::get_if<core::Spring>(&force)) {
          change(scene, *spring);
          break;
        }
      }
      return scene;
    };
    using S = core::Spring;
    expect_refused(name, with([](auto&, S& s) { s.damping = 0.1; }), "spring of body 'body' is damped");
    expect_refused(name, with([](auto&, S& s) { s.anchor = {0.1, 0, 0}; }), "not anchored at the centre");
    expect_refused(name, with([](auto&, S& s) { s.stiffness = 0; }), "no stiffness");
    expect_refused(name, with([](core::Scene& scene, S& s) {
                     scene.bodies.push_back(scene.bodies[0]);
                     s.to = 1;
                   }),
                   "ends on another body");
    expect_refused(name, with([](core::Scene& scene, S&) {
                     scene.bodies.push_back(scene.bodies[0]);
                     scene.bodies[1].name = "loose";
                   }),
                   "body 'loose' has no spring");
  }
  core::Scene stretched = ReferenceFile("spring_orbit").scene;
  expect_refused("spring_zero_length", stretched, "has a rest length");
  core::Scene falling = stretched;
  falling.forces.emplace_back(core::UniformGravity{});
  expect_refused("spring_orbit", falling, "gravity");
  core::Scene radial = stretched;
  radial.bodies[0].initial.velocity = {2, 0, 0};
  expect_refused("spring_orbit", radial, "moves through the pin");
  core::Scene near = stretched;
  near.bodies[0].initial.velocity = {20, 1e-5, 0};
  expect_refused("spring_orbit", near, "too near the pin");
  core::Scene two = stretched;
  two.forces.push_back(two.forces[0]);
  expect_refused("spring_orbit", two, "two springs");
}

TEST(Domain, free_tops) {
  expect_refused("free_symmetric_top", valid("free_asymmetric_top"), "no two equal principal moments");
  core::Scene separatrix =
      ReferenceFile("dzhanibekov").scene;  // |L|^2 = 2 E I2: I1 (I2 - I1) w1^2 = I3 (I3 - I2) w3^2
  separatrix.bodies[0].inertia = core::Vector3(2, 3, 4).asDiagonal();
  separatrix.bodies[0].initial.angular_velocity = {0, 3, 0};
  EXPECT_NO_THROW(make("free_asymmetric_top", separatrix));               // on the unstable axis, for ever
  separatrix.bodies[0].inertia = core::Vector3(1, 2, 2.25).asDiagonal();  // 1 w1^2 = 0.5625 w3^2
  separatrix.bodies[0].initial.angular_velocity = {3, 1, 4};
  expect_refused("dzhanibekov", separatrix, "separatrix");
  core::Scene flat = valid("free_asymmetric_top");
  flat.bodies[0].inertia = core::Vector3(0, 1, 1).asDiagonal();
  expect_refused("free_asymmetric_top", flat, "not positive");
  flat.bodies[0].inertia = core::Vector3(-1, 1, 1).asDiagonal();
  expect_refused("free_symmetric_top", flat, "not positive");
}

using B = core::Body;
using S = core::Scene;

// with(change): the scene after change(scene, its first body).
auto variations_of(const core::Scene& good) {
  return [good](void (*change)(S&, B&)) {
    S scene = good;
    change(scene, scene.bodies[0]);
    return scene;
  };
}

TEST(Domain, heavy_top) {
  const auto with = variations_of(ReferenceFile("heavy_top_nutating").scene);
  expect_refused("heavy_top", with([](S& s, B&) { s.forces.clear(); }), "no gravity");
  expect_refused("heavy_top", with([](S& s, B&) { s.joints.clear(); }), "exactly one joint");
  expect_refused("heavy_top", with([](S& s, B&) { s.joints[0].type = core::JointType::hinge; }),
                 "not a ball joint");
  expect_refused("heavy_top", with([](S& s, B& b) {
                   b.initial.position = {0, 0, 0};
                   s.joints[0].point = {0, 0, 0};
                 }),
                 "at its pivot");
  expect_refused("heavy_top", with([](S&, B& b) { b.inertia(0, 0) *= 1.01; }),
                 "no two equal principal moments");
  expect_refused("heavy_top", with([](S& s, B&) { s.joints[0].point.x() += 1e-6; }),
                 "not on its symmetry axis");
  expect_refused("heavy_top", with([](S&, B& b) { b.initial.velocity.x() += 1e-6; }), "breaks its joint");
  expect_refused("heavy_top", with([](S& s, B& b) {  // whirls up to rest upright: v^2/2 = 2 g l exactly
                   b.inertia.setZero();
                   b.initial = {{0, -0.5, 0}, core::Quaternion(0, 1, 0, 0), {0, 0, 4}, {-8, 0, 0}};
                   s.forces = {core::UniformGravity{{0, -8, 0}}};
                 }),
                 "separatrix");
}

TEST(Domain, bouncing_sphere) {
  const auto with = variations_of(valid("bouncing_sphere"));
  const char* name = "bouncing_sphere";
  expect_refused(name, with([](S& s, B&) { s.planes.clear(); }), "one plane");
  expect_refused(name, with([](S& s, B&) { s.forces.clear(); }), "gravity does not point into plane 'floor'");
  expect_refused(name, with([](S&, B& b) { b.shape = core::Box{{1, 1, 1}}; }), "is not a sphere");
  expect_refused(name, with([](S&, B& b) { b.collide = false; }), "does not collide");
  expect_refused(name, with([](S& s, B&) { s.materials.clear(); }), "no material");
  expect_refused(name, with([](S& s, B&) { s.materials[0].friction = 0.1; }), "friction");
  expect_refused(name, with([](S&, B& b) { b.initial.position.y() = 0.4; }), "starts inside the plane");
  expect_refused(name, with([](S& s, B&) {
                   s.bodies.push_back(s.bodies[0]);
                   s.bodies[1].name = "other";
                   s.bodies[1].initial.position.x() += 5;
                   s.bodies[1].initial.velocity.x() = -4.5;
                 }),
                 "may touch body 'other'");
}

TEST(Domain, two_sphere_oblique) {
  const auto with = variations_of(valid("two_sphere_oblique"));
  const char* name = "two_sphere_oblique";
  expect_refused(name, with([](S& s, B&) { s.bodies.pop_back(); }), "two bodies");
  expect_refused(name, with([](S& s, B&) { s.planes.emplace_back(); }), "plane");
  expect_refused(name, with([](S&, B& b) { b.shape = std::monostate{}; }), "is not a sphere");
  expect_refused(name, with([](S&, B& b) { b.collide = false; }), "does not collide");
  expect_refused(name, with([](S& s, B&) { s.materials.clear(); }), "no material");
  expect_refused(name, with([](S& s, B&) { s.materials[0].friction = 0.1; }), "smooth");
  expect_refused(name, with([](S&, B& b) { b.initial.position = {-0.5, 0, 0}; }), "overlap");
}

}  // namespace
}  // namespace cylon::exact
