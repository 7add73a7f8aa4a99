// A viewer session, without sockets and without a clock.
#include "harness/view/command.h"
#include "harness/view/viewer_messages.h"
#include "tests/harness/view/fixture.h"

#include "harness/core/observable.h"
#include "harness/process/json_fields.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>

namespace cylon::view {
namespace {

using core::Vector3;
using nlohmann::json;

constexpr std::size_t body_bytes = sizeof(float) * 13;  ///< Of one body's state in a message.

Session session_of(const core::Scene& scene, SessionOptions options) {
  return {scenario(scene), std::move(options)};
}

void say(Session& session, const std::string& line) { session.apply(parse_command(line)); }

/// The message's header, checked against its lengths.
json header_of(const std::string& message, std::size_t payload) {
  std::uint32_t sizes[2];
  std::memcpy(sizes, message.data(), sizeof sizes);
  EXPECT_EQ(sizes[1], payload);
  EXPECT_EQ(message.size(), 8 + sizes[0] + sizes[1]);
  return json::parse(message.substr(8, sizes[0]));
}

// Whatever comes, it is refused with a sentence that names the key, and nothing has changed.
TEST(Session, RejectsInvalidCommands) {
  core::Scene scene = ball_on_floor(1, {0.1, 0, 0}, 0.5);
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].name = "wall.1", scene.bodies[1].locked = true, scene.bodies[1].initial.position.x() = 3;
  scene.forces.emplace_back(core::Spring{.body = 0, .stiffness = 3});
  SessionOptions settings = options("bullet");
  settings.engines.push_back(ask(engine("ode").row, limits));  // which is asked for an integrator below
  Session session = session_of(scene, std::move(settings));
  const std::pair<const char*, const char*> rows[] = {
      {"", "JSON"},
      {"{", "JSON"},
      {"[1, 2]", "object"},
      {"nonsense", "JSON"},
      {"{}", "do"},
      {R"({"do": 1})", "do"},
      {R"({"do": "dance"})", "dance"},
      {R"({"do": "play", "now": true})", "now"},
      {R"({"do": "speed"})", "value"},
      {R"({"do": "speed", "value": "fast"})", "value"},
      {R"({"do": "speed", "value": 0})", "value: 0"},
      {R"({"do": "speed", "value": -1})", "-1"},
      {R"({"do": "speed", "value": 101})", "101"},
      {R"({"do": "speed", "value": 1e999})", "JSON"},
      {R"({"do": "speed", "value": null})", "value"},
      {R"({"do": "kick", "body": 0})", "impulse"},
      {R"({"do": "kick", "body": 2, "impulse": [0, 0, 1]})", "body 2"},
      {R"({"do": "kick", "body": -1, "impulse": [0, 0, 1]})", "body -1"},
      {R"({"do": "kick", "body": 0.5, "impulse": [0, 0, 1]})", "body"},
      {R"({"do": "kick", "body": 1e30, "impulse": [0, 0, 1]})", "body"},
      {R"({"do": "kick", "body": 4294967296, "impulse": [0, 0, 1]})", "body"},
      {R"({"do": "kick", "body": 1, "impulse": [0, 0, 1]})", "locked"},
      {R"({"do": "kick", "body": 0, "impulse": [0, 1]})", "impulse"},
      {R"({"do": "kick", "body": 0, "impulse": [0, 1, "x"]})", "impulse"},
      {R"({"do": "kick", "body": 0, "impulse": [0, 1, 1e300]})", "1e+300"},
      {R"({"do": "kick", "body": 0, "impulse": [0, 1, 0], "angular_impulse": [0, 1]})", "angular_impulse"},
      {R"({"do": "kick", "body": 0, "impulse": [0, 1, 0], "spin": [0, 1, 0]})", "spin"},
      {R"({"do": "pull", "body": 0, "anchor": [0, 0, 0], "pin": [0, 0, 0], "stiffness": 0})", "stiffness: 0"},
      {R"({"do": "pull", "body": 9, "anchor": [0, 0, 0], "pin": [0, 0, 0], "stiffness": 1})", "body 9"},
      {R"({"do": "lanes", "lanes": []})", "lanes"},
      {R"({"do": "lanes", "lanes": [{"engine": "bulet", "integrator": "", "dt_text": "0.01"}]})", "bullet"},
      {R"({"do": "lanes", "lanes": [{"engine": "ode", "integrator": "rk4", "dt_text": "0.01"}]})", "rk4"},
      {R"({"do": "lanes", "lanes": [{"engine": "ode", "integrator": "", "dt_text": "0"}]})", "0"},
      {R"({"do": "lanes", "lanes": [{"engine": "ode", "integrator": "", "dt_text": "60"}]})", "60"},
      {R"({"do": "lanes", "lanes": [{"engine": "ode", "integrator": "", "dt_text": "x"}]})", "x"},
      {R"({"do": "lanes", "lanes": [1]})", "lanes"},
      {R"({"do": "set", "key": "gravity", "value": 3})", "gravity"},
      {R"({"do": "set", "key": "mood", "value": 3})", "mood"},
      {R"({"do": "set", "key": "a..b", "value": 3})", "a..b"},
      {R"({"do": "set", "key": "spring.1.stiffness", "value": 3})", "spring '1'"},
      {R"({"do": "set", "key": "spring.-1.stiffness", "value": 3})", "spring '-1'"},
      {R"({"do": "set", "key": "spring.0.stiffness", "value": -3})", "-3"},
      {R"({"do": "set", "key": "spring.0.stiffness", "value": [1, 2, 3]})", "number"},
      {R"({"do": "set", "key": "spring.0.colour", "value": 1})", "colour"},
      {R"({"do": "set", "key": "material.0.restitution", "value": 1.5})", "1.5"},
      {R"({"do": "set", "key": "body.ghost.mass", "value": 1})", "ghost"},
      {R"({"do": "set", "key": "body.ball.mass", "value": 0})", "body.ball.mass = 0"},
  };
  const std::string before = session_json(session).dump();
  const std::string state = state_message(session);
  for (const auto& [line, named] : rows) {
    try {
      say(session, line);
      ADD_FAILURE() << line << " was taken";
    } catch (const BadCommand& error) {
      EXPECT_NE(std::string(error.what()).find(named), std::string::npos) << line << ": " << error.what();
    }
  }
  std::string lanes;
  for (std::size_t i = 0; i <= most_lanes; ++i)
    lanes += std::string(i ? "," : "") + R"({"engine": "ode", "integrator": "", "dt_text": "0.01"})";
  EXPECT_THROW(say(session, R"({"do": "lanes", "lanes": [)" + lanes + "]}"), BadCommand);
  EXPECT_EQ(session_json(session).dump(), before);
  EXPECT_EQ(state_message(session), state);
}

TEST(Session, TimeFollowsSpeedAndStopsWhenPaused) {
  Session session = session_of(ball_on_floor(1, {0.1, 0, 0}, 0.5), options("ode"));
  session.advance(0.05);  // a step, by which it learns what one costs
  advance_to(session, 0.5);
  EXPECT_NEAR(session.time(), 0.5, 1e-12);
  say(session, R"({"do": "speed", "value": 4})");
  session.advance(0.05);
  EXPECT_NEAR(session.time(), 0.7, 1e-12);
  session.advance(3600);  // a machine that slept
  EXPECT_NEAR(session.time(), 1.1, 1e-12);
  say(session, R"({"do": "pause"})");
  EXPECT_FALSE(session.advance(0.05));
  EXPECT_NEAR(session.time(), 1.1, 1e-12);
  say(session, R"({"do": "step"})");
  EXPECT_TRUE(session.advance(0));
  EXPECT_FALSE(session.advance(0.05));
  EXPECT_NEAR(session.time(), 1.11, 1e-12);
  say(session, R"({"do": "play"})");
  EXPECT_TRUE(session.advance(0.05));
  say(session, R"({"do": "reset"})");
  EXPECT_EQ(session.time(), 0);
  EXPECT_EQ(session.lanes()[0]->state()[0].position, session.scenario().scene.bodies[0].initial.position);
}

// Without gravity momentum changes by the kick and by nothing else, in every lane.
TEST(Session, KickAddsItsMomentum) {
  core::Scene scene = ball_on_floor(4, {0.1, 0.2, 0.3}, 0.5);
  scene.forces.clear();
  Session session = session_of(scene, options("bullet"));
  say(session, R"({"do": "lanes", "lanes": [{"engine": "bullet", "integrator": "", "dt_text": "0.01"},
                                              {"engine": "in-house", "integrator": "rk4", "dt_text": "1/60"},
                                              {"engine": "ode", "integrator": "", "dt_text": "0.01"}]})");
  advance_to(session, 0.3);
  say(session, R"({"do": "kick", "body": 0, "impulse": [1.5, -0.25, 0.125]})");
  advance_to(session, 0.6);
  ASSERT_EQ(session.lanes().size(), 3u);
  for (const auto& lane : session.lanes()) {
    ASSERT_TRUE(lane->running()) << lane->reason();
    EXPECT_NEAR(lane->time(), 0.6, 0.02);
    EXPECT_LE((momentum(scene, lane->state()) - Vector3(0.2, 0.4, 0.6) - Vector3(1.5, -0.25, 0.125)).norm(),
              2e-15)
        << lane->spec().engine;
  }
}

