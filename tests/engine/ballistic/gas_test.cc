// Gases of spheres: what mechanics conserves, and the symmetries under which a scene and its run must change
// alike.  A gas amplifies every difference, by about a factor of path length over radius at each hit; so
// where a transformation rounds (turning, shifting), runs are compared over the first few hits of each body
// only.
#include "tests/engine/ballistic/ballistic_fixture.h"

#include "engine/rotation.h"

namespace cylon::engine::ballistic_test {
namespace {

constexpr double rounding = std::numeric_limits<Real>::epsilon();

Model boxed_gas(int side, const Material& material, std::uint64_t seed, bool spinning = false) {
  Model model = spheres_of(material);
  add_box(model, 1);
  add_gas(model, side, 1, Real(0.5) / static_cast<Real>(side), seed, spinning);
  return model;
}

Model free_gas(std::uint64_t seed, const Material& material = {1, 0}) {
  Model model = spheres_of(material, {Real(0.3), Real(-1.7), Real(0.6)});
  add_gas(model, 4, 1, Real(0.14), seed, true);
  return model;
}

// 1000 spheres for 10 s, some 5e4 impacts, each of which rounds some ulps of the energy of two spheres: as a
// random walk sqrt(5e4) * 4 ulp / 1000, far below; the claim is 1e-13 in double.
TEST(BallisticGas, EnergyStaysToRounding) {
  const Model model = boxed_gas(10, {1, 0}, 7);
  const Outcome end = run(model, 1.0 / 64, 640);
  EXPECT_FALSE(end.handover);
  EXPECT_GT(end.impacts.size(), 30000u);
  EXPECT_LE(std::abs(energy(model, end.motions) / energy(model, model.motions) - 1), 450 * rounding);
}

TEST(BallisticGas, SpheresStayInClosedBox) {
  for (const Real e : {Real(1), Real(0.9)}) {
    Model model = spheres_of({e, Real(0.3)}, {Real(0.4), Real(-0.9), Real(0.2)});
    const Quaternion r = exponential({Real(0.4), Real(-0.8), Real(0.3)});
    add_box(model, 1, r);
    add_gas(model, 5, 1, Real(0.1), 3, true);
    for (Motion& m : model.motions) m.position = r * m.position;
    const auto stepper = make_ballistic(model, 1.0 / 32);
    std::vector<Motion> motions;
    std::size_t impacts = 0;
    for (int i = 0; i < 64 && !stepper->handover(); ++i) {
      stepper->step();
      impacts += stepper->impacts().size();
      stepper->read(motions);
      for (std::size_t k = 0; k < motions.size(); ++k) {
        ASSERT_TRUE(motions[k].position.allFinite() && motions[k].momentum.allFinite() &&
                    motions[k].orientation.coeffs().allFinite() && motions[k].angular_momentum.allFinite());
        for (const Plane& plane : model.planes)
          ASSERT_GE(
              plane.normal.dot(motions[k].position) - plane.offset - std::get<Sphere>(model.shapes[k]).radius,
              -16 * ulp);
      }
    }
    EXPECT_GT(impacts, 300u) << e;
  }
}

TEST(BallisticGas, SpheresNeverOverlap) {
  const Model model = boxed_gas(5, {1, 0}, 12);
  const auto stepper = make_ballistic(model, 1.0 / 16);
  std::vector<Motion> motions;
  for (int i = 0; i < 64; ++i) {
    stepper->step();
    stepper->read(motions);
    for (std::size_t a = 0; a < motions.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        ASSERT_GE((motions[a].position - motions[b].position).norm() -
                      std::get<Sphere>(model.shapes[a]).radius - std::get<Sphere>(model.shapes[b]).radius,
                  -16 * ulp);
  }
}

// Without walls momentum and angular momentum stay too, with friction and restitution below 1 as well; under
// gravity once the fall is taken out: K - M g t, and L about the centre of mass.
TEST(BallisticGas, MomentumAndAngularMomentumStayToRounding) {
  for (const Material& material : {Material{1, 0}, Material{Real(0.7), Real(0.4)}}) {
    Model model = free_gas(5, material);
    for (Motion& m : model.motions) m.momentum -= Real(0.8) * m.position;  // towards each other
    const Outcome end = run(model, 1.0 / 32, 64);
    EXPECT_GT(end.impacts.size(), 40u);
    double mass = 0;
    for (const Body& b : model.bodies) mass += static_cast<double>(b.mass);
    const Eigen::Vector3d g = model.forces.gravity.cast<double>();
    const auto about_centre = [&](const std::vector<Motion>& motions) {
      Eigen::Vector3d centre = Eigen::Vector3d::Zero();
      for (std::size_t i = 0; i < motions.size(); ++i)
        centre += static_cast<double>(model.bodies[i].mass) * motions[i].position.cast<double>();
      return Eigen::Vector3d(angular_momentum(motions) - (centre / mass).cross(momentum(motions)));
    };
    // M g t = 64 * 3.7 kg m/s: 64 bodies each round their velocity of some 4 m/s once per impact
    EXPECT_LE((momentum(end.motions) - momentum(model.motions) - 2 * mass * g).norm(), 64 * 16 * rounding);
    EXPECT_LE((about_centre(end.motions) - about_centre(model.motions)).norm(), 64 * 64 * rounding);
  }
}

// Negative control: friction does turn, restitution below 1 does lose energy.
TEST(BallisticGas, FrictionAndRestitutionAct) {
  const Model smooth = boxed_gas(4, {1, 0}, 5), rough = boxed_gas(4, {1, Real(0.4)}, 5),
              soft = boxed_gas(4, {Real(0.9), 0}, 5);
  const double start = energy(smooth, smooth.motions);
  const Outcome a = run(smooth, 1.0 / 16, 32), b = run(rough, 1.0 / 16, 32), c = run(soft, 1.0 / 16, 32);
  EXPECT_EQ(a.motions[7].angular_momentum.norm(), 0);
  EXPECT_GT(b.motions[7].angular_momentum.norm(), 1e-3);
  EXPECT_LT(energy(rough, b.motions), 0.99 * start);
  EXPECT_LT(energy(soft, c.motions), 0.9 * start);
}

// Back and forth: each hit amplifies rounding by about 2 * path / radius ~ 10; some five hits per sphere.
TEST(BallisticGas, TimeReversal) {
  const Model model = boxed_gas(4, {1, 0}, 9);
  const Outcome there = run(model, 0.25, 4);
  EXPECT_GT(there.impacts.size(), 100u);
  Model back = model;
  back.motions = there.motions;
  for (Motion& m : back.motions) m.momentum = -m.momentum;
  Outcome again = run(back, 0.25, 4);
  EXPECT_EQ(again.impacts.size(), there.impacts.size());
  for (Motion& m : again.motions) m.momentum = -m.momentum;
  EXPECT_LE(distance(model, again.motions, model.motions), 1e6 * rounding);
}

// The stepper's clock does not enter: the same events, with the same bits, however the time is cut into
// steps.
TEST(BallisticGas, BitsDoNotDependOnStep) {
  const Model model = free_gas(21);
  const Outcome coarse = run(model, 2.0, 1), fine = run(model, 1.0 / 128, 256);
  ASSERT_EQ(coarse.impacts.size(), fine.impacts.size());
  EXPECT_GT(coarse.impacts.size(), 20u);
  for (std::size_t i = 0; i < model.bodies.size(); ++i)
    EXPECT_TRUE(same_bits(coarse.motions[i], fine.motions[i])) << i;
}

// run(T1 + T2) = run(T2) after run(T1); the state in between is rounded once.
TEST(BallisticGas, SplitRun) {
  const Model model = boxed_gas(4, {1, Real(0.2)}, 33, true);
  const Outcome whole = run(model, 0.125, 8), half = run(model, 0.125, 4);
  Model rest = model;
  rest.motions = half.motions;
  const Outcome joined = run(rest, 0.125, 4);
  EXPECT_EQ(half.impacts.size() + joined.impacts.size(), whole.impacts.size());
  EXPECT_LE(distance(model, whole.motions, joined.motions), 1e5 * rounding);
}

// The order in which bodies are given is not seen by a bit: a pair's event is computed from the pair alone.
// (Unless two events fall on one instant, which they do not here.)
TEST(BallisticGas, BitsDoNotDependOnBodyOrder) {
  const Model model = boxed_gas(4, {1, Real(0.2)}, 17, true);
  const std::size_t n = model.bodies.size();
  Model shuffled = model;
  const auto at = [n](std::size_t i) { return (i * 37 + 11) % n; };  // 37 has no factor in common with 64
  for (std::size_t i = 0; i < n; ++i) {
    shuffled.bodies[at(i)] = model.bodies[i];
    shuffled.motions[at(i)] = model.motions[i];
    shuffled.shapes[at(i)] = model.shapes[i];
  }
  const Outcome a = run(model, 0.5, 4), b = run(shuffled, 0.5, 4);
  EXPECT_GT(a.impacts.size(), 200u);
  for (std::size_t i = 0; i < n; ++i) EXPECT_TRUE(same_bits(a.motions[i], b.motions[at(i)])) << i;
}

// Length times 4, mass times 8, time times 2: every number changes by a power of two, no mantissa does.
TEST(BallisticGas, ScalingByPowersOfTwoIsExact) {
  for (const Impacts impacts : {Impacts::sequential, Impacts::simultaneous}) {
    Model model = free_gas(41, {Real(0.8), Real(0.3)});
    add_plane(model, {Real(0.2), Real(0.9), Real(-0.3)}, Real(-1.9));
    model.impacts = impacts;
    Model scaled = model;
    const Real length = 4, mass = 8, time = 2;
    scaled.forces.gravity *= length / (time * time);
    scaled.planes[0].offset *= length;
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
      scaled.bodies[i] =
          make_body(mass * model.bodies[i].mass, mass * length * length * model.bodies[i].inertia);
      scaled.motions[i].position *= length;
      scaled.motions[i].momentum *= mass * length / time;
      scaled.motions[i].angular_momentum *= mass * length * length / time;
      std::get<Sphere>(scaled.shapes[i]).radius *= length;
    }
    const Outcome a = run(model, 1.0 / 16, 24), b = run(scaled, 2.0 / 16, 24);
    EXPECT_GT(a.impacts.size(), 30u);
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
      Motion m = b.motions[i];
      m.position /= length;
      m.momentum /= mass * length / time;
      m.angular_momentum /= mass * length * length / time;
      EXPECT_TRUE(same_bits(m, a.motions[i])) << i;
    }
  }
}

struct Relation {
  const char* name;
  Quaternion turn = Quaternion::Identity();
  Vector3 shift = Vector3::Zero(), boost = Vector3::Zero();
  bool mirror = false;
};

// Translation, rotation, Galilei's boost and the mirror of a gas that falls freely and collides with
// friction.
TEST(BallisticGas, SymmetriesOfMechanics) {
  const Relation relations[] = {
      {"translation", Quaternion::Identity(), {Real(0.7), Real(-1.9), Real(0.4)}},
      {"rotation", exponential({Real(0.5), Real(-1.1), Real(0.8)})},
      {"boost", Quaternion::Identity(), Vector3::Zero(), {Real(1.3), Real(-0.4), Real(2.1)}},
      {"mirror", Quaternion::Identity(), Vector3::Zero(), Vector3::Zero(), true},
  };
  const Model model = free_gas(77, {Real(0.9), Real(0.3)});
  const Time end = 1.5;
  const Outcome plain = run(model, end / 8, 8);
  EXPECT_GT(plain.impacts.size(), 20u);
  for (const Relation& relation : relations) {
    const Vector3 flip(relation.mirror ? -1 : 1, 1, 1);
    const auto polar = [&](const Vector3& v) -> Vector3 {
      return relation.turn * Vector3(flip.asDiagonal() * v);
    };
    const auto axial = [&](const Vector3& v) -> Vector3 { return (relation.mirror ? -1 : 1) * polar(v); };
    const auto change = [&](const std::vector<Motion>& motions, Time t) {
      std::vector<Motion> changed = motions;
      for (std::size_t i = 0; i < changed.size(); ++i) {
        changed[i].position =
            polar(motions[i].position) + relation.shift + static_cast<Real>(t) * relation.boost;
        changed[i].momentum = polar(motions[i].momentum) + model.bodies[i].mass * relation.boost;
        changed[i].angular_momentum = axial(motions[i].angular_momentum);
      }
      return changed;
    };
    Model other = model;
    other.motions = change(model.motions, 0);
    other.forces.gravity = polar(model.forces.gravity);
    const Outcome result = run(other, end / 8, 8);
    EXPECT_EQ(result.impacts.size(), plain.impacts.size()) << relation.name;
    const auto expected = change(plain.motions, end);
    EXPECT_LE(distance(model, result.motions, expected), 1e5 * rounding) << relation.name;
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_LE((result.motions[i].angular_momentum - expected[i].angular_momentum).norm(), 1e5 * rounding)
          << relation.name;
  }
}

// A grid of cells and the plain search over all pairs find the same events: a cloud that flies apart leaves
// its grid, and one sphere is too large for it.
TEST(BallisticGas, LargeSpheresAndOpenSpace) {
  Model model = spheres_of({1, 0});
  add_gas(model, 5, 1, Real(0.08), 51);
  for (Motion& m : model.motions) m.momentum -= Real(0.9) * m.position;
  add_sphere(model, 40, Real(0.9), {Real(3.1), Real(0.4), Real(-0.2)}, {Real(-0.8), 0, 0});
  const double start = energy(model, model.motions);
  const auto stepper = make_ballistic(model, 1.0 / 16);
  std::vector<Motion> motions;
  std::size_t impacts = 0, with_large = 0;
  for (int i = 0; i < 160; ++i) {
    stepper->step();
    impacts += stepper->impacts().size();
    for (const Impact& hit : stepper->impacts()) with_large += hit.other == 125 ? 1 : 0;
    stepper->read(motions);
    for (std::size_t a = 0; a < motions.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        ASSERT_GE((motions[a].position - motions[b].position).norm() -
                      std::get<Sphere>(model.shapes[a]).radius - std::get<Sphere>(model.shapes[b]).radius,
                  -64 * ulp);
  }
  EXPECT_GT(impacts, 60u);
  EXPECT_GT(with_large, 5u);
  EXPECT_LE(std::abs(energy(model, motions) / start - 1), 450 * rounding);
}

}  // namespace
}  // namespace cylon::engine::ballistic_test
