// A verdict is of the motion, and not of how it is described: a scene, its truth and a recording of it that
// are moved, turned, set going or measured in other units together are judged as before.
#include "harness/core/event_find.h"
#include "harness/core/event_rows.h"
#include "harness/core/measure.h"
#include "harness/core/scale.h"
#include "harness/core/unit.h"
#include "harness/scenario/bind_motion.h"
#include "harness/study/restate.h"
#include "harness/study/yardstick.h"
#include "tests/mutants/matrix/shipped.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

namespace cylon::mutants {
namespace {

using core::Claim;
using core::Component;
using core::State;
using core::Vector3;
using scenario::Scenario;

/// A change of description, seen from a frame that moves on.
struct Description {
  const char* name;
  study::Restatement words;
  Vector3 boost = Vector3::Zero();  // in the new words [m/s]

  // A value in `unit` is multiplied by this.
  double factor(std::string unit) const {
    if (unit == "J") unit = "kg m^2/s^2";
    const core::Dimension d = core::dimension(unit);
    return std::pow(words.mass, d.mass) * std::pow(words.length, d.length) * std::pow(words.time, d.time);
  }
  State operator()(const State& state, double time) const {
    State result = words(state);
    for (core::BodyState& s : result) s.position += words.time * time * boost, s.velocity += boost;
    return result;
  }
};

std::vector<core::Event> restated(std::vector<core::Event> events, const Description& d, const Vector3& up) {
  for (core::Event& e : events) {
    e.time *= d.factor("s"), e.speed *= d.factor("m/s"), e.distance *= d.factor("m");
    e.height *= d.factor("m");
    if (e.kind == core::EventKind::turn)
      e.height += d.factor("m") * up.dot(d.words.turn.transpose() * d.words.move);
  }
  return events;
}

core::Truth restated(const core::Truth& truth, const Description& d, const Vector3& up) {
  core::Truth result = truth;
  result.state = [state = truth.state, d](double t) { return d(state(t / d.words.time), t / d.words.time); };
  result.events = restated(truth.events, d, up);
  result.horizon *= d.words.time;
  for (double& t : result.times) t *= d.words.time;
  if (!truth.times.empty())  // asked for at these times exactly
    result.state = [state = truth.state, old = truth.times, times = result.times, d](double t) {
      const auto near = std::ranges::min_element(times, {}, [t](double at) { return std::abs(at - t); });
      const double then = old[static_cast<std::size_t>(near - times.begin())];
      return d(state(then), then);
    };
  return result;
}

// x becomes z and z becomes x, but for a sign, in a quarter turn about y.
Component turned(Component component) {
  return component == Component::x ? Component::z : component == Component::z ? Component::x : component;
}

Claim restated(const Claim& claim, const Description& d, const Vector3& up) {
  Claim result = claim;
  const double unit = d.factor(std::string(core::unit(claim.observable)));
  if (claim.truth) result.truth = restated(*claim.truth, d, up);
  core::BodyState about;
  about.position = claim.observable.about;
  result.observable.about = d.words(about).position;
  if (d.words.turn != core::Matrix3::Identity())
    result.observable.component = turned(claim.observable.component);
  result.until *= d.words.time;
  if (result.sample) *result.sample *= d.words.time;
  if (result.at_least) *result.at_least *= unit;
  double reduced = unit;
  if (claim.reduction == core::Reduction::mean_square) reduced = unit * unit;
  if (claim.reduction == core::Reduction::rate) reduced = unit / d.words.time;
  if (claim.reduction == core::Reduction::order) reduced = 1;
  result.tolerance.absolute *= reduced;
  result.tolerance.size *= unit;
  result.tolerance.constant *= unit / std::pow(d.words.time, 2);
  for (auto& [order, constant] : result.tolerance.constants)
    constant *= unit / std::pow(d.words.time, order + 1);
  return result;
}

Scenario restated(const Scenario& scenario, const Description& d) {
  Scenario result = scenario;
  const Vector3 up = core::event_up(scenario.scene, scenario.scene.bodies.front());
  result.scene = d.words(scenario.scene);
  for (core::Body& body : result.scene.bodies) body.initial.velocity += d.boost;
  for (core::Force& force : result.scene.forces)
    if (auto* thrust = std::get_if<core::Thrust>(&force); thrust && thrust->exchanged_velocity)
      *thrust->exchanged_velocity += d.boost;
  result.duration *= d.words.time, result.step *= d.words.time;
  result.claims.clear();
  for (const Claim& claim : scenario.claims) result.claims.push_back(restated(claim, d, up));
  scenario::bind_motion(result.claims, result.duration);
  return result;
}

core::Recording restated(const core::Recording& recording, const Description& d, const Vector3& up) {
  core::Recording result = recording;
  result.dt *= d.words.time;
  for (std::size_t i = 0; i < recording.states.size(); ++i)
    result.states[i] = d(recording.states[i], recording.time(i));
  result.events = restated(recording.events, d, up);
  const Vector3 drift = d.words.time * recording.time(recording.steps.size() - 1) * d.boost;
  if (result.contacts)
    for (core::Contact& c : *result.contacts) {
      c.point = d.factor("m") * (d.words.turn * c.point + d.words.move) + drift;
      c.normal = d.words.turn * c.normal;
      if (c.impulse) *c.impulse *= d.factor("kg m/s");
      if (c.friction) c.friction = d.factor("kg m/s") * (d.words.turn * *c.friction);
    }
  if (result.reactions)
    for (core::Reaction& r : *result.reactions) {
      r.point = d.factor("m") * (d.words.turn * r.point + d.words.move) + drift;
      r.impulse = d.factor("kg m/s") * (d.words.turn * r.impulse);
      r.moment = d.factor("kg m^2/s") * (d.words.turn * r.moment);
    }
  return result;
}

bool has_component(const Scenario& scenario) {
  return std::ranges::any_of(scenario.claims,
                             [](const Claim& claim) { return claim.observable.component != Component::all; });
}

const core::Water* water_of(const Scenario& scenario) {
  for (const core::Force& force : scenario.scene.forces)
    if (const auto* water = std::get_if<core::Water>(&force)) return water;
  return nullptr;
}

bool has_gravity(const Scenario& scenario) {
  return std::ranges::any_of(scenario.scene.forces, [](const core::Force& f) {
    return std::holds_alternative<core::UniformGravity>(f);
  });
}

// Those that the scene's physics allows.  Up is y without gravity, and a claim names axes of the world.
std::vector<Description> descriptions(const Scenario& scenario) {
  if (const core::Water* water = water_of(scenario))  // waves run along x; a table of cells has a place
    return water->mode == "volume" ? std::vector<Description>{{"moved", {.move = {0, 0, -7}}}}
                                   : std::vector<Description>{};
  std::vector<Description> result = {{"other units", {.length = 3, .mass = 7, .time = 0.5}}};
  const double half = std::numbers::pi / 2;
  core::Matrix3 turn = Eigen::AngleAxisd(half, Vector3::UnitY()).toRotationMatrix();
  turn = turn.array().round();
  if (!has_component(scenario) && has_gravity(scenario))
    turn = core::Quaternion(0.5, -0.1, 0.7, 0.3).normalized().toRotationMatrix();
  result.push_back({"turned", {.turn = turn}});
  const auto& frame = scenario.scene.frame;
  if (!frame || frame->angular_velocity.isZero(0)) result.push_back({"moved", {.move = {10, 10, -7}}});
  if (!core::anything_fixed(scenario.scene)) result.push_back({"set going", {}, {0.7, -0.4, 1.1}});
  return result;
}

class Descriptions : public testing::TestWithParam<std::filesystem::path> {};

void expect_same_verdicts(const Scenario& scenario, const ShippedRun& run, const Description& d) {
  const Scenario other = restated(scenario, d);
  const core::Recording recording =
      restated(run.recording, d, core::event_up(scenario.scene, scenario.scene.bodies.front()));
  for (std::size_t i = 0; i < scenario.claims.size(); ++i) {
    const Claim& claim = other.claims[i];
    if (core::runs_needed(claim) > 1) continue;  // one recording is at hand
    const core::Measured m = core::measure(claim, other.scene, {&recording, 1}, other.duration);
    const results::Status status = status_of(m);
    EXPECT_EQ(results::name(status), results::name(run.findings[i].status))
        << d.name << ", " << claim.label << ": " << m.value << " of " << m.allowed << ", was "
        << run.findings[i].measured << " of " << run.findings[i].allowed;
    if (run.findings[i].allowed > 0 && claim.reduction <= core::Reduction::end) {
      const double unit = d.factor(std::string(core::unit(claim.observable)));
      EXPECT_NEAR(m.allowed / run.findings[i].allowed / unit, 1, 1e-6) << d.name << ", " << claim.label;
    }
  }
}

TEST_P(Descriptions, LeaveEveryVerdict) {
  ShippedFile& file = ShippedFile::of(GetParam());
  const Scenario& scenario = file.scenario();
  for (const Subject& subject : decorated_mutants()) {
    if (subject.name != "one step late" && subject.name != "frozen") continue;
    const auto& run = file.run(subject);
    for (const Description& d : descriptions(scenario))
      if (run && d.boost.isZero()) expect_same_verdicts(scenario, *run, d);
  }
  const auto& right = file.run(correct_subjects().front());
  for (const Description& d : descriptions(scenario))
    if (right) expect_same_verdicts(scenario, *right, d);
}

// A motion far from the origin was offered a coarser step: its errors were relative to the distance from there.
TEST_P(Descriptions, LeaveTheErrorsThatTradeAndAdviseCompare) {
  ShippedFile& file = ShippedFile::of(GetParam());
  const Scenario& scenario = file.scenario();
  for (const Subject& subject : decorated_mutants()) {
    if (subject.name != "one step late") continue;
    const auto& run = file.run(subject);
    if (!run) continue;
    const study::Yardstick plain(scenario, 1);
    const std::vector<double> errors = plain.errors(run->recording);
    for (const Description& d : descriptions(scenario)) {
      if (!d.boost.isZero()) continue;  // a late motion is another one there
      const Scenario other = restated(scenario, d);
      const study::Yardstick yardstick(other, 1);
      const std::vector<double> restated_errors = yardstick.errors(
          restated(run->recording, d, core::event_up(scenario.scene, scenario.scene.bodies.front())));
      ASSERT_EQ(errors.size(), restated_errors.size()) << d.name;
      for (std::size_t i = 0; i < errors.size(); ++i)
        EXPECT_NEAR(restated_errors[i], errors[i], 1e-6 * (1 + errors[i]))
            << d.name << ", " << plain.measures()[i].name;
    }
  }
}

std::string name_of(const testing::TestParamInfo<std::filesystem::path>& info) {
  std::string name = info.param.stem().string();
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(All, Descriptions, testing::ValuesIn(shipped_scenarios()), name_of);

// ---- No tolerance exceeds a tenth of its scale --------------------------------------------------

// The in-house engine's run in place of a truth, for scenes that have none.
std::shared_ptr<const core::RequiredMotion> recorded(const core::Recording& run) {
  core::Truth truth;
  const auto kept = std::make_shared<const core::Recording>(run);
  truth.state = [kept](double t) {
    const auto step = std::llround(t / kept->dt);
    const auto found = std::ranges::lower_bound(kept->steps, step);
    return kept->states[static_cast<std::size_t>(found - kept->steps.begin())];
  };
  const core::Recording& recording = *kept;
  const std::size_t stride = std::max<std::size_t>(1, recording.states.size() / 256);
  for (std::size_t i = 0; i < recording.states.size(); i += stride) truth.times.push_back(recording.time(i));
  return std::make_shared<core::RequiredMotion>(truth, recording.time(recording.states.size() - 1));
}

class Tolerances : public testing::TestWithParam<std::filesystem::path> {};

TEST_P(Tolerances, AreAtMostATenthOfTheirScale) {
  ShippedFile& file = ShippedFile::of(GetParam());
  const Scenario& scenario = file.scenario();
  const auto& run = file.run(correct_subjects().front());
  for (Claim claim : scenario.claims) {
    if (claim.follows.empty() && !claim.motion && run) claim.motion = recorded(run->recording);
    const double allowed = core::allowed(claim, scenario.scene, scenario.duration, core::epsilon_of_float);
    EXPECT_LE(allowed, core::widest(claim, scenario.scene, scenario.duration) * (1 + 1e-6)) << claim.label;
  }
}
// A bound below a rounding of single precision is a number of roundings, or of what no engine computes.
TEST_P(Tolerances, OfRoundingFollowThePrecision) {
  const std::map<std::string, std::string> nothing_rounds = {
      {"dzhanibekov", "linear_momentum conserved"},  // 0, and nothing is added
      {"free_symmetric_top", "linear_momentum conserved"},
      {"locked_post", "position conserved, post"}};
  const Scenario& scenario = ShippedFile::of(GetParam()).scenario();
  for (const Claim& claim : scenario.claims) {
    const core::Tolerance& t = claim.tolerance;
    if (t.order || t.level > 0 || core::validates(claim)) continue;
    if (claim.observable.event_quantity == core::EventQuantity::count ||
        claim.observable.event_quantity == core::EventQuantity::order)
      continue;                                        // whole numbers
    if (t.reason.starts_with("truncation")) continue;  // of the step
    const auto known = nothing_rounds.find(scenario.name);
    if (known != nothing_rounds.end() && known->second == claim.label) continue;
    EXPECT_GT(core::allowed(claim, scenario.scene, scenario.duration, core::epsilon_of_float),
              core::epsilon_of_float * core::scale(claim, scenario.scene, scenario.duration))
        << claim.label;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Tolerances, testing::ValuesIn(shipped_scenarios()), name_of);

}  // namespace
}  // namespace cylon::mutants
