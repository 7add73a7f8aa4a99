// A live run in pieces: the same bits as one run, the contacts of the last step, and the ways it ends.
#include "tests/harness/view/fixture.h"

#include <cmath>

namespace cylon::view {
namespace {

using process::Failure;
using process::LiveRun;
using process::Piece;

void expect_same_bits(const core::State& a, const core::State& b, const std::string& what) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].position, b[i].position) << what;
    EXPECT_EQ(a[i].orientation.coeffs(), b[i].orientation.coeffs()) << what;
    EXPECT_EQ(a[i].velocity, b[i].velocity) << what;
    EXPECT_EQ(a[i].angular_velocity, b[i].angular_velocity) << what;
  }
}

struct Runner {
  const char *engine, *integrator;
};

// Contacts are asked for in each piece and in none of the run: they change no bit either.
TEST(LiveRun, PiecesGiveBitsOfOneRun) {
  core::Scene bouncing = ball_on_floor(0.3, {0.4, -1, 0.2}, 0.6);
  core::Scene two = bouncing;
  two.bodies.push_back(two.bodies[0]);
  two.bodies[1].name = "other", two.bodies[1].initial.position.x() = 1.7;
  two.bodies[1].initial.velocity = {-1, 0.5, 0.1};
  const core::Scene scenes[] = {bouncing, two, hinged_pair()};
  for (const Runner& row :
       {Runner{"in-house", "rk4"}, Runner{"in-house", "auto"}, Runner{"in-house", "velocity-verlet"},
        Runner{"in-house/path=stepping", ""}, Runner{"bullet", ""}, Runner{"ode", ""}})
    for (const core::Scene& scene : scenes) {
      const std::string what = std::string(row.engine) + " " + row.integrator;
      process::RunRequest request{&scene, setup(0.01, row.integrator), 60, 60};
      const process::RunOutcome whole = run(engine(row.engine), request, limits);
      ASSERT_EQ(whole.status, results::Status::pass) << what << whole.reason;
      LiveRun live(engine(row.engine), limits);
      ASSERT_TRUE(live.live());
      live.load(scene, request.setup);
      Piece last;
      for (const std::int64_t n : {1, 30, 7, 22}) last = live.advance(n);
      expect_same_bits(last.state, whole.recording->states.back(), what);
    }
}

// m g dt: over a step the floor takes what gravity gives, to the number's rounding; ODE's constraint force
// mixing and error reduction leave 1e-12 (measured).
TEST(LiveRun, ContactForceOfBallIsItsWeight) {
  const struct {
    const char* engine;
    double part;
  } rows[] = {{"in-house", 1e-14},
              {"in-house/path=stepping", 1e-12},
              {"in-house/path=events,integrator=rk4", 1e-14},
              {"bullet", 1e-12},
              {"bullet-multibody", 1e-12},
              {"bullet-float", 1e-6},
              {"ode", 1e-9},
              {"ode-quick", 1e-9}};
  for (const auto& row : rows) {
    LiveRun live(engine(row.engine), limits);
    live.load(ball_on_floor(0, core::Vector3::Zero(), 0), setup(0.002));
    for (const std::int64_t n : {20, 1, 5}) {
      const Piece piece = live.advance(n);
      double pressed = 0;  // in-house steps tell what acts before the middle of a step and after it
      for (const core::Contact& contact : piece.contacts) {
        EXPECT_EQ(contact.pair, (core::Pair{0, core::world, 0})) << row.engine;
        EXPECT_NEAR(contact.normal.y(), 1, 1e-12) << row.engine;
        EXPECT_NEAR((contact.point - core::Vector3(0.3, 0, -0.1)).norm(), 0, 1e-6) << row.engine;
        ASSERT_TRUE(contact.impulse) << row.engine;
        pressed += *contact.impulse;
      }
      EXPECT_NEAR(pressed / (2 * 9.81 * 0.002), 1, row.part) << row.engine;
    }
  }
}

// Two boxes, one on the other, turned about the vertical: what the floor takes is the weight of both, what
// the lower one takes of the upper one's points is that one's.  Ours ends where all velocities are met to 256
// roundings of what the impulses of one contact give, arms and inertias included: 6e-14, and some times that
// in the sum of eight (measured 7e-13); ODE solves directly; Bullet's sequential impulses leave 1.4e-4.
TEST(LiveRun, ContactForcesOfBoxesAreTheirWeights) {
  const struct {
    const char* engine;
    double part;
  } rows[] = {{"in-house", 2e-12}, {"in-house/path=stepping", 2e-12}, {"bullet", 4e-4}, {"ode", 1e-13}};
  core::Scene scene = ball_on_floor(0, core::Vector3::Zero(), 0);
  scene.bodies[0].shape = core::Box{{0.4, 0.5, 0.3}};
  scene.bodies[0].inertia = core::Vector3(0.3, 0.2, 0.35).asDiagonal();
  scene.bodies[0].initial.orientation = Eigen::AngleAxisd(0.6, core::Vector3::UnitY());
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].name = "upper", scene.bodies[1].mass = 1.5, scene.bodies[1].initial.position.y() = 1.5;
  for (const auto& row : rows) {
    LiveRun live(engine(row.engine), limits);
    live.load(scene, setup(0.002));
    const Piece piece = live.advance(100);
    double on_floor = 0, on_lower = 0;
    for (const core::Contact& c : piece.contacts) {
      ASSERT_TRUE(c.impulse) << row.engine;
      const double up = *c.impulse * c.normal.y();
      (c.pair.plane == 0 ? on_floor : on_lower) += c.pair.plane == 0 || c.pair.body == 1 ? up : -up;
    }
    EXPECT_NEAR(on_floor / (3.5 * 9.81 * 0.002), 1, row.part) << row.engine;
    EXPECT_NEAR(on_lower / (1.5 * 9.81 * 0.002), 1, row.part) << row.engine;
  }
}

