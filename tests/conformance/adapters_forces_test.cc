// The forces of a scene, each against F = m a and torque by hand in the first instant, and against what they
// keep.
#include "tests/conformance/adapters_fixture.h"

#include <array>
#include <cmath>
#include <functional>

namespace cylon::conformance {
namespace {

class Forces : public EveryEngine {};
INSTANTIATE_TEST_SUITE_P(Adapters, Forces, testing::ValuesIn(subjects), test_name);

// ---- The first instant -----------------------------------------------------------------------------

struct Wrench {
  Vector3 force = Vector3::Zero(), torque = Vector3::Zero();  // about the centre of mass
};
using Wrenches = std::array<Wrench, 3>;

// A force on body "a" (0), and on "b" (1) if it has another end, and what it is by hand at t = 0.
struct Row {
  const char* name;
  core::Force force;
  std::function<Wrenches(const core::Scene&)> by_hand;
  std::function<void(core::Scene&)> prepare = [](core::Scene&) {};
};

const Vector3 anchor(0.21, -0.13, 0.34), to_anchor(-0.17, 0.28, 0.09), pin(0.8, -1.4, 0.5);
const Vector3 push(2.3, -1.1, 3.7);

Vector3 velocity_at(const core::BodyState& s, const Vector3& arm) {
  return s.velocity + s.angular_velocity.cross(arm);
}

Wrenches spring_by_hand(const core::Scene& scene, bool pinned) {
  const core::BodyState &a = scene.bodies[0].initial, &b = scene.bodies[1].initial;
  const Vector3 arm = a.orientation * anchor, to_arm = b.orientation * to_anchor;
  const Vector3 end = pinned ? pin : b.position + to_arm;
  const Vector3 end_velocity = pinned ? Vector3::Zero() : velocity_at(b, to_arm);
  const Vector3 d = end - (a.position + arm), along = d.normalized();
  const double stretching = along.dot(end_velocity - velocity_at(a, arm));
  const Vector3 f = (17.0 * (d.norm() - 0.4) + 1.9 * stretching) * along;
  Wrenches result;
  result[0] = {f, arm.cross(f)};
  if (!pinned) result[1] = {-f, to_arm.cross(-f)};
  return result;
}

Wrenches on_a(const Vector3& force, const Vector3& torque) {
  Wrenches result;
  result[0] = {force, torque};
  return result;
}

core::Matrix3 inertia_of(const core::Body& body) {
  return core::world_inertia(body, body.initial.orientation);
}

// ---- Water, by summing columns -----------------------------------------------------------------------

const Vector3 fall(3.3, -8.1, 4.6);
const core::Water sea = {.level = -0.2, .wave = 0.3, .speed = 2.1, .buoyancy = 21.0, .drag = 3.7};

// What is below the sea's surface at t = 0 of a body that fills, over each point (x, z) of body axes, the
// column from -top(x, z) to top(x, z); x and z within `reach`.
Wrench below_sea(const core::BodyState& s, const Vector3& reach,
                 const std::function<double(double, double)>& top) {
  const double height = sea.level + sea.wave * std::sin(s.position.x());
  const Vector3 up = s.orientation.conjugate() * Vector3::UnitY();  // body axes
  constexpr int n = 1500;
  const double dx = 2 * reach.x() / n, dz = 2 * reach.z() / n;
  double volume = 0, whole = 0;
  Vector3 moment = Vector3::Zero();
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const double x = -reach.x() + (i + 0.5) * dx, z = -reach.z() + (k + 0.5) * dz, h = top(x, z);
      // up . (x, y, z) <= height - position.y
      const double cut = (height - s.position.y() - up.x() * x - up.z() * z) / up.y();
      const double low = up.y() > 0 ? -h : std::max(cut, -h), high = up.y() > 0 ? std::min(cut, h) : h;
      whole += 2 * h * dx * dz;
      if (high <= low) continue;
      const double v = (high - low) * dx * dz;
      volume += v, moment += v * Vector3(x, (low + high) / 2, z);
    }
  if (volume == 0) return {};
  const Vector3 lift = -sea.buoyancy * volume * fall;
  return {lift - sea.drag * volume / whole * s.velocity, (s.orientation * (moment / volume)).cross(lift)};
}

Wrenches in_sea(const core::Scene& scene, const std::function<Wrench(const core::BodyState&)>& one) {
  Wrenches result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = one(scene.bodies[i].initial);
    result[i].force += scene.bodies[i].mass * fall;
  }
  return result;
}

