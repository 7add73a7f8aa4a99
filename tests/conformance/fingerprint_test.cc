// The probes find out from motions alone what the sources of the engines say.
#include "harness/study/probes.h"
#include "tests/conformance/fixture.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>
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
};

TEST(Fingerprint, IdentifiesBuiltInEngines) {
  for (const Row& row : rows)
    for (const study::Probe& probe : study::probes())
      if (probe.name == row.probe) {
        const study::Finding found = probe.ask(study::worker_runner(conformance::engine(row.engine), {}));
        EXPECT_EQ(found.answer, row.answer) << row.engine << ", " << row.probe << ": " << found.evidence;
      }
}

// The optional engines whose methods no other has: answers that only one of them gives together.
struct Identity {
  const char* engine;
  std::vector<std::pair<std::string_view, std::string_view>> answers;  // by probe
};
const Identity identities[] = {
    // A tree of bodies with an explicit gyroscopic torque, Newton's restitution at the end of a step with a threshold, and a
    // linear complementarity problem for friction.
    {"dart",
     {{"gyroscopic torque", "explicit: adds energy"},
      {"slow bounces", "no restitution at 0.1 m/s and below"},
      {"friction", "friction pyramid: depends on the direction"}}},
    // The midpoint rule of Moreau and Jean, whose velocity at a contact is that after the step, without gravity's gain.
    {"siconos",
     {{"spring", "order 2.0, energy bounded"},
      {"gyroscopic torque", "on, order 2.0 in energy"},
      {"restitution", "speed at the time of impact"}}},
    // Springs in place of contacts, and an angular velocity that is added to the quaternion.
    {"cannon-es",
     {{"rotation per step", "approximate at every angle"},
      {"restitution", "neither the speed before nor after gravity acts in the step"}}},
};

study::Finding ask(std::string_view name, const process::EngineChoice& engine) {
  constexpr process::Limits patient = {60, 120, std::size_t{4} << 30};
  for (const study::Probe& probe : study::probes())
    if (probe.name == name) try {
        return probe.ask(study::worker_runner(engine, patient));
      } catch (const study::RunFailed& failed) {
        return {std::string(results::name(failed.outcome.status)), failed.outcome.reason};
      }
  throw std::logic_error("no probe of that name");
}

// A time-out or a crash is no answer by which an engine is known.
bool answered(const study::Finding& found) {
  return found.answer != "timeout" && found.answer != "crash" && found.answer != "non-finite";
}

TEST(Fingerprint, TellsDartSiconosAndCannonFromAllOthers) {
  int told = 0;
  for (const Identity& identity : identities) {
    const process::EngineChoice own = conformance::engine(identity.engine);
    if (process::missing(own.row)) continue;
    for (const auto& [probe, answer] : identity.answers) {
      const study::Finding found = ask(probe, own);
      EXPECT_EQ(found.answer, answer) << identity.engine << ", " << probe << ": " << found.evidence;
    }
    for (const process::EngineRow& row : process::default_engines(binary_dir)) {
      if (row.id == identity.engine || process::missing(row)) continue;
      const process::EngineChoice other = conformance::engine(row.id);
      const bool differs = std::ranges::any_of(identity.answers, [&](const auto& answer) {
        const study::Finding found = ask(answer.first, other);
        EXPECT_TRUE(answered(found)) << row.id << ", " << answer.first << ": " << found.answer;
        return found.answer != answer.second;
      });
      EXPECT_TRUE(differs) << row.id << " answers as " << identity.engine;
      ++told;
    }
  }
  if (told == 0) GTEST_SKIP() << "none of them is here; `./run engines` brings them";
}

}  // namespace
}  // namespace cylon
