// Metamorphic relations on a correct engine and on engines with one fault each: each fault is found by its
// relation, and the correct engine passes all.
#include "harness/study/relations.h"
#include "harness/study/restate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace cylon::study {
namespace {

using core::Scene;
using core::State;
using core::Vector3;

enum class Fault {
  none,
  grid,          // places are rounded to 0.1 m
  slow_along_x,  // drag along x alone
  magnetic,      // a force v x e_y, which a mirror turns round
  medium,        // drag against a medium at rest
  light_falls,   // gravity by mass
  clamp,         // no body is faster than 3 m/s
  stale_first,   // the first body's springs see the step before
  box_step,      // the step grows with the extent of the scene
  clock,         // springs soften with time
  counter,       // springs soften with every run
  stiffening,    // springs of x^3
  body_turn,     // angular velocity taken in body axes
  heavy_only,    // gravity on the first body alone
  crowd,         // springs soften with every further body
  first_force,   // the force that is listed first is larger
  one_sided,     // a spring pulls its second body less
  light_weld,    // a fixed joint forgets the second body's mass
};

// Bodies on springs in gravity, by velocity Verlet; turns at constant angular velocity.
class Engine {
 public:
  explicit Engine(Fault fault) : fault_(fault) {}

  core::Recording operator()(const Scene& scene, double dt, std::int64_t steps, std::int64_t every) {
    ++runs_;
    core::Recording result;
    result.dt = dt;
    State state = core::initial_state(scene), before = state;
    for (std::int64_t n = 0; n <= steps; ++n) {
      if (n % every == 0 || n == steps) result.steps.push_back(n), result.states.push_back(state);
      const auto a = accelerations(scene, state, before, static_cast<double>(n) * dt);
      before = state;
      double h = dt;
      if (fault_ == Fault::box_step) h *= 1 + 1e-4 * extent(state);
      for (std::size_t i = 0; i < state.size(); ++i) {
        state[i].velocity += h / 2 * a[i];
        state[i].position += h * state[i].velocity;
        const Vector3 w = state[i].angular_velocity * h;
        const core::Quaternion turn(
            Eigen::AngleAxisd(w.norm(), w.norm() > 0 ? Vector3(w.normalized()) : Vector3::UnitX()));
        state[i].orientation =
            fault_ == Fault::body_turn ? state[i].orientation * turn : turn * state[i].orientation;
      }
      const auto b = accelerations(scene, state, before, static_cast<double>(n + 1) * dt);
      for (std::size_t i = 0; i < state.size(); ++i) {
        state[i].velocity += h / 2 * b[i];
        if (fault_ == Fault::clamp && state[i].velocity.norm() > 3)
          state[i].velocity *= 3 / state[i].velocity.norm();
        if (fault_ == Fault::grid) state[i].position = (10 * state[i].position).array().round() / 10;
      }
    }
    return result;
  }

 private:
  static double extent(const State& state) {
    double r = 0;
    for (const auto& s : state) r = std::max(r, (s.position - state.front().position).norm());
    return r;
  }

  std::vector<Vector3> accelerations(const Scene& scene, const State& now, const State& before,
                                     double t) const {
    std::vector<Vector3> a(now.size(), Vector3::Zero());
    const auto mass = [&](int i) { return scene.bodies[static_cast<std::size_t>(i)].mass; };
    for (const core::Force& f : scene.forces) {
      if (const auto* g = std::get_if<core::UniformGravity>(&f))
        for (std::size_t i = 0; i < a.size(); ++i)
          if (fault_ != Fault::heavy_only || i == 0)
            a[i] += g->acceleration * (fault_ == Fault::light_falls ? mass(static_cast<int>(i)) : 1);
      if (const auto* k = std::get_if<core::Spring>(&f)) {
        const auto at = [&](int i) { return static_cast<std::size_t>(i); };
        const State& seen = fault_ == Fault::stale_first && k->body == 0 ? before : now;
        const Vector3 d =
            (k->to == core::world ? k->to_anchor : seen[at(k->to)].position) - seen[at(k->body)].position;
        double stiffness = k->stiffness;
        if (fault_ == Fault::clock) stiffness *= 1 - 0.1 * t;
        if (fault_ == Fault::counter) stiffness *= 1 - 1e-3 * runs_;
        if (fault_ == Fault::crowd) stiffness *= 1 - 0.01 * static_cast<double>(now.size());
        if (fault_ == Fault::first_force && &f == &scene.forces.front()) stiffness *= 1.05;
        if (fault_ == Fault::stiffening) stiffness *= 1 + d.squaredNorm();
        const Vector3 force = stiffness * (d.norm() > 0 ? 1 - k->rest_length / d.norm() : 0) * d;
        a[at(k->body)] += force / mass(k->body);
        if (k->to != core::world)
          a[at(k->to)] -= (fault_ == Fault::one_sided ? 0.9 : 1) * force / mass(k->to);
      }
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
      const Vector3& v = now[i].velocity;
      if (fault_ == Fault::slow_along_x) a[i].x() -= 0.3 * v.x();
      if (fault_ == Fault::magnetic) a[i] += v.cross(Vector3(0.3, 0.5, 0.1));
      if (fault_ == Fault::medium) a[i] -= 0.3 * v;
    }
    // Of two bodies at one place: a = (m_a a_a + m_b a_b)/(m_a + m_b).
    for (const core::Joint& j : scene.joints) {
      const auto one = static_cast<std::size_t>(j.body), two = static_cast<std::size_t>(j.to);
      const double m_one = mass(j.body), m_two = fault_ == Fault::light_weld ? 0 : mass(j.to);
      a[one] = a[two] = (m_one * a[one] + m_two * a[two]) / (m_one + m_two);
    }
    return a;
  }

