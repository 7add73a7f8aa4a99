// What the adapters' tests share: every engine as a row, runs through its real worker, general scenes.
// CYLON_RESIDUALS=1 in the environment prints each measured number beside what is allowed.
#pragma once

#include "harness/process/client.h"
#include "harness/process/engines.h"
#include "harness/process/session.h"
#include "tests/paths.h"
#include "tests/reference/exact/random_scenes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::conformance {

using core::Quaternion;
using core::Vector3;

/// Room for a debug build with sanitizers on a machine under load.
inline const process::Limits limits = {60, 120, std::size_t{4} << 30};

/// An engine under test, and what may be expected of its arithmetic and of its integrator.
struct Subject {
  const char* id;
  bool single = false;      ///< State in single precision.
  int order = 1;            ///< Of the integrator in smooth motion.
  bool reduced = false;     ///< Joints by reduced coordinates: no gap by construction.
  bool iterative = false;   ///< Joints by sweeps that stop before they have converged.
  int start_units = 8;      ///< Roundings, in units, of a state on its way in and out.
  bool bounces = true;      ///< Has a coefficient of restitution.
  bool touches = true;      ///< Has contacts at all.
  int order_of_masses = 0;  ///< Of the integrator where a mass changes; 0: the same.
  bool tells = true;        ///< Tells forces of contacts and joints.
  bool archimedes = true;   ///< Knows the submerged part of a shape.
  bool any_pair = true;     ///< Has a restitution for each pair, whatever those of the others.
  double drift = 2;         ///< Roundings, in units, that a step adds at most.
  double least_turn = 0;    ///< Corrections of a joint by smaller turns are not made [rad].
  double joint_units = 64;  ///< Roundings of a joint that is closed, in units.

  /// Unit roundoff: half the distance between 1 and the next number.
  double unit() const { return single ? 0x1p-24 : 0x1p-53; }
  process::EngineChoice choice() const {
    return process::parse_engine(id, process::default_engines(binary_dir));
  }
};

/// A build of Rapier (rapier_builds_test.cc).
constexpr Subject of_rapier(const char* id) {
  return {.id = id,
          .single = true,
          .iterative = true,
          .tells = false,
          .archimedes = false,
          .any_pair = false,
          .drift = 64};
}

inline const Subject subjects[] = {
    // One step after another, as the others: what auto does is bounded by its tolerance, not by rounding.
    {.id = "in-house/integrator=rk4",
     .order = 4,
     .start_units = 32},  // w from L by an inverse inertia of axes
    {.id = "bullet", .iterative = true},
    {.id = "bullet-float", .single = true, .iterative = true},
    {.id = "bullet-multibody", .reduced = true},
    {.id = "bullet-multibody-float", .single = true, .reduced = true},
    {.id = "ode"},
    {.id = "ode-quick", .iterative = true},
    {.id = "in-house-float/integrator=rk4", .single = true, .order = 4, .start_units = 32},
    {.id = "mujoco", .reduced = true, .bounces = false},
    {.id = "simbody", .order = 4, .reduced = true, .bounces = false, .touches = false, .order_of_masses = 1},
    // Both give a turned angular momentum its old size, which rounds a few times more; Rapier does so four times a step.
    {.id = "jolt", .single = true, .iterative = true, .tells = false, .archimedes = false, .drift = 8},
    of_rapier("rapier"),
    of_rapier("rapier-deterministic"),
    of_rapier("rapier-simd"),
    {.id = "mujoco3", .reduced = true, .bounces = false, .tells = false, .archimedes = false},
    {.id = "crashcat",
     .iterative = true,
     .tells = false,
     .archimedes = false,
     .drift = 8,
     .least_turn = 1e-6},
    {.id = "physx",
     .single = true,
     .iterative = true,
     .tells = false,
     .archimedes = false,
     .any_pair = false,
     .drift = 8},
};

/// DART has neither all shapes nor all loops: suites that it can take name it themselves.  Its rotations are made of an axis
/// and an angle at the start and in each step: twice as many conversions as elsewhere at the start, and a joint is closed to
/// 1.8e-13 m after 800 steps.
inline const Subject dart = {.id = "dart", .reduced = true, .start_units = 16, .joint_units = 4096};

