// Forces whose law is given from outside: against the engine's own laws, and against closed forms.
#include "engine/methods.h"
#include "tests/engine/fixtures.h"

#include <cmath>
#include <functional>
#include <utility>

namespace cylon::engine {
namespace {

using Bodies = std::span<const SeenBody>;
using Loads = std::span<Load>;

struct Law final : UserLaw {
  using Apply = std::function<void(Time, Bodies, Loads)>;
  explicit Law(Apply apply, bool of_velocities = false, bool of_time = false)
      : law(std::move(apply)), velocities(of_velocities), time(of_time) {}
  bool reads_velocities() const override { return velocities; }
  bool reads_time() const override { return time; }
  void apply(Time t, Bodies bodies, Loads loads) const override { law(t, bodies, loads); }

  Apply law;
  bool velocities, time;
};

UserForce force(std::vector<int> bodies, Law::Apply apply, bool velocities = false, bool time = false) {
  return {std::move(bodies), std::make_shared<const Law>(std::move(apply), velocities, time)};
}

const Vector3 g = {0.3, -9.81, 0.7};

// F = m g
UserForce weight(std::vector<int> on, const Vector3& field = g) {
  return force(std::move(on), [field](Time, Bodies bodies, Loads loads) {
    for (std::size_t i = 0; i < bodies.size(); ++i) loads[i].force = bodies[i].mass * field;
  });
}

Real farthest(const Model& a, const Model& b, const Options& options, int steps) {
  return distance(run(a, options, steps).motions, run(b, options, steps).motions);
}

// ---- The same motion as by the engine's own laws -----------------------------------------------------------

TEST(UserForce, ThatCopiesGravityFallsAsGravityDoes) {
  Model own = coupled_bodies(), user = own;
  own.forces.gravity = g;
  user.forces.user_forces.push_back(weight({0, 1}));
  for (const char* integrator : {"rk4", "velocity-verlet", "dop853"})
    EXPECT_LT(farthest(own, user, with(integrator, 0.01), 100), 3e-13) << integrator;
  EXPECT_LT(farthest(own, user, with("auto", 0.01), 100), 1e-9);
  // The measure sees a thousandth of it.
  user.forces.user_forces = {weight({0, 1}, Real(1.001) * g)};
  EXPECT_GT(farthest(own, user, with("rk4", 0.01), 100), 1e-3);
}

// On bodies in reduced coordinates the force acts at the centre of mass, not at the pivot.
TEST(UserForce, ActsAtTheCentreOfMassOfAPinnedBody) {
  for (const bool constraints : {false, true}) {
    Model own = linked_bodies(true), user = own;
    user.forces.user_forces.push_back(weight({1, 0}, own.forces.gravity));
    user.forces.gravity.setZero();
    Options options = with("rk4", 0.005);
    options.constraints = constraints;
    EXPECT_LT(farthest(own, user, options, 200), 1e-12) << constraints;
  }
}

// A law sees velocities of the centre of mass, the angular velocity, and masses as they are now:
//   F = -c v,  torque = -d w,  beside a mass that changes.
TEST(UserForce, ThatCopiesDragIsDrag) {
  for (const bool pinned : {false, true}) {
    Model own = linked_bodies(pinned), user = own;
    own.forces.drags.push_back({0, 0.3, 0.02, 0});
    user.forces.user_forces.push_back(force(
        {0},
        [](Time, Bodies bodies, Loads loads) {
          loads[0] = {Real(-0.3) * bodies[0].velocity, Real(-0.02) * bodies[0].angular_velocity};
        },
        true));
    EXPECT_LT(farthest(own, user, with("rk4", 0.005), 200), 1e-12) << pinned;
  }
  Model own = coupled_bodies();
  own.forces.thrusts.push_back({1, {0, 0, 0}, Real(-0.1), true, {0.2, 0.1, -0.3}});
  own.bodies[1].mass_rate = Real(-0.1);
  Model user = own;
  own.forces.gravity = g;
  user.forces.user_forces.push_back(weight({0, 1}));
  EXPECT_LT(farthest(own, user, with("rk4", 0.01), 100), 1e-12);
}

TEST(UserForce, ThatReadsTimeIsGivenIt) {
  const Drive drive = {0, {0.9, 0.4, -1.1}, 2.3};
  Model own = coupled_bodies(), user = own;
  own.forces.drives.push_back(drive);
  user.forces.user_forces.push_back(force(
      {0},
      [drive](Time t, Bodies, Loads loads) { loads[0].force = drive.force * std::cos(drive.frequency * t); },
      false, true));
  EXPECT_LT(farthest(own, user, with("rk4", 0.01), 100), 1e-13);
}

// Between two bodies, of which one is locked and comes first in the scene.
TEST(UserForce, BetweenBodiesIsASpring) {
  for (const bool locked : {false, true}) {
    Model own = coupled_bodies();
    own.forces.springs = {{0, {0, 0, 0}, 1, {0, 0, 0}, 9.0, 0.7, 0}};
    if (locked) {
      own.bodies[0] = make_body(own.bodies[0].mass, own.bodies[0].inertia, true);
      own.motions[0].momentum.setZero(), own.motions[0].angular_momentum.setZero();
    }
    Model user = own;
    user.forces.springs.clear();
    user.forces.user_forces.push_back(force({0, 1}, [](Time, Bodies b, Loads loads) {
      const Vector3 d = b[1].position - b[0].position;
      loads[0].force = Real(9) * (d.norm() - Real(0.7)) * d.normalized();
      loads[1].force = -loads[0].force;
    }));
    EXPECT_LT(farthest(own, user, with("rk4", 0.01), 200), 1e-12) << locked;
  }
}

// A ball under it bounces as under gravity, located in time.
TEST(UserForce, MakesABallBounce) {
  Model own = ball_over_plane(0.4, 0.7), user = own;
  user.forces.user_forces.push_back(weight({0}, own.forces.gravity));
  user.forces.gravity.setZero();
  EXPECT_EQ(make_plan(user, with("auto", 0.01)).path, Path::events);
  const Outcome a = run(own, with("auto", 0.01), 120), b = run(user, with("auto", 0.01), 120);
  ASSERT_EQ(a.impacts.size(), b.impacts.size());
  ASSERT_GT(a.impacts.size(), 2u);
  for (std::size_t i = 0; i < a.impacts.size(); ++i) EXPECT_NEAR(a.impacts[i].time, b.impacts[i].time, 1e-9);
  EXPECT_LT(distance(a.motions, b.motions), 1e-8);
}

// ---- Closed forms ------------------------------------------------------------------------------------------

// Duffing's oscillator  x'' = -a x - b x^3  from rest at A:  x = A cn(w t, k),  w^2 = a + b A^2,  k^2 = b A^2/(2 w^2)
// (NIST Handbook of Mathematical Functions, 22.19.5); cn u = cos phi with F(phi, k) = u, by Newton's method.
struct Duffing {
  static constexpr double linear = 1.5, cubic = 10, start = 0.7, mass = 2;