  Fault fault_;
  int runs_ = 0;
};

// Two bodies on a spring, free or hung up; general numbers.
Scene scene(bool hung, double rest_length) {
  Scene s;
  for (const double side : {-1.0, 1.0}) {
    core::Body b;
    b.name = side < 0 ? "a" : "b";
    b.mass = 1.5 + 0.4 * side;
    b.inertia = Vector3(0.2, 0.3, 0.4).asDiagonal();
    b.shape = core::Sphere{0.1};  // so that the parts of a split body share its centre
    b.initial = {Vector3(0.6, 0.2, -0.3) * side, core::Quaternion(0.8, 0.1, -0.5, 0.3).normalized(),
                 Vector3(0.4, -0.7 * side, 0.9), Vector3(0.5, 1.1 * side, -0.4)};
    s.bodies.push_back(b);
  }
  s.forces.emplace_back(core::Spring{0, Vector3::Zero(), 1, Vector3::Zero(), 20, rest_length, 0});
  if (hung) {
    s.forces.emplace_back(core::Spring{0, Vector3::Zero(), core::world, {0.1, 1.4, 0.2}, 15, rest_length, 0});
    s.forces.emplace_back(core::UniformGravity{{0.4, -9.0, 1.1}});
  }
  return s;
}

// Beside a third one, which hangs on a spring of its own.
Scene three() {
  Scene s = scene(true, 0.7);
  core::Body b = s.bodies.front();
  b.name = "c", b.initial.position = {3, 0.4, 1};
  s.bodies.push_back(b);
  s.forces.emplace_back(core::Spring{2, Vector3::Zero(), core::world, {3.1, 1.2, 0.7}, 12, 0.3, 0});
  return s;
}

// Deviation by relation; those that say nothing of the scene are left out.
std::map<std::string, double> deviations(Fault fault, const Scene& s) {
  Engine engine(fault);
  const Runner run = [&](const Scene& other, double dt, std::int64_t n, std::int64_t every) {
    return engine(other, dt, n, every);
  };
  constexpr double dt = 1e-3;
  constexpr std::int64_t steps = 1000, every = 10;
  const core::Recording plain = run(s, dt, steps, every);
  const Subject subject{s, plain, every, scales(s, dt * steps), dt * steps};
  std::map<std::string, double> result;
  for (const Relation& relation : relations())
    if (!relation.undefined_in(s)) result[std::string(relation.name)] = relation.deviation(subject, run);
  return result;
}

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = {scene(false, 0), scene(false, 0.7), scene(true, 0), scene(true, 0.7),
                                         three()};
  return all;
}

// Rounding of 1000 steps, grown tenfold; what Verlet makes of free fall is exact.
constexpr double rounding = 1e-10;

TEST(Relations, CorrectEnginePassesAll) {
  std::map<std::string, int> asked;
  for (const Scene& s : scenes())
    for (const auto& [name, value] : deviations(Fault::none, s)) {
      EXPECT_LE(value, name == "repetition" || name == "units" ? 0 : rounding) << name;
      ++asked[name];
    }
  EXPECT_EQ(asked.size(), relations().size());  // the scenes give every relation something to say
}

