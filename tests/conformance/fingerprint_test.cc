// The probes find out from motions alone what the sources of the built-in engines say.
#include "harness/study/probes.h"
#include "tests/conformance/fixture.h"

#include <gtest/gtest.h>

#include <string_view>

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

}  // namespace
}  // namespace cylon
