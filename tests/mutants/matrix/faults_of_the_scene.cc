#include "tests/mutants/matrix/decorator.h"

#include "harness/core/collision_filter.h"

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

Mask joints(core::JointType from, core::JointType to) {
  return scene([=](Scene& s) {
    for (core::Joint& joint : s.joints)
      if (joint.type == from) joint.type = to;
  });
}

// Who touches whom by another rule: each thing in a group of its own, with a mask of those that it meets.  `may_meet`
// gets the filters of two things, bodies before planes and in the order of the scene.
Mask groups_by(bool (*may_meet)(const core::CollisionFilter&, const core::CollisionFilter&)) {
  return scene([may_meet](Scene& s) {
    const core::CollisionFilters filters(s);
    if (!filters.stated) return;
    std::vector<core::CollisionFilter> all = filters.of_body;
    all.insert(all.end(), filters.of_plane.begin(), filters.of_plane.end());
    const auto state = [&](auto& thing, std::size_t i) {
      thing.collision_groups = {"thing " + std::to_string(i)};
      thing.collision_mask = {"nothing"};
      for (std::size_t k = 0; k < all.size(); ++k)
        if (k != i && (k < i ? may_meet(all[k], all[i]) : may_meet(all[i], all[k])))
          thing.collision_mask.push_back("thing " + std::to_string(k));
    };
    for (std::size_t i = 0; i < s.bodies.size(); ++i) state(s.bodies[i], i);
    for (std::size_t p = 0; p < s.planes.size(); ++p) state(s.planes[p], s.bodies.size() + p);
  });
}

