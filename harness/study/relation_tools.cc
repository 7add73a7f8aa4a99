#include "harness/study/relation_tools.h"

#include "harness/core/force_law.h"

#include <cmath>
#include <limits>
#include <map>

namespace cylon::study {

using core::Recording;
using core::Scene;
using core::State;

Reason broken(const Scene& scene, const char* core::Broken::*law) {
  for (const core::Broken& one : core::broken_by(scene))
    if (const char* why = one.*law) return why;
  return {};
}

Reason placed(const Scene& scene) { return broken(scene, &core::Broken::restatement); }

Reason fixed_place(const Scene& scene) {
  if (const Reason why = placed(scene)) return why;
  if (scene.frame && scene.frame->turns()) return "the frame turns about its origin";
  return {};
}

double worst(const Subject& s, const Recording& other,
             const std::function<State(const State&, double)>& required) {
  std::map<std::int64_t, const State*> at;
  for (std::size_t i = 0; i < other.steps.size(); ++i) at[other.steps[i]] = &other.states[i];
  double result = std::numeric_limits<double>::quiet_NaN();  // of no common sample
  for (std::size_t i = 0; i < s.plain.steps.size(); ++i) {
    const auto found = at.find(s.plain.steps[i]);
    if (found == at.end() || s.plain.time(i) > s.until * (1 + 1e-12)) continue;
    const double d = apart(required(s.plain.states[i], s.plain.time(i)), *found->second, s.scales);
    if (std::isnan(d)) return d;
    result = std::fmax(result, d);
  }
  return result;
}

Recording again(const Subject& s, const Runner& run, const Scene& scene, double time) {
  return run(scene, time * s.plain.dt, s.plain.steps.back(), s.every);
}

}  // namespace cylon::study