// All three at the surface, where `shape` is cut.
std::function<void(core::Scene&)> afloat(const core::Shape& shape) {
  return [shape](core::Scene& scene) {
    const double depths[] = {0.11, -0.17, 0.05};
    for (std::size_t i = 0; i < 3; ++i) {
      scene.bodies[i].shape = shape;
      Vector3& x = scene.bodies[i].initial.position;
      x.y() = sea.level + sea.wave * std::sin(x.x()) - depths[i];
    }
    scene.forces.emplace_back(core::UniformGravity{fall});
  };
}

const core::Box box = {{0.4, 0.3, 0.5}};

// ---- A turning frame, by summing mass points -----------------------------------------------------------

// A body whose principal moments are those of pairs of points on the principal axes: a point of mass m_k at
// +-1 m on axis k gives  I_k = 2 (m_i + m_j).  At t = 0 each point feels  -m (a + 2 W x v + W' x r + W x (W x r)).
Wrenches turned(const core::Scene& scene) {
  const Vector3 turn = scene.frame->angular_velocity, faster = scene.frame->angular_acceleration;
  Wrenches result;
  for (std::size_t b = 0; b < 3; ++b) {
    const core::Body& body = scene.bodies[b];
    const core::BodyState& s = body.initial;
    const core::PrincipalAxes axes = core::principal_axes(body.inertia);
    const Vector3 points = (Vector3::Constant(axes.moments.sum() / 2) - axes.moments) / 2;  // [kg]
    const auto fictitious = [&](double m, const Vector3& r, const Vector3& v) -> Vector3 {
      return -m *
             (scene.frame->acceleration + 2 * turn.cross(v) + faster.cross(r) + turn.cross(turn.cross(r)));
    };
    for (int k = 0; k < 3; ++k)
      for (const double side : {-1.0, 1.0}) {
        const Vector3 arm = s.orientation * (axes.rotation * (side * Vector3::Unit(k)));
        const Vector3 f = fictitious(points[k], s.position + arm, velocity_at(s, arm));
        result[b].force += f;
        result[b].torque += arm.cross(f);
      }
    // The rest of the mass sits in the centre.
    result[b].force += fictitious(body.mass - 2 * points.sum(), s.position, s.velocity);
  }
  return result;
}