  static double x(double t) {
    const double w = std::sqrt(linear + cubic * start * start);
    const double k = std::sqrt(cubic / 2) * start / w;
    double phi = w * t;
    for (int i = 0; i < 50; ++i)
      phi -= (std::ellint_1(k, phi) - w * t) * std::sqrt(1 - std::pow(k * std::sin(phi), 2));
    return start * std::cos(phi);
  }

  static Model model() {
    Model model;
    // Along a general direction, from a general spin, which the force leaves alone.
    add_body(model, make_body(mass, general_inertia(0.2, 0.3, 0.4)), start * along(), {0.4, 0.2, -0.3},
             {0, 0, 0}, {0.3, -0.2, 0.5});
    model.forces.user_forces.push_back(force({0}, [](Time, Bodies bodies, Loads loads) {
      const Vector3& x = bodies[0].position;
      loads[0].force = -mass * (linear + cubic * x.squaredNorm()) * x;
    }));
    return model;
  }
  static Vector3 along() { return Vector3(0.6, -0.48, 0.64); }
  static double error(std::string_view integrator, int steps) {
    constexpr double span = 3;
    return (run(model(), integrator, span, steps).motions[0].position - x(span) * along()).norm();
  }
};

TEST(UserForce, KeepsTheOrderOfEachIntegrator) {
  const struct {
    const char* integrator;
    int steps;
    double order;
  } rows[] = {
      {"explicit-euler", 8000, 1}, {"velocity-verlet", 500, 2}, {"yoshida4", 300, 4}, {"rk4", 300, 4}};
  for (const auto& row : rows) {
    const double coarse = Duffing::error(row.integrator, row.steps),
                 fine = Duffing::error(row.integrator, 2 * row.steps);
    EXPECT_NEAR(std::log2(coarse / fine), row.order, 0.1) << row.integrator << ": " << coarse;
  }
  EXPECT_LT(Duffing::error("auto", 30), 1e-9);
}

// The work is what the potential  U = m (a x^2/2 + b x^4/4)  loses.
TEST(UserForce, IsAccounted) {
  Options options = with("rk8", 0.005);
  options.account = true;
  const Outcome end = run(Duffing::model(), options, 200);
  ASSERT_EQ(end.works.size(), 2u);
  const auto potential = [](const Vector3& x) {
    const double s = x.squaredNorm();
    return Duffing::mass * (Duffing::linear * s / 2 + Duffing::cubic * s * s / 4);
  };
  const Real lost = potential(Duffing::start * Duffing::along()) - potential(end.motions[0].position);
  EXPECT_GT(std::abs(lost), 0.01);
  EXPECT_NEAR(end.works[1], lost, 1e-10);
  EXPECT_EQ(end.works[0], 0);
}

// A torque alone: w' = -c w of a ball.
TEST(UserForce, MayTurn) {
  Model model;
  add_body(model, make_body(0.7, 0.03 * Matrix3::Identity()), {0.1, 0.2, 0.3}, {0.2, 0.1, 0.4}, {0, 0, 0},
           {0, 0, 0});
  model.forces.user_forces.push_back(force({0}, [](Time, Bodies, Loads loads) {
    loads[0].torque = {0.003, -0.006, 0.009};
  }));
  const Outcome end = run(model, "rk4", 2, 100);  // L = torque t, from rest
  EXPECT_LT((end.motions[0].angular_momentum - Vector3(0.006, -0.012, 0.018)).norm(), 1e-15);
  EXPECT_GT(angle(end.motions[0].orientation, model.motions[0].orientation), 0.3);
}

// ---- Which method takes it ---------------------------------------------------------------------------------

TEST(UserForce, GoesToMethodsThatSampleIt) {
  for (int method = 0; method < static_cast<int>(Method::count); ++method) {
    const auto m = static_cast<Method>(method);
    const bool samples = m == Method::bodies || m == Method::trees || m == Method::events;
    EXPECT_EQ(supports(m).has(Feature::user_force), samples) << method;
    EXPECT_EQ(supports(m).has(Feature::user_force), supports(m).has(Feature::user_force_of_velocities));
  }
  // Neither a closed form nor the points' lanes.
  Model point;
  add_body(point, make_body(1, Matrix3::Zero()), {0.1, 0.2, 0.3}, {0, 0, 0}, {0.4, 0.5, 0.6}, {0, 0, 0});
  EXPECT_EQ(make_plan(point, with("auto", 0.01)).path, Path::exact);
  point.forces.user_forces.push_back(weight({0}));
  EXPECT_EQ(make_plan(point, with("auto", 0.01)).path, Path::bodies);
}

TEST(UserForce, IsRefusedWhereItCannotBeRight) {
  const UserForce brake = force(
      {0}, [](Time, Bodies b, Loads loads) { loads[0].force = -b[0].velocity.norm() * b[0].velocity; }, true);
  Model model = coupled_bodies();
  model.forces.user_forces.push_back(brake);
  EXPECT_EQ(unsupported(model, with("rk4", 0.01)), "");
  EXPECT_NE(unsupported(model, with("velocity-verlet", 0.01)).find("forces of plug-ins that read velocities"),
            std::string::npos);
  model.frame = RotatingFrame{{0.1, 0.2, 0.3}};
  EXPECT_NE(unsupported(model, with("rk4", 0.01)), "");
  model.forces.user_forces = {weight({0})};
  EXPECT_EQ(unsupported(model, with("rk4", 0.01)), "");

  Model ball = ball_over_plane(0.4, 0.7);
  ball.forces.user_forces.push_back(weight({0}));
  Options options = with("auto", 0.01);
  options.path = "stepping";
  EXPECT_NE(unsupported(ball, options).find("forces of plug-ins"), std::string::npos)
      << unsupported(ball, options);
}

// ---- Islands -----------------------------------------------------------------------------------------------

// A law of three bodies makes one island of them; each of the others stays by itself, to the last bit.
TEST(UserForce, TiesItsBodiesTogether) {
  const auto part = [](int first) {
    return force({first, first + 1, first + 2}, [](Time, Bodies b, Loads loads) {
      for (std::size_t i = 0; i < 3; ++i)
        loads[i].force = b[(i + 1) % 3].position + b[(i + 2) % 3].position - 2 * b[i].position;
    });
  };
  Model one, two;
  const auto add_three = [](Model& model, const Vector3& place) {
    for (int i = 0; i < 3; ++i)
      add_body(model, make_body(Real(1 + 0.2 * i), general_inertia(0.2, 0.3, 0.4)),
               place + Vector3(Real(0.7 * i), Real(i == 1), Real(-0.3 * i)), {0.1, 0.2, 0.3},
               {Real(0.1 * i), 0.2, 0.1}, {0.3, 0.1, 0.2});
  };
  add_three(one, {40, 0, 0}), add_three(two, {40, 0, 0}), add_three(two, {0, 0, 0});
  one.forces.user_forces.push_back(part(0));
  two.forces.user_forces.push_back(part(3)), two.forces.user_forces.push_back(part(0));
  EXPECT_EQ(World(one, with("auto", 0.01)).island_count(), 1u);
  EXPECT_EQ(World(two, with("auto", 0.01)).island_count(), 2u);
  const Outcome alone = run(one, with("auto", 0.01), 100), together = run(two, with("auto", 0.01), 100);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(same_bits(alone.motions[i], together.motions[i])) << i;
}

}  // namespace
}  // namespace cylon::engine
