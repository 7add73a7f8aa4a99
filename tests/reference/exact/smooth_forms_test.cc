// The smooth solutions against other forms of the same motion: textbook formulas in their special cases, and
// each other where two of them serve one scene.
#include "reference/exact/exponential.h"
#include "reference/exact/solutions.h"
#include "tests/reference/exact/reference_file.h"
#include "tests/reference/exact/smooth_scenes.h"

#include <gtest/gtest.h>

#include <numbers>

namespace cylon::exact {
namespace {

constexpr Wide pi = std::numbers::pi_v<Wide>;

void expect_state(const core::BodyState& s, const WideVector& p, const WideVector& v,
                  const core::StateError& bound) {
  EXPECT_LE(static_cast<double>((widen(s.position) - p).norm()), bound.position);
  EXPECT_LE(static_cast<double>((widen(s.velocity) - v).norm()), bound.velocity);
}

core::Body point(const core::Vector3& position, const core::Vector3& velocity, double mass) {
  core::Body b;
  b.name = "body";
  b.mass = mass;
  b.initial.position = position, b.initial.velocity = velocity;
  return b;
}

// ---- Kepler: the textbook's equation of each conic, M = E - e sin E, e sinh F - F, D + D^3/3 --------------

struct Element {
  Wide x, y, vx, vy;
};

// mu = 1 and pericentre distance q, t from the pericentre; the anomaly by bisection.
Element orbit(Wide e, Wide q, Wide t) {
  Wide low = -60, high = 60;
  const Wide a = e == 1 ? 0 : q / std::abs(1 - e),
             n = e == 1 ? 1 / std::sqrt(2 * q * q * q) : 1 / std::sqrt(a * a * a);
  for (int i = 0; i < 200; ++i) {
    const Wide x = (low + high) / 2;
    const Wide mean = e < 1 ? x - e * std::sin(x) : e > 1 ? e * std::sinh(x) - x : x + x * x * x / 3;
    (mean > n * t ? high : low) = x;
  }
  const Wide x = (low + high) / 2;
  if (e == 1) {
    const Wide rate = n / (1 + x * x);
    return {q * (1 - x * x), 2 * q * x, -2 * q * x * rate, 2 * q * rate};
  }
  const Wide across = std::sqrt(std::abs(1 - e * e));
  if (e < 1) {
    const Wide rate = n / (1 - e * std::cos(x));
    return {a * (std::cos(x) - e), a * across * std::sin(x), -a * std::sin(x) * rate,
            a * across * std::cos(x) * rate};
  }
  const Wide rate = n / (e * std::cosh(x) - 1);
  return {a * (e - std::cosh(x)), a * across * std::sinh(x), -a * std::sinh(x) * rate,
          a * across * std::cosh(x) * rate};
}

TEST(SmoothForms, kepler_by_the_textbook) {
  const WideVector u = WideVector(0.48L, 0.6L, 0.64L),
                   w = WideVector(-0.8L, 0.6L, 0);  // w.u = -0.024: made normal
  const WideVector v = (w - w.dot(u) * u).normalized();
  for (const Wide e : {0.0L, 0.3L, 0.9L, 0.99L, 1.0L, 1.5L, 6.0L}) {
    SCOPED_TRACE(static_cast<double>(e));
    const Wide q = 0.7L, from = -1.3L;
    const auto at = [&](Wide t) {
      const Element k = orbit(e, q, t);
      return std::pair<WideVector, WideVector>(k.x * u + k.y * v, k.vx * u + k.vy * v);
    };
    for (bool locked : {false, true}) {
      core::Scene scene;
      const auto [d, rate] = at(from);
      const WideVector drift = locked ? WideVector(0, 0, 0) : WideVector(0.3L, -0.2L, 0.1L);
      // Masses 0.25 and 0.75 about a centre of mass that drifts; strength so that mu = 1.
      scene.bodies = {point((-0.75L * d).cast<double>(), (drift - 0.75L * rate).cast<double>(), 0.25),
                      point((0.25L * d).cast<double>(), (drift + 0.25L * rate).cast<double>(), 0.75)};
      scene.bodies[1].name = "other";
      core::Attraction attraction{0, 1, 1};
      if (locked) {
        scene.bodies[0] = point({0, 0, 0}, {0, 0, 0}, 0.25);
        scene.bodies[0].locked = true;
        scene.bodies[1].initial.position = d.cast<double>(),
        scene.bodies[1].initial.velocity = rate.cast<double>();
        attraction.strength = 4;
      }
      scene.forces.emplace_back(attraction);
      const core::Truth truth = kepler(scene, 12);
      for (const Wide t : {0.0L, 0.9L, 1.3L, 2.0L, 7.0L, 12.0L}) {
        const auto [p, s] = at(from + t);
        const core::State state = truth.state(static_cast<double>(t));
        // The start was rounded to double: the bound covers that as well.
        expect_state(state[1], locked ? p : WideVector(drift * t + 0.25L * p),
                     locked ? s : WideVector(drift + 0.25L * s), truth.error);
        if (!locked) expect_state(state[0], drift * t - 0.75L * p, drift - 0.75L * s, truth.error);
      }
    }
  }
}

// ---- Linear equations ------------------------------------------------------------------------------

TEST(SmoothForms, exponential_differences_are_smooth_and_symmetric) {
  using C = WideComplex;
  const Wide t = 1.7L;
  const C a(-0.4L, 2), b(-1.1L, -0.3L), c(0, 5);
  const auto three = [&](C x, C y, C z) { return exponential_difference(x, y, z, t); };
  const C direct = std::exp(a * t) / ((a - b) * (a - c)) + std::exp(b * t) / ((b - a) * (b - c)) +
                   std::exp(c * t) / ((c - a) * (c - b));
  EXPECT_LE(std::abs(three(a, b, c) - direct), 1e-18L);
  EXPECT_LE(std::abs(three(c, a, b) - direct), 1e-18L);
  EXPECT_LE(std::abs(three(a, a, a) - t * t / 2 * std::exp(a * t)), 1e-18L);
  // d/dx of [a, x] where x -> a, and the seam at |a - c| t = 2.
  for (const Wide near : {1e-3L, 1e-8L, 1e-15L}) {
    EXPECT_LE(std::abs(three(a, a + near, a) - t * t / 2 * std::exp(a * t)), near * t * t * t);
    EXPECT_LE(std::abs(exponential_difference(a, a + near, t) - t * std::exp(a * t)), near * t * t);
  }
  const C edge = a + 2 / t;
  EXPECT_LE(std::abs(three(a, b, edge * (1 + 1e-18L)) - three(a, b, edge * (1 - 1e-18L))), 1e-17L);
  EXPECT_EQ(exponential_difference(-5000, -1e4L, 10.0L), C(0));  // no overflow, no 0/0
}

core::Scene oscillator(double stiffness, double drag) {
  core::Scene s;
  s.bodies = {point({1, -0.3, 0.5}, {0.2, 2, 3}, 1)};
  s.forces.emplace_back(core::Spring{0, {0, 0, 0}, core::world, {0, 0, 0}, stiffness, 0, 0});
  s.forces.emplace_back(core::Drag{0, drag, 0, 0});
  return s;
}

// x = exp(-b t)(x0 + (v0 + b x0) t) at k = b^2, and nothing jumps on either side of it.
TEST(SmoothForms, critical_damping_has_no_seam) {
  for (const double off : {0.0, 1e-15, -1e-15, 1e-12, -1e-12, 1e-8, -1e-8, 1e-4, -1e-4}) {
    const core::Scene scene = oscillator(100 * (1 + off), 20);
    const core::Truth truth = damped_spring(scene, 1.5);
    for (const Wide t : {0.0L, 0.2L, 0.7L, 1.5L}) {
      const WideVector x = widen(scene.bodies[0].initial.position),
                       v = widen(scene.bodies[0].initial.velocity);
      const WideVector slope = v + 10 * x;
      const core::BodyState s = truth.state(static_cast<double>(t))[0];
      core::StateError bound = truth.error;
      bound.position += 40 * std::abs(off), bound.velocity += 400 * std::abs(off);
      expect_state(s, std::exp(-10 * t) * (x + slope * t), std::exp(-10 * t) * (v - 10 * slope * t), bound);
    }
  }
}

// Without damping at resonance, x = (F/2 m w) t sin(w t); off it by little, the beat.
TEST(SmoothForms, resonance) {
  for (const Wide off : {0.0L, 1e-12L, 1e-6L, 1e-3L}) {
    core::Scene scene = oscillator(25, 0);
    scene.bodies[0] = point({0, 0, 0}, {0, 0, 0}, 1);
    const double frequency = static_cast<double>(5 * (1 + off));
    scene.forces.emplace_back(core::Drive{0, {2, 0, 0}, frequency});
    const core::Truth truth = driven_spring(scene, 20);
    for (const Wide t : {0.5L, 3.0L, 20.0L}) {
      const Wide sum = (Wide(frequency) + 5) / 2, half = (Wide(frequency) - 5) / 2;
      const Wide beat = half == 0 ? t : std::sin(half * t) / half;  // (cos 5t - cos Wt)/(W^2 - 25) 2
      const Wide rate = std::cos(half * t) * std::sin(sum * t) + sum * beat * std::cos(sum * t);
      expect_state(truth.state(static_cast<double>(t))[0], {beat * std::sin(sum * t) / sum, 0, 0},
                   {rate / sum, 0, 0}, truth.error);
    }
  }
}

// A pure mode swings at 2 sqrt(k/m) sin(n pi/(2 N + 2)) with fixed ends and 2 sqrt(k/m) sin(n pi/(2 N)) with
// free ones, where the whole drifts besides.
TEST(SmoothForms, modes_of_equal_chains) {
  for (const int beads : {1, 2, 5, 40}) {
    for (const bool fixed : {true, false}) {
      if (!fixed && beads == 1) continue;
      for (const int mode : {1, std::max(1, beads / 2), fixed ? beads : beads - 1}) {
        SCOPED_TRACE(testing::Message() << beads << (fixed ? " fixed " : " free ") << mode);
        const double k = 80, m = 0.7, horizon = 12;
        core::Scene scene;
        const auto shape = [&](int i) {
          return fixed ? std::sin(static_cast<Wide>(mode * (i + 1)) * pi / static_cast<Wide>(beads + 1))
                       : std::cos((static_cast<Wide>(i) + 0.5L) * static_cast<Wide>(mode) * pi /
                                  static_cast<Wide>(beads));
        };
        const Wide w =
            2 * std::sqrt(Wide(k) / Wide(m)) *
            std::sin(static_cast<Wide>(mode) * pi / static_cast<Wide>(fixed ? 2 * beads + 2 : 2 * beads));
        const Wide size = 0.1L, drift = fixed ? 0 : 0.25L;
        for (int i = 0; i < beads; ++i) {
          scene.bodies.push_back(point({0.3, i + 1 + static_cast<double>(size * shape(i)), 0},
                                       {0, static_cast<double>(drift), 0}, m));
          scene.bodies.back().name = "bead" + std::to_string(i);
          if (i > 0) scene.forces.emplace_back(core::Spring{i - 1, {0, 0, 0}, i, {0, 0, 0}, k, 1, 0});
        }
        if (fixed) {
          scene.forces.emplace_back(core::Spring{0, {0, 0, 0}, core::world, {0.3, 0, 0}, k, 1, 0});
          scene.forces.emplace_back(
              core::Spring{beads - 1, {0, 0, 0}, core::world, {0.3, beads + 1.0, 0}, k, 1, 0});
        }
        const core::Truth truth = spring_chain(scene, horizon);
        EXPECT_LE(truth.error.position, 1e-11);
        for (const Wide t : {0.0L, 1.0L, 12.0L}) {
          const core::State state = truth.state(static_cast<double>(t));
          for (int i = 0; i < beads; ++i) {
            const Wide c = size * shape(i);
            expect_state(state[static_cast<std::size_t>(i)],
                         {widen(core::Vector3(0.3, 0, 0)).x(),
                          static_cast<Wide>(i + 1) + c * std::cos(w * t) + drift * t, 0},
                         {0, -c * w * std::sin(w * t) + drift, 0}, truth.error);
          }
        }
      }
    }
  }
}

// Next to no flow of mass is no flow of mass.
TEST(SmoothForms, little_mass_flows) {
  for (const double rate : {0.0, 1e-15, -1e-12, 1e-9}) {
    core::Scene scene;
    scene.bodies = {point({1, 2, 3}, {4, -5, 6}, 2)};
    scene.forces.emplace_back(core::UniformGravity{{1, -9, 2}});
    const core::Truth flight = projectile(scene, 3);
    core::Thrust thrust{0, {0, 0, 0}, rate, core::Vector3(10, 0, 0), {}};
    scene.forces.emplace_back(thrust);
    const core::Truth out = rocket(scene, 3);
    thrust.exchanged_velocity = thrust.exhaust_velocity, thrust.exhaust_velocity.reset();
    scene.forces.back() = thrust;
    const core::Truth in = accretion(scene, 3);
    for (const core::Truth* truth : {&out, &in}) {
      core::StateError bound = truth->error;
      bound.position += 200 * std::abs(rate), bound.velocity += 200 * std::abs(rate);
      const core::BodyState s = flight.state(3)[0];
      expect_state(truth->state(3)[0], widen(s.position), widen(s.velocity), bound);
    }
  }
}

// ---- Frames ----------------------------------------------------------------------------------------

TEST(SmoothForms, straight_line_from_a_carousel) {
  core::Scene scene;
  scene.bodies = {point({1, 0.2, 0.5}, {0.1, 0, -0.3}, 1)};
  scene.frame = core::Frame{{5, 4, 3}, {0.3, 0.9, -0.2}};
  const core::Truth truth = rotating_frame(scene, 8);
  const WideVector w = widen(scene.frame->angular_velocity), p0 = widen(scene.bodies[0].initial.position),
                   v0 = widen(scene.bodies[0].initial.velocity) + w.cross(p0), n = w.normalized();
  for (const Wide t : {0.0L, 1.1L, 4.5L, 8.0L}) {
    // Rodrigues' formula, turning back.
    const auto seen = [&](const WideVector& x) -> WideVector {
      const Wide c = std::cos(w.norm() * t), s = -std::sin(w.norm() * t);
      return x * c + n.cross(x) * s + n * n.dot(x) * (1 - c);
    };
    const WideVector p = seen(p0 + v0 * t);
    expect_state(truth.state(static_cast<double>(t))[0], p, seen(v0) - w.cross(p), truth.error);
  }
}

// ---- Pendulums: on a hinge, on a rod, and as a top without spin on its tip -------------------------

core::Scene pendulum(double angle, double rate, core::JointType type) {
  core::Scene scene;
  core::Body b = point({0.7 * std::sin(angle), -0.7 * std::cos(angle), 0}, {0, 0, 0}, 1.3);
  b.inertia = type == core::JointType::distance ? core::Matrix3(core::Matrix3::Zero())
                                                : core::Matrix3(core::Vector3(0.2, 0.1, 0.2).asDiagonal());
  b.initial.orientation = core::Quaternion(Eigen::AngleAxisd(angle, core::Vector3::UnitZ()));
  if (type != core::JointType::distance) b.initial.angular_velocity = {0, 0, rate};
  b.initial.velocity = core::Vector3(0, 0, rate).cross(b.initial.position);
  scene.bodies = {b};
  scene.forces.emplace_back(core::UniformGravity{});
  core::Joint joint;
  joint.type = type;
  joint.axis = core::Vector3::UnitZ();
  joint.length = b.initial.position.norm();
  scene.joints.push_back(joint);
  return scene;
}

// Rates about that of the separatrix from `angle`, w = 2 w0 cos(angle/2) for the moment of inertia `moment`.
void expect_plane_swings_agree(core::JointType type, core::Truth (*other)(const core::Scene&, double),
                               double moment) {
  const double w0 = std::sqrt(1.3 * 9.81 * 0.7 / (moment + 1.3 * 0.49));
  for (const double angle : {0.0, 0.4, -2.0, 3.1}) {
    for (const double part : {0.0, 0.5, -0.999, 1.001, -1.01, 3.0}) {
      if (angle == 0 && part == 0) continue;
      SCOPED_TRACE(testing::Message() << "from " << angle << " with " << part << " of the separatrix");
      const double rate = part * 2 * w0 * std::cos(angle / 2);
      core::Scene hinged = pendulum(angle, rate, core::JointType::hinge);
      if (moment == 0) hinged.bodies[0].inertia.setZero();
      const core::Truth one = physical_pendulum(hinged, 6), two = other(pendulum(angle, rate, type), 6);
      for (double t : {0.0, 0.6, 1.7, 3.4, 6.0}) {
        const core::BodyState a = one.state(t)[0], b = two.state(t)[0];
        EXPECT_LE((a.position - b.position).norm(), one.error.position + two.error.position);
        EXPECT_LE((a.velocity - b.velocity).norm(), one.error.velocity + two.error.velocity);
        if (moment > 0) {
          EXPECT_LE(angle_between(a.orientation, b.orientation),
                    one.error.orientation + two.error.orientation);
        }
      }
      EXPECT_LE(one.error.position, 1e-10);
    }
  }
}

TEST(SmoothForms, plane_swing_of_a_top) { expect_plane_swings_agree(core::JointType::ball, heavy_top, 0.2); }
TEST(SmoothForms, plane_swing_of_a_bob) {
  expect_plane_swings_agree(core::JointType::distance, spherical_pendulum, 0);
}

// As near to the separatrix as doubles tell: the energy stays, and the bound grows as the phase is lost.
TEST(SmoothForms, next_to_the_separatrix) {
  double before = 0;
  for (const double off : {1e-2, -1e-6, 1e-9, -1e-12}) {
    const double w0 = std::sqrt(1.3 * 9.81 * 0.7 / (0.2 + 1.3 * 0.49));
    core::Scene scene = pendulum(0.4, (1 + off) * 2 * w0 * std::cos(0.2), core::JointType::hinge);
    const core::Truth truth = physical_pendulum(scene, 8);
    const auto energy = [](const core::BodyState& s) {
      return (0.2 + 1.3 * 0.49) / 2 * s.angular_velocity.squaredNorm() + 1.3 * 9.81 * s.position.y();
    };
    const double start = energy(scene.bodies[0].initial);
    for (int k = 0; k <= 80; ++k) EXPECT_NEAR(energy(truth.state(0.1 * k)[0]), start, 1e-13 * 20);
    EXPECT_GT(truth.error.position, before);
    before = truth.error.position;
  }
  EXPECT_LE(before, 1e-2);
}

// Height kept, w^2 = g/(l cos(angle)); and at rest at the bottom for ever.
TEST(SmoothForms, conical_pendulum) {
  for (const double angle : {1e-3, 0.3, 1.0, 1.5}) {
    core::Scene scene = pendulum(angle, 0, core::JointType::distance);
    const double w = std::sqrt(9.81 / (0.7 * std::cos(angle)));
    core::BodyState& b = scene.bodies[0].initial;
    b.velocity = core::Vector3(0, w, 0).cross(b.position);
    const core::Truth truth = spherical_pendulum(scene, 6);
    for (const Wide t : {0.0L, 1.0L, 6.0L}) {
      const WideVector p = turn(WideVector::UnitY(), w * t) * widen(b.position);
      expect_state(truth.state(static_cast<double>(t))[0], p, WideVector(0, w, 0).cross(p), truth.error);
    }
  }
  const core::Scene rest = pendulum(0, 0, core::JointType::distance);
  EXPECT_LE((spherical_pendulum(rest, 5).state(5)[0].position - rest.bodies[0].initial.position).norm(),
            1e-18);
}

// No torque about the hinge: it turns on.
TEST(SmoothForms, hinge_without_weight) {
  core::Scene scene = pendulum(0.4, 1.5, core::JointType::hinge);
  scene.forces = {core::UniformGravity{{0, 0, -9.81}}};
  const core::BodyState s = physical_pendulum(scene, 5).state(5)[0];
  const core::Quaternion turned(Eigen::AngleAxisd(7.5, core::Vector3::UnitZ()));
  EXPECT_LE((s.position - turned * scene.bodies[0].initial.position).norm(), 1e-14);
}

}  // namespace
}  // namespace cylon::exact
