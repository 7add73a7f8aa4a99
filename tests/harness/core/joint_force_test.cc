// What a joint exerts follows from the motion: against closed forms of bodies at rest, whirling and swinging, in any frame of
// description; and what engines tell of it is brought to the joint's point.
#include "harness/core/joint_force.h"

#include "harness/core/last_step.h"
#include "harness/core/loads.h"
#include "harness/core/measure.h"
#include "harness/core/scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace {

using namespace cylon::core;

constexpr double g = 9.81, dt = 1.0 / 256;
const Observable force{.quantity = Quantity::joint_force}, torque{.quantity = Quantity::joint_torque};

Observable of(Observable q, int joint) {
  q.joint = joint;
  return q;
}

Vector3 only_entry(const RequiredForces& required) {
  EXPECT_EQ(required.values.size(), 1U);
  return required.values.at(0).head<3>();
}

Body body(double mass, const Vector3& position) {
  Body body;
  body.mass = mass, body.inertia = Vector3(0.03, 0.05, 0.04).asDiagonal();
  body.initial.position = position;
  return body;
}

Truth rest(const Scene& scene) {
  Truth truth;
  truth.state = [state = initial_state(scene)](double) { return state; };
  return truth;
}

// ---- Statics ------------------------------------------------------------------------------------------

// A beam from the wall, a post across its tip (the joint names the beam first), a lamp below the post.
Scene beams() {
  Scene s;
  s.bodies = {body(2, {0.4, 0.1, -0.2}), body(0.7, {0.9, 0.3, 0.3}), body(1.3, {1.1, -0.4, 0.6})};
  s.forces = {UniformGravity{{0.6, -g, 0.2}}};
  s.joints = {{JointType::fixed, 0, world, {0, 0, 0}},
              {JointType::fixed, 0, 1, {0.8, 0.2, -0.1}},
              {JointType::fixed, 2, 1, {1, 0, 0.5}}};
  return s;
}

TEST(JointForce, AtRestIsTheWeightOfWhatHangsOnIt) {
  const Scene scene = beams();
  const Vector3 fall = gravity(scene);
  const struct {
    int joint;
    double sign;
    std::vector<std::size_t> bodies;
  } rows[] = {{0, -1, {0, 1, 2}}, {1, 1, {1, 2}}, {2, -1, {2}}};
  for (const auto& row : rows) {
    Vector3 weight = Vector3::Zero(), moment = Vector3::Zero();
    for (const std::size_t i : row.bodies) {
      const Body& b = scene.bodies[i];
      weight += b.mass * fall;
      moment +=
          (b.initial.position - scene.joints[static_cast<std::size_t>(row.joint)].point).cross(b.mass * fall);
    }
    const RequiredForces f = required_joint_forces(of(force, row.joint), scene, rest(scene), 2, dt),
                         n = required_joint_forces(of(torque, row.joint), scene, rest(scene), 2, dt);
    EXPECT_LT((only_entry(f) - row.sign * weight).norm(), 1e-13 * weight.norm()) << row.joint;
    EXPECT_LT((only_entry(n) - row.sign * moment).norm(), 1e-13 * weight.norm()) << row.joint;
    EXPECT_LT(f.error, 1e-12) << "no error of the truth, and none of the quadrature";
  }
  EXPECT_EQ(required_joint_forces(force, scene, rest(scene), 2, dt).values.size(), 3U);
}

