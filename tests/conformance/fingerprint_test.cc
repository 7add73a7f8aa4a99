// The probes find out from motions alone what the sources of the engines say.
#include "harness/process/session.h"
#include "harness/study/probes.h"
#include "tests/conformance/fixture.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace cylon {
namespace {

struct Row {
  const char* engine;
  std::string_view probe, answer;
};

// ODE keeps friction in a box on its own two directions; btMultiBody takes the speed after the step's
// gravity, which is the factor 400 of a published table.
constexpr Row rows[] = {
    {"in-house", "free fall", "second order or better"},
    {"in-house", "gyroscopic torque", "on, exact within rounding"},
    {"in-house", "restitution", "speed at the time of impact"},
    {"in-house", "friction", "Coulomb cone"},
    {"in-house-float", "precision", "single"},
    {"in-house/integrator=explicit-euler", "free fall", "explicit Euler"},
    {"in-house/integrator=lie-trotter", "spring", "order 1.0, energy bounded"},
    {"in-house/integrator=velocity-verlet", "spring", "order 2.0, energy bounded"},
    {"in-house/integrator=rk4", "spring", "order 4.0, energy decays"},
    {"bullet", "free fall", "semi-implicit Euler"},
    {"bullet", "gyroscopic torque", "implicit: removes energy"},
    {"bullet", "restitution", "speed before gravity acts in the step"},
    {"bullet", "friction", "Coulomb cone"},
    {"bullet-float", "precision", "single"},
    {"bullet/gyro=none", "gyroscopic torque", "off"},
    {"bullet-multibody", "gyroscopic torque", "explicit: adds energy"},
    {"bullet-multibody", "restitution", "speed after gravity acts in the step"},
    {"ode", "free fall", "semi-implicit Euler"},
    {"ode", "restitution", "speed before gravity acts in the step"},
    {"ode", "friction", "friction pyramid: depends on the direction"},
    {"ode", "rotation per step", "exact up to 3 rad per step"},
    {"ode-quick", "friction", "friction pyramid: depends on the direction"},
    {"mujoco/integrator=rk4", "gyroscopic torque", "on, order 2"},
    {"rapier", "free fall", "semi-implicit Euler with 4 sub-steps"},
    {"havok", "free fall", "semi-implicit Euler with 4 sub-steps"},
    {"havok", "slow bounces", "no restitution at 0.1 m/s and below, another than the scene's up to 1 m/s"},
};

study::Finding ask(std::string_view name, const process::EngineChoice& engine) {
  constexpr process::Limits patient = {60, 120, std::size_t{4} << 30};
  const study::Runner run = study::worker_runner(engine, patient);
  for (const study::Probe& probe : study::probes())
    if (probe.name == name) try {
        return probe.ask(run, study::damping_of(run));
      } catch (const study::RunFailed& failed) {
        return {std::string(results::name(failed.outcome.status)), failed.outcome.reason};
      }
  throw std::logic_error("no probe of that name");
}

TEST(Fingerprint, IdentifiesEngines) {
  for (const Row& row : rows) {
    const process::EngineChoice engine = conformance::engine(row.engine);
    if (process::missing(engine.row)) continue;
    const study::Finding found = ask(row.probe, engine);
    EXPECT_EQ(found.answer, row.answer) << row.engine << ", " << row.probe << ": " << found.evidence;
  }
}

// What tells the engines apart: no two of them answer all of these alike.  Rapier's other builds are not among them:
// they differ from rapier in roundings alone (rapier_builds_test.cc), and their answers are its own.
constexpr std::string_view telling[] = {"precision",   "free fall", "gyroscopic torque",
                                        "restitution", "friction",  "rest"};
constexpr const char* engines[] = {
    "in-house", "bullet", "bullet-multibody", "ode",   "mujoco", "simbody",  "dart",     "siconos",
    "jolt",     "rapier", "mujoco3",          "havok", "physx",  "crashcat", "cannon-es"};

// A time-out or a crash is no answer by which an engine is known.
bool answered(const study::Finding& found) {
  return found.answer != "timeout" && found.answer != "crash" && found.answer != "non-finite";
}

TEST(Fingerprint, TellsEveryEngineApart) {
  const process::KeptWorkers kept;  // those in Node take longer to start than to answer
  std::map<std::vector<std::string>, std::string> known;
  for (const char* id : engines) {
    const process::EngineChoice engine = conformance::engine(id);
    if (process::missing(engine.row)) continue;
    std::vector<std::string> answers;
    for (const std::string_view probe : telling) {
      const study::Finding found = ask(probe, engine);
      EXPECT_TRUE(answered(found)) << id << ", " << probe << ": " << found.answer;
      answers.push_back(found.answer);
    }
    const auto [same, is_new] = known.emplace(answers, id);
    EXPECT_TRUE(is_new) << id << " answers as " << same->second;
  }
  EXPECT_GE(known.size(), 4U);
}

// What an engine does as shipped is seen through its damping.
constexpr Row as_shipped[] = {
    {"jolt", "damping", "linear 0.05/s, angular 0.05/s"},
    {"jolt", "free fall", "semi-implicit Euler"},
    {"jolt", "gyroscopic torque", "off"},
    {"jolt", "slow bounces", "no restitution at 1 m/s and below"},
    {"jolt", "speed limit", "500 m/s"},
    {"jolt", "spin limit", "47.12 rad/s"},
    {"jolt", "sleeping", "slow bodies are stopped"},
    {"crashcat", "gyroscopic torque", "off"},
    {"physx", "gyroscopic torque", "off"},
    {"physx", "spin limit", "100 rad/s"},
    {"rapier", "speed limit", "400 m/s"},
    {"rapier", "free fall", "semi-implicit Euler with 4 sub-steps"},
    {"havok", "speed limit", "less than 1000 m/s, a start that it does not hold"},
    {"cannon-es", "damping", "linear 0.0101/s, angular 0.0101/s"},
};

TEST(Fingerprint, SeesThroughDampingAsShipped) {
  const process::KeptWorkers kept;  // those in Node take longer to start than to answer
  for (const Row& row : as_shipped) {
    const process::EngineChoice engine = conformance::engine(std::string(row.engine) + "/path=as-shipped");
    if (process::missing(engine.row)) continue;
    const study::Finding found = ask(row.probe, engine);
    EXPECT_EQ(found.answer, row.answer) << row.engine << ", " << row.probe << ": " << found.evidence;
  }
}

}  // namespace
}  // namespace cylon
