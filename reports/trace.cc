#include "reports/trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace cylon::reports {
namespace {

// At most `most` of `count` indices, evenly spread, the first and the last among them.
std::vector<std::size_t> spread(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  const std::size_t n = std::min(count, std::max<std::size_t>(2, most));
  for (std::size_t i = 0; i < n; ++i) chosen.push_back(n > 1 ? i * (count - 1) / (n - 1) : 0);
  return chosen;
}

// The claim whose truth is shown: one that is known at any time, else recorded data.
const core::Claim* shown(const std::vector<core::Claim>& claims) {
  const core::Claim* recorded = nullptr;
  for (const core::Claim& claim : claims) {
    if (!claim.truth || !claim.truth->state) continue;
    if (claim.truth->times.empty()) return &claim;
    if (!recorded) recorded = &claim;
  }
  return recorded;
}

// Evenly spread, and where recorded data know the truth.
core::Trajectory motion(const core::Recording& recording, const core::Claim* followed,
                        const TraceLimits& limits) {
  core::Trajectory result;
  if (recording.states.empty()) return result;
  const std::size_t bodies = std::max<std::size_t>(1, recording.states.front().size());
  const std::size_t most = std::min(limits.frames, limits.frames_bodies / bodies);
  std::set<std::size_t> chosen;
  if (followed) {
    const std::vector<double>& times = followed->truth->times;
    for (const std::size_t i : spread(times.size(), most)) {
      const auto step = std::llround(times[i] / recording.dt);
      const auto found = std::lower_bound(recording.steps.begin(), recording.steps.end(), step);
      if (found != recording.steps.end() && *found == step)
        chosen.insert(static_cast<std::size_t>(found - recording.steps.begin()));
    }
  }
  const std::vector<std::size_t> even = spread(recording.states.size(), most - std::min(most, chosen.size()));
  chosen.insert(even.begin(), even.end());
  for (const std::size_t i : chosen) {
    result.time.push_back(recording.time(i));
    result.states.push_back(recording.states[i]);
  }
  return result;
}

// At the frames' times, as far as the truth goes; of recorded data at those of its times that are frames.
std::optional<Ghost> ghost(const core::Claim* followed, const core::Trajectory& frames) {
  if (!followed) return std::nullopt;
  const core::Truth& truth = *followed->truth;
  Ghost result{{}, followed->follows, truth.source};
  const auto known = [&](double t) {
    if (truth.times.empty()) return t <= truth.horizon;
    const auto next = std::lower_bound(truth.times.begin(), truth.times.end(), t * (1 - 1e-9));
    return next != truth.times.end() && *next <= t * (1 + 1e-9);
  };
  for (const double t : frames.time) {
    if (!known(t)) continue;
    result.motion.time.push_back(t);
    result.motion.states.push_back(truth.state(t));
  }
  if (result.motion.time.empty()) return std::nullopt;
  return result;
}

// A violation is one of the number that the claim is about; a mean or a slope over time has no first one.
bool has_first_violation(core::Reduction reduction) {
  return reduction == core::Reduction::max || reduction == core::Reduction::end || core::one_sided(reduction);
}

ErrorCurve error_curve(const core::Claim& claim, const core::Reading& reading, double dt,
                       std::size_t points) {
  ErrorCurve curve;
  curve.claim = claim.label;
  curve.unit = unit(claim.observable);
  curve.allowed = reading.allowed;
  const core::Series& series = reading.series;
  const std::size_t n = series.deviation.size();
  if (has_first_violation(claim.reduction) && !claim.tolerance.order) {
    const std::size_t begin = claim.reduction == core::Reduction::end && n > 0 ? n - 1 : 0;
    for (std::size_t i = begin; i < n && !curve.first_violation; ++i)
      if (!(series.deviation[i] <= curve.allowed))
        curve.first_violation = {series.time[i], std::llround(series.time[i] / dt), series.deviation[i]};
  }
  // The last sample stands for itself, so that the curve ends where the run does.
  const std::size_t bins = std::min(n, std::max<std::size_t>(2, points)), rest = n > 0 ? n - 1 : 0;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    const bool last = bin + 1 == bins;
    std::size_t worst_of_bin = last ? rest : bin * rest / (bins - 1);
    for (std::size_t i = worst_of_bin; !last && i < (bin + 1) * rest / (bins - 1); ++i)
      if (!(series.deviation[i] <= series.deviation[worst_of_bin])) worst_of_bin = i;
    curve.time.push_back(series.time[worst_of_bin]);
    curve.value.push_back(series.deviation[worst_of_bin]);
  }
  return curve;
}