// Each law: what it pushes is taken up by the joint.
TEST(JointForce, TakesUpEveryForceOnTheBody) {
  Scene scene;
  scene.bodies = {body(1.5, {0.3, -0.2, 0.4}), body(4, {2, 1, -1})};
  scene.bodies[0].initial.orientation = Quaternion(0.5, -0.1, 0.7, 0.3).normalized();
  scene.bodies[0].gravity = Vector3(1, 2, -3);
  scene.bodies[1].locked = true;
  scene.joints = {{JointType::fixed, 0, world, {0.1, 0, 0}}};
  const BodyState& s = scene.bodies[0].initial;
  const Vector3 arm(0.2, -0.1, 0.3), turned = s.orientation * arm, pin(1, 1, 2);
  const Vector3 along = pin - s.position - turned, to = scene.bodies[1].initial.position - s.position;
  const struct {
    const char* name;
    Force law;
    Vector3 pushed, at;  // the force on the body and where it acts
  } rows[] = {
      {"its own gravity alone", UniformGravity{{7, 8, 9}}, Vector3::Zero(), s.position},
      {"a spring", Spring{0, arm, world, pin, 25, 0.4, 3}, 25 * (along.norm() - 0.4) * along.normalized(),
       s.position + turned},
      {"a spring that names it second", Spring{1, {0.1, 0.2, 0.3}, 0, arm, 10, 0, 0},
       10 * (scene.bodies[1].initial.position + Vector3(0.1, 0.2, 0.3) - s.position - turned),
       s.position + turned},
      {"a thrust", Thrust{0, {3, -1, 2}, 0, {}, {}}, s.orientation * Vector3(3, -1, 2), s.position},
      {"attraction", Attraction{0, 1, 2.5}, 2.5 * 1.5 * 4 / std::pow(to.norm(), 3) * to, s.position},
  };
  for (const auto& row : rows) {
    scene.forces = {row.law};
    const Vector3 weight = 1.5 * *scene.bodies[0].gravity, point = scene.joints[0].point;
    const Vector3 all = weight + row.pushed,
                  moment = (s.position - point).cross(weight) + (row.at - point).cross(row.pushed);
    EXPECT_LT((only_entry(required_joint_forces(force, scene, rest(scene), 1, dt)) + all).norm(), 1e-12)
        << row.name;
    EXPECT_LT((only_entry(required_joint_forces(torque, scene, rest(scene), 1, dt)) + moment).norm(), 1e-12)
        << row.name;
  }
}

// ---- Motion -------------------------------------------------------------------------------------------

// A body that turns with constant w about an axis through the joint's point, which is none of its own.  Drag acts on it,
// and a drive.
struct Whirl {
  Vector3 w = Vector3(0.4, 1.7, -2.1), arm = Vector3(0.3, 0.5, -0.2), point = Vector3(-0.2, 0.3, 0.1);
  double mass = 1.7, linear = 0.6, angular = 0.2, momentum = 0.3, frequency = 5;
  Vector3 push = Vector3(2, -1, 3);

  Scene scene() const {
    Scene s;
    s.bodies = {body(mass, point + arm)};
    s.bodies[0].initial.orientation = Quaternion(0.8, 0.3, 0.4, 0.33166).normalized();
    s.bodies[0].initial.velocity = w.cross(arm), s.bodies[0].initial.angular_velocity = w;
    s.joints = {{JointType::hinge, 0, world, point, w.normalized()}};
    s.forces = {UniformGravity{{0.5, -g, 0.3}}, Drag{0, linear, angular, momentum},
                Drive{0, push, frequency}};
    return s;
  }
  State state(double t) const {
    const Quaternion turn(Eigen::AngleAxisd(w.norm() * t, w.normalized()));
    BodyState s = scene().bodies[0].initial;
    s.position = point + turn * arm, s.orientation = turn * s.orientation, s.velocity = w.cross(turn * arm);
    return {s};
  }
  Truth truth() const {
    Truth truth;
    truth.state = [*this](double t) { return state(t); };
    return truth;
  }
  // Of the instant:  F = m w x (w x r) - F_a,  N = w x L - M_a about the point.
  Vector3 exerted(double t, bool turns) const {
    const Scene s = scene();
    const BodyState now = state(t)[0];
    const Vector3 r = now.position - point, spin = world_inertia(s.bodies[0], now.orientation) * w;
    const Vector3 applied = mass * gravity(s) - linear * now.velocity + push * std::cos(frequency * t);
    const Vector3 needs = mass * w.cross(w.cross(r));
    if (!turns) return needs - applied;
    return r.cross(needs - applied) + w.cross(spin) + angular * w + momentum * spin;
  }
};

