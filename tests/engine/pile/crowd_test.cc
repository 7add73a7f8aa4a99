// Many boxes by sweeps: they come to rest, stay there at no cost, and wake when something touches them.
#include "engine/pile/body_pile.h"
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

namespace cylon::engine {
namespace {

constexpr Real half = Real(0.5);
constexpr double dt = 1. / 60;

// Cubes a little out of line, dropped into an open box.
Model dropped(int side, int layers) {
  Model model = ball_pile(side, layers, 0, Real(0.5));
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    model.bodies[i] = make_body(1, Matrix3::Identity() / 6);
    model.shapes[i] = Box{Vector3::Constant(half)};
  }
  return model;
}

Real fastest(const std::vector<Motion>& motions) {
  Real most = 0;
  for (const Motion& m : motions) most = std::max({most, m.momentum.norm(), m.angular_momentum.norm()});
  return most;
}

Real lowest(const std::vector<Motion>& motions) {
  Real low = motions.front().position.y();
  for (const Motion& m : motions) low = std::min(low, m.position.y());
  return low;
}

// Until the sweeps had springs where bodies overlap, towers of three rocked at centimetres a second for ever.
TEST(PileCrowd, DroppedCubesComeToRest) {
  const auto stepper = make_pile(dropped(4, 4), dt);
  const auto end = after(*stepper, 300);
  EXPECT_LT(fastest(end), Real(1e-4));
  EXPECT_GT(lowest(end), half - Real(3e-4));
  // Not all of it by chance: they fell, and have not sunk in.
  EXPECT_LT(end.back().position.y(), Real(3.6));
  EXPECT_GT(end.back().position.y(), Real(3.49));
}

// Sweeps leave 1e-4 of a cube; what comes to rest is solved to rounding before.
TEST(PileCrowd, AtRestNothingOverlaps) {
  const Model model = dropped(4, 4);
  const auto end = after(*make_pile(model, dt), 400);
  EXPECT_EQ(fastest(end), 0);
  const Real deepest = Real(1.01) * PileSettings().direct_slop * half;
  EXPECT_GT(lowest(end), half - deepest);
  EXPECT_LT(lowest(end), half);
  for (std::size_t i = 0; i < end.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Vector3 apart = (end[i].position - end[k].position).cwiseAbs();
      EXPECT_GT(apart.maxCoeff(), 2 * half - deepest) << k << " and " << i;
    }
}

// Fourteen columns, whose contacts are too many to be solved to rounding in every step.
Model columns() {
  Model model = pile_model(0, Real(0.5));
  for (int i = 0; i < 14; ++i)
    for (int k = 0; k < 5; ++k)
      add_box(model, 1, Vector3::Constant(half),
              {Real(1.5) * static_cast<Real>(i), half + static_cast<Real>(k), 0});
  return model;
}

TEST(PileCrowd, AtRestNothingMovesAtAll) {
  const auto stepper = make_pile(columns(), dt);
  const auto early = after(*stepper, 10), late = after(*stepper, 200);
  for (std::size_t i = 0; i < early.size(); ++i) {
    EXPECT_EQ(early[i].position, late[i].position) << i;
    EXPECT_EQ(early[i].orientation.coeffs(), late[i].orientation.coeffs()) << i;
  }
}

// A cube on its edge, 1e-5 degrees from balance, gains less speed in a step than what is laid to rest may have:
// it was frozen there for ever where a scene had more than 64 contact points.  Beside it one that lies.
TEST(PileCrowd, ACubeOnItsEdgeFalls) {
  for (const Real tilt : {Real(1e-5), Real(1e-3)}) {
    Model model = columns();
    const Real angle = (45 + tilt) * std::numbers::pi_v<Real> / 180;
    const int fallen = static_cast<int>(model.bodies.size());
    add_box(model, 1, Vector3::Constant(half), {-5, std::sqrt(half), 0});
    model.motions.back().orientation = exponential(Vector3(0, 0, angle));
    const auto stepper = make_pile(model, dt);
    const auto early = after(*stepper, 60), end = after(*stepper, 600);
    EXPECT_GT(early[static_cast<std::size_t>(fallen)].position.y(), Real(0.7)) << tilt;
    EXPECT_NEAR(end[static_cast<std::size_t>(fallen)].position.y(), half, Real(1e-3)) << tilt;
    for (std::size_t i = 0; i + 1 < model.bodies.size(); ++i) EXPECT_EQ(early[i].position, end[i].position);
  }
}

// What presses the floor is the weight, at rest as before it.
TEST(PileCrowd, ContactsAtRestTellTheirImpulses) {
  const Model model = columns();
  const auto stepper = make_pile(model, dt);
  stepper->keep_contacts(true);
  for (const int steps : {1, 50}) {
    after(*stepper, steps);
    Real sum = 0;
    for (const Contact& contact : stepper->contacts())
      if (contact.plane == 0) sum += *contact.impulse;
    EXPECT_NEAR(sum, static_cast<Real>(model.bodies.size()) * g * static_cast<Real>(dt), Real(1e-3) * sum)
        << steps;
  }
}

// A cube that arrives after a while knocks one column over; the others do not move.
TEST(PileCrowd, WakesWhatIsStruckAndNothingElse) {
  Model model = columns();
  const std::size_t struck = 5 * 13 + 4;  // the last column's top
  add_box(model, 2, Vector3::Constant(half), {Real(1.5) * 13 + 8, Real(6), 0}, {-8, Real(3.5), 0});
  const auto stepper = make_pile(model, dt);
  const auto before = after(*stepper, 40), end = after(*stepper, 80);
  EXPECT_LT((before[struck].position - model.motions[struck].position).norm(), Real(1e-6));
  EXPECT_GT((end[struck].position - model.motions[struck].position).norm(), Real(0.3));
  constexpr std::size_t sleepers = 50;
  for (std::size_t i = 0; i < sleepers; ++i) EXPECT_EQ(before[i].position, end[i].position) << i;
}

// v_after = e v_before, cube by cube; none without restitution.
TEST(PileCrowd, BouncesAsNewtonsLawSays) {
  for (const Real e : {Real(0), Real(0.6)}) {
    Model model = pile_model(e, Real(0.5));
    const Real h = Real(0.3), fall = std::sqrt(2 * g * h);
    for (int i = 0; i < 40; ++i)
      add_box(model, 1, Vector3::Constant(half), {2 * static_cast<Real>(i), half + h, 0});
    const auto stepper = make_pile(model, 1. / 240);
    Real most = 0;
    std::vector<Motion> now;
    for (int k = 0; k < 100; ++k) {
      stepper->step(), stepper->read(now);
      for (const Motion& m : now) most = std::max(most, m.momentum.y());
    }
    EXPECT_NEAR(most, e * fall, Real(0.05) * fall) << e;
  }
}

// a = g (sin - mu cos) for forty boxes on an incline at once, and none slides where friction holds it.
TEST(PileCrowd, SlidesAsCoulombsLawSays) {
  const Real angle = Real(0.35);
  const Vector3 normal(-std::sin(angle), std::cos(angle), 0), down(-std::cos(angle), -std::sin(angle), 0);
  const Quaternion turn(Eigen::AngleAxis<Real>(angle, Vector3::UnitZ()));
  for (const Real friction : {Real(0.2), Real(0.5)}) {
    Model model = pile_model(0, friction);
    model.planes[0] = {normal, 0};
    for (int i = 0; i < 40; ++i)
      add_box(model, 2, Vector3(half, Real(0.3), Real(0.4)),
              Real(0.3) * normal + Vector3(0, 0, static_cast<Real>(i)), Vector3::Zero(), Vector3::Zero(),
              turn);
    const auto end = after(*make_pile(model, 1. / 240), 240);
    const Real a = std::max(g * (std::sin(angle) - friction * std::cos(angle)), Real(0));
    for (std::size_t i = 0; i < end.size(); ++i)
      EXPECT_NEAR(down.dot(end[i].position - model.motions[i].position), a / 2, Real(0.01)) << friction;
  }
}

// A crowd's pass over bounces took up to half of the energy, a step before the impact, and turned flat boxes.
TEST(PileCrowd, ElasticBouncesOfManyKeepEnergyAndDoNotTurn) {
  Model model = pile_model(1, 0);
  for (int i = 0; i < 45; ++i)
    add_box(model, 1, Vector3::Constant(Real(0.2)), {static_cast<Real>(i), Real(0.6), 0});
  const auto end = after(*make_pile(model, 0.001), 400);
  EXPECT_NEAR(mechanical_energy(model, end) / mechanical_energy(model, model.motions), 1, 0.01);
  for (const Motion& m : end) {
    EXPECT_GT(m.momentum.y(), 0) << "on its way up";
    EXPECT_LT(m.angular_momentum.norm(), Real(1e-5));
  }
}

// Kept contacts gave the point of a rolling ball a lever, which drove it from 0.010 to 0.026 m/s.
TEST(PileCrowd, BallAmongManyRollsOnAsItWas) {
  Model model = pile_model(0, Real(0.5));
  for (int i = 0; i < 40; ++i)
    add_box(model, 1, Vector3::Constant(Real(0.2)), {static_cast<Real>(i), Real(0.2), 5});
  add_ball(model, 1, half, {0, half, 0}, {Real(0.01), 0, 0}, {0, 0, Real(-0.02)});
  const auto end = after(*make_pile(model, 0.01), 1000);
  EXPECT_NEAR(end.back().momentum.x(), Real(0.01), Real(1e-5));
}

// A box that was at rest in a crowd, was hit while there were few contacts, and hung where it was once there
// were many again.
TEST(PileCrowd, WhoIsHitWhileFewTouchGoesOn) {
  const auto place_of_struck = [](int hopping) {
    Model model = pile_model(Real(0.3), Real(0.1));
    for (int i = 0; i < 15; ++i)
      add_box(model, 1, Vector3::Constant(Real(0.2)), {0, Real(0.2), Real(0.5) * static_cast<Real>(i)});
    add_ball(model, 1, Real(0.1), {Real(-0.5), Real(0.25), 0}, {5, Real(0.2), 0});  // meets at 0.04 s
    for (int i = 0; i < hopping; ++i)  // 66 contact points at first, and from 0.09 s on
      add_ball(model, 1, Real(0.1), {5 + static_cast<Real>(i), Real(0.1), 0}, {0, -1, 0});
    return after(*make_pile(model, 0.002), 200)[0].position.x();
  };
  const Real alone = place_of_struck(0);
  EXPECT_GT(alone, Real(0.3));
  EXPECT_NEAR(place_of_struck(6), alone, Real(0.02));
}

// Where nothing sleeps, what lies still is swept in every step: it may creep, and costs what it cost.
TEST(PileCrowd, NothingRestsWhereThatIsNotWanted) {
  const Model model = columns();
  PileSettings settings;
  const auto sleeps = make_pile(model, dt, settings);
  settings.rest = false;
  const auto wakes = make_pile(model, dt, settings);
  after(*sleeps, 20), after(*wakes, 20);
  const std::int64_t asleep = sleeps->operations(), awake = wakes->operations();
  const auto end = after(*sleeps, 20), moved = after(*wakes, 20);
  EXPECT_EQ(fastest(end), 0);
  EXPECT_GT(fastest(moved), 0);
  EXPECT_LT(fastest(moved), Real(1e-3));
  EXPECT_GT(wakes->operations() - awake, 5 * (sleeps->operations() - asleep));
}

TEST(PileCrowd, GivesTheSameBitsOnAnyNumberOfThreads) {
  const Model model = dropped(4, 3);
  PileSettings settings;
  const auto one = after(*make_pile(model, dt, settings), 60);
  settings.threads = 4;
  const auto four = after(*make_pile(model, dt, settings), 60);
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].position, four[i].position) << i;
}

}  // namespace
}  // namespace cylon::engine
