#include "tests/mutants/matrix/judge.h"

#include "harness/results/verdict.h"

namespace cylon::mutants {

bool Finding::guilty() const { return results::judge(measured, allowed) != results::Status::pass; }
bool Finding::of_relation() const { return claim.starts_with("relation "); }
bool Finding::of_file() const { return !claim.starts_with("theory: ") && !of_relation(); }
double Finding::margin() const { return -results::digits(measured, allowed); }

const std::vector<Judge>& judges() {
  static const std::vector<Judge> all = [] {
    std::vector<Judge> result = scene_judges();
    for (Judge& judge : shipped_relation_judges()) result.push_back(std::move(judge));
    for (Judge& judge : relation_judges()) result.push_back(std::move(judge));
    return result;
  }();
  return all;
}

std::vector<Subject> mutants() {
  std::vector<Subject> result = decorated_mutants();
  for (Subject& subject : seed_mutants()) result.push_back(std::move(subject));
  return result;
}

}  // namespace cylon::mutants
