// Trees of joints in the coordinates that the joints leave free, against the same bodies with joints as constraints.
#include "engine/trees.h"

#include "tests/engine/joint_scenes.h"
#include "tests/engine/mixed_scenes.h"

#include <numbers>

namespace cylon::engine {
namespace {

enum class Root { free, world, locked };
struct Kind {
  const char* name;
  Joint::Type type;
};
constexpr Kind kinds[] = {{"ball", joint_types::ball},
                          {"hinge", joint_types::hinge},
                          {"fixed", joint_types::fixed},
                          {"slider", joint_types::slider},
                          {"cylindrical", joint_types::cylindrical},
                          {"planar", joint_types::planar},
                          {"universal", joint_types::universal},
                          {"gimbal", joint_types::gimbal},
                          {"rectangular", joint_types::rectangular},
                          {"offset_universal", joint_types::offset_universal}};

Vector3 velocity_at(const Model& model, int body, const Vector3& point) {
  if (body == fixed_world || model.bodies[static_cast<std::size_t>(body)].locked) return Vector3::Zero();
  const Body& b = model.bodies[static_cast<std::size_t>(body)];
  const Motion& m = model.motions[static_cast<std::size_t>(body)];
  return velocity(b, m) + angular_velocity(b, m).cross(point - m.position);
}

Vector3 spin_of(const Model& model, int body) {
  if (body == fixed_world || model.bodies[static_cast<std::size_t>(body)].locked) return Vector3::Zero();
  return angular_velocity(model.bodies[static_cast<std::size_t>(body)],
                          model.motions[static_cast<std::size_t>(body)]);
}

// Adds a body in a general place, on a joint to `parent`, with velocities that the joint allows; `reversed`: the joint is
// stated from the parent.
void hang(Model& model, Dice& dice, Joint::Type type, int parent, bool reversed) {
  using Place = Joint::Place;
  using Turn = Joint::Turn;
  const int child = static_cast<int>(model.bodies.size());
  const Vector3 axis = Vector3(dice.vector(1) + Vector3(0.2, 0.3, 1.5)).normalized(),
                second = axis.unitOrthogonal(), third = axis.cross(second);
  const Vector3 turn = dice.vector(1.5), position = dice.vector(1);
  const Quaternion q_child = exponential(turn);
  Quaternion q_parent = Quaternion::Identity();
  Vector3 place = Vector3::Zero();
  if (parent != fixed_world)
    q_parent = model.motions[static_cast<std::size_t>(parent)].orientation,
    place = model.motions[static_cast<std::size_t>(parent)].position;
  Vector3 apart = Vector3::Zero(), slip = Vector3::Zero(), spin = Vector3::Zero();
  if (type.place == Place::along_axis) apart = 0.3 * axis, slip = 0.5 * axis;
  if (type.place == Place::in_plane) apart = 0.2 * second - 0.3 * third, slip = 0.4 * third;
  if (!type.twists()) spin = dice.vector(1.5);
  if (type.turn == Turn::about_axis) spin = 1.3 * axis;
  if (type.turn == Turn::about_two_axes)
    spin = 1.1 * axis - 0.7 * second;  // `axis` is the first: carried by `to`
  Joint joint;
  if (type.place == Place::along_normal) {  // as the first turn of the two carries it
    joint.length = Real(0.25), apart = (reversed ? -1 : 1) * joint.length * third;
    slip = (reversed ? Vector3(Real(-0.7) * second) : Vector3(Real(1.1) * axis)).cross(apart);
  }
  const Vector3 point = position + dice.vector(0.5), held = point - apart;  // of the child, of the parent
  const Vector3 w = spin_of(model, parent) + spin;
  // d' of what the joint leaves free is seen by who carries its axes.
  const Vector3 carrier = reversed && joint.length == 0 ? w : spin_of(model, parent);
  const Vector3 v =
      velocity_at(model, parent, held) + carrier.cross(apart) + slip - w.cross(point - position);
  add_body(model, make_body(dice.between(0.5, 1.5), general_inertia(0.05, 0.07, 0.1)), position, turn, v, w);
  joint.type = type;
  const Vector3 mine = q_child.conjugate() * (point - position), its = q_parent.conjugate() * (held - place);
  joint.body = reversed ? parent : child, joint.to = reversed ? child : parent;
  joint.anchor = reversed ? its : mine, joint.to_anchor = reversed ? mine : its;
  const Quaternion q_body = reversed ? q_parent : q_child, q_to = reversed ? q_child : q_parent;
  joint.to_axis = q_to.conjugate() * axis;
  const Vector3 tilted = Real(0.8) * second + Real(0.6) * axis;
  joint.axis = q_body.conjugate() * (type.turn == Turn::about_two_axes     ? second
                                     : type.turn == Turn::about_three_axes ? tilted
                                                                           : axis);
  joint.relative = q_to.conjugate() * q_body;
  model.joints.push_back(joint);
}

// Five bodies that hang from each other and from the root by all kinds of joints in turn, beginning with one.
Model tree(std::uint32_t number, Root root) {
  Dice dice(number);
  Model model;
  int last = fixed_world;
  if (root == Root::locked) {
    add_body(model, make_body(1, Matrix3::Identity(), true), {0.3, 0.1, -0.2}, {0.4, -0.6, 0.2}, {0, 0, 0},
             {0, 0, 0});
    last = 0;
  }
  if (root == Root::free) {
    add_body(model, make_body(1.2, general_inertia(0.05, 0.07, 0.1)), {0.2, 0.1, -0.3}, {0.5, 1.1, -0.6},
             {0.3, 0.8, -0.5}, {1.2, -0.7, 0.9});
    last = 0;
  }
  for (int k = 0; k < 5; ++k) {
    const bool reversed = last != fixed_world && dice.between(0, 1) < 0.5;
    hang(model, dice, kinds[(number + static_cast<std::uint32_t>(k)) % std::size(kinds)].type, last,
         reversed);
    if (k == 0 || dice.between(0, 1) < 0.7) last = static_cast<int>(model.bodies.size()) - 1;
  }
  return model;
}

// Everything that reads places, velocities, turns and the time; also along a joint.
void add_forces(Model& model) {
  const int last = static_cast<int>(model.bodies.size()) - 1;
  model.forces.gravity = {0.3, -9.81, 0.7};
  model.forces.springs.push_back({last, {0.2, 0.1, -0.3}, fixed_world, {0.6, 1.9, 0.4}, 25.0, 0.5, 0.6});
  model.forces.drags.push_back({last, 0.3, 0.02, 0.1});
  model.forces.drives.push_back({last - 1, {0.9, 0.4, -1.1}, 2.3});
  for (const Joint& joint : model.joints) {
    if (joint.type != joint_types::hinge) continue;
    CoordinateLaw law;
    law.at.kind = Coordinate::Kind::angle;
    law.at.body = joint.body, law.at.to = joint.to;
    law.at.axis = joint.to_axis, law.at.zero = joint.to_axis.unitOrthogonal();
    const auto turn = [&](int body) {
      return body == fixed_world ? Quaternion(Quaternion::Identity())
                                 : model.motions[static_cast<std::size_t>(body)].orientation;
    };
    law.at.mark = turn(joint.body).conjugate() * (turn(joint.to) * law.at.zero);
    law.stiffness = 3, law.damping = 0.1, law.quadratic_damping = 0.05, law.force = 0.4;
    law.target = harmonic(0.2, 0.5, 3, 0.4);
    model.forces.coordinate_laws.push_back(law);
    break;
  }
}

// Springs, dampers and motors on all angles of gimbals, the third far from where their axes are parallel.
void add_gimbal_laws(Model& model) {
  for (const Joint& joint : model.joints) {
    if (joint.type.turn != Joint::Turn::about_three_axes) continue;
    Real more = 0;
    for (const Coordinate& q : gimbal_angles(model, joint)) {
      CoordinateLaw law;
      law.at = q, law.stiffness = q.kind == Coordinate::Kind::inclination ? 60 : 2 + more,
      law.damping = Real(0.1), law.force = Real(0.3) - more;
      law.target = harmonic(0.2, 0.5, 3, 0.4);
      model.forces.coordinate_laws.push_back(law), more += Real(0.4);
    }
  }
}

// A rotor on each displacement and each angle that joints leave free, beside what acts already.
void add_rotors(Model& model) {
  Real armature = Real(0.02);
  const auto add = [&](const Joint& joint, Coordinate::Kind kind, const Vector3& axis, bool on_body) {
    CoordinateLaw law;
    law.at.kind = kind, law.at.on_body = on_body;
    law.at.body = joint.body, law.at.anchor = joint.anchor, law.at.to = joint.to,
    law.at.to_anchor = joint.to_anchor;
    law.at.axis = axis, law.at.zero = axis.unitOrthogonal();
    law.armature = armature, armature += Real(0.03);
    model.forces.coordinate_laws.push_back(law);
  };
  for (const Joint& joint : model.joints) {
    if (joint.type.place == Joint::Place::along_axis)
      add(joint, Coordinate::Kind::displacement, joint.to_axis, false);
    if (joint.type.place == Joint::Place::in_plane) {
      // Not along the axes that the coordinates of a tree have.
      const Vector3 one = joint.to_axis.unitOrthogonal(), two = joint.to_axis.cross(one);
      add(joint, Coordinate::Kind::displacement, Real(0.6) * one + Real(0.8) * two, false);
    }
    if (joint.type.turn == Joint::Turn::about_axis) add(joint, Coordinate::Kind::angle, joint.to_axis, false);
    if (joint.type.turn == Joint::Turn::about_two_axes) {
      add(joint, Coordinate::Kind::angle, joint.to_axis, false);
      add(joint, Coordinate::Kind::angle, joint.axis, true);
    }
    if (joint.type.turn != Joint::Turn::about_three_axes) continue;
    for (const Coordinate& q : gimbal_angles(model, joint)) {
      add(joint, q.kind, q.axis, q.on_body);
      model.forces.coordinate_laws.back().at = q;
    }
  }
}

constexpr Root roots[] = {Root::free, Root::world, Root::locked};
constexpr std::uint32_t trees = 40;  // four of each kind at the root, and on each root

Model forced_tree(std::uint32_t number) {
  Model model = tree(number, roots[number % 3]);
  add_forces(model);
  add_gimbal_laws(model);
  return model;
}

bool hang_together(const Model& model, const Options& options) {
  return Trees::applies(model, options, *find_integrator(options.integrator));
}

// Both are of eighth order; the constraints are closed to rounding after each step.
TEST(Trees, MoveAsConstraintsDo) {
  for (std::uint32_t number = 0; number < trees; ++number) {
    const Model model = forced_tree(number);
    Options coordinates = with("rk8", 1. / 512), constraints = coordinates;
    constraints.constraints = true;
    ASSERT_TRUE(hang_together(model, coordinates)) << number;
    const Outcome ours = run(model, coordinates, 512), theirs = run(model, constraints, 512);
    ASSERT_GT(distance(ours.motions, model.motions), 0.1) << "hardly a motion";
    EXPECT_LT(distance(ours.motions, theirs.motions), 1e-9) << number;
  }
}

// Rotors on all coordinates change the motion, by the coordinates as by rows of constraints.  For half a second: later some
// bring a gimbal to where its axes are parallel.
TEST(Trees, WithRotorsMoveAsConstraintsDo) {
  for (std::uint32_t number = 0; number < trees; ++number) {
    const Model bare = forced_tree(number);
    Model model = bare;
    add_rotors(model);
    const Options coordinates = with("rk8", 1. / 512);
    Options constraints = coordinates;
    constraints.constraints = true;
    ASSERT_TRUE(hang_together(model, coordinates)) << number;
    const Outcome ours = run(model, coordinates, 256), theirs = run(model, constraints, 256);
    EXPECT_LT(distance(ours.motions, theirs.motions), 1e-9) << number;
    if (model.forces.coordinate_laws.size() > bare.forces.coordinate_laws.size()) {
      EXPECT_GT(distance(ours.motions, run(bare, coordinates, 256).motions), 1e-3) << number;
    }
  }
}

// With controlled errors, too.
TEST(Trees, MeetATolerance) {
  for (std::uint32_t number = 0; number < trees; number += 2) {
    const Model model = forced_tree(number);
    const auto exact = run(model, "rk8", 1, 2048).motions;
    for (const Real tolerance : {1e-6, 1e-9}) {
      Options options = with("auto", 0.1);
      options.tolerance = tolerance;
      EXPECT_LT(distance(run(model, options, 10).motions, exact), 20 * tolerance) << number;
    }
  }
}

TEST(Trees, HaveTheOrderOfTheirIntegrator) {
  for (std::uint32_t number = 0; number < trees; number += 3) {
    const Model model = forced_tree(number);
    const auto exact = run(model, "rk8", 0.5, 1024).motions;
    for (const auto& [name, order, n] : {std::tuple{"rk4", 4, 128}, {"explicit-euler", 1, 4096}}) {
      const Real coarse = distance(run(model, name, 0.5, n).motions, exact),
                 fine = distance(run(model, name, 0.5, 2 * n).motions, exact);
      EXPECT_NEAR(std::log2(coarse / fine), order, 0.25) << number << ' ' << name;
    }
  }
}

bool has_gimbal(const Model& model) {
  return std::ranges::any_of(model.joints,
                             [](const Joint& joint) { return joint.type == joint_types::gimbal; });
}

// By a method that errs by centimetres, and comes to where a gimbal's axes are parallel.
TEST(Trees, KeepTheirJointsClosed) {
  for (std::uint32_t number = 0; number < trees; ++number) {
    const Model model = forced_tree(number);
    if (has_gimbal(model)) continue;
    const Outcome end = run(model, "explicit-euler", 2, 400);
    for (const Joint& joint : model.joints) EXPECT_LT(opened(end.motions, joint), 1e-13) << number;
  }
}

// The momentum to rounding, as it is one of the coordinates; the angular momentum to the order.
TEST(Trees, InSpaceKeepTheirMomentum) {
  for (std::uint32_t number = 0; number < trees; ++number) {
    const Model model = tree(number, Root::free);
    const auto lost = [&](int steps) {
      const Outcome end = run(model, "rk4", 2, steps);
      EXPECT_LT((momentum(end.motions) - momentum(model.motions)).norm(), 1e-13) << number;
      return (angular_momentum(end.motions) - angular_momentum(model.motions)).norm();
    };
    EXPECT_GT(std::log2(lost(400) / lost(800)), 3.5) << number;
  }
}

// Of random mixes of features those that are trees, by auto.
TEST(Trees, OfMixesMoveAsConstraintsDo) {
  int trees_met = 0;
  for (std::uint32_t number = 0; number < 4000; ++number) {
    const Model model = mixed_scene(number).model;
    Options coordinates = with("auto", 0.05), constraints = coordinates;
    constraints.constraints = true;
    if (model.joints.empty() || !unsupported(model, constraints).empty()) continue;
    if (make_plan(model, coordinates).path != Path::bodies ||
        !Trees::applies(model, coordinates, *find_integrator("dop853")))
      continue;
    ++trees_met;
    EXPECT_LT(apart(model.bodies, run(model, coordinates, 20).motions, run(model, constraints, 20).motions),
              1e-8)
        << number;
  }
  EXPECT_GT(trees_met, 20);
}

// Several trees, and bodies on no joint, stand beside each other.
TEST(Trees, ManyMoveAsEachAlone) {
  Model all = forced_tree(3);
  const std::size_t first = all.bodies.size();
  Dice dice(5);
  add_body(all, make_body(1.2, general_inertia(0.05, 0.07, 0.1)), {9, 1, 0}, {0.5, 1.1, -0.6},
           {0.3, 0.8, -0.5}, {1.2, -0.7, 0.9});
  hang(all, dice, joint_types::hinge, static_cast<int>(first), true);
  const Outcome together = run(all, "rk4", 1, 100);
  const Outcome alone = run(forced_tree(3), "rk4", 1, 100);
  for (std::size_t i = 0; i < first; ++i)
    EXPECT_LT((together.motions[i].position - alone.motions[i].position).norm(), 1e-12);
}

// A wheel on a torsion spring, wound up by fifty turns, in steps of the samples that hold several turns each: neither the
// steps nor a run that begins where another ends lose count.   J a'' = -k a  from a = 100 pi, J the reduced inertia.
TEST(Trees, CountTheTurnsOfTheirJoints) {
  for (const bool reversed : {false, true}) {
    Model model;
    const Real j = 0.06, other = 0.1, k = 0.5, wound = 100 * std::numbers::pi_v<Real>;
    const Vector3 axis = Vector3(0.3, -0.5, 0.8).normalized();
    add_body(model, make_body(1, other * Matrix3::Identity()), {0.1, 0.2, 0.3}, {0.4, -0.2, 0.3}, {0, 0, 0},
             {0, 0, 0});
    add_body(model, make_body(1, j * Matrix3::Identity()), {0.1, 0.2, 0.3}, {-0.3, 0.5, 0.1}, {0, 0, 0},
             {0, 0, 0});
    const int body = reversed ? 0 : 1, to = 1 - body;
    const auto turn = [&](int i) { return model.motions[static_cast<std::size_t>(i)].orientation; };
    Joint hinge;
    hinge.type = joint_types::hinge, hinge.body = body, hinge.to = to;
    hinge.axis = turn(body).conjugate() * axis, hinge.to_axis = turn(to).conjugate() * axis;
    hinge.relative = turn(to).conjugate() * turn(body);
    model.joints.push_back(hinge);
    CoordinateLaw law;
    law.at.kind = Coordinate::Kind::angle;
    law.at.body = body, law.at.to = to, law.at.axis = hinge.to_axis,
    law.at.zero = hinge.to_axis.unitOrthogonal();
    law.at.mark = turn(body).conjugate() * (turn(to) * law.at.zero);
    law.at.origin = wound, law.at.start = wound, law.stiffness = k;
    model.forces.coordinate_laws.push_back(law);
    Options options = with("auto", 0.7);
    ASSERT_TRUE(Trees::applies(model, options, *find_integrator("dop853")));
    const Outcome end = run(model, options, 10);
    const Real reduced = j * other / (j + other),
               rate = -wound * std::sqrt(k / reduced) * std::sin(std::sqrt(k / reduced) * Real(7));
    const auto spin = [&](int i) {
      return angular_velocity(model.bodies[static_cast<std::size_t>(i)],
                              end.motions[static_cast<std::size_t>(i)]);
    };
    EXPECT_NEAR((spin(body) - spin(to)).dot(axis), rate, 1e-7 * wound) << reversed;
  }
}

// What the coordinates do not express stays with constraints.
TEST(Trees, LeaveOutWhatTheyDoNotExpress) {
  const Options options = with("rk4", 0.01);
  const Model good = forced_tree(1);
  EXPECT_TRUE(hang_together(good, options));
  EXPECT_FALSE(hang_together(good, with("velocity-verlet", 0.01))) << "its parts are of momenta";
  Model wet = good;
  wet.forces.waters.emplace_back();
  EXPECT_TRUE(hang_together(wet, options));
  EXPECT_FALSE(hang_together(wet, with("dop853", 0.01))) << "switches are located in motions";
  Options kept = options;
  kept.constraints = true;
  EXPECT_FALSE(hang_together(good, kept));
  Model loop = good;
  loop.joints.push_back(loop.joints.front());
  EXPECT_FALSE(hang_together(loop, options));
  for (const Joint::Type type : {joint_types::distance, joint_types::screw}) {
    Model other = good;
    other.joints.back().type = type;
    EXPECT_FALSE(hang_together(other, options));
  }
  Model thin = good;
  thin.bodies.back() = make_body(1, Vector3(0.1, 0, 0.1).asDiagonal());
  EXPECT_FALSE(hang_together(thin, options));
  Model burning = good;
  burning.bodies.back().mass_rate = -0.1;
  EXPECT_FALSE(hang_together(burning, options));
  Options accounted = options;
  accounted.account = true;
  EXPECT_FALSE(hang_together(good, accounted));
}

}  // namespace
}  // namespace cylon::engine
