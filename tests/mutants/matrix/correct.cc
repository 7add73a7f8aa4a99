// Correct simulators, each within its declared accuracy: every judge must accept them.
#include "tests/mutants/matrix/seed/engine.h"
#include "tests/mutants/matrix/subject.h"

namespace cylon::mutants {

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
  Subject seed;
  seed.name = "the seed's engine, put right";
  seed.make = [] { return seed::make_engine({}); };
  result.push_back(std::move(seed));
  return result;
}

}  // namespace cylon::mutants