// A ball that nothing turns keeps the spin that a kick gives it: L = I w jumps by the angular impulse, in every lane.
TEST(Session, SpinKickAddsItsAngularMomentum) {
  core::Scene scene = ball_on_floor(4, {0.1, 0.2, 0.3}, 0.5);
  scene.forces.clear();
  scene.bodies[0].initial.angular_velocity = {0.4, -0.2, 0.1};
  Session session = session_of(scene, options("bullet"));
  say(session, R"({"do": "lanes", "lanes": [{"engine": "bullet", "integrator": "", "dt_text": "0.01"},
                                              {"engine": "in-house", "integrator": "rk4", "dt_text": "1/60"},
                                              {"engine": "ode", "integrator": "", "dt_text": "0.01"}]})");
  advance_to(session, 0.3);
  say(session, R"({"do": "kick", "body": 0, "impulse": [0, 0, 0], "angular_impulse": [0.5, -0.25, 0.125]})");
  advance_to(session, 0.6);
  const core::Matrix3& inertia = scene.bodies[0].inertia;
  for (const auto& lane : session.lanes()) {
    ASSERT_TRUE(lane->running()) << lane->reason();
    const Vector3 spin = inertia * (lane->state()[0].angular_velocity - Vector3(0.4, -0.2, 0.1));
    EXPECT_LE((spin - Vector3(0.5, -0.25, 0.125)).norm(), 1e-14) << lane->spec().engine;
    EXPECT_LE((momentum(scene, lane->state()) - Vector3(0.2, 0.4, 0.6)).norm(), 2e-15) << lane->spec().engine;
  }
}