const Row rows[] = {
    {"turning frame", core::UniformGravity{Vector3::Zero()}, turned,
     [](core::Scene& scene) {
       scene.frame = core::Frame{{0.7, -0.4, 1.1}, {1.3, -0.8, 2.1}};
     }},
    {"uneven frame", core::UniformGravity{Vector3::Zero()}, turned,
     [](core::Scene& scene) {
       scene.frame = core::Frame{{0.7, -0.4, 1.1}, {1.3, -0.8, 2.1}, {2.7, 3.4, -1.9}, 2.3, {3.1, 1.8, -2.6}};
     }},
    {"accelerating frame", core::UniformGravity{Vector3::Zero()}, turned,
     [](core::Scene& scene) {
       scene.frame = core::Frame{{0.7, -0.4, 1.1}, Vector3::Zero(), {2.7, 3.4, -1.9}};
     }},
    {"moving frame", core::UniformGravity{fall},
     [](const core::Scene& scene) { return in_sea(scene, [](const core::BodyState&) { return Wrench(); }); },
     [](core::Scene& scene) {
       scene.frame = core::Frame{{0.7, -0.4, 1.1}, Vector3::Zero()};
     }},
    {"water, spheres", sea,
     [](const core::Scene& scene) {
       const auto top = [](double x, double z) { return std::sqrt(std::max(0.0, 0.16 - x * x - z * z)); };
       return in_sea(scene,
                     [&](const core::BodyState& s) { return below_sea(s, Vector3::Constant(0.4), top); });
     },
     afloat(core::Sphere{0.4})},
    {"water, boxes", sea,
     [](const core::Scene& scene) {
       return in_sea(scene, [](const core::BodyState& s) {
         return below_sea(s, box.half_extents, [](double, double) { return box.half_extents.y(); });
       });
     },
     afloat(box)},
    {"water in steps",
     core::Water{.level = 0.1, .wave = 0.5, .speed = 3, .buoyancy = 12, .drag = 1.6, .mode = "step"},
     [](const core::Scene& scene) {
       Wrenches result;
       for (std::size_t i = 0; i < 3; ++i) {
         const core::BodyState& s = scene.bodies[i].initial;
         const int column = static_cast<int>(4 * s.position.x() + 20),
                   row = static_cast<int>(4 * s.position.z() + 20);
         const double height = 0.1 + 0.25 * std::sin(column) + 0.25 * std::sin(column * row / 2.0);
         if (s.position.y() > height) continue;
         result[i].force = Vector3(0, 12, 0) - 1.6 * s.velocity;
         result[i].torque = -inertia_of(scene.bodies[i]) * s.angular_velocity;
       }
       return result;
     },
     [](core::Scene& scene) {
       scene.bodies[0].initial.position.y() = -1.5, scene.bodies[1].initial.position.y() = 1.5;
     }},
    {"rocket", core::Thrust{.body = 0, .mass_rate = -0.3, .exhaust_velocity = push},
     [](const core::Scene& scene) {
       return on_a(scene.bodies[0].initial.orientation * (-0.3 * push), Vector3::Zero());
     }},
    {"accretion", core::Thrust{.body = 0, .mass_rate = 0.7, .exchanged_velocity = push},
     [](const core::Scene& scene) {
       return on_a(0.7 * (push - scene.bodies[0].initial.velocity), Vector3::Zero());
     }},
    {"gravity", core::UniformGravity{{3.3, -8.1, 4.6}},
     [](const core::Scene& scene) {
       Wrenches result;
       for (std::size_t i = 0; i < 3; ++i) result[i].force = scene.bodies[i].mass * Vector3(3.3, -8.1, 4.6);
       return result;
     }},
    {"spring between two", core::Spring{0, anchor, 1, to_anchor, 17.0, 0.4, 1.9},
     [](const core::Scene& scene) { return spring_by_hand(scene, false); }},
    {"spring to a pin", core::Spring{0, anchor, core::world, pin, 17.0, 0.4, 1.9},
     [](const core::Scene& scene) { return spring_by_hand(scene, true); }},
    {"linear drag", core::Drag{0, 1.7, 0, 0},
     [](const core::Scene& scene) { return on_a(-1.7 * scene.bodies[0].initial.velocity, Vector3::Zero()); }},
    {"angular drag", core::Drag{0, 0, 2.6, 0},
     [](const core::Scene& scene) {
       return on_a(Vector3::Zero(), -2.6 * scene.bodies[0].initial.angular_velocity);
     }},
    {"momentum drag", core::Drag{0, 0, 0, 3.1},
     [](const core::Scene& scene) {
       return on_a(Vector3::Zero(),
                   -3.1 * (inertia_of(scene.bodies[0]) * scene.bodies[0].initial.angular_velocity));
     }},
    {"drive", core::Drive{0, push, 5.3}, [](const core::Scene&) { return on_a(push, Vector3::Zero()); }},
    {"thrust", core::Thrust{.body = 0, .force = push},
     [](const core::Scene& scene) {
       return on_a(scene.bodies[0].initial.orientation * push, Vector3::Zero());
     }},
    {"attraction", core::Attraction{0, 1, 4.2},
     [](const core::Scene& scene) {
       const Vector3 d = scene.bodies[1].initial.position - scene.bodies[0].initial.position;
       const Vector3 f = 4.2 * scene.bodies[0].mass * scene.bodies[1].mass / std::pow(d.norm(), 3) * d;
       Wrenches result;
       result[0].force = f, result[1].force = -f;
       return result;
     }},
};

