// Correct simulators, each within its declared accuracy: every judge must accept them.
#include "tests/mutants/matrix/decorator.h"
#include "tests/mutants/matrix/seed/engine.h"
#include "tests/mutants/matrix/subject.h"

#include <algorithm>
#include <cmath>

namespace cylon::mutants {

std::vector<HarmlessRow> harmless_masks() {
  return {
      {"q told as -q",
       {.reading =
            [](const Moment& m, core::State& state) {
              if (m.step % 3 == 1)
                for (core::BodyState& s : state) s.orientation.coeffs() *= -1;
            }}},
      {"forces in reverse",
       {.scene = [](core::Scene& s) { std::reverse(s.forces.begin(), s.forces.end()); }}},
      {"other colours",
       {.scene =
            [](core::Scene& s) {
              for (core::Body& body : s.bodies) body.color = "#123456";
            }}},
      {"an ulp of noise",
       {.reading =
            [](const Moment& m, core::State& state) {
              if (m.step == 0) return;
              for (core::BodyState& s : state)
                for (double& x : s.position) x = std::nextafter(x, m.step % 2 ? HUGE_VAL : -HUGE_VAL);
            }}},
  };
}

std::vector<Subject> correct_subjects() {
  std::vector<Subject> result;
  for (const char* integrator : {"auto", "rk4", "explicit-euler", "lie-trotter", "velocity-verlet",
                                 "stormer-verlet", "yoshida4", "dop853"}) {
    Subject subject;
    subject.name = std::string("in-house, ") + integrator;
    subject.make = core::make_simulator;
    subject.setup.integrator = integrator;
    result.push_back(std::move(subject));
  }
  for (const HarmlessRow& row : harmless_masks()) {
    Subject subject;
    subject.name = std::string("in-house, ") + row.name;
    subject.make = [mask = row.mask] { return masked(mask); };
    subject.setup.integrator = "auto";
    result.push_back(std::move(subject));
  }
  Subject seed;
  seed.name = "the seed's engine, put right";
  seed.make = [] { return seed::make_engine({}); };
  result.push_back(std::move(seed));
  return result;
}

}  // namespace cylon::mutants