// A kick on a jointed body: what the loader would refuse, velocities that break the joint, never comes to it.
TEST(Session, AKickOnAPendulumKeepsItHanging) {
  Session session = session_of(hinged_pair(), options("in-house", "rk4"));
  say(session, R"({"do": "lanes", "lanes": [{"engine": "in-house", "integrator": "rk4", "dt_text": "0.01"},
                                              {"engine": "ode", "integrator": "", "dt_text": "0.01"},
                                              {"engine": "bullet", "integrator": "", "dt_text": "0.01"}]})");
  advance_to(session, 0.2);
  for (int i = 0; i < 5; ++i) {
    say(session, R"({"do": "kick", "body": 1, "impulse": [0.5, 1, -2]})");
    advance_to(session, session.time() + 0.1);
  }
  for (const auto& lane : session.lanes()) {
    ASSERT_TRUE(lane->running()) << lane->reason();
    core::Values gaps;
    core::evaluate({.quantity = core::Quantity::joint_gap}, lane->scene(), lane->state(), gaps);
    for (const Eigen::Vector4d& gap : gaps) EXPECT_LE(std::abs(gap.x()), 2e-3) << lane->spec().engine;
  }
}

// The spring's energy stands in the sum, and its damping only takes: with that the sum falls, and the body
// comes to the pin as near as its weight lets it.
TEST(Session, PullAddsNoEnergy) {
  core::Scene scene = ball_on_floor(4, {0.1, 0.2, 0.3}, 0.5);
  Session session = session_of(scene, options("in-house", "rk4"));
  advance_to(session, 0.2);
  say(session, R"({"do": "pull", "body": 0, "anchor": [0, 0, 0], "pin": [1, 6, 0], "stiffness": 200})");
  const Vector3 pin(1, 6, 0);
  const auto energy = [&] {
    core::Values values;
    core::evaluate({.quantity = core::Quantity::energy}, session.lanes()[0]->scene(),
                   session.lanes()[0]->state(), values);
    return values[0].x();
  };
  // Before the first step: kinetic, weight and k d^2/2, by hand.
  const core::BodyState& start = session.lanes()[0]->state()[0];
  const double taut = 100 * (pin - start.position).squaredNorm();
  EXPECT_NEAR(energy(), start.velocity.squaredNorm() + 2 * 9.81 * start.position.y() + taut, 1e-9);
  const double at_first = energy();
  double before = at_first;
  for (double t = 0.3; t < 4; t += 0.1) {
    advance_to(session, t);
    EXPECT_LE(energy(), before + 1e-9) << t;
    before = energy();
  }
  EXPECT_LE(energy(), at_first - taut / 2);
  EXPECT_LE((session.lanes()[0]->state()[0].position - pin).norm(), 3 * 2 * 9.81 / 200);
  ASSERT_TRUE(session.pull());
  say(session, R"({"do": "release"})");
  EXPECT_FALSE(session.pull());
  EXPECT_EQ(session.lanes()[0]->scene().forces.size(), 1u);
  const double rises = session.lanes()[0]->state()[0].velocity.y();
  advance_to(session, session.time() + 0.4);
  EXPECT_NEAR(session.lanes()[0]->state()[0].velocity.y(), rises - 0.4 * 9.81, 1e-9);
}

