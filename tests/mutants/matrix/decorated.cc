// Typical faults of engines, as wrappers around the in-house engine.
#include "tests/mutants/matrix/decorator.h"

namespace cylon::mutants {

std::vector<Subject> decorated_mutants() {
  std::vector<Subject> result;
  for (const auto& rows :
       {faults_of_the_scene(), faults_of_the_joints(), faults_of_the_reading(), faults_of_the_motion()})
    for (const MaskedRow& row : rows) {
      Subject subject;
      subject.name = row.name;
      subject.fault = row.fault;
      subject.make = [mask = row.mask] { return masked(mask); };
      subject.setup.integrator = "auto";
      subject.judge = row.judge;
      subject.claim = row.claim;
      result.push_back(std::move(subject));
    }
  return result;
}

}  // namespace cylon::mutants
