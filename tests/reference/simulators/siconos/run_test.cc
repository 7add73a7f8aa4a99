// What Siconos does in a run: the order that it states, its complaints, contacts as they are told.
#include "harness/core/simulator.h"
#include "tests/reference/exact/random_scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>

namespace cylon::simulators {
namespace {

using core::Vector3;

core::State after(const core::Scene& scene, const core::Setup& setup, double t) {
  const auto simulator = core::make_simulator();
  simulator->load(scene, setup);
  const long steps = std::lround(t / setup.dt);
  for (long i = 0; i < steps; ++i) simulator->step();
  core::State state;
  simulator->read(state);
  return state;
}

core::Scene tumbling() {
  core::Scene scene;
  scene.bodies = {exact::RandomScenes(31).body({0.3, 0.5, 0.7})};
  scene.bodies[0].name = "a";
  scene.forces = {core::UniformGravity{{0.3, -9.1, 0.4}}};
  return scene;
}

// Halving the step divides the error by 2^order; the finest of three is the truth of the others.
TEST(SiconosRun, HasTheOrderThatItStates) {
  for (const auto& [integrator, order] :
       {std::pair{"moreau-jean", 2}, std::pair{"moreau-jean-implicit", 1}}) {
    const core::Scene scene = tumbling();
    const auto simulator = core::make_simulator();
    EXPECT_EQ(simulator->load(scene, {.dt = 0.01, .integrator = integrator}).order, order);
    const auto at = [&](double dt) {
      return after(scene, {.dt = dt, .path = "as-expert", .integrator = integrator}, 1)[0].orientation;
    };
    const core::Quaternion coarse = at(1. / 64), middle = at(1. / 128), fine = at(1. / 256);
    const double slope = std::log2(coarse.angularDistance(middle) / middle.angularDistance(fine));
    EXPECT_NEAR(slope, order, 0.1) << integrator;
  }
}

// A parabola is what the midpoint keeps; theta = 1 falls g T dt/2 too far.
TEST(SiconosRun, FallsAsItsThetaSays) {
  core::Scene scene = tumbling();
  scene.bodies[0].initial.angular_velocity.setZero();
  const core::BodyState start = scene.bodies[0].initial;
  const Vector3 g = core::gravity(scene), truth = start.position + start.velocity + g / 2;
  EXPECT_LE((after(scene, {.dt = 1. / 64}, 1)[0].position - truth).norm(), 1e-13);
  const Vector3 late =
      after(scene, {.dt = 1. / 64, .integrator = "moreau-jean-implicit"}, 1)[0].position - truth;
  EXPECT_LE((late - g / 128).norm(), 1e-13);
}

// Springs at a centre of mass and off it.  The midpoint rule has order 2 here too, and both schemes keep the energy of a
// spring within a part of (w dt): it grew without bound where forces were those of the state before the step.
TEST(SiconosRun, OscillatesAsItsThetaSays) {
  core::Scene scene = tumbling();
  scene.forces = {core::Spring{0, {0.1, 0.2, -0.1}, core::world, {0.5, 1.5, 0.2}, 40, 0.3, 0}};
  for (const auto& [integrator, order] :
       {std::pair{"moreau-jean", 2}, std::pair{"moreau-jean-implicit", 1}}) {
    const auto at = [&](double dt) {
      return after(scene, {.dt = dt, .path = "as-expert", .integrator = integrator}, 1)[0].position;
    };
    const Vector3 coarse = at(1. / 128), middle = at(1. / 256), fine = at(1. / 512);
    EXPECT_NEAR(std::log2((coarse - middle).norm() / (middle - fine).norm()), order, 0.15) << integrator;
  }
  core::Scene spring = tumbling();
  core::Body& body = spring.bodies[0];
  body.initial.angular_velocity.setZero(), body.initial.velocity.setZero();
  body.initial.position = {1, 0, 0};
  const double rate = std::sqrt(40 / body.mass), dt = 0.1 / rate;
  spring.forces = {core::Spring{0, Vector3::Zero(), core::world, Vector3::Zero(), 40, 0, 0}};
  for (const char* integrator : {"moreau-jean", "moreau-jean-implicit"}) {
    const core::BodyState end = after(spring, {.dt = dt, .integrator = integrator}, 2000 * dt)[0];
    const double energy = body.mass * end.velocity.squaredNorm() / 2 + 20 * end.position.squaredNorm();
    EXPECT_NEAR(energy, 20, 20 * 0.06) << integrator;  // w dt/2 of theta = 1, at any time
  }
}

core::Scene on_the_floor(double friction) {
  core::Scene scene;
  scene.bodies.resize(3);
  for (std::size_t i = 0; i < 3; ++i) {
    core::Body& body = scene.bodies[i];
    body.name = std::string(1, static_cast<char>('a' + i));
    body.shape = core::Sphere{0.5};
    body.inertia = core::Matrix3::Identity() / 10;
    body.collide = true;
    // A nanometre deep in each other: where a gap is a rounding above zero, Siconos has no contact in that step.
    body.initial.position = {0, (0.5 + static_cast<double>(i)) * (1 - 1e-9), 0};
    body.initial.velocity = {0.4, 0, 0.3};
  }
  scene.planes = {{"floor", Vector3::UnitY(), 0, {}, {}}};
  scene.materials = {{{"*", "*"}, 0, friction}};
  scene.forces = {core::UniformGravity{}};
  return scene;
}

// Three spheres on each other: the floor bears m g dt of each of them, and each contact the weight above it.
TEST(SiconosRun, TellsContactsThatBearTheWeight) {
  for (const double friction : {0., 0.2}) {
    const core::Scene scene = on_the_floor(friction);
    const auto simulator = core::make_simulator();
    simulator->load(scene, {.dt = 1e-3, .path = "as-expert"});
    for (int i = 0; i < 3; ++i) simulator->step();
    const std::vector<core::Contact> contacts = simulator->contacts();
    ASSERT_EQ(contacts.size(), 3u);
    for (const core::Contact& contact : contacts) {
      const int above = contact.pair.plane >= 0 ? 3 : 3 - std::max(contact.pair.body, contact.pair.other);
      // With friction the spheres slide off each other by micrometres, and what they bear leans.
      EXPECT_NEAR(*contact.impulse, above * 9.81e-3, 1e-12 + 2e-5 * friction)
          << contact.pair.body << contact.pair.other;
      if (contact.pair.plane < 0) continue;
      // It slides: mu N against the motion.
      const Vector3 expected = -friction * *contact.impulse * Vector3(0.8, 0, 0.6);
      EXPECT_LE((*contact.friction - expected).norm(), 1e-6);
    }
    EXPECT_TRUE(simulator->remarks().empty());
  }
}

// One sweep does not solve it, and one iteration of Newton's does not end.
TEST(SiconosRun, TellsWhatItLeavesUnsolved) {
  const auto simulator = core::make_simulator();
  const auto told = [&](const core::Scene& scene, std::map<std::string, std::string> options) {
    simulator->load(scene, {.dt = 1e-3, .options = std::move(options)});
    for (int i = 0; i < 4; ++i) simulator->step();
    const std::vector<std::string> remarks = simulator->remarks();
    return std::accumulate(remarks.begin(), remarks.end(), std::string());
  };
  EXPECT_EQ(told(on_the_floor(0.2), {}), "");
  const std::string unsolved =
      told(on_the_floor(0.2), {{"solver-iterations", "1"}, {"solver-tolerance", "1e-14"}});
  EXPECT_NE(unsolved.find("Siconos's solver of contacts failed"), std::string::npos) << unsolved;
  const std::string open = told(tumbling(), {{"newton-iterations", "1"}, {"newton-tolerance", "1e-14"}});
  EXPECT_NE(open.find("Newton's iteration did not end in 4 of 4 steps, first in step 1"), std::string::npos)
      << open;
}

TEST(SiconosRun, EndsWithTheSentenceOfAForce) {
  core::Scene scene = tumbling();
  scene.forces.emplace_back(
      core::Thrust{.body = 0, .mass_rate = -scene.bodies[0].mass, .exhaust_velocity = Vector3(0, 1, 0)});
  try {
    after(scene, {.dt = 0.125}, 1.25);
    ADD_FAILURE() << "the mass was used up";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("the mass of 'a' is"), std::string::npos) << error.what();
  }
}

TEST(SiconosRun, GivesTheSameBits) {
  for (const double friction : {0., 0.2}) {
    const core::State once = after(on_the_floor(friction), {.dt = 1e-3}, 0.2);
    const core::State again = after(on_the_floor(friction), {.dt = 1e-3}, 0.2);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(once[i].position, again[i].position);
      EXPECT_EQ(once[i].velocity, again[i].velocity);
    }
  }
}

}  // namespace
}  // namespace cylon::simulators