TEST(JointForce, IsWhatKeepsABodyWhirling) {
  const Whirl whirl;
  for (const bool turns : {false, true}) {
    const double end = 0.8, h = 1.0 / 64;
    Vector3 mean = Vector3::Zero();
    constexpr int parts = 2000;  // Simpson
    for (int i = 0; i <= 2 * parts; ++i)
      mean += (i % (2 * parts) == 0 ? 1
               : i % 2              ? 4
                                    : 2) /
              (6.0 * parts) * whirl.exerted(end - h + h * i / (2 * parts), turns);
    const RequiredForces f =
        required_joint_forces(turns ? torque : force, whirl.scene(), whirl.truth(), end, h);
    EXPECT_LT((only_entry(f) - mean).norm(), 1e-11 * mean.norm()) << turns;
    EXPECT_GT((mean - whirl.exerted(end, turns)).norm(), 1e-3 * mean.norm()) << "a mean is no instant";
    EXPECT_LT(f.error, 1e-9);
  }
}

// The joint of two bodies that fly together through space, whose point moves: moving all of it uniformly changes nothing.
TEST(JointForce, IsTheSameInEveryFrameThatMovesUniformly) {
  const auto flying = [](const Vector3& boost) {
    Whirl whirl;
    whirl.arm -=
        whirl.arm.dot(whirl.w) / whirl.w.squaredNorm() * whirl.w;  // free bodies keep their angular momentum
    Scene s = whirl.scene();
    s.forces.clear();
    s.bodies.push_back(body(0.9, whirl.point - 1.7 / 0.9 * whirl.arm));
    s.bodies[1].initial.velocity = -1.7 / 0.9 * s.bodies[0].initial.velocity,
    s.bodies[1].initial.angular_velocity = whirl.w;
    for (Body& b : s.bodies) b.inertia = 0.04 * Matrix3::Identity();
    s.joints[0].to = 1, s.joints[0].type = JointType::fixed;
    s.joints[0].point += Vector3(0.1, 0.2, 0.3);
    for (Body& b : s.bodies) b.initial.velocity += boost;
    Truth truth;
    truth.state = [whirl, boost, s](double t) {
      const Quaternion turn(Eigen::AngleAxisd(whirl.w.norm() * t, whirl.w.normalized()));
      State state = initial_state(s);
      for (BodyState& b : state) {
        const Vector3 arm = b.position - whirl.point;
        b.position = whirl.point + turn * arm + boost * t, b.velocity = whirl.w.cross(turn * arm) + boost;
        b.orientation = turn * b.orientation;
      }
      return state;
    };
    return std::pair(s, truth);
  };
  for (const Observable& q : {force, torque}) {
    const auto [still, truth] = flying(Vector3::Zero());
    const auto [moving, same] = flying({3, -2, 5});
    const Vector3 f = only_entry(required_joint_forces(q, still, truth, 0.5, dt));
    EXPECT_LT((only_entry(required_joint_forces(q, moving, same, 0.5, dt)) - f).norm(), 1e-10);
    // Either side of the joint says the same: of the second body alone, with the opposite sign.
    Scene other = still;
    other.joints[0].body = 1, other.joints[0].to = 0;
    EXPECT_LT((only_entry(required_joint_forces(q, other, truth, 0.5, dt)) + f).norm(), 1e-10);
    EXPECT_GT(f.norm(), 0.01);
    EXPECT_NEAR(largest_joint_force(q, still, truth, 2), largest_joint_force(q, moving, same, 2), 1e-9);
  }
}