TEST(Session, ParametersChangeWhileItRuns) {
  core::Scene scene = ball_on_floor(4, {0, 0, 0}, 0.5);
  Session session = session_of(scene, options("ode"));
  const std::uint64_t changes = session.changes();
  advance_to(session, 0.1);
  say(session, R"({"do": "set", "key": "gravity", "value": [1, 0, 0]})");
  const Vector3 then = session.lanes()[0]->state()[0].velocity;
  advance_to(session, 0.4);
  EXPECT_LE((session.lanes()[0]->state()[0].velocity - then - Vector3(0.3, 0, 0)).norm(), 1e-12);
  say(session, R"({"do": "set", "key": "body.ball.mass", "value": 3})");
  EXPECT_EQ(session.scene().bodies[0].mass, 3);
  EXPECT_NEAR(session.scene().bodies[0].inertia(1, 1), 0.3, 1e-15);
  say(session, R"({"do": "set", "key": "material.0.restitution", "value": 1})");
  EXPECT_EQ(session.scene().materials[0].restitution, 1);
  EXPECT_EQ(session.changes(), changes + 3);
  EXPECT_EQ(session_json(session)["scene"]["gravity"], json({1.0, 0.0, 0.0}));
}

// Lanes fail one by one, each with its reason; the others go on, and a reset tries again.
TEST(Session, FailedEngineFailsItsLane) {
  SessionOptions settings = options("ode");
  for (const char* mode : {"abort_in_run", "loop_in_run", "nan"}) {
    process::EngineRow row = process::scripted(mode).row;
    row.id = mode;
    settings.rows.push_back(row);
    settings.engines.push_back({mode, "1", {"uniform"}});
  }
  settings.limits.run_seconds = 2;
  Session session = session_of(process::two_bodies(), settings);
  say(session, R"({"do": "lanes", "lanes": [{"engine": "abort_in_run", "integrator": "", "dt_text": "0.01"},
                                              {"engine": "loop_in_run", "integrator": "", "dt_text": "0.01"},
                                              {"engine": "nan", "integrator": "", "dt_text": "0.01"},
                                              {"engine": "ode", "integrator": "", "dt_text": "0.01"}]})");
  advance_to(session, 0.3);
  const char* const reasons[] = {"crash: ", "timeout: ", "non-finite: "};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(session.lanes()[i]->status(), Lane::Status::failed) << reasons[i];
    EXPECT_TRUE(session.lanes()[i]->reason().starts_with(reasons[i])) << session.lanes()[i]->reason();
  }
  EXPECT_TRUE(session.lanes()[3]->running());
  EXPECT_NEAR(session.time(), 0.3, 1e-12);
  const json state = header_of(state_message(session), body_bytes * 2 * 4);
  EXPECT_EQ(state["lanes"][0]["status"], "failed");
  EXPECT_EQ(state["lanes"][3]["status"], "running");
  say(session, R"({"do": "reset"})");
  EXPECT_TRUE(session.lanes()[0]->running());
}