// m (1 + e) v, and at most what gravity adds within the step; before and after it nothing presses.
TEST(LiveRun, ABounceHasItsImpulse) {
  const double speed = 1.7, e = 0.6, dt = 0.001;
  for (const char* id : {"in-house", "in-house/path=stepping", "in-house/path=events,integrator=rk4",
                         "bullet", "bullet-multibody", "ode"}) {
    LiveRun live(engine(id), limits);
    live.load(ball_on_floor(10.5 * speed * dt, {0, -speed, 0}, e), setup(dt));
    EXPECT_TRUE(live.advance(5).contacts.empty()) << id;
    double told = 0;
    int steps = 0;
    for (int step = 0; step < 10; ++step)
      for (const core::Contact& contact : live.advance(1).contacts)
        told += contact.impulse.value_or(NAN), ++steps;
    EXPECT_GE(steps, 1) << id;
    const double arrival =
        speed + 13 * 9.81 * dt;  // no faster than this, whatever is added before the bounce
    EXPECT_GE(told, 2 * (1 + e) * speed * (1 - 1e-3)) << id;
    EXPECT_LE(told, 2 * (1 + e) * arrival + steps * 2 * 9.81 * dt) << id;
  }
}

// Two balls, or a ball and a locked one, in either order: equal to a body's change of momentum, towards
// `body`.
TEST(LiveRun, ContactPairsNameBothBodies) {
  for (const bool locked : {false, true})
    for (const bool swapped : {false, true})
      for (const char* id : {"in-house", "bullet", "ode"}) {
        core::Scene scene = ball_on_floor(5, {1.2, 0, 0}, 0.5);
        scene.forces.clear();
        core::Body other = scene.bodies[0];
        other.name = "other";
        other.initial.position.x() += 1.0005;
        other.initial.velocity = core::Vector3::Zero();
        other.locked = locked;
        scene.bodies.push_back(other);
        if (swapped) std::swap(scene.bodies[0], scene.bodies[1]);
        LiveRun live(engine(id), limits);
        live.load(scene, setup(0.001));
        const std::string what = std::string(id) + (locked ? " locked" : "") + (swapped ? " swapped" : "");
        core::Vector3 pushed = core::Vector3::Zero();  // on the ball that moved
        const int ball = swapped ? 1 : 0;
        Piece piece;
        bool touched = false;
        for (int step = 0; step < 4; ++step) {
          piece = live.advance(1);
          for (const core::Contact& contact : piece.contacts) {
            touched = true;
            EXPECT_EQ(contact.pair.body + contact.pair.other, 1) << what;
            pushed += (contact.pair.body == ball ? 1 : -1) * contact.impulse.value_or(NAN) * contact.normal;
          }
        }
        EXPECT_TRUE(touched) << what;
        const core::Vector3 change =
            2 * (piece.state[static_cast<std::size_t>(ball)].velocity - core::Vector3(1.2, 0, 0));
        EXPECT_NEAR((pushed - change).norm(), 0, 1e-5 * change.norm()) << what;
      }
}

// A worker that is not live is loaded anew for each piece; x = x_0 + v t all the same.
TEST(LiveRun, WorkerWithoutLiveModeIsReloaded) {
  const core::Scene scene = process::two_bodies();
  LiveRun live(process::scripted("good"), limits);
  EXPECT_FALSE(live.live());
  live.load(scene, setup(0.01));
  Piece piece;
  for (const std::int64_t n : {3, 1, 6}) piece = live.advance(n);
  EXPECT_TRUE(piece.contacts.empty());
  for (std::size_t i = 0; i < 2; ++i) {
    const core::BodyState& start = scene.bodies[i].initial;
    EXPECT_LE((piece.state[i].position - start.position - 0.1 * start.velocity).norm(), 1e-14);
  }
  core::Scene driven = scene;
  driven.forces = {core::Drive{0, {1, 0, 0}, 2}};
  live.load(driven, setup(0.01));
  live.advance(1);
  EXPECT_THROW(live.advance(1), Failure);
}

TEST(LiveRun, EngineExitGivesItsStatus) {
  const struct {
    const char* mode;
    results::Status status;
  } rows[] = {{"abort_in_run", results::Status::crash},  {"exit_0_in_run", results::Status::crash},
              {"loop_in_run", results::Status::timeout}, {"garbage_in_run", results::Status::protocol},
              {"nan", results::Status::non_finite},      {"unsupported", results::Status::unsupported},
              {"abort_in_load", results::Status::crash}, {"wrong_start", results::Status::fail},
              {"error_in_run", results::Status::crash},  {"miscounts", results::Status::protocol}};
  for (const auto& row : rows) {
    try {
      LiveRun live(process::scripted(row.mode), {20, 2, 0});
      live.load(process::two_bodies(), setup(0.01));
      live.advance(4);
      ADD_FAILURE() << row.mode << " passed";
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.status, row.status) << row.mode << ": " << failure.what();
      EXPECT_STRNE(failure.what(), "") << row.mode;
    }
  }
  EXPECT_FALSE(process::has_children());
}

}  // namespace
}  // namespace cylon::view