// Mean acceleration over a blow: an impulse within the step counts.
TEST(JointForce, CountsBlowsWithinTheStep) {
  Scene scene;
  scene.bodies = {body(2, {0, 0, 0}), body(1, {0.5, 0, 0})};
  scene.joints = {{JointType::fixed, 1, 0, {0.3, 0, 0}}};
  Truth truth;
  truth.state = [scene](double t) {
    State s = initial_state(scene);
    for (BodyState& b : s) b.velocity = t < 0.5 - dt / 2 ? Vector3(3, 0, 0) : Vector3(-1, 0, 0);
    return s;
  };
  EXPECT_NEAR(only_entry(required_joint_forces(force, scene, truth, 0.5, dt)).x(), 1 * -4 / dt, 1e-9);
}

// The bound holds where states are off by as much as they may be, and is not far above what can come.
TEST(JointForce, ErrorIsBoundedByThatOfTheStates) {
  const Whirl whirl;
  Scene scene = whirl.scene();
  scene.forces.emplace_back(Spring{0, {0.2, -0.1, 0.3}, world, {1, 1, 2}, 25, 0.4, 3});
  Truth right = whirl.truth();
  right.error = {.position = 1e-9, .velocity = 2e-9, .orientation = 3e-9, .angular_velocity = 4e-9};
  for (const Observable& q : {force, torque}) {
    const RequiredForces known = required_joint_forces(q, scene, right, 0.5, dt);
    double most = 0;
    for (int trial = 0; trial < 200; ++trial) {
      Truth off = right;
      off.state = [&, trial](double t) {
        State s = right.state(t);
        const auto aside = [&](int k) {
          return Vector3(std::sin(trial + k + 7 * t / dt), std::cos(2 * trial + k), std::sin(3 * trial - k))
              .normalized();
        };
        s[0].position += 1e-9 * aside(1), s[0].velocity += 2e-9 * aside(2);
        s[0].orientation = Quaternion(Eigen::AngleAxisd(3e-9, aside(3))) * s[0].orientation;
        s[0].angular_velocity += 4e-9 * aside(4);
        return s;
      };
      most = std::max(most,
                      (only_entry(required_joint_forces(q, scene, off, 0.5, dt)) - only_entry(known)).norm());
    }
    EXPECT_LT(most, known.error);
    EXPECT_GT(most, known.error / 20);
    EXPECT_NEAR(truth_error(q, scene, right, 0.5, dt), known.error, 1e-12) << "what a claim is held to";
    EXPECT_GT(truth_error(q, scene, right, 0.5, dt / 8), 6 * known.error) << "a rate over a shorter step";
  }
}

// ---- Where the motion does not say it -------------------------------------------------------------------