bool first_admits(const core::CollisionFilter& a, const core::CollisionFilter& b) {
  return (a.mask & b.groups) != 0;
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
       "theory: position follows",
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
      {"leaking angular momentum", "1e-5 a second", "symmetric_top", "theory: angular_momentum conserved",
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
      {"hinge taken for a ball", "the point is held, the axis is not", "hinge_tilted", "angular_joint_gap",
       joints(core::JointType::hinge, core::JointType::ball)},
      {"hinge taken for a weld", "it does not turn at all", "pendulum", "orientation follows",
       joints(core::JointType::hinge, core::JointType::fixed)},
      {"weld taken for a ball", "the point is held, the turn is not", "fixed_arm", "angular_joint_gap",
       joints(core::JointType::fixed, core::JointType::ball)},
      {"joints at the centre", "wherever they are", "heavy_top", "axis follows", scene([](Scene& s) {
         for (core::Joint& joint : s.joints)
           if (joint.to == core::world)
             joint.point = s.bodies[static_cast<std::size_t>(joint.body)].initial.position;
       })},
      {"joints forgotten", "bodies are free", "pendulum", "joint_gap",
       scene([](Scene& s) { s.joints.clear(); })},
      {"spring damping ignored", "springs swing for ever", "spring_damper", "position follows",
       every<core::Spring>([](auto& k) { k.damping = 0; })},
      {"spring damping doubled", "each end damps", "spring_damper", "position follows",
       every<core::Spring>([](auto& k) { k.damping *= 2; })},
      {"stiffness off by 1e-6", "as a printed number is", "spring_zero", "theory: position follows",
       every<core::Spring>([](auto& k) { k.stiffness *= 1 + 1e-6; })},
      {"springs to bodies forgotten", "those to the world act", "two_body_spring", "position follows",
       scene([](Scene& s) {
         std::erase_if(s.forces, [](const Force& f) {
           const auto* spring = std::get_if<core::Spring>(&f);
           return spring && spring->to != core::world;
         });
       })},
      {"gravity along y alone", "x and z are dropped", "tilted_gravity", "position follows",
       every<core::UniformGravity>([](auto& g) { g.acceleration.x() = 0, g.acceleration.z() = 0; })},
      {"gravity of 9.8", "whatever it is, 1e-3 less", "projectile", "theory: position follows",
       every<core::UniformGravity>([](auto& g) { g.acceleration *= 9.8 / 9.81; })},
      {"every other body heavier", "by 1e-4", "spring_chain", "theory: position follows", scene([](Scene& s) {
         for (std::size_t i = 1; i < s.bodies.size(); i += 2) s.bodies[i].mass *= 1 + 1e-4;
       })},
      {"exact materials lost", "* wins over a name", "named_material", "position follows",
       scene([](Scene& s) {
         const bool general = std::any_of(s.materials.begin(), s.materials.end(), [](const Material& m) {
           return m.between[0] == "*" && m.between[1] == "*";
         });
         if (general)
           std::erase_if(s.materials,
                         [](const Material& m) { return m.between[0] != "*" || m.between[1] != "*"; });
       })},
      {"half-named materials lost", "a name with * wins over two names", "named_material", "position follows",
       scene([](Scene& s) {
         const bool half = std::any_of(s.materials.begin(), s.materials.end(), [](const Material& m) {
           return (m.between[0] == "*") != (m.between[1] == "*");
         });
         if (half)
           std::erase_if(s.materials,
                         [](const Material& m) { return m.between[0] != "*" && m.between[1] != "*"; });
       })},
      {"boxes do not bounce", "e = 0 for boxes", "box_edge", "angular_velocity follows", scene([](Scene& s) {
         const bool box = std::any_of(s.bodies.begin(), s.bodies.end(), [](const Body& b) {
           return std::holds_alternative<core::Box>(b.shape);
         });
         for (Material& m : s.materials)
           if (box) m.restitution = 0;
       })},
      {"restitution 0.99 of its value", "every blow loses a little", "two_walls", "velocity follows",
       every_material([](Material& m) { m.restitution *= 0.99; })},
      {"friction 1 % high", "as a rounded angle is", "block_stops", "position follows",
       every_material([](Material& m) { m.friction *= 1.01; })},
      {"friction twice", "by either body", "rough_ball", "velocity follows",
       every_material([](Material& m) { m.friction *= 2; })},
      {"water drags ten times", "a decimal point", "cork", "position follows",
       every<core::Water>([](auto& w) { w.drag *= 10; })},
      {"water without drag", "floats swing for ever", "cork", "position follows",
       every<core::Water>([](auto& w) { w.drag = 0; })},
      {"wave stands still", "the water is a hill", "cork", "position follows",
       every<core::Water>([](auto& w) { w.speed = 0; })},
      {"buoyancy 1 % low", "as of another liquid", "cork", "position follows",
       every<core::Water>([](auto& w) { w.buoyancy *= 0.99; })},
      {"boxes half a millimetre in", "a margin that is not taken off", "box_on_slab", "normal_gap",
       every_body([](Body& b) {
         if (auto* box = std::get_if<core::Box>(&b.shape)) box->half_extents.array() -= 2.5e-4;
       })},
      {"boxes with rounded corners", "a margin of a centimetre", "box_edge", "normal_gap",
       every_body([](Body& b) {
         if (auto* box = std::get_if<core::Box>(&b.shape)) box->half_extents.array() -= 1e-2;
       })},
      {"floors 0.1 mm low", "an offset in float", "bouncing", "theory: position follows", scene([](Scene& s) {
         for (core::Plane& plane : s.planes) plane.offset -= 1e-4;
       })},
      {"slopes flatter by 1e-3", "the angle of a plane", "block_stops", "position follows",
       scene([](Scene& s) {
         for (core::Plane& plane : s.planes)
           plane.normal = (plane.normal + 1e-3 * Vector3::UnitX()).normalized();
       })},
      {"spin of spheres forgotten", "balls are points", "rough_ball", "angular_velocity follows",
       every_body([](Body& b) {
         if (std::holds_alternative<core::Sphere>(b.shape)) b.initial.angular_velocity.setZero();
       })},
      {"starts in body axes", "the first w is taken as the body's", "two_body_spring", "orientation follows",
       every_body(
           [](Body& b) { b.initial.angular_velocity = b.initial.orientation * b.initial.angular_velocity; })},
      {"angular drag forgotten", "spins last", "damped_top", "angular_velocity follows",
       every<core::Drag>([](auto& d) { d.angular = 0, d.momentum = 0; })},
      {"drag off by 1e-5", "of its value", "projectile_drag", "theory: position follows",
       every<core::Drag>([](auto& d) { d.linear *= 1 + 1e-5; })},
      {"thrust forgotten", "no engine", "airplane", "velocity follows",
       every<core::Thrust>([](auto& t) { t.force.setZero(); })},
      {"masses fall faster", "a tenth, of a rocket", "rocket", "velocity follows",
       every<core::Thrust>([](auto& t) { t.mass_rate *= 1.1; })},
      {"drive of 1 % more", "its amplitude", "driven_spring", "position follows",
       every<core::Drive>([](auto& d) { d.force *= 1.01; })},
      {"frame turns the other way", "Coriolis to the left", "rotating_frame", "position follows",
       scene([](Scene& s) {
         if (s.frame) s.frame->angular_velocity *= -1;
       })},
      {"frame turns half as fast", "w x v in place of 2 w x v", "rotating_frame", "position follows",
       scene([](Scene& s) {
         if (s.frame) s.frame->angular_velocity *= 0.5;
       })},
      {"impacts all at once", "where a blow should travel", "cradle", "velocity follows", scene([](Scene& s) {
         s.impacts =
             s.impacts == core::Impacts::sequential ? core::Impacts::simultaneous : core::Impacts::sequential;
       })},
      {"inertia 1 % high", "of every body", "rod_hit", "angular_velocity follows",
       every_body([](Body& b) { b.inertia *= 1.01; })},
      {"inertia off by 1e-6", "of one moment", "hammer", "theory: orientation follows",
       every_body([](Body& b) { b.inertia(0, 0) *= 1 + 1e-6; })},
      {"own gravity ignored", "all fall alike", "own_gravity", "position follows",
       every_body([](Body& b) { b.gravity.reset(); })},
      {"own gravity added", "to the scene's, in place of which it stands", "own_gravity", "position follows",
       scene([](Scene& s) {
         const Vector3 of_all = core::gravity(s);
         for (Body& b : s.bodies)
           if (b.gravity) *b.gravity += of_all;
       })},
      {"own gravity only switches off", "zero is known, other values are not", "own_gravity",
       "position follows", every_body([](Body& b) {
         if (b.gravity && !b.gravity->isZero(0)) b.gravity.reset();
       })},
      {"own gravity zero is none", "as if the key were absent", "own_gravity", "position follows",
       every_body([](Body& b) {
         if (b.gravity && b.gravity->isZero(0)) b.gravity.reset();
       })},
      {"collision groups ignored", "everything touches everything", "groups", "position follows",
       groups_by([](const auto&, const auto&) { return true; })},
      {"collision groups of planes ignored", "bodies alone have filters", "groups_planes", "position follows",
       scene([](Scene& s) {
         for (core::Plane& plane : s.planes) plane.collision_groups.clear(), plane.collision_mask.clear();
         for (Body& body : s.bodies) body.collision_mask.clear();
       })},
      {"collision masks by or", "one of the two masks is enough", "groups", "position follows",
       groups_by([](const auto& a, const auto& b) { return first_admits(a, b) || first_admits(b, a); })},
      {"collision mask of the first", "that of the second is not asked", "groups", "position follows",
       groups_by([](const auto& a, const auto& b) { return first_admits(a, b); })},
      {"collision mask of the second", "that of the first is not asked", "groups", "position follows",
       groups_by([](const auto& a, const auto& b) { return first_admits(b, a); })},
      {"locked bodies are heavy", "and no more than that", "locked_post", "position", every_body([](Body& b) {
         if (b.locked) b.locked = false, b.mass = 1e4, b.inertia = 1e4 * Matrix3::Identity();
       })},
      {"drag forgotten", "no resistance", "projectile_drag", "position follows", without<core::Drag>()},
      {"drive forgotten", "no driving force", "driven_spring", "position follows", without<core::Drive>()},
      {"drive off by 1e-4", "of its frequency", "driven_spring", "theory: position follows",
       every<core::Drive>([](auto& d) { d.frequency *= 1 + 1e-4; })},
      {"rest length forgotten", "springs have none", "spring_orbit", "position follows",
       every<core::Spring>([](auto& k) { k.rest_length = 0; })},
      {"anchors at the centre", "springs do not turn bodies", "two_body_spring", "orientation follows",
       every<core::Spring>([](auto& k) {
         k.anchor.setZero();
         if (k.to != core::world) k.to_anchor.setZero();
       })},
      {"attraction softened", "by 1e-5", "kepler", "theory: position follows",
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
      {"Euler force forgotten", "of a frame that turns ever faster", "carousel_spins_up", "position follows",
       scene([](Scene& s) {
         if (s.frame) s.frame->angular_acceleration.setZero();
       })},
      {"train accelerates the wrong way", "the acceleration of the frame as a force", "braking_train",
       "position follows", scene([](Scene& s) {
         if (s.frame) s.frame->acceleration *= -1;
       })},
      {"shaking out of time", "the frame's acceleration is constant", "shaken_spring", "position follows",
       scene([](Scene& s) {
         if (s.frame) s.frame->frequency = 0;
       })},
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
       "theory: position follows", claims_to_be("velocity-verlet", auto_at_1e_10)},
      {"order overstated", "first order, said to be second", "spring_zero",
       "theory: order of position follows",
       claims_to_be("lie-trotter", [](Terms& terms) { terms.order = 2; })},
      {"impacts at the end of a step",
       "said to be located",
       "box_edge",
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
