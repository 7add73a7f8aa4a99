#include "tests/mutants/matrix/decorator.h"

#include <algorithm>
#include <cmath>

namespace cylon::mutants {
namespace {

using core::Body;
using core::Force;
using core::Material;
using core::Matrix3;
using core::Scene;
using core::Setup;
using core::Terms;
using core::Vector3;

Mask scene(std::function<void(Scene&)> change) { return {.scene = std::move(change)}; }

Mask every_body(std::function<void(Body&)> change) {
  return scene([change = std::move(change)](Scene& s) {
    for (Body& body : s.bodies) change(body);
  });
}

Mask every_material(std::function<void(Material&)> change) {
  return scene([change = std::move(change)](Scene& s) {
    for (Material& material : s.materials) change(material);
  });
}

template <class F>
Mask every(std::function<void(F&)> change) {
  return scene([change = std::move(change)](Scene& s) {
    for (Force& force : s.forces)
      if (auto* one = std::get_if<F>(&force)) change(*one);
  });
}

template <class F>
Mask without() {
  return scene(
      [](Scene& s) { std::erase_if(s.forces, [](const Force& f) { return std::holds_alternative<F>(f); }); });
}

// Damping that the user did not ask for: per mass, per inertia (mean), per angular momentum [1/s].
Mask damped(double linear, double angular, double momentum) {
  return scene([=](Scene& s) {
    for (std::size_t i = 0; i < s.bodies.size(); ++i)
      s.forces.emplace_back(core::Drag{static_cast<int>(i), linear * s.bodies[i].mass,
                                       angular * s.bodies[i].inertia.trace() / 3, momentum});
  });
}

// Gravity and the free motion of a rigid body, and nothing that holds, pushes or meets it.
void falls_freely(Scene& s) {
  for (Body& body : s.bodies) body.collide = false;
  s.planes.clear();
  s.joints.clear();
  std::erase_if(s.forces, [](const Force& f) { return !std::holds_alternative<core::UniformGravity>(f); });
}

Mask claims_to_be(const char* integrator, std::function<void(Terms&)> lie) {
  return {.setup = [integrator](Setup& s) { s.integrator = integrator; }, .terms = std::move(lie)};
}

void auto_at_1e_10(Terms& terms) {
  terms.integrator = "auto";
  terms.settings = {{"tolerance", "1e-10", "1e-10", "bound on the error at the samples"}};
}

}  // namespace

std::vector<MaskedRow> faults_of_the_scene() {
  const Matrix3 cycle = (Matrix3() << 0, 1, 0, 0, 0, 1, 1, 0, 0).finished();
  return {
      {"only falls", "no contact, no joint, no force but gravity", "bouncing", "position follows",
       scene(falls_freely)},
      {"gravity twice", "by the scene and by the world", "projectile", "position follows",
       every<core::UniformGravity>([](auto& g) { g.acceleration *= 2; })},
      {"gravity leans", "by a millionth", "projectile", "linear_momentum",
       every<core::UniformGravity>([](auto& g) { g.acceleration.x() += 1e-6 * g.acceleration.norm(); })},
      {"clock fast by 1e-6",
       "time runs fast by a millionth",
       "projectile",
       "position follows * by theory",
       {.setup = [](Setup& s) { s.dt *= 1 + 1e-6; }}},
      {"half steps",
       "advances by dt/2",
       "projectile",
       "position follows",
       {.setup = [](Setup& s) { s.dt /= 2; }}},
      {"steps skipped",
       "one in a hundred",
       "projectile",
       "position follows",
       {.skips = [](std::int64_t step) { return step % 100 == 50; }}},
      {"gyroscopic term off", "as if all moments were equal", "symmetric_top", "orientation follows",
       every_body([](Body& b) { b.inertia = Matrix3::Identity() * b.inertia.trace() / 3; })},
      {"inertia axes permuted", "x, y, z as y, z, x", "damped_top", "orientation follows",
       every_body([=](Body& b) { b.inertia = cycle * b.inertia * cycle.transpose(); })},
      {"inertia off-diagonal dropped", "moments without axes", "hammer", "orientation follows",
       every_body([](Body& b) { b.inertia = Matrix3(b.inertia.diagonal().asDiagonal()); })},
      {"inertia sign of products", "+ for - off the diagonal", "hammer", "orientation follows",
       every_body([](Body& b) { b.inertia = 2 * Matrix3(b.inertia.diagonal().asDiagonal()) - b.inertia; })},
      {"hollow spheres", "2/3 in place of 2/5", "slide_to_roll", "velocity follows", every_body([](Body& b) {
         if (std::holds_alternative<core::Sphere>(b.shape)) b.inertia *= 5.0 / 3;
       })},
      {"hidden damping 0.04", "linear, as an engine's default", "projectile", "position follows",
       damped(0.04, 0, 0)},
      {"hidden damping 0.05 of spin", "angular, as an engine's default", "constant_spin",
       "orientation follows", damped(0, 0.05, 0)},
      {"leaking angular momentum", "1e-5 a second", "symmetric_top", "angular_momentum conserved by theory",
       damped(0, 0, 1e-5)},
      {"restitution by product", "e^2 in place of e", "bouncing", "position follows",
       every_material([](Material& m) { m.restitution *= m.restitution; })},
      {"restitution by max", "with a default of 0.5", "head_on", "velocity follows",
       every_material([](Material& m) { m.restitution = std::max(m.restitution, 0.5); })},
      {"friction by mean", "with a default of 0.5", "rough_ball", "velocity follows",
       every_material([](Material& m) { m.friction = (m.friction + 0.5) / 2; })},
      {"friction off", "every surface is smooth", "slide_to_roll", "velocity follows",
       every_material([](Material& m) { m.friction = 0; })},
      {"friction without limit", "no slip ever", "rough_ball", "velocity follows",
       every_material([](Material& m) { m.friction = m.friction > 0 ? 100 : 0; })},
      {"contact margin", "spheres are 1 mm larger", "bouncing", "event follows", every_body([](Body& b) {
         if (auto* sphere = std::get_if<core::Sphere>(&b.shape)) sphere->radius += 1e-3;
       })},
      {"tunnelling", "fast bodies miss what they pass in a step", "fast_ball", "normal_gap",
       every_body([](Body& b) {
         const auto* sphere = std::get_if<core::Sphere>(&b.shape);
         if (sphere && b.initial.velocity.norm() / 1024 > 2 * sphere->radius) b.collide = false;
       })},
      {"mass ratios clipped", "no mass above twice another", "oblique", "velocity follows",
       scene([](Scene& s) {
         double least = s.bodies.front().mass;
         for (const Body& b : s.bodies) least = std::min(least, b.mass);
         for (Body& b : s.bodies) b.mass = std::min(b.mass, 2 * least);
       })},
      {"mass by number", "each body a millionth heavier than the last", "body order", "motion",
       scene([](Scene& s) {
         for (std::size_t i = 0; i < s.bodies.size(); ++i)
           s.bodies[i].mass *= 1 + 1e-6 * static_cast<double>(i);
       })},
      {"drag forgotten", "no resistance", "projectile_drag", "position follows", without<core::Drag>()},
      {"drive forgotten", "no driving force", "driven_spring", "position follows", without<core::Drive>()},
      {"drive off by 1e-4", "of its frequency", "driven_spring", "position follows * by theory",
       every<core::Drive>([](auto& d) { d.frequency *= 1 + 1e-4; })},
      {"rest length forgotten", "springs have none", "spring_orbit", "position follows",
       every<core::Spring>([](auto& k) { k.rest_length = 0; })},
      {"anchors at the centre", "springs do not turn bodies", "two_body_spring", "orientation follows",
       every<core::Spring>([](auto& k) {
         k.anchor.setZero();
         if (k.to != core::world) k.to_anchor.setZero();
       })},
      {"attraction softened", "by 1e-5", "kepler", "position follows * by theory",
       every<core::Attraction>([](auto& a) { a.strength *= 1 - 1e-5; })},
      {"exhaust turned round", "the rocket brakes", "rocket", "velocity follows",
       every<core::Thrust>([](auto& t) {
         if (t.exhaust_velocity) *t.exhaust_velocity *= -1;
       })},
      {"mass kept", "a rocket that stays as heavy", "rocket", "velocity follows",
       every<core::Thrust>([](auto& t) {
         if (!t.exhaust_velocity) return;
         t.force += t.mass_rate * *t.exhaust_velocity;
         t.mass_rate = 0, t.exhaust_velocity.reset();
       })},
      {"water 1 cm too high", "the level", "cork", "position follows",
       every<core::Water>([](auto& w) { w.level += 0.01; })},
      {"turning frame forgotten", "no Coriolis, no centrifugal term", "rotating_frame", "position follows",
       scene([](Scene& s) { s.frame.reset(); })},
      {"soft joint", "a stiff spring in place of a ball joint", "heavy_top", "joint_gap", scene([](Scene& s) {
         for (const core::Joint& joint : s.joints) {
           const core::BodyState& b = s.bodies[static_cast<std::size_t>(joint.body)].initial;
           if (joint.to == core::world)
             s.forces.emplace_back(core::Spring{joint.body,
                                                b.orientation.conjugate() * (joint.point - b.position),
                                                core::world, joint.point, 1e4, 0, 0});
         }
         std::erase_if(s.joints, [](const core::Joint& joint) { return joint.to == core::world; });
       })},
      {"energy-neutral, wrong phase", "a symplectic integrator that claims to bound its error", "spring_zero",
       "position follows * by theory", claims_to_be("velocity-verlet", auto_at_1e_10)},
      {"order overstated", "first order, said to be second", "spring_zero", "position follows * order",
       claims_to_be("lie-trotter", [](Terms& terms) { terms.order = 2; })},
      {"impacts at the end of a step",
       "said to be located",
       "bouncing",
       "position follows",
       {.setup =
            [](Setup& s) {
              s.integrator.clear();
              s.path = "stepping";
            },
        .terms = auto_at_1e_10}},
  };
}

}  // namespace cylon::mutants
