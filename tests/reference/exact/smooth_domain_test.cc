// Every smooth solution with forces or joints of its own refuses what it cannot serve and says which
// condition failed: one scene per condition.  What all solutions refuse alike stands in domain_test.cc.
#include "reference/exact/catalogue.h"
#include "tests/reference/exact/smooth_scenes.h"

#include <gtest/gtest.h>

namespace cylon::exact {
namespace {

using S = core::Scene;
using B = core::Body;

template <class Force>
Force& first(S& scene) {
  for (core::Force& force : scene.forces) {
    if (auto* found = std::get_if<Force>(&force)) return *found;
  }
  throw std::runtime_error("no such force");
}

struct Refusal {
  const char* solution;
  void (*change)(S&, B&);
  const char* reason;
};

void PrintTo(const Refusal& r, std::ostream* out) { *out << r.solution << ": " << r.reason; }

class SmoothDomain : public testing::TestWithParam<Refusal> {};

TEST_P(SmoothDomain, refuses) {
  const auto& [solution_name, change, reason] = GetParam();
  const auto name = solution_name;  // a structured binding may not be captured by every compiler
  S scene = SmoothScenes(5).scene(name);
  const auto make = [&] {
    for (const Solution& solution : catalogue()) {
      if (solution.name == name) return solution.make(scene, 2);
    }
    throw std::runtime_error("no such solution");
  };
  EXPECT_NO_THROW(make());
  change(scene, scene.bodies[0]);
  try {
    make();
    ADD_FAILURE() << name << " accepted a scene with: " << reason;
  } catch (const core::OutOfDomain& refusal) {
    EXPECT_NE(std::string(refusal.what()).find(reason), std::string::npos) << refusal.what();
    EXPECT_EQ(std::string(refusal.what()).find(name), 0u) << refusal.what();
  }
}

const Refusal refusals[] = {
    {"damped_spring", [](S& s, B&) { first<core::Spring>(s).rest_length = 1; }, "has a rest length"},
    {"damped_spring", [](S& s, B&) { first<core::Spring>(s).damping = 1; }, "is damped"},
    {"driven_spring", [](S& s, B&) { first<core::Spring>(s).to = 1; }, "ends on another body"},
    {"rocket", [](S& s, B&) { first<core::Thrust>(s).mass_rate = -s.bodies[0].mass; }, "has no mass left"},
    {"rocket", [](S& s, B&) { s.forces.emplace_back(first<core::Thrust>(s)); }, "has two thrusts"},
    {"rocket", [](S& s, B&) { first<core::Thrust>(s).exhaust_velocity.reset(); }, "no stated velocity"},
    {"rocket", [](S& s, B&) { first<core::Thrust>(s).exchanged_velocity = core::Vector3(1, 0, 0); },
     "accretion"},
    {"accretion", [](S& s, B&) { first<core::Thrust>(s).exhaust_velocity = core::Vector3(1, 0, 0); },
     "rocket"},
    {"accretion",
     [](S& s, B&) {
       first<core::Thrust>(s).force = {1, 0, 0};
     },
     "has a thrust besides"},
    {"accretion", [](S& s, B&) { first<core::Thrust>(s).exchanged_velocity.reset(); }, "no stated velocity"},
    {"seed_airplane", [](S& s, B&) { first<core::Thrust>(s).mass_rate = -0.1; }, "changes its mass"},
    {"damped_free_top", [](S& s, B&) { first<core::Drag>(s).angular = 0.1; },
     "does not turn about a principal axis"},
    {"damped_free_top", [](S&, B& b) { b.inertia = core::Vector3(0, 1, 1).asDiagonal(); }, "is not positive"},
    {"damped_free_top",
     [](S&, B& b) {
       b.inertia = core::Vector3(1, 2, 2.25).asDiagonal();  // 1 w1^2 = 0.5625 w3^2
       b.initial.orientation.setIdentity();
       b.initial.angular_velocity = {3, 1, 4};
     },
     "separatrix"},
    {"kepler", [](S& s, B&) { s.bodies.push_back(s.bodies[0]); }, "must have two bodies"},
    {"kepler", [](S& s, B&) { s.forces.push_back(s.forces.back()); }, "two attractions"},
    {"kepler", [](S& s, B&) { s.forces.pop_back(); }, "no attraction"},
    {"kepler", [](S& s, B&) { first<core::Attraction>(s).strength = 0; }, "no strength"},
    {"kepler", [](S& s, B& b) { b.locked = s.bodies[1].locked = true; }, "both bodies are locked"},
    {"kepler", [](S&, B& b) { b.locked = true; }, "gravity and a locked body"},
    {"kepler", [](S& s, B& b) { b.initial.velocity = s.bodies[1].initial.velocity; }, "or too near it"},
    {"physical_pendulum", [](S& s, B&) { s.joints.pop_back(); }, "must have exactly one joint"},
    {"physical_pendulum", [](S& s, B&) { s.joints[0].type = core::JointType::ball; }, "is not a hinge"},
    {"physical_pendulum", [](S& s, B&) { s.joints[0].to = 1; }, "does not end on the world"},
    {"physical_pendulum", [](S&, B& b) { b.initial.angular_velocity += core::Vector3(1e-6, 1e-6, 0); },
     "does not turn about its hinge"},
    {"physical_pendulum", [](S&, B& b) { b.initial.velocity.x() += 1e-6; }, "breaks its joint"},
    {"physical_pendulum",
     [](S& s, B& b) {  // from the bottom with just the energy of the top: w^2 = 4 m g l/J
       b.mass = 1;
       b.inertia.setZero();
       b.initial = {{0, -0.5, 0}, core::Quaternion(1, 0, 0, 0), {4, 0, 0}, {0, 0, 8}};
       s.joints[0].point.setZero();
       s.joints[0].axis = {0, 0, 1};
       s.forces = {core::UniformGravity{{0, -8, 0}}};
     },
     "separatrix"},
    {"physical_pendulum",
     [](S& s, B& b) {
       b.inertia.setZero();
       s.joints[0].point = b.initial.position;
       b.initial.velocity.setZero();
     },
     "no moment of inertia about its hinge"},
    {"spherical_pendulum", [](S& s, B&) { s.forces.clear(); }, "no gravity"},
    {"spherical_pendulum", [](S& s, B&) { s.joints.pop_back(); }, "must have exactly one joint"},
    {"spherical_pendulum", [](S& s, B&) { s.joints[0].type = core::JointType::ball; },
     "is not a distance joint"},
    {"spherical_pendulum", [](S& s, B&) { s.joints[0].to = 1; }, "does not end on the world"},
    {"spherical_pendulum", [](S& s, B&) { s.joints[0].length *= 1.001; }, "is not at its joint's length"},
    {"spherical_pendulum",
     [](S& s, B& b) { b.initial.velocity += 1e-3 * (b.initial.position - s.joints[0].point); },
     "breaks its joint"},
    {"spherical_pendulum",
     [](S& s, B& b) {  // v^2/2 = 2 g l
       b.initial.position = {0, -0.5, 0}, b.initial.velocity = {4, 0, 0};
       s.joints[0].point.setZero(), s.joints[0].length = 0.5;
       s.forces = {core::UniformGravity{{0, -8, 0}}};
     },
     "separatrix"},
    {"spring_chain",
     [](S& s, B&) {
       first<core::Spring>(s).anchor = {0.1, 0, 0};
     },
     "not anchored at the centre"},
    {"spring_chain",
     [](S& s, B&) {
       first<core::Spring>(s).to_anchor = {0.1, 0, 0};
     },
     "not anchored at the centre"},
    {"spring_chain", [](S& s, B&) { first<core::Spring>(s).damping = 1; }, "is damped"},
    {"spring_chain", [](S& s, B&) { first<core::Spring>(s).stiffness = 0; }, "no stiffness"},
    {"spring_chain", [](S& s, B&) { s.bodies.push_back(s.bodies[0]); }, "in several pieces"},
    {"rotating_frame", [](S& s, B&) { s.frame.reset(); }, "has no frame"},
    {"rotating_frame",
     [](S& s, B&) {
       s.frame->angular_velocity.setZero();
       s.frame->angular_acceleration.setZero();
     },
     "does not turn"},
    {"rotating_frame",
     [](S& s, B&) {
       s.frame->acceleration = {0.1, 0, 0};
     },
     "accelerates"},
    {"rotating_frame",
     [](S& s, B&) { s.frame->angular_acceleration += s.frame->angular_velocity.unitOrthogonal(); },
     "not along its angular velocity"},
    {"rotating_frame", [](S& s, B&) { s.forces.emplace_back(core::Spring{}); },
     "is pinned to a turning frame"},
    {"rotating_frame", [](S& s, B&) { s.forces.emplace_back(core::UniformGravity{}); }, "gravity"},
    {"rotating_frame",
     [](S& s, B&) {
       s.forces = {core::Spring{0, {0.1, 0, 0}, 1, {0, 0, 0}, 5, 0, 0}};
     },
     "no solution serves the inertial scene"},
    {"water_step_force", [](S& s, B&) { first<core::Water>(s).mode = "volume"; }, "not of mode 'step'"},
    {"water_step_force", [](S& s, B&) { s.forces.pop_back(); }, "has no water"},
    {"water_step_force", [](S& s, B&) { s.forces.push_back(s.forces.back()); }, "two waters"},
    {"water_step_force", [](S& s, B&) { first<core::UniformGravity>(s).acceleration.x() = 1; },
     "not vertical"},
    {"water_step_force", [](S&, B& b) { b.initial.velocity.x() = 1; }, "moves sideways"},
    {"water_step_force", [](S&, B& b) { b.initial.position.z() = -5.1; }, "is off the water"},
    {"water_step_force",
     [](S& s, B& b) {  // thrown up to the still surface exactly
       first<core::Water>(s) = {1, 0, 0, 0, 0, "step"};
       first<core::UniformGravity>(s).acceleration = {0, -2, 0};
       b.mass = 1;
       b.initial.position.y() = 0, b.initial.velocity.y() = 2;
     },
     "grazes the surface"},
};

INSTANTIATE_TEST_SUITE_P(all, SmoothDomain, testing::ValuesIn(refusals), [](const auto& p) {
  return std::string(p.param.solution) + "_" + std::to_string(p.index);
});

// What only a chain with rest lengths must be.
TEST(ChainDomain, chains_with_rest_lengths) {
  S good;
  for (int i = 0; i < 3; ++i) {
    B b;
    b.name = "bead" + std::to_string(i);
    b.initial.position = {0.5, 0.25, 1.0 * i};
    b.initial.velocity = {0.5, 0, 0.1 * i};
    good.bodies.push_back(b);
    if (i > 0) good.forces.emplace_back(core::Spring{i - 1, {0, 0, 0}, i, {0, 0, 0}, 50, 0.9, 0});
  }
  const auto chain = [&](auto&& change) {
    S scene = good;
    change(scene);
    for (const Solution& solution : catalogue()) {
      if (solution.name == "spring_chain") return solution.make(scene, 2);
    }
    throw std::runtime_error("no spring_chain");
  };
  EXPECT_NO_THROW(chain([](S&) {}));
  const auto refused = [&](auto&& change, const char* reason) {
    try {
      chain(change);
      ADD_FAILURE() << "accepted: " << reason;
    } catch (const core::OutOfDomain& refusal) {
      EXPECT_NE(std::string(refusal.what()).find(reason), std::string::npos) << refusal.what();
    }
  };
  refused([](S& s) { s.bodies[1].initial.position.x() += 1e-9; }, "not exactly parallel");
  refused([](S& s) { s.bodies[1].initial.velocity.x() += 1e-9; }, "moves across the chain");
  refused([](S& s) { s.bodies[1].initial.velocity.z() = 30; }, "may meet");
  refused([](S& s) { s.bodies[1].initial.position = s.bodies[0].initial.position; }, "starts without length");
  refused(
      [](S& s) {
        for (B& b : s.bodies) b.initial.velocity.x() = 0;
        s.forces.emplace_back(core::Spring{0, {0, 0, 0}, core::world, {0.5, 0.25, -1}, 50, 0.9, 0});
        s.forces.emplace_back(core::UniformGravity{});
      },
      "gravity acts across the chain");
}

}  // namespace
}  // namespace cylon::exact
