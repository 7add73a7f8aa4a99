// Scenes with general values inside the domain of each smooth solution that RandomScenes does not know.
#pragma once

#include "tests/reference/exact/random_scenes.h"

#include <map>
#include <string>

namespace cylon::exact {

class SmoothScenes {
 public:
  explicit SmoothScenes(unsigned seed) : random_(seed) {}

  static bool knows(const std::string& solution) { return rows().contains(solution); }

  core::Scene scene(const std::string& solution) { return (this->*rows().at(solution))(); }

 private:
  using Row = core::Scene (SmoothScenes::*)();
  static const std::map<std::string, Row>& rows() {
    static const std::map<std::string, Row> table = {
        {"projectile_drag", &SmoothScenes::projectile_drag},
        {"damped_spring", &SmoothScenes::damped_spring},
        {"driven_spring", &SmoothScenes::driven_spring},
        {"rocket", &SmoothScenes::rocket},
        {"accretion", &SmoothScenes::accretion},
        {"damped_free_top", &SmoothScenes::damped_free_top},
        {"kepler", &SmoothScenes::kepler},
        {"physical_pendulum", &SmoothScenes::physical_pendulum},
        {"spherical_pendulum", &SmoothScenes::spherical_pendulum},
        {"spring_chain", &SmoothScenes::spring_chain},
        {"rotating_frame", &SmoothScenes::rotating_frame},
        {"water_step_force", &SmoothScenes::water_step_force},
        {"seed_airplane", &SmoothScenes::seed_airplane},
    };
    return table;
  }

  double between(double low, double high) { return random_.between(low, high); }
  core::Vector3 vector(double size) { return random_.vector(size); }

  // Two balls with spins, in gravity that points anywhere.
  core::Scene balls() {
    core::Scene s;
    for (const char* name : {"body", "other"}) {
      const double moment = between(0.1, 1);
      s.bodies.push_back(random_.body({moment, moment, moment}));
      s.bodies.back().name = name;
      s.bodies.back().inertia = moment * core::Matrix3::Identity();
    }
    s.forces.emplace_back(core::UniformGravity{vector(10)});
    return s;
  }

  core::Scene projectile_drag() {
    core::Scene s = balls();
    s.forces.emplace_back(core::Drag{0, between(0.1, 3), between(0.01, 0.3), between(0.01, 0.3)});
    s.forces.emplace_back(core::Drag{1, between(1e-6, 1e-4), 0, 0});
    return s;
  }

  // The first under-damped, the second over-damped.
  core::Scene damped_spring() {
    core::Scene s = balls();
    for (int i : {0, 1}) {
      s.forces.emplace_back(core::Spring{i, {0, 0, 0}, core::world, vector(1), between(5, 80), 0, 0});
      s.forces.emplace_back(core::Spring{i, {0, 0, 0}, core::world, vector(1), between(5, 80), 0, 0});
      const double critical = 2 * std::sqrt(160 * s.bodies[static_cast<std::size_t>(i)].mass);
      s.forces.emplace_back(core::Drag{i, between(0.05, 0.2) * critical * (i == 0 ? 1 : 10), 0, 0.1});
    }
    return s;
  }

  core::Scene driven_spring() {
    core::Scene s = damped_spring();
    for (int i : {0, 0, 1}) s.forces.emplace_back(core::Drive{i, vector(5), between(0.5, 9)});
    return s;
  }

  core::Scene variable_mass() {
    core::Scene s = balls();
    for (core::Body& body : s.bodies) body.initial.angular_velocity.setZero();
    for (int i : {0, 1}) {
      const double mass = s.bodies[static_cast<std::size_t>(i)].mass;
      s.forces.emplace_back(core::Thrust{i, {0, 0, 0}, (i == 0 ? -0.15 : 0.3) * mass, {}, {}});
    }
    return s;
  }

  core::Scene rocket() {
    core::Scene s = variable_mass();
    for (core::Force& force : s.forces) {
      if (auto* thrust = std::get_if<core::Thrust>(&force)) thrust->exhaust_velocity = vector(20);
    }
    std::get<core::Thrust>(s.forces.back()).force = vector(3);
    return s;
  }

  core::Scene accretion() {
    core::Scene s = variable_mass();
    for (core::Force& force : s.forces) {
      if (auto* thrust = std::get_if<core::Thrust>(&force)) thrust->exchanged_velocity = vector(3);
    }
    return s;
  }

  core::Scene damped_free_top() {
    core::Scene s = balls();
    s.bodies[0].inertia = random_.inertia({between(0.5, 0.7), between(0.75, 0.95), between(1, 1.2)});
    s.forces.emplace_back(core::Drag{0, between(0.1, 1), 0, between(0.05, 0.5)});
    s.forces.emplace_back(core::Drag{1, 0, between(0.01, 0.1), between(0.05, 0.5)});
    return s;
  }