// (v_1 - v_0)/dt = F/m + O(dt), (w_1 - w_0)/dt = I^-1 (tau - w x I w) + O(dt), relative to the largest of
// each in the scene.  The step balances O(dt) against rounding v/dt: 1e-6 s in double, 3e-4 s in single
// precision.
TEST_P(Forces, InitialAccelerationsAgreeWithHandCalculation) {
  const double h = subject().single ? 3e-4 : 1e-6;
  for (const Row& row : rows) {
    const auto* water = std::get_if<core::Water>(&row.force);
    if (water && water->mode != "step" && !subject().archimedes) continue;
    core::Scene scene = three_bodies(51);
    scene.forces = {row.force};
    row.prepare(scene);
    const core::State before = core::initial_state(scene), after = last(subject().choice(), scene, h, 1);
    const Wrenches wrenches = row.by_hand(scene);
    double error = 0, size = 0, turning_error = 0, turning_size = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const core::Matrix3 inertia = inertia_of(scene.bodies[i]);
      const Vector3& w = before[i].angular_velocity;
      const Vector3 a = wrenches[i].force / scene.bodies[i].mass;
      const Vector3 turning = inertia.inverse() * (wrenches[i].torque - w.cross(inertia * w));
      error = std::max(error, ((after[i].velocity - before[i].velocity) / h - a).norm());
      turning_error = std::max(turning_error, ((after[i].angular_velocity - w) / h - turning).norm());
      size = std::max(size, a.norm());
      turning_size = std::max(turning_size, turning.norm());
    }
    const double allowed = subject().single ? 1e-2 : 3e-5;  // 30 h/s, h/s being O(dt) for rates of 30/s
    expect_within(fmt::format("acceleration by {}, {}", row.name, subject().id), error,
                  allowed * std::max(1.0, size));
    expect_within(fmt::format("angular acceleration by {}, {}", row.name, subject().id), turning_error,
                  allowed * std::max(1.0, turning_size));
  }
}

// ---- Over time -------------------------------------------------------------------------------------

// x = x_0 + v_0 t + F/m (1 - cos f t)/f^2: the drive's time is the engine's.
TEST_P(Forces, DriveHasCorrectPhase) {
  const double f = 5.3, t = 0.8;
  const auto error = [&](std::int64_t steps) {
    core::Scene scene = three_bodies(52);
    scene.forces = {core::Drive{1, push, f}};
    const core::BodyState& b = scene.bodies[1].initial;
    const Vector3 exact =
        b.position + b.velocity * t + push / scene.bodies[1].mass * (1 - std::cos(f * t)) / (f * f);
    return (last(subject().choice(), scene, t / static_cast<double>(steps), steps)[1].position - exact)
        .norm();
  };
  const double coarse = error(80), fine = error(800);
  expect_within(fmt::format("drive, {}", subject().id), fine,
                1.25 * coarse / std::pow(10, subject().order) + 800 * subject().unit());
}

// x = x_0 + v_0 t - a (1 - cos f t)/f^2 in a frame that shakes; and a frame that turns ever faster about the y axis,
// angle  s = W t + W' t^2/2,  sees a body on which nothing acts turned back by it.
TEST_P(Forces, AFrameShakesInPhaseAndTurnsEverFaster) {
  const double f = 5.3, t = 0.8;
  const auto shaken = [&](std::int64_t steps) {
    core::Scene scene = three_bodies(55);
    scene.forces.clear();
    scene.frame = core::Frame{.acceleration = push, .frequency = f};
    const core::BodyState& b = scene.bodies[1].initial;
    const Vector3 exact = b.position + b.velocity * t - push * (1 - std::cos(f * t)) / (f * f);
    return (last(subject().choice(), scene, t / static_cast<double>(steps), steps)[1].position - exact)
        .norm();
  };
  const auto turned = [&](std::int64_t steps) {
    core::Scene scene = three_bodies(56);
    scene.forces.clear();
    scene.frame = core::Frame{.angular_velocity = {0, 0.4, 0}, .angular_acceleration = {0, 1.1, 0}};
    const core::BodyState& b = scene.bodies[1].initial;
    const Vector3 inertial = b.position + (b.velocity + scene.frame->angular_velocity.cross(b.position)) * t;
    const Vector3 exact = Eigen::AngleAxisd(-(0.4 * t + 1.1 * t * t / 2), Vector3::UnitY()) * inertial;
    return (last(subject().choice(), scene, t / static_cast<double>(steps), steps)[1].position - exact)
        .norm();
  };
  const auto compare = [&](const char* what, const auto& error) {
    const double coarse = error(80), fine = error(800);
    expect_within(fmt::format("{}, {}", what, subject().id), fine,
                  1.25 * coarse / std::pow(10, subject().order) + 800 * subject().unit());
  };
  compare("a frame that shakes", shaken);
  compare("a frame that turns ever faster", turned);
}

