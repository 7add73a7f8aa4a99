// Seed eq. 84 as it should read (errata 23): the kinetic energy changes by the works of the forces.
#include "tests/engine/fixtures.h"

namespace cylon::engine {
namespace {

Options accounting(std::string_view integrator, Time dt) {
  Options options = with(integrator, dt);
  options.account = true;
  return options;
}

// Kinetic energy gained less the works of all forces [J].
Real missing(const Model& model, std::string_view integrator, Time duration, int steps) {
  const Outcome end = run(model, accounting(integrator, duration / steps), steps);
  EXPECT_EQ(end.works.size(), model.forces.count());
  Real works = 0;
  for (const Real w : end.works) works += w;
  return kinetic_energy(end.bodies, end.motions) - kinetic_energy(model.bodies, model.motions) - works;
}

class Balance : public EveryIntegrator {};

// A kick's work is counted with the mean of the speeds before and after it, which is its gain of energy to
// the last digit, and a drift has none: splittings balance without truncation.
TEST_P(Balance, IsKeptWithoutDrag) {
  Model model = coupled_bodies();
  model.forces.gravity = {0.3, -9.81, 0.7};
  model.forces.springs.push_back({1, {0.2, 0.1, -0.3}, fixed_world, {0.6, 1.9, 0.4}, 25.0, 0.5, 0});
  model.forces.drives.push_back({0, {0.9, 0.4, -1.1}, 2.3});
  const Real coarse = std::abs(missing(model, GetParam().name, 1, 64));
  if (GetParam().kind == Kind::splitting) {
    EXPECT_LT(coarse, 64 * GetParam().evaluations * 4e-15);  // an ulp of 20 J a kick
  } else if (GetParam().order == 8) {
    EXPECT_LT(coarse, 1e-8);
  } else {
    const int n = GetParam().order == 4 ? 128 : 16384;
    EXPECT_NEAR(std::log2(std::abs(missing(model, GetParam().name, 1, n) /
                                   missing(model, GetParam().name, 1, 2 * n))),
                GetParam().order, 0.2);
  }
}

// With drag and damping: Runge-Kutta integrators balance to their order; splittings count each kick's work
// with the mean speed, which is second order whatever the integrator's.
TEST_P(Balance, HoldsToTruncationWithDrag) {
  const Model model = forced_bodies();
  const bool splitting = GetParam().kind == Kind::splitting;
  if (!splitting && GetParam().order == 8) {
    EXPECT_LT(std::abs(missing(model, GetParam().name, 1, 200)), 1e-11);
    return;
  }
  const int order = splitting ? 2 : GetParam().order;
  const int n = order == 4 ? 256 : order == 2 ? 1024 : 16384;
  const Real coarse = missing(model, GetParam().name, 1, n), fine = missing(model, GetParam().name, 1, 2 * n);
  EXPECT_NEAR(std::log2(std::abs(coarse / fine)), order, 0.2);
}

CYLON_EVERY_SCHEME(Balance);

// Each force's own work against its closed form.
TEST(Work, OfEachForceIsItsClosedForm) {
  const Model model = forced_bodies();
  const Time t = 1;
  std::vector<std::vector<Motion>> seen = {model.motions};
  const int n = 1000;
  const Outcome end =
      run(model, accounting("rk8", t / n), n, [&](const World& w) { seen.push_back(w.motions()); });
  // gravity: m g.(p' - p)
  Real gravity = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    gravity +=
        model.bodies[i].mass * model.forces.gravity.dot(end.motions[i].position - model.motions[i].position);
  }
  EXPECT_NEAR(end.works[0], gravity, 1e-11);
  // The rest by Simpson's rule over the samples, from the motion alone:  h^4/180 of a fourth derivative of
  // 1e4
  const auto integrate = [&](auto power) {
    Real sum = 0;
    for (int i = 0; i <= n; ++i) {
      const Real weight = i == 0 || i == n ? 1 : i % 2 == 1 ? 4 : 2;
      sum += weight * power(seen[static_cast<std::size_t>(i)], i * t / n);
    }
    return sum * t / n / 3;
  };
  const auto anchor_velocity = [&](const std::vector<Motion>& m, int body, const Vector3& anchor) -> Vector3 {
    if (body == fixed_world) return Vector3::Zero();
    const auto i = static_cast<std::size_t>(body);
    return velocity(model.bodies[i], m[i]) +
           angular_velocity(model.bodies[i], m[i]).cross(m[i].orientation * anchor);
  };
  for (std::size_t k = 0; k < 2; ++k) {
    const Spring& s = model.forces.springs[k];
    const auto stretch = [&](const std::vector<Motion>& m) {
      return (place(m, s.to, s.to_anchor) - place(m, s.body, s.anchor)).norm() - s.rest_length;
    };
    // Its energy given back, less what the damper takes.
    const Real stored =
        s.stiffness / 2 * (std::pow(stretch(end.motions), 2) - std::pow(stretch(model.motions), 2));
    const Real lost = integrate([&](const std::vector<Motion>& m, Time) {
      const Vector3 u = (place(m, s.to, s.to_anchor) - place(m, s.body, s.anchor)).normalized();
      const Real rate = u.dot(anchor_velocity(m, s.to, s.to_anchor) - anchor_velocity(m, s.body, s.anchor));
      return s.damping * rate * rate;
    });
    EXPECT_NEAR(end.works[1 + k], -stored - lost, 1e-9) << k;
    EXPECT_GT(lost, 0.01);
  }
  const Drag& d = model.forces.drags[0];
  EXPECT_NEAR(end.works[3], integrate([&](const std::vector<Motion>& m, Time) {
                const Vector3 v = velocity(model.bodies[0], m[0]),
                              w = angular_velocity(model.bodies[0], m[0]);
                return -d.linear * v.squaredNorm() - d.angular * w.squaredNorm() -
                       d.momentum * w.dot(m[0].angular_momentum);
              }),
              1e-9);
  EXPECT_NEAR(end.works[4], integrate([&](const std::vector<Motion>& m, Time now) {
                return std::cos(2.3 * now) *
                       model.forces.drives[0].force.dot(velocity(model.bodies[0], m[0]));
              }),
              1e-9);
}

// Joints work on nothing: the balance holds without them, pinned bodies too.
TEST(Work, JointsDoNone) {
  for (const Model& model : {heavy_top(), linked_bodies(true), linked_bodies(false)}) {
    EXPECT_NEAR(missing(model, "rk8", 1, 1000), 0, 1e-11);
  }
  Model damped = heavy_top();
  damped.forces.drags.push_back({0, 0.1, 0.001, 0.05});
  EXPECT_NEAR(missing(damped, "rk8", 1, 1000), 0, 1e-11);
  EXPECT_GT(std::abs(kinetic_energy(damped.bodies, run(damped, "rk8", 1, 1000).motions) -
                     kinetic_energy(damped.bodies, damped.motions)),
            0.05);
}

TEST(Work, IsCountedOnlyOnRequest) { EXPECT_TRUE(run(forced_bodies(), "rk4", 0.1, 10).works.empty()); }

// The account changes nothing in the motion.
TEST(Work, CountingDoesNotChangeMotion) {
  for (const Integrator& integrator : fixed_integrators()) {
    const Outcome a = run(forced_bodies(), with(integrator.name, 0.01), 100),
                  b = run(forced_bodies(), accounting(integrator.name, 0.01), 100);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_TRUE(same_bits(a.motions[i], b.motions[i])) << integrator.name;
  }
}

}  // namespace
}  // namespace cylon::engine