/// All but those of these engines.
inline std::vector<Subject> subjects_but(std::initializer_list<std::string_view> engines) {
  std::vector<Subject> all(std::begin(subjects), std::end(subjects));
  std::erase_if(all, [&](const Subject& subject) {
    const std::string_view id = subject.id;
    return std::ranges::find(engines, id.substr(0, id.find('/'))) != engines.end();
  });
  return all;
}

/// Those whose engine is here: an optional one may not be.
inline std::vector<Subject> subjects_here() {
  std::vector<Subject> here;
  for (const Subject& subject : subjects)
    if (!process::missing(subject.choice().row)) here.push_back(subject);
  return here;
}

inline void PrintTo(const Subject& subject, std::ostream* out) { *out << subject.id; }

inline std::string test_name(const testing::TestParamInfo<Subject>& info) {
  std::string name = info.param.id;
  name = name.substr(0, name.find('/'));
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

// The tests of a fixture keep one worker for each engine, as a process of Node starts for longer than a run takes.  That runs
// in one worker are those of workers of their own is tested in tests/harness/process/session_test.cc.
class EveryEngine : public testing::TestWithParam<Subject> {
 public:
  static void SetUpTestSuite() { kept_.emplace(); }
  static void TearDownTestSuite() { kept_.reset(); }

 protected:
  // An optional engine is tested where it is.
  void SetUp() override {
    if (const auto reason = process::missing(subject().choice().row)) GTEST_SKIP() << *reason;
  }
  const Subject& subject() const { return GetParam(); }
  double pair_restitution() const { return subject().bounces ? 0.5 : 0; }

 private:
  static inline std::optional<process::KeptWorkers> kept_;
};

/// A run of `steps` steps, every `every`-th kept; whatever keeps it from its end fails the test.
inline core::Recording play(const process::EngineChoice& engine, const core::Scene& scene, double dt,
                            std::int64_t steps, std::int64_t every = 1) {
  process::RunRequest request;
  request.scene = &scene;
  request.setup.dt = dt;
  request.steps = steps;
  request.every = every;
  process::RunOutcome outcome = process::run(engine, request, limits);
  if (!outcome.recording)
    throw std::runtime_error(
        fmt::format("{}: {}: {}", engine.id, results::name(outcome.status), outcome.reason));
  return *outcome.recording;
}

/// The state after `steps` steps.
inline core::State last(const process::EngineChoice& engine, const core::Scene& scene, double dt,
                        std::int64_t steps) {
  return play(engine, scene, dt, steps, std::max<std::int64_t>(1, steps)).states.back();
}

/// EXPECT_LE that tells its number when asked to.
inline void expect_within(const std::string& what, double measured, double allowed) {
  if (std::getenv("CYLON_RESIDUALS")) fmt::print("{:<60} {:9.2e} of {:9.2e}\n", what, measured, allowed);
  EXPECT_LE(measured, allowed) << what;
}

/// The largest difference between two states over all bodies: metres, radians, m/s and rad/s alike.
inline double difference(const core::State& a, const core::State& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double sign = a[i].orientation.dot(b[i].orientation) < 0 ? -1 : 1;
    worst = std::max({worst, (a[i].position - b[i].position).norm(),
                      2 * (a[i].orientation.coeffs() - sign * b[i].orientation.coeffs()).norm(),
                      (a[i].velocity - b[i].velocity).norm(),
                      (a[i].angular_velocity - b[i].angular_velocity).norm()});
  }
  return worst;
}

/// Bodies "a", "b", "c" with full inertia tensors, turned, spinning and moving in general directions.
inline core::Scene three_bodies(unsigned seed) {
  exact::RandomScenes random(seed);
  core::Scene scene;
  for (const char* name : {"a", "b", "c"}) {
    scene.bodies.push_back(
        random.body({random.between(0.3, 0.5), random.between(0.5, 0.7), random.between(0.7, 0.8)}));
    scene.bodies.back().name = name;
  }
  return scene;
}

}  // namespace cylon::conformance