// Bullet has no distance joint: that lane says so, at once.
TEST(Session, UnsupportedEngineIsReported) {
  core::Scene scene = process::two_bodies();
  scene.joints = {{core::JointType::distance, 0, 1, Vector3::Zero(), Vector3::UnitY(),
                   (scene.bodies[0].initial.position - scene.bodies[1].initial.position).norm()}};
  scene.bodies[1].initial.velocity = scene.bodies[0].initial.velocity;
  SessionOptions settings = options("bullet");
  settings.playing = false;
  Session session = session_of(scene, settings);
  EXPECT_EQ(session.lanes()[0]->status(), Lane::Status::unsupported);
  EXPECT_NE(session.lanes()[0]->reason().find("distance"), std::string::npos);
  EXPECT_FALSE(session.advance(0.1));
}

// A force that knows the time: changes wait for a reset.
TEST(Session, DrivenSceneRestartsOnlyFromTimeZero) {
  core::Scene scene = process::two_bodies();
  scene.forces = {core::Drive{0, {1, 0, 0}, 2}};
  Session session = session_of(scene, options("ode"));
  const std::string kick = R"({"do": "kick", "body": 0, "impulse": [1, 0, 0]})";
  say(session, kick);
  advance_to(session, 0.1);
  EXPECT_THROW(say(session, kick), BadCommand);
  EXPECT_THROW(say(session, R"({"do": "set", "key": "gravity", "value": [1, 0, 0]})"), BadCommand);
  say(session, R"({"do": "reset"})");
  say(session, kick);
}

// As live.ts has them: keys, numbers, and float32 states in the lanes' order.
TEST(Session, MessagesMatchPageFormat) {
  core::Scene scene = ball_on_floor(0, {0, 0, 0}, 0);
  scene.bodies[0].name = "ball \"\xff<script>";
  Session session = session_of(scene, options("bullet"));
  advance_to(session, 0.1);
  const json about = header_of(session_message(session), 0);
  EXPECT_EQ(about["type"], "session");
  for (const char* key : {"scenario", "title", "story", "duration", "scene", "engines", "lanes", "playing",
                          "speed", "recording"})
    EXPECT_TRUE(about["session"].contains(key)) << key;
  EXPECT_EQ(about["session"]["lanes"],
            json({{{"engine", "bullet"}, {"integrator", ""}, {"dt_text", "0.01"}}}));
  const std::string message = state_message(session);
  const json state = header_of(message, body_bytes);
  EXPECT_EQ(state["type"], "state");
  EXPECT_NEAR(state["t"].get<double>(), 0.1, 1e-12);
  const json& lane = state["lanes"][0];
  EXPECT_NEAR(lane["energy"].get<double>(), 2 * 9.81 * 0.5, 1e-9);
  EXPECT_NEAR(lane["contacts"][0]["impulse"].get<double>(), 2 * 9.81 * 0.01, 1e-7);
  EXPECT_EQ(lane["contacts"][0]["other"], -1);
  EXPECT_GT(lane["cpu_per_second"].get<double>(), 0);
  float first = 0;
  std::memcpy(&first, message.data() + message.size() - body_bytes, sizeof first);
  EXPECT_FLOAT_EQ(first, 0.3F);
}

}  // namespace
}  // namespace cylon::view