TEST(JointForce, IsRefusedWhereTheMotionLeavesItOpen) {
  const struct {
    const char* name;
    std::function<void(Scene&)> change;
    Observable q;
    const char* says;  // "": it is defined
  } rows[] = {
      {"as it is", [](Scene&) {}, force, ""},
      {"no joints", [](Scene& s) { s.joints.clear(); }, force,
       "no joint of the scene has an end that can move"},
      {"a loop",
       [](Scene& s) {
         s.joints.push_back({JointType::ball, 2, world, {2, 0, 0}});
       },
       of(force, 1), "of joint 2: joints close a loop"},
      {"a loop of three bodies",
       [](Scene& s) {
         s.joints.push_back({JointType::ball, 2, 0, {2, 0, 0}});
       },
       of(force, 1), "close a loop"},
      {"a loop that another joint bears",
       [](Scene& s) {
         s.joints.push_back({JointType::ball, 2, 0, {2, 0, 0}});
       },
       of(force, 0), ""},
      {"a contact with the rest",
       [](Scene& s) {
         for (Body& b : s.bodies) b.shape = Sphere{0.1}, b.collide = true;
       },
       of(force, 1), "of joint 2: contacts may bear what it holds"},
      {"a contact within what hangs on it",
       [](Scene& s) {
         for (Body& b : s.bodies) b.shape = Sphere{0.1}, b.collide = true;
       },
       of(force, 0), ""},
      {"a ground below",
       [](Scene& s) { s.bodies[2].shape = Sphere{0.1}, s.bodies[2].collide = true, s.planes.emplace_back(); },
       of(force, 2), "contacts may bear"},
      {"both ends locked", [](Scene& s) { s.bodies[0].locked = true; }, of(force, 0),
       "neither of its ends can move"},
      {"one end locked", [](Scene& s) { s.bodies[0].locked = true; }, of(force, 1), ""},
      {"a motor on it",
       [](Scene& s) {
         s.joints[0].type = JointType::hinge;
         s.joints[0].angles.emplace_back().force = 1;
       },
       of(force, 0), "of joint 1: something acts along its own coordinate"},
      {"a motor on a joint beyond",
       [](Scene& s) {
         s.joints[1].type = JointType::hinge;
         s.joints[1].angles.emplace_back().force = 1;
       },
       of(force, 0), ""},
      {"water", [](Scene& s) { s.forces.emplace_back(Water{}); }, force, "water acts"},
      {"a plug-in", [](Scene& s) { s.forces.emplace_back(PluginForce{}); }, force, "plug-in"},
      {"a rocket", [](Scene& s) { s.forces.emplace_back(Thrust{.mass_rate = -0.1}); }, force,
       "mass of a body changes"},
      {"a frame that turns", [](Scene& s) { s.frame.emplace().angular_velocity.y() = 1; }, force,
       "frame turns"},
      {"a frame that accelerates", [](Scene& s) { s.frame.emplace().acceleration.y() = 1; }, force,
       "turns or accelerates"},
      {"a frame that moves", [](Scene& s) { s.frame.emplace().velocity.y() = 1; }, force, ""},
  };
  for (const auto& row : rows) {
    Scene scene = beams();
    row.change(scene);
    const std::string why = undefined_in(row.q, scene).value_or("");
    if (*row.says)
      EXPECT_NE(why.find(row.says), std::string::npos) << row.name << ": " << why;
    else
      EXPECT_EQ(why, "") << row.name;
  }
}

// ---- What engines tell ------------------------------------------------------------------------------------

Recording resting(const Scene& scene) {
  Recording r;
  r.dt = dt;
  r.steps = {0, 255, 256};
  r.states.assign(3, initial_state(scene));
  r.contacts.emplace();
  r.reactions.emplace();
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const Vector3 f = only_entry(
                      required_joint_forces(of(force, static_cast<int>(j)), scene, rest(scene), 1, dt)),
                  n = only_entry(
                      required_joint_forces(of(torque, static_cast<int>(j)), scene, rest(scene), 1, dt));
    // Told of another point: that of the centre of the body, as ODE and Bullet do.
    const Vector3 at = scene.bodies[static_cast<std::size_t>(scene.joints[j].body)].initial.position;
    r.reactions->push_back({j, at, dt * f, dt * (n + (scene.joints[j].point - at).cross(f))});
  }
  return r;
}

Claim claim_of(const Observable& q, const Scene& scene) {
  Claim claim;
  claim.observable = q, claim.follows = "statics", claim.truth = rest(scene);
  claim.tolerance.relative = 1e-3;
  return claim;
}