  // Ellipses and hyperbolas, nearer than 1/10 of the start never.
  core::Scene kepler() {
    core::Scene s = balls();
    s.forces.emplace_back(core::Attraction{1, 0, between(2, 6)});
    const core::Vector3 d = s.bodies[0].initial.position - s.bodies[1].initial.position;
    const core::Vector3 across = d.cross(vector(1)).normalized();
    const double mu =
        std::get<core::Attraction>(s.forces[1]).strength * (s.bodies[0].mass + s.bodies[1].mass);
    s.bodies[0].initial.velocity =
        s.bodies[1].initial.velocity +
        std::sqrt(mu / d.norm()) * (between(0.6, 1.8) * across + 0.3 * d.normalized());
    return s;
  }

  // The first swings, the second whirls.
  core::Scene physical_pendulum() {
    core::Scene s = balls();
    for (int i : {0, 1}) {
      core::Body& body = s.bodies[static_cast<std::size_t>(i)];
      body.inertia = random_.inertia({between(0.5, 0.7), between(0.75, 0.95), between(1, 1.2)});
      core::Joint hinge;
      hinge.type = core::JointType::hinge;
      hinge.body = i;
      hinge.axis = random_.rotation() * core::Vector3::UnitX();
      hinge.point = body.initial.position + vector(0.8);
      body.initial.angular_velocity = (i == 0 ? between(-1, 1) : between(9, 12)) * hinge.axis;
      body.initial.velocity = body.initial.angular_velocity.cross(body.initial.position - hinge.point);
      s.joints.push_back(hinge);
    }
    return s;
  }

  core::Scene spherical_pendulum() {
    core::Scene s = balls();
    for (int i : {0, 1}) {
      core::BodyState& b = s.bodies[static_cast<std::size_t>(i)].initial;
      core::Joint rod;
      rod.type = core::JointType::distance;
      rod.body = i;
      rod.point = b.position + vector(1);
      const core::Vector3 arm = b.position - rod.point;
      rod.length = arm.norm();
      b.velocity -= arm.dot(b.velocity) / arm.squaredNorm() * arm;
      s.joints.push_back(rod);
    }
    return s;
  }

  // Five beads of any mass on a line along z with rest lengths, tied to one wall; or a free net without.
  core::Scene spring_chain() {
    core::Scene s;
    const bool line = between(0, 1) < 0.5;
    const core::Vector3 origin = vector(1);
    for (int i = 0; i < 5; ++i) {
      core::Body b = random_.body({1, 1, 1});
      b.name = i == 0 ? "body" : "bead" + std::to_string(i);
      b.inertia = core::Matrix3::Identity();
      if (line) {
        b.initial.position = {origin.x(), origin.y(), origin.z() + 1.1 * i + between(-0.05, 0.05)};
        b.initial.velocity = {0, 0, between(-0.05, 0.05)};
      }
      s.bodies.push_back(b);
      if (i > 0) {
        s.forces.emplace_back(core::Spring{i - 1,
                                           {0, 0, 0},
                                           i,
                                           {0, 0, 0},
                                           line ? between(100, 200) : between(20, 80),
                                           line ? between(0.95, 1.1) : 0,
                                           0});
      }
    }
    if (line) {
      s.forces.emplace_back(core::UniformGravity{{0, 0, 0.3}});
      s.forces.emplace_back(core::Spring{
          4, {0, 0, 0}, core::world, {origin.x(), origin.y(), origin.z() + 5.5}, between(100, 200), 1, 0});
    } else {
      s.forces.emplace_back(core::UniformGravity{vector(10)});
      s.forces.emplace_back(core::Spring{0, {0, 0, 0}, 3, {0, 0, 0}, between(20, 80), 0, 0});
    }
    return s;
  }

  // A tumbling body and a ball, nothing acting; or two bodies that attract each other.
  core::Scene rotating_frame() {
    const bool pair = between(0, 1) < 0.5;
    core::Scene s = pair ? kepler() : damped_free_top();
    std::erase_if(s.forces,
                  [](const core::Force& f) { return !std::holds_alternative<core::Attraction>(f); });
    s.frame = core::Frame{vector(1), vector(1)};
    s.frame->angular_acceleration = between(-0.5, 0.5) * s.frame->angular_velocity;
    return s;
  }

  core::Scene water_step_force() {
    core::Scene s = balls();
    s.forces = {core::UniformGravity{{0, -between(8, 11), 0}},
                core::Water{between(-1, 1), between(0.1, 0.5), between(0.2, 2), between(30, 60),
                            between(0.5, 3), "step"}};
    for (core::Body& body : s.bodies) {
      body.initial.velocity = {0, between(-2, 2), 0};
      body.initial.angular_velocity.setZero();
    }
    return s;
  }

  // The second does not turn.
  core::Scene seed_airplane() {
    core::Scene s = balls();
    for (int i : {0, 1}) s.forces.emplace_back(core::Thrust{i, vector(8), 0, {}, {}});
    s.bodies[1].initial.angular_velocity.setZero();
    return s;
  }

  RandomScenes random_;
};

}  // namespace cylon::exact
