// Runs the engine on a reference scene and measures how far it is from the file.
#pragma once

#include "harness/core/simulator.h"
#include "tests/conformance/accuracy/truth/truth_scene.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace cylon::accuracy {

/// Largest deviation over bodies and samples, and what it is a fraction of.
struct Deviation {
  double error = 0;   ///< In the quantity's unit; NaN when anything was.
  double scale = 0;   ///< Largest |truth|; of an orientation 1 rad.
  bool seen = false;  ///< Whether the file says anything of it.

  void add(double e, double size) {
    error = std::isnan(e) || e > error ? e : error;
    scale = std::max(scale, size);
    seen = true;
  }
  /// A quantity that is zero throughout is held against one unit.
  double relative() const { return error / (scale > 0 ? scale : 1); }
};

struct Deviations {
  Deviation position, velocity, orientation, angular_velocity;

  double worst() const {
    double result = 0;
    for (const Deviation* d : {&position, &velocity, &orientation, &angular_velocity})
      if (d->seen) result = std::isnan(d->relative()) ? d->relative() : std::max(result, d->relative());
    return result;
  }
};

/// 4 asin(|q - q'|/2) after the sign fix [rad].
inline double angle_between(const core::Quaternion& p, const core::Quaternion& q) {
  const double chord = std::min((p.coeffs() - q.coeffs()).norm(), (p.coeffs() + q.coeffs()).norm());
  return 4 * std::asin(std::min(1.0, chord / 2));
}

inline void compare(const Sample& sample, const core::State& state, Deviations& result) {
  for (const Expected& e : sample.bodies) {
    const core::BodyState& s = state[static_cast<std::size_t>(e.body)];
    if (e.position) result.position.add((s.position - *e.position).norm(), e.position->norm());
    if (e.velocity) result.velocity.add((s.velocity - *e.velocity).norm(), e.velocity->norm());
    if (e.orientation) result.orientation.add(angle_between(s.orientation, *e.orientation), 1);
    if (e.angular_velocity)
      result.angular_velocity.add((s.angular_velocity - *e.angular_velocity).norm(),
                                  e.angular_velocity->norm());
  }
}

/// Samples that one run can visit: all of them where they are whole multiples of the first that is not zero.
struct Grid {
  double spacing = 0;  ///< [s]
  std::vector<Sample> samples;
};

/// One grid for even samples; else a run of its own for every sample, so that each is met exactly.
inline std::vector<Grid> grids(const std::vector<Sample>& samples) {
  const auto first = std::ranges::find_if(samples, [](const Sample& s) { return s.time > 0; });
  const bool even = std::ranges::all_of(samples, [&](const Sample& s) {
    const double steps = s.time / first->time;
    return std::abs(steps - std::round(steps)) < 1e-9;
  });
  if (even) return {{first->time, samples}};
  std::vector<Grid> result;
  for (const Sample& sample : samples)
    if (sample.time > 0) result.push_back({sample.time, {sample}});
  return result;
}

/// `per_spacing` steps between neighbours of a grid.  Requires that the simulator takes the scene.
inline void run(core::Simulator& simulator, const core::Scene& scene, core::Setup setup, const Grid& grid,
                int per_spacing, Deviations& result, std::vector<std::string>* remarks = nullptr) {
  setup.dt = grid.spacing / per_spacing;
  simulator.load(scene, setup);
  core::State state;
  long done = 0;
  for (const Sample& sample : grid.samples) {
    const long steps = std::lround(sample.time / grid.spacing) * per_spacing;
    for (; done < steps; ++done) simulator.step();
    simulator.read(state);
    compare(sample, state, result);
  }
  if (remarks)
    for (std::string& remark : simulator.remarks()) remarks->push_back(std::move(remark));
}

}  // namespace cylon::accuracy
