// Spheres that lie on something: solved to rounding where they are few or stand, however the scene is turned.
#include "engine/pile/solved_spheres.h"
#include "engine/event_stepper.h"
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::engine {
namespace {

// A regular tetrahedron of equal balls, `layers` along each edge, on the floor.
Model tetrahedron(int layers, Real friction) {
  Model model = pile_model(0, friction);
  const Real r = Real(0.1), d = 2 * r, rise = d * std::sqrt(Real(2) / 3);
  for (int layer = 0; layer < layers; ++layer)
    for (int i = 0; i < layers - layer; ++i)
      for (int j = 0; j < layers - layer - i; ++j) {
        const Real x = static_cast<Real>(i), z = static_cast<Real>(j), y = static_cast<Real>(layer);
        add_ball(model, 1, r,
                 {d * (x + z / 2 + y / 2), r + y * rise, d * std::sqrt(Real(3)) * (z / 2 + y / 6)});
      }
  return model;
}

Real farthest(const std::vector<Motion>& one, const std::vector<Motion>& other) {
  Real most = 0;
  for (std::size_t i = 0; i < one.size(); ++i)
    most = std::max(most, (one[i].position - other[i].position).norm());
  return most;
}

// A ball on three stands where friction is at least tan(a/2), a = asin(1/sqrt 3) the angle of its contacts with the
// vertical: all forces on a ball of the base, its weight apart, go through two points of it.
const Real least_of_four = std::tan(std::asin(1 / std::sqrt(Real(3))) / 2);

struct Pile {
  int layers;
  Real friction;
  bool stands;
};

class Tetrahedron : public testing::TestWithParam<Pile> {};

// What stands with some friction stands with more: at 0.9 to 1.1 ten balls have another solution, in which they part.
TEST_P(Tetrahedron, StandsToRoundingWhereItCan) {
  const auto [layers, friction, stands] = GetParam();
  const Model model = tetrahedron(layers, friction);
  const auto stepper = make_pile(model, 1. / 240);
  const Real moved = farthest(after(*stepper, 480), model.motions);
  if (stands)
    EXPECT_LT(moved, 1000 * eps);
  else
    EXPECT_GT(moved, Real(0.1));
}

INSTANTIATE_TEST_SUITE_P(All, Tetrahedron,
                         testing::Values(Pile{2, Real(0.98) * least_of_four, false},
                                         Pile{2, Real(1.02) * least_of_four, true}, Pile{2, 1, true},
                                         Pile{3, Real(0.35), false}, Pile{3, Real(0.5), true},
                                         Pile{3, Real(0.8), true}, Pile{3, Real(0.9), true}, Pile{3, 1, true},
                                         Pile{3, Real(1.1), true}, Pile{3, 3, true},
                                         Pile{4, Real(0.5), false}, Pile{4, Real(0.8), true},
                                         Pile{4, 1, true}, Pile{5, 1, true}, Pile{8, 2, true}));

// Two balls at rest on a rough floor, and one that hits the first.
Model row_that_is_hit() {
  Model model = pile_model(0, Real(0.87));
  add_ball(model, Real(0.3), Real(0.11), {Real(0.38), Real(0.11), 0});
  add_ball(model, 5, Real(0.08), {Real(0.6), Real(0.08), 0});
  add_ball(model, Real(0.3), Real(0.098), {Real(-0.27), Real(0.1), 0}, {Real(1.7), Real(0.3), 0});
  model.impacts = Impacts::simultaneous;
  return model;
}

std::vector<Motion> turned(const Quaternion& q, std::vector<Motion> motions) {
  for (Motion& m : motions) {
    m.position = q * m.position, m.orientation = q * m.orientation;
    m.momentum = q * m.momentum, m.angular_momentum = q * m.angular_momentum;
  }
  return motions;
}

Model turned(const Quaternion& q, Model model) {
  model.motions = turned(q, model.motions);
  model.forces.gravity = q * model.forces.gravity;
  for (Plane& plane : model.planes) plane.normal = q * plane.normal;
  return model;
}

// Sweeps in the order of the balls in space left 9e-3 to 1e-3 m between scenes turned against each other, at steps of 1/240
// to 1/15360 s, and so far from events.
TEST(SolvedSpheres, MoveAlikeHoweverTheSceneIsTurned) {
  const Model model = row_that_is_hit();
  for (const int rate : {240, 960}) {
    const auto plain = after(*make_pile(model, 1. / rate), 3 * rate / 4);
    for (const Vector3& axis : {Vector3(1, 2, -1), Vector3(-3, 1, 2)}) {
      const Quaternion q(Eigen::AngleAxis<Real>(2, axis.normalized()));
      const auto other = after(*make_pile(turned(q, model), 1. / rate), 3 * rate / 4);
      EXPECT_LT(farthest(turned(q, plain), other), Real(1e6) * eps) << rate;
    }
  }
}

// Where nothing bounces impacts followed each other by events alone.
TEST(SolvedSpheres, TakeDullImpactsInTurnAsEventsDo) {
  Model model = pile_model(0, Real(0.1));
  add_ball(model, 5, Real(0.15), {Real(-0.15), Real(0.15), Real(0.02)}, {Real(1.89), 0, 0});
  add_ball(model, Real(0.3), Real(0.08), {Real(0.41), Real(0.08), Real(0.02)}, Vector3::Zero(), {13, -7, -3});
  add_ball(model, 5, Real(0.1), {Real(0.79), Real(0.1), Real(0.02)}, Vector3::Zero(), {-5, 8, 4});
  model.impacts = Impacts::sequential;
  EventStepper events(model, *find_integrator("dop853"), 0.05, Real(1e-11));
  const auto exact = after(events, 10);
  const auto error = [&] { return farthest(after(*make_pile(model, 1. / 15360), 7680), exact); };
  EXPECT_LT(error(), Real(1e-3));
  model.impacts = Impacts::simultaneous;
  EXPECT_GT(error(), Real(4e-3));
}

TEST(SolvedSpheres, ConvergeToEventsAtFirstOrder) {
  const Model model = row_that_is_hit();
  EventStepper events(model, *find_integrator("dop853"), 0.075, Real(1e-11));
  const auto exact = after(events, 10);
  const auto error = [&](int rate) {
    return farthest(after(*make_pile(model, 1. / rate), 3 * rate / 4), exact);
  };
  EXPECT_LT(error(1920), Real(5e-4));
  EXPECT_LT(error(7680), Real(1.3e-4));
}

// `many` at rest beside what happens: in all more than are solved to rounding.
Model beside(int many) {
  Model model = pile_model(0, 0);
  model.impacts = Impacts::sequential;
  for (int i = 0; i < many; ++i) {
    const int row = i / 6;
    add_ball(model, 1, Real(0.1),
             {Real(0.3) * static_cast<Real>(i % 6), Real(0.1), Real(0.3) * static_cast<Real>(row)});
  }
  return model;
}

// Of those that are swept the parts of a step gave a blow again and again: a quarter of it came back.
TEST(SweptSpheres, GiveNothingBackWithoutRestitution) {
  Model model = beside(36);
  add_ball(model, 1, Real(0.1), {0, Real(0.5), 0});
  const auto after_fall = after(*make_pile(model, 1e-3), 240);
  EXPECT_NEAR(after_fall[36].position.y(), 0.3, 1e-4);
  EXPECT_NEAR(after_fall[36].momentum.y(), 0, 1e-4);
}

// Two that touch are pushed by a third: all go on as one, at 2/7 of 2 m/s, as each was lighter or heavier.
TEST(SweptSpheres, PassABlowOnWithinItsInstant) {
  const auto off = [](int rate) {
    Model model = beside(36);
    add_ball(model, 1, Real(0.1), {Real(-0.25), Real(0.1), Real(-0.3)}, {2, 0, 0});
    add_ball(model, 1, Real(0.1), {0, Real(0.1), Real(-0.3)});
    add_ball(model, 5, Real(0.1), {Real(0.2), Real(0.1), Real(-0.3)});
    const auto end = after(*make_pile(model, 1. / rate), 3 * rate / 10);
    Real most = 0;
    for (std::size_t i = 36; i < 39; ++i)
      most = std::max(most, std::abs(end[i].momentum.x() / model.bodies[i].mass - Real(2) / 7));
    return most;
  };
  EXPECT_LT(off(1000), Real(0.02));
  EXPECT_LT(off(10000), Real(0.002));
}

// Until one lies on something each meets others at the instant at which it does.
TEST(SolvedSpheres, LocateImpactsInFlight) {
  Model model = pile_model(1, 0);
  model.forces.gravity.setZero();
  add_ball(model, 1, Real(0.1), {0, Real(0.55), 0}, {0, -1, 0});
  add_ball(model, 1, Real(0.1), {0, Real(1.7), 0}, {0, Real(-0.3), 0});
  // down 0.45, up until 0.2 lie between them
  const Real meet = Real(0.45), apart = Real(1.7) - Real(0.3) * meet - Real(0.1);
  const Real then = meet + (apart - Real(0.2)) / Real(1.3), place = Real(0.1) + (then - meet);
  pile::SolvedSpheres stepper(model, 0.1, {});
  ASSERT_LT(then, 2);
  const auto end = after(stepper, 20);
  EXPECT_NEAR(end[0].position.y(), place - Real(0.3) * (2 - then), 256 * eps);
  EXPECT_NEAR(end[1].position.y(), place + Real(0.2) + (2 - then), 256 * eps);
}

// The step in which the first lies on something is made once, with its contacts and the order that is told.
TEST(SolvedSpheres, TellTheirContactsAndTheirOrder) {
  Model model = pile_model(0, Real(0.5));
  add_ball(model, 2, Real(0.1), {0, Real(0.1), 0}, {Real(0.5), 0, 0});
  pile::SolvedSpheres lies(model, 0.01, {});
  lies.keep_contacts(true);
  lies.step();
  Real pressed = 0;
  for (const Contact& contact : lies.contacts()) pressed += *contact.impulse;
  EXPECT_NEAR(pressed, 2 * g * Real(0.01), 1000 * eps);
  EXPECT_EQ(lies.order_so_far(), 2);

  model.motions[0].position.y() = Real(0.3);
  pile::SolvedSpheres falls(model, 0.01, {});
  falls.keep_contacts(true);
  int struck = 0;
  for (int k = 0; k < 40; ++k) {
    falls.step();
    struck += static_cast<int>(falls.impacts().size());
  }
  EXPECT_EQ(struck, 1);
  EXPECT_FALSE(falls.contacts().empty());
  EXPECT_NE(falls.order_so_far(), 2);
}

}  // namespace
}  // namespace cylon::engine
