// Kicks between steps: momenta jump by the impulses, joints answer, and the motion goes on as from that state.
#include "tests/engine/rail_and_wheel.h"

namespace cylon::engine {
namespace {

const Vector3 impulse = {0.4, -0.7, 0.2}, angular = {-0.3, 0.5, 0.6};

// L = I w jumps by the angular impulse and K by the impulse, and in free motion both stay: for every integrator and in closed
// form.
TEST(Kick, OfAFreeBodyAddsItsMomenta) {
  for (const char* integrator : {"auto", "rk4", "lie-trotter", "velocity-verlet"}) {
    const Model model = free_top();
    World world(model, with(integrator, 0.01));
    world.advance(50);
    const Motion before = world.motions()[0];
    world.kick(0, impulse, angular);
    EXPECT_EQ(world.motions()[0].position, before.position) << integrator;
    EXPECT_LT((world.motions()[0].momentum - before.momentum - impulse).norm(), 1e-15) << integrator;
    EXPECT_LT((world.motions()[0].angular_momentum - before.angular_momentum - angular).norm(), 1e-14);
    const Motion kicked = world.motions()[0];
    world.advance(50);
    EXPECT_LT((world.motions()[0].momentum - kicked.momentum).norm(), 1e-14) << integrator;
    EXPECT_LT((world.motions()[0].angular_momentum - kicked.angular_momentum).norm(), 1e-7) << integrator;
    const Vector3 way = kicked.momentum / model.bodies[0].mass * 0.5;
    EXPECT_LT((world.motions()[0].position - kicked.position - way).norm(), 1e-13) << integrator;
    EXPECT_EQ(world.time(), 1);
    // As a run does that begins with that motion.
    Model anew = model;
    anew.motions[0] = kicked;
    EXPECT_LT(distance(run(anew, with(integrator, 0.01), 50).motions, world.motions()), 1e-9) << integrator;
  }
}

// From rest 2 T = J.v + L.w: what joints answer does no work on motions that they allow.
TEST(Kick, OfJointedBodiesKeepsTheJointsClosed) {
  for (const bool constraints : {false, true})
    for (const bool pinned : {false, true}) {
      Model model = linked_bodies(pinned);
      for (Motion& m : model.motions) m.momentum.setZero(), m.angular_momentum.setZero();
      model.forces.gravity.setZero();
      Options options = with("rk4", 0.005);
      options.constraints = constraints;
      World world(model, options);
      world.step();
      world.kick(1, impulse, angular);
      const Motion& m = world.motions()[1];
      const Real work =
          impulse.dot(velocity(model.bodies[1], m)) + angular.dot(angular_velocity(model.bodies[1], m));
      EXPECT_NEAR(2 * kinetic_energy(world.bodies(), world.motions()), work, 1e-12) << pinned << constraints;
      EXPECT_GT(work, 0.1);
      for (int i = 0; i < 100; ++i) world.step();
      for (const Joint& joint : model.joints) EXPECT_LT(joint_gap(world.motions(), joint), 1e-11);
      EXPECT_NEAR(2 * kinetic_energy(world.bodies(), world.motions()), work, 1e-5) << pinned << constraints;
    }
}

// A drive and a changing mass go on with their time.
TEST(Kick, DoesNotTurnBackTime) {
  Model model = forced_bodies();
  model.forces.thrusts.push_back({1, {0, 0, 0}, Real(-0.05), true, {0.2, 0.1, -0.3}});
  model.bodies[1].mass_rate = Real(-0.05);
  World plain(model, with("rk4", 0.01)), kicked(model, with("rk4", 0.01));
  plain.advance(100);
  kicked.advance(30);
  kicked.kick(0, Vector3::Zero(), Vector3::Zero());
  kicked.advance(70);
  EXPECT_LT(distance(plain.motions(), kicked.motions()), 1e-12);
  kicked.kick(0, Vector3(1e-3, 0, 0), Vector3::Zero());  // the measure sees a small one
  EXPECT_GT(distance(plain.motions(), kicked.motions()), 5e-4);
}

// Others move on, to the last bit; and a ball that is kicked into another's way meets it.
TEST(Kick, LeavesOtherIslandsAlone) {
  Model model;
  for (const Real x : {Real(0), Real(30)})
    add_body(model, make_body(1, 0.1 * Matrix3::Identity()), {x, 0.1, 0.2}, {0.1, 0.2, 0.3}, {0, 0, 0},
             {0.1, 0.2, 0.3}, Sphere{0.5});
  make_touchable(model, 1);
  for (int body = 0; body < 2; ++body) {
    model.forces.springs.push_back(
        {body, {0, 0, 0}, fixed_world, {Real(30 * body), 0.2, 0.3}, Real(0.05), 0, 0});
  }
  World plain(model, with("auto", 0.01)), kicked(model, with("auto", 0.01));
  ASSERT_EQ(kicked.island_count(), 2u);
  plain.advance(20), kicked.advance(20);
  kicked.kick(0, {0, 0, 0.3}, {0, 0, 0});
  for (int i = 0; i < 20; ++i) plain.step(), kicked.step();
  EXPECT_TRUE(same_bits(plain.motions()[1], kicked.motions()[1]));
  EXPECT_FALSE(same_bits(plain.motions()[0], kicked.motions()[0]));
  kicked.kick(0, {60, 0, 0}, {0, 0, 0});
  std::size_t impacts = 0;
  for (int i = 0; i < 100; ++i) kicked.step(), impacts += kicked.impacts().size();
  EXPECT_GE(impacts, 1u);
}

// I q'' = -k q over many turns, q = W/w sin(w t): a run that begins anew goes on with the turns that there were.
TEST(Kick, KeepsTheTurnsOfAWoundSpring) {
  for (const char* integrator : {"auto", "rk8", "yoshida6"}) {
    Wheel w = wheel_that_turns(40);
    CoordinateLaw law;
    law.at = w.angle, law.stiffness = Real(0.3);
    w.model.forces.coordinate_laws.push_back(law);
    const Real rate = std::sqrt(law.stiffness / w.inertia);
    World world(w.model, with(integrator, 2e-3));
    for (int i = 0; i < 15; ++i) {
      world.advance(100);
      world.kick(0, Vector3::Zero(), Vector3::Zero());
    }
    EXPECT_NEAR(rail_axis.dot(angular_velocity(w.model.bodies[0], world.motions()[0])),
                40 * std::cos(rate * 3), 1e-6)
        << integrator;
  }
}

// Steps that go in parts lost the turns: with a limit the wheel moves event by event, and is looked at only every 0.3 s.
TEST(Kick, KeepsTheTurnsWhereStepsGoInParts) {
  Wheel w = wheel_that_turns(40);
  CoordinateLaw law;
  law.at = w.angle, law.stiffness = Real(0.3), law.lower = -100, law.upper = 100;
  w.model.forces.coordinate_laws.push_back(law);
  w.model.forces.gravity = {Real(0.2), Real(-9.81), Real(0.4)};
  const Real rate = std::sqrt(law.stiffness / w.inertia);
  World world(w.model, with("auto", 0.3));
  for (int i = 0; i < 10; ++i) {
    world.step();
    world.kick(0, Vector3::Zero(), Vector3::Zero());
  }
  EXPECT_NEAR(rail_axis.dot(angular_velocity(w.model.bodies[0], world.motions()[0])), 40 * std::cos(rate * 3),
              1e-6);
}

TEST(Kick, IsRefusedWhereARunCannotBeginAnew) {
  Options options = with("rk4", 0.01);
  EXPECT_EQ(World(coupled_bodies(), options).no_kick(), "");
  options.account = true;
  EXPECT_NE(World(coupled_bodies(), options).no_kick(), "");
  // A locked body takes none.
  Model model = coupled_bodies();
  model.bodies[0] = make_body(model.bodies[0].mass, model.bodies[0].inertia, true);
  model.motions[0].momentum.setZero(), model.motions[0].angular_momentum.setZero();
  World world(model, with("rk4", 0.01));
  world.kick(0, impulse, angular);
  EXPECT_TRUE(same_bits(world.motions(), model.motions));
}

}  // namespace
}  // namespace cylon::engine