struct Total {
  core::Quantity quantity;
  const char* name;
  bool vector;
};
constexpr std::array all_totals = {Total{core::Quantity::energy, "energy", false},
                                   Total{core::Quantity::kinetic_energy, "kinetic energy", false},
                                   Total{core::Quantity::linear_momentum, "momentum", true},
                                   Total{core::Quantity::angular_momentum, "angular momentum", true}};

std::vector<TotalCurve> totals(const core::Scene& scene, const core::Recording& recording,
                               std::size_t points) {
  std::vector<TotalCurve> curves;
  const std::vector<std::size_t> samples = spread(recording.states.size(), points);
  core::Values values;
  for (const Total& total : all_totals) {
    core::Observable observable;
    observable.quantity = total.quantity;
    if (undefined_in(observable, scene)) continue;
    constexpr std::array axes = {"x", "y", "z"};
    const std::size_t components = total.vector ? 3 : 1;
    const std::size_t first = curves.size();
    for (std::size_t c = 0; c < components; ++c)
      curves.push_back({total.name, std::string(unit(observable)), total.vector ? axes[c] : "", {}, {}});
    for (const std::size_t i : samples) {
      evaluate(observable, scene, recording.states[i], values);
      for (std::size_t c = 0; c < components; ++c) {
        curves[first + c].time.push_back(recording.time(i));
        curves[first + c].value.push_back(values.empty() ? NAN
                                                         : values.front()[static_cast<Eigen::Index>(c)]);
      }
    }
  }
  return curves;
}

std::string pair_name(const core::Scene& scene, const core::Pair& pair) {
  const auto body = [&](int i) { return scene.bodies[static_cast<std::size_t>(i)].name; };
  if (pair.plane >= 0)
    return fmt::format("{} and {}", body(pair.body), scene.planes[static_cast<std::size_t>(pair.plane)].name);
  return pair.other >= 0 ? fmt::format("{} and {}", body(pair.body), body(pair.other)) : body(pair.body);
}

std::vector<TraceEvent> events(const core::Scene& scene, const core::Recording& recording, std::size_t most) {
  std::vector<TraceEvent> result;
  for (const core::Event& event : recording.events) {
    if (result.size() == most) break;
    result.push_back({event.time, std::string(name(event.kind)),
                      fmt::format("{}, {}", event.index, pair_name(scene, event.pair))});
  }
  return result;
}

}  // namespace

Trace trace(const core::Scene& scene, const std::vector<core::Claim>& claims,
            std::span<const core::Reading> readings, const core::Recording& recording,
            const TraceLimits& limits) {
  Trace result;
  const core::Claim* followed = shown(claims);
  result.motion = motion(recording, followed, limits);
  result.ghost = ghost(followed, result.motion);
  for (std::size_t i = 0; i < claims.size(); ++i)
    if (claims[i].observable.quantity != core::Quantity::event)
      result.errors.push_back(error_curve(claims[i], readings[i], recording.dt, limits.points));
  result.totals = totals(scene, recording, limits.points);
  result.events = events(scene, recording, limits.points);
  result.remarks = recording.remarks;
  return result;
}

}  // namespace cylon::reports