TEST(Relations, EachFaultIsFoundByItsRelation) {
  const std::pair<Fault, const char*> table[] = {
      {Fault::grid, "translation"},
      {Fault::slow_along_x, "rotation"},
      {Fault::magnetic, "mirror"},
      {Fault::medium, "boost"},
      {Fault::medium, "time reversal"},
      {Fault::light_falls, "mass"},
      {Fault::clamp, "units"},
      {Fault::stale_first, "body order"},
      {Fault::box_step, "far body"},
      {Fault::clock, "split run"},
      {Fault::counter, "repetition"},
      {Fault::stiffening, "superposition"},
      {Fault::body_turn, "body axes"},
      {Fault::heavy_only, "free fall"},
      {Fault::crowd, "bystander"},
      {Fault::crowd, "removal"},
      {Fault::first_force, "part order"},
      {Fault::one_sided, "other points"},
      {Fault::light_weld, "weld"},
  };
  for (const auto& [fault, relation] : table) {
    double worst = 0;
    for (const Scene& s : scenes()) {
      const auto found = deviations(fault, s);
      if (const auto it = found.find(relation); it != found.end()) worst = std::max(worst, it->second);
    }
    // Ten times more than rounding; a thousandth of the scales but for a step's delay and a softer spring.
    EXPECT_GT(worst, fault == Fault::stale_first || fault == Fault::counter ? 1e-5 : 1e-3) << relation;
  }
}

TEST(Relations, AreSkippedWhereTheyDoNotHold) {
  const auto reason = [](const char* name, const Scene& s) {
    for (const Relation& relation : relations())
      if (relation.name == name) return relation.undefined_in(s).value_or("");
    return std::string("no such relation");
  };
  Scene s = scene(true, 0.7);
  EXPECT_EQ(reason("boost", s), "a spring ends at the world");
  EXPECT_EQ(reason("superposition", s), "a spring has a length, a damper or an arm");
  s.forces.emplace_back(core::Drag{0, 0.2, 0, 0});
  EXPECT_EQ(reason("time reversal", s), "drag loses energy");
  s.forces.emplace_back(core::Drive{0, {1, 0, 0}, 2});
  EXPECT_EQ(reason("split run", s), "a drive has a phase");
  s.forces.emplace_back(core::Water{});
  EXPECT_EQ(reason("translation", s), "water has a place and axes of its own");
  EXPECT_EQ(reason("weld", s), "water lifts each body");
  s.bodies[0].shape = core::Box{{0.1, 0.2, 0.3}};
  EXPECT_EQ(reason("body axes", s), "the shape of 'a' has axes");
  EXPECT_EQ(reason("removal", scene(true, 0.7)), "no body is independent of all others");
  Scene room = three();
  for (const Vector3& normal : {Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1)}) {
    EXPECT_EQ(reason("bystander", room), "");
    room.planes.push_back({"wall", normal, -10});
  }
  EXPECT_EQ(reason("bystander", room), "planes leave no way to a place like this one");
  room.forces = {core::Thrust{0, Vector3::Zero(), -0.1, {}, {}}};
  EXPECT_EQ(reason("weld", room), "the mass changes");
}

// The motion of a restated scene's start is the restated start: mass, energy and inertia in the new words.
TEST(Restatement, DescribesTheSameScene) {
  Scene s = scene(true, 0.7);
  s.bodies[0].shape = core::Hull{{{0.1, 0, 0}, {0, 0.2, 0}, {0, 0, 0.3}, {-0.1, -0.1, 0}}};
  s.bodies[0].collide = true;
  s.planes.push_back({"floor", Vector3(0.6, 0.8, 0), -2});
  s.joints.push_back({core::JointType::hinge, 0, 1, {0.3, 0.1, 0.2}, Vector3(0, 0.6, 0.8)});
  Restatement change;
  change.turn = change.own = Vector3(-1, 1, 1).asDiagonal();
  change.move = {0.3, -0.2, 0.5};
  change.length = 2, change.mass = 3, change.time = 0.5;
  const Scene t = change(s);
  const double energy = 3 * 4 / 0.25;
  for (std::size_t i = 0; i < s.bodies.size(); ++i) {
    const auto kinetic = [](const core::Body& b) {
      const Vector3& w = b.initial.angular_velocity;
      return b.mass / 2 * b.initial.velocity.squaredNorm() +
             w.dot(core::world_inertia(b, b.initial.orientation) * w) / 2;
    };
    EXPECT_NEAR(kinetic(t.bodies[i]), energy * kinetic(s.bodies[i]), 1e-12 * energy);
    EXPECT_NEAR(t.bodies[i].initial.orientation.norm(), 1, 1e-14);
  }
  // The distance of a hull's corner from the plane is that of its image.
  const auto gap = [](const Scene& of) {
    const core::BodyState& b = of.bodies[0].initial;
    return of.planes[0].normal.dot(b.position +
                                   b.orientation * std::get<core::Hull>(of.bodies[0].shape).vertices[2]) -
           of.planes[0].offset;
  };
  EXPECT_NEAR(gap(t), 2 * gap(s), 1e-13);
  // The joint's point stays where it was in its body.
  const auto arm = [](const Scene& of) {
    const core::BodyState& b = of.bodies[0].initial;
    return Vector3(b.orientation.conjugate() * (of.joints[0].point - b.position));
  };
  EXPECT_LE((arm(t) - 2 * (change.own * arm(s))).norm(), 1e-14);
}

}  // namespace
}  // namespace cylon::study