// Springs between bodies: forces are equal and opposite, so momentum stays to a hundred roundings; and on one
// line, so angular momentum stays as well as the integrator keeps it.
TEST_P(Forces, SpringsKeepBothMomenta) {
  core::Scene scene = three_bodies(53);
  scene.forces = {core::Spring{0, anchor, 1, to_anchor, 17.0, 0.4, 1.9},
                  core::Spring{2, to_anchor, 0, anchor, 11.0, 0.1, 0.3}};
  const auto momenta = [&](const core::State& state) {
    std::pair<Vector3, Vector3> sum = {Vector3::Zero(), Vector3::Zero()};
    for (std::size_t i = 0; i < state.size(); ++i) {
      const core::Body& body = scene.bodies[i];
      const core::BodyState& s = state[i];
      sum.first += body.mass * s.velocity;
      sum.second += body.mass * s.position.cross(s.velocity) +
                    core::world_inertia(body, s.orientation) * s.angular_velocity;
    }
    return sum;
  };
  const auto start = momenta(core::initial_state(scene));
  const Vector3 &p = start.first, &l = start.second;  // clang 14 captures no structured binding
  const auto drift = [&](std::int64_t steps) {
    const auto [p1, l1] = momenta(last(subject().choice(), scene, 1.0 / static_cast<double>(steps), steps));
    expect_within(fmt::format("momentum, {} steps, {}", steps, subject().id), (p1 - p).norm() / p.norm(),
                  100 * subject().unit());
    return (l1 - l).norm() / l.norm();
  };
  const double coarse = drift(100), fine = drift(1000);
  expect_within(fmt::format("angular momentum, {}", subject().id), fine,
                1.25 * coarse / std::pow(10, subject().order) + 2000 * subject().unit());
}

// ---- Locked bodies ---------------------------------------------------------------------------------

// Whatever acts on it, a locked body stays to the last bit; and a spring hangs from it as from a pin in the
// same place.
TEST_P(Forces, LockedBodiesStayAndHold) {
  core::Scene scene = three_bodies(54);
  core::Body& wall = scene.bodies[1];
  wall.locked = true;
  wall.initial.velocity = wall.initial.angular_velocity = Vector3::Zero();
  scene.forces = {core::UniformGravity{{2, -9, 1}}, core::Spring{0, anchor, 1, to_anchor, 17.0, 0.4, 1.9},
                  core::Drive{1, 100 * push, 3}, core::Drag{1, 5, 5, 5}};
  const core::Recording recording = play(subject().choice(), scene, 1e-3, 500, 50);
  for (const core::State& state : recording.states)
    EXPECT_EQ(difference({state[1]}, {recording.states[0][1]}), 0);

  core::Scene pinned = scene;
  pinned.forces[1] = core::Spring{
      0, anchor, core::world, wall.initial.position + wall.initial.orientation * to_anchor, 17.0, 0.4, 1.9};
  expect_within(fmt::format("a spring from a locked body as from a pin, {}", subject().id),
                difference(last(subject().choice(), pinned, 1e-3, 500), recording.states.back()),
                2000 * subject().unit());
}

}  // namespace
}  // namespace cylon::conformance
