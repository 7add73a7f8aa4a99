// Joints in fixed steps were closed by sixteen sweeps, which left most of them open by 1e-9 to 1e-6 m, and a diagnostic said
// so of nearly every step.
#include "tests/engine/diagnostic_scenes.h"
#include "tests/engine/joint_scenes.h"

namespace cylon::engine {
namespace {

Options by_steps(Time dt) {
  Options options = with("auto", dt);
  options.path = "stepping";
  return options;
}

// The end of a run by steps, and whether joints stayed open.
struct Jointed {
  std::vector<Motion> motions;
  bool drifted = false;
};
Jointed after_steps(const Model& model, Time dt, int steps) {
  EXPECT_EQ(unsupported(model, by_steps(dt)), "");
  World world(model, by_steps(dt));
  for (int k = 0; k < steps; ++k) world.step();
  const auto told = world.diagnostics();
  return {world.motions(), std::ranges::any_of(told, [](const Diagnostic& d) {
            return d.kind == DiagnosticKind::joints_drifted;
          })};
}

// Chains that fall on a floor, and each kind of joint with a limit that it meets.
TEST(JointsInSteps, AreClosedToRounding) {
  for (const Time dt : {0.02, 0.005}) {
    const Model chain = chain_of_boxes(8);
    const int steps = static_cast<int>(std::lround(1 / dt));
    const Jointed end = after_steps(chain, dt, steps);
    for (const Joint& joint : chain.joints)
      EXPECT_LT(opened(end.motions, joint), 1e-13) << dt;  // 2 to 9 m away
    EXPECT_FALSE(end.drifted) << dt;
  }
  for (const JointKind& kind : joint_kinds) {
    for (const bool to_world : {false, true}) {
      JointScene scene = joint_scene(kind.type, to_world);
      scene.model.forces.gravity = {0.2, -9.81, 0.4};
      CoordinateLaw law;
      law.at = kind.type.place == Joint::Place::together ? scene.angle() : scene.displacement(scene.axis);
      if (kind.type.place == Joint::Place::in_plane) law.at = scene.displacement(scene.second);
      law.lower = -0.05, law.upper = 0.05, law.friction = 0.1;
      scene.model.forces.coordinate_laws.push_back(law);
      scene.model.planes = {{Vector3::UnitY(), -40}};
      make_touchable(scene.model, 0);
      const Jointed end = after_steps(scene.model, 0.005, 200);
      EXPECT_LT(opened(end.motions, scene.joint()), 1e-13) << kind.name << to_world;
      EXPECT_FALSE(end.drifted) << kind.name << to_world;
    }
  }
}

// An arm on a hinge of the world carries a ball on a universal joint, which strikes a rough floor.  A rotor on the hinge is
// inertia of the arm about its axis.  It took the steps to first order, by which an impact with friction is two: the ball went
// elsewhere with each step.
TEST(JointsInSteps, RotorStrikesAsInertiaDoes) {
  const auto struck = [](bool rotor, Time dt) {
    Model model;
    const Real more = Real(0.1);
    const Matrix3 own = Vector3(Real(0.02), Real(0.03), Real(0.025)).asDiagonal();
    add_body(model, make_body(1, rotor ? own : Matrix3(own + more * Matrix3::Identity())), {0.25, 0.9, 0},
             {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
    add_body(model, make_body(0.5, Real(0.003) * Matrix3::Identity()), {0.6, 0.8, 0.1}, {0, 0, 0}, {0, 0, 0},
             {0, 0, 0}, Sphere{Real(0.12)});
    Joint hinge{.type = joint_types::hinge, .body = 0, .anchor = {-0.25, 0, 0}, .to_anchor = {0, 0.9, 0}};
    hinge.axis = hinge.to_axis = Vector3::UnitZ();
    Joint wrist{.type = joint_types::universal,
                .body = 1,
                .anchor = {-0.15, 0.05, -0.1},
                .to = 0,
                .to_anchor = {0.2, -0.05, 0}};
    wrist.to_axis = Vector3::UnitZ(), wrist.axis = Vector3::UnitX();
    model.joints = {hinge, wrist};
    if (rotor) {
      CoordinateLaw law;
      law.at.kind = Coordinate::Kind::angle, law.at.to_anchor = hinge.to_anchor, law.at.anchor = hinge.anchor;
      law.at.axis = Vector3::UnitZ(), law.at.zero = law.at.mark = Vector3::UnitX(), law.armature = more;
      model.forces.coordinate_laws = {law};
    }
    model.forces.gravity = {0.2, -9.81, 0.1};
    model.planes = {{Vector3::UnitY(), Real(0.45)}};
    make_touchable(model, 0, Real(0.3));
    model.surfaces[0] = no_surface;
    return after_steps(model, dt, static_cast<int>(std::lround(0.75 / static_cast<double>(dt)))).motions;
  };
  for (const Time dt : {1. / 512, 1. / 1024, 1. / 2048}) {
    const auto turned = struck(true, dt), heavy = struck(false, dt);
    EXPECT_NEAR(heavy[1].position.y(), 0.57, 1e-3) << "it lies on the floor";
    EXPECT_LT((turned[1].position - heavy[1].position).norm(), 1e-4) << dt;
  }
}

// Two moving bodies on a joint, with a floor far below or with nothing but a ball beside them, which they do not meet.
Model pair_in_steps(const Model& pair, bool isolated) {
  Model model = pair;
  for (Shape& shape : model.shapes) shape = Sphere{Real(0.1)};
  if (isolated)
    add_body(model, make_body(1, Real(0.004) * Matrix3::Identity()), {0.5, 3, 0.2}, {0, 0, 0}, {0, 0, 0},
             {0, 0, 0}, Sphere{Real(0.1)});
  else
    model.planes = {{Vector3::UnitY(), -40}};
  make_touchable(model, 0);
  return model;
}

Real apart(const std::vector<Motion>& a, const std::vector<Motion>& b) {
  Real worst = 0;
  for (std::size_t i = 0; i < 2; ++i)
    worst = std::max({worst, (a[i].position - b[i].position).norm(), (a[i].momentum - b[i].momentum).norm(),
                      (a[i].angular_momentum - b[i].angular_momentum).norm()});
  return worst;
}

// What steps leave falls with the step, for each kind of joint, with a rotor on its first coordinate, on its second, on none.
// Joints whose points are apart were pushed midway between these, and a rotor that is geared to its coordinate forgot that its
// gearing changes: both errors stayed, however short the steps.
TEST(JointsInSteps, ConvergeForEachKindWithARotor) {
  for (const JointKind& kind : joint_kinds) {
    for (const int rotor : {-1, 0, 1})
      for (const bool isolated : {false, true}) {
        JointScene scene = joint_scene(kind.type, false);
        const bool turns = kind.type.turn != Joint::Turn::never;
        if (rotor >= 0) {
          CoordinateLaw law;
          if (turns && (rotor == 0 || kind.type.turn != Joint::Turn::about_axis))
            law.at = scene.angle(rotor == 1);
          else
            law.at = scene.displacement(kind.type.place == Joint::Place::in_plane && rotor == 0 ? scene.second
                                        : kind.type.place == Joint::Place::in_plane
                                            ? Vector3(scene.axis.cross(scene.second))
                                            : scene.axis);
          law.armature = Real(0.05);
          if (kind.type.place == Joint::Place::together && !turns) continue;
          scene.model.forces.coordinate_laws = {law};
        }
        const Model model = pair_in_steps(scene.model, isolated);
        const auto exact = run(scene.model, "auto", 0.5, 50).motions;
        std::array<Real, 2> off;
        for (const int finer : {0, 1}) {
          const int steps = finer == 1 ? 1024 : 256;
          off[static_cast<std::size_t>(finer)] = apart(after_steps(model, 0.5 / steps, steps).motions, exact);
        }
        EXPECT_LT(off[1], off[0] / 3 + 1e-9)
            << kind.name << ", rotor " << rotor << (isolated ? ", alone" : ", over a floor");
      }
  }
}

// The restitution of a stop was lowered where the bodies took energy from a rotor, as if it came from nowhere.
TEST(JointsInSteps, ElasticStopKeepsTheEnergyOfARotorBesideIt) {
  Model pair;
  add_body(pair, make_body(1, Vector3(0.043, 0.097, 0.113).asDiagonal()), {0, 0, 0}, {0, 0, 0}, {0, 0, 0},
           {0, 0, 0});
  add_body(pair, make_body(2, Vector3(0.067, 0.033, 0.087).asDiagonal()), {1.2, -0.17, 0.1}, {0, 0, 0},
           {-2, 0, 1}, {0, 0, 0});
  Joint joint{.type = joint_types::rectangular,
              .body = 1,
              .anchor = {-0.6, 0.17, -0.1},
              .to = 0,
              .to_anchor = {0.6, 0, 0}};
  joint.axis = joint.to_axis = Vector3::UnitY();
  pair.joints = {joint};
  CoordinateLaw stop;
  stop.at.body = 1, stop.at.anchor = joint.anchor, stop.at.to = 0, stop.at.to_anchor = joint.to_anchor;
  CoordinateLaw rotor = stop;
  stop.at.axis = Vector3::UnitX(), stop.lower = Real(-0.05), stop.upper = Real(0.05), stop.restitution = 1;
  rotor.at.axis = Vector3::UnitZ(), rotor.armature = Real(0.5);
  pair.forces.coordinate_laws = {stop, rotor};
  const auto energy = [&](const Model& model, const std::vector<Motion>& motions) {
    Real sum = 0;
    for (std::size_t i = 0; i < 2; ++i)
      sum += motions[i].momentum.squaredNorm() / (2 * model.bodies[i].mass) +
             motions[i].angular_momentum.dot(angular_velocity(model.bodies[i], motions[i])) / 2;
    const Real turned =
        speed_of(row_of(rotor.at, model.bodies, motions.data()), model.bodies, motions.data());
    return sum + rotor.armature * turned * turned / 2;
  };
  for (const bool isolated : {false, true}) {
    const Model model = pair_in_steps(pair, isolated);
    const Real before = energy(model, model.motions);
    const auto end = after_steps(model, 1e-4, 500).motions;
    EXPECT_GT((end[1].momentum - model.motions[1].momentum).norm(), 1) << "it has struck";
    EXPECT_NEAR(energy(model, end), before, 1e-4 * before) << isolated;
  }
}

// A light link on a universal joint, which a heavy body on its hinge turns by 0.1 rad in a step.  The rows of both joints ask
// for large turns of the link that cancel; made one after another they left more than they took, and the body flew off.
TEST(JointsInSteps, AreClosedOnALightLink) {
  const Vector3 place = {0.078, -0.22, 0.025}, axis = Vector3(-0.546, 0.348, 0.762).normalized(),
                second = axis.cross(Vector3(-0.142, 0.858, -0.493)).normalized(), at = {1.06, -0.06, 0.14},
                hinge = Vector3(0.7, -0.6, 0.4).normalized();
  for (const Real speed : {Real(2), Real(2.16), Real(2.5), Real(3), Real(4)}) {
    const Vector3 w = speed * (Real(-0.42) * axis + Real(0.9) * second);
    Model model;
    const auto body = [&](Real mass, const Matrix3& inertia, const Vector3& position, const Shape& shape) {
      add_body(model, make_body(mass, inertia), position, {0, 0, 0}, w.cross(position - place), w, shape);
    };
    body(Real(0.3), Vector3(0.008, 0.013, 0.013).asDiagonal(), {0, 0, 0},
         Box{{Real(0.3), Real(0.2), Real(0.2)}});
    body(Real(1.8), Matrix3::Identity() * Real(1.8), {2.43, 0.2, -0.025}, {});
    Joint universal{.type = joint_types::universal, .body = 0, .anchor = place, .to_anchor = place};
    universal.axis = second, universal.to_axis = axis;
    Joint held{.type = joint_types::hinge, .body = 1, .to = 0, .to_anchor = at};
    held.anchor = at - model.motions[1].position;
    held.axis = held.to_axis = hinge;
    model.joints = {universal, held};
    model.planes = {{Vector3::UnitY(), Real(-0.8)}};  // within the reach of the link
    make_touchable(model, 0);
    const Jointed end = after_steps(model, 0.02, 150);
    for (const Joint& joint : model.joints) EXPECT_LT(opened(end.motions, joint), 1e-12) << speed;
    EXPECT_FALSE(end.drifted) << speed;
  }
}

}  // namespace
}  // namespace cylon::engine