TEST(JointForce, IsJudgedAsItIsTold) {
  const Scene scene = beams();
  const double weight = 4 * gravity(scene).norm();
  const struct {
    const char* name;
    std::function<void(std::vector<Reaction>&)> change;
    Observable q;
    bool passes;
  } rows[] = {
      {"right", [](auto&) {}, force, true},
      {"right, torque", [](auto&) {}, torque, true},
      {"in another order", [](auto& r) { std::swap(r[0], r[2]); }, force, true},
      {"told of another point",
       [](auto& r) {
         const Vector3 shift(0.3, -0.1, 0.7);
         r[1].point += shift, r[1].moment -= shift.cross(r[1].impulse);
       },
       torque, true},
      {"on the other body", [](auto& r) { r[1].impulse *= -1, r[1].moment *= -1; }, of(force, 1), false},
      {"of another joint", [](auto& r) { std::swap(r[1].joint, r[2].joint); }, of(force, 1), false},
      {"of another joint, which is not asked for", [](auto& r) { std::swap(r[1].joint, r[2].joint); },
       of(force, 0), true},
      {"about the centre, told of the joint",
       [](auto& r) {
         r[1].point = {0.8, 0.2, -0.1};
       },
       of(torque, 1), false},
      {"the torque of the other body", [](auto& r) { r[0].moment *= -1; }, torque, false},
      {"half a percent off", [](auto& r) { r[0].impulse *= 1.005; }, force, false},
  };
  for (const auto& row : rows) {
    Recording run = resting(scene);
    row.change(*run.reactions);
    const Claim claim = claim_of(row.q, scene);
    const Measured m = measure(claim, scene, {&run, 1}, 1);
    EXPECT_FALSE(m.unanswered) << m.detail;
    EXPECT_EQ(m.value <= m.allowed, row.passes) << row.name << ": " << m.value << " of " << m.allowed;
  }
  EXPECT_NEAR(scale(claim_of(force, scene), scene, 1), weight, 1e-9 * weight) << "the largest of the joints'";
  EXPECT_NEAR(scale(claim_of(of(force, 2), scene), scene, 1), 1.3 * gravity(scene).norm(), 1e-9);
  Scene idle = scene;
  idle.joints[2].point = scene.bodies[2].initial.position;
  EXPECT_NEAR(scale(claim_of(of(torque, 2), idle), idle, 1), 2 * gravity(idle).norm() * std::sqrt(0.05 / 0.7),
              0.2)
      << "no torque: m g d of the largest body";
}

TEST(JointForce, IsUnansweredWhereItIsNotTold) {
  const Scene scene = beams();
  const struct {
    const char* name;
    std::function<void(Recording&)> change;
    const char* says;
  } rows[] = {
      {"nothing told", [](Recording& r) { r.reactions.reset(); }, "the engine tells no forces of joints"},
      {"one left out", [](Recording& r) { r.reactions->erase(r.reactions->begin() + 1); },
       "the engine tells no force of joint 2 in the last step"},
      {"one told twice", [](Recording& r) { r.reactions->push_back(r.reactions->front()); },
       "no force of joint 1"},
  };
  for (const auto& row : rows) {
    Recording run = resting(scene);
    row.change(run);
    const Measured m = measure(claim_of(force, scene), scene, {&run, 1}, 1);
    EXPECT_TRUE(m.unanswered) << row.name;
    EXPECT_NE(m.detail.find(row.says), std::string::npos) << row.name << ": " << m.detail;
    EXPECT_TRUE(std::isnan(m.value));
  }
  // The truth's error in a force grows as 1/dt, and the run's step may be shorter than the scenario's.
  Claim loose = claim_of(force, scene);
  loose.truth->error.velocity = 1e-6;
  Recording run = resting(scene);
  EXPECT_FALSE(measure(loose, scene, {&run, 1}, 1).unanswered);
  run.dt = 1e-5;
  for (Reaction& r : *run.reactions) r.impulse *= run.dt / dt, r.moment *= run.dt / dt;
  const Measured m = measure(loose, scene, {&run, 1}, 1);
  EXPECT_TRUE(m.unanswered);
  EXPECT_NE(m.detail.find("is only good to"), std::string::npos) << m.detail;
}

TEST(JointForce, IsNaNWhereAStateIs) {
  const Scene scene = beams();
  Recording run = resting(scene);
  run.states.back()[0].position.x() = std::nan("");
  const Measured m = measure(claim_of(torque, scene), scene, {&run, 1}, 1);
  EXPECT_TRUE(std::isnan(m.value));
}

TEST(JointForce, OfTwoRunsAreAsFarApartAsTheyAreTold) {
  const Scene scene = beams();
  const Recording one = resting(scene);
  Recording other = one;
  other.reactions->at(1).impulse.z() += 0.03 * dt;
  EXPECT_NEAR(spread_of_last_step(force, scene, one, other), 0.03, 1e-12);
  EXPECT_NEAR(spread_of_last_step(of(force, 0), scene, one, other), 0, 1e-12);
}

}  // namespace
