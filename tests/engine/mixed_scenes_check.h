// Compares random models that mix features on every path of the engine.
#pragma once

#include "tests/engine/mixed_scenes.h"

#include <ctime>

namespace cylon::engine {

inline constexpr Time span = 0.5;  // [s]

// A scene is refused for one of these, which no path has, and for nothing else.
inline constexpr Features not_modelled = {Feature::unknown_displacement, Feature::contact_in_turning_frame,
                                          Feature::world_joint_in_turning_frame,
                                          Feature::force_in_turning_frame};

struct Ran {
  Path path = Path::bodies;
  std::vector<Motion> motions;
  std::vector<std::string> remarks;
  double seconds = 0;  // of the processor
};

inline Ran run_to_end(const Model& model, const Options& options) {
  const std::clock_t start = std::clock();
  World world(model, options);
  world.advance(static_cast<std::int64_t>(std::lround(span / options.dt)));
  return {world.plan().path, world.motions(), world.remarks(),
          static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC};
}

inline std::string told(const std::string& what, const Ran& ran) {
  std::string text = what + " (path " + std::to_string(static_cast<int>(ran.path)) + ")";
  for (const std::string& remark : ran.remarks) text += "; " + remark;
  return text;
}

struct Truth {
  Ran run;
  Real error = 0;  // apart from a run with twice the step
};

// Whether the run says that it left out events for the rest of a step, or located none there: no bound holds then.
inline bool gave_up(const Ran& run) {
  return std::any_of(run.remarks.begin(), run.remarks.end(), [](const std::string& remark) {
    return remark.find("for the rest of") != std::string::npos ||
           remark.find("without location of events") != std::string::npos;
  });
}

// Whether a run, or a part of the scene for some time of it, went in fixed steps: it says so.
inline bool was_stepped(const Ran& run) {
  return run.path == Path::stepping ||
         std::any_of(run.remarks.begin(), run.remarks.end(), [](const std::string& remark) {
           return remark.find("path stepping") != std::string::npos;
         });
}

// Within the tolerance, or within what a run says of itself, or within the order of its steps: a path of
// first order comes nearer in proportion to its step.
inline void expect_same(const MixedScene& scene, const Truth& truth, Options options, const char* what) {
  const auto distance_of = [&](const Ran& run) {
    return apart(scene.model.bodies, truth.run.motions, run.motions);
  };
  Ran run = run_to_end(scene.model, options);
  Real d = distance_of(run);
  Real allowed = std::max(run.remarks.empty() ? Real(1e-7) : Real(1e-3), 10 * truth.error);
  if (was_stepped(run)) {
    allowed = std::max(40 * static_cast<Real>(options.dt), 10 * truth.error);
    for (int finer = 0; finer < 2 && !(d <= allowed); ++finer) {
      allowed = std::max(d / 4, 10 * truth.error);
      options.dt /= 8;
      run = run_to_end(scene.model, options);
      d = distance_of(run);
    }
  }
  EXPECT_TRUE(d <= allowed) << what << " is " << d << " from rk8, allowed " << allowed << ": " << scene.text
                            << "\n  " << told(what, run) << "\n  " << told("rk8", truth.run);
  EXPECT_LT(run.seconds, 5) << what << ": " << scene.text;
}

/// Scenes by number, from `first` on.
inline void expect_same_on_every_path(std::uint32_t first, std::uint32_t scenes) {
  int refused = 0, unsure = 0, left = 0;
  for (std::uint32_t k = first; k < first + scenes; ++k) {
    const MixedScene scene = mixed_scene(k);
    SCOPED_TRACE(k);
    const Model& model = scene.model;
    Options automatic = with("auto", 0.1);
    if (const std::string reason = unsupported(model, automatic); !reason.empty()) {
      EXPECT_FALSE((required(model) - (required(model) - not_modelled)).empty()) << reason;
      ++refused;
      continue;
    }
    if (make_plan(model, automatic).path == Path::stepping) automatic.dt = 1. / 2048;
    Options fixed = with("rk8", 1. / 128), half = with("rk8", 1. / 256), full = automatic;
    if (can_touch(model)) fixed.path = half.path = "events";
    full.full = true;
    if (make_plan(model, full).path == Path::stepping) full.dt = 1. / 2048;
    Truth truth{run_to_end(model, half)};
    if (gave_up(truth.run)) {
      ++left;
      continue;
    }
    truth.error = apart(model.bodies, truth.run.motions, run_to_end(model, fixed).motions);
    unsure += truth.error > Real(1e-6);
    expect_same(scene, truth, automatic, "auto");
    expect_same(scene, truth, full, "full");
  }
  EXPECT_LE(refused, scenes / 8);
  EXPECT_LE(unsure, scenes / 20) << "the truth is too coarse";
  EXPECT_LE(left, scenes / 100) << "events are left out too often";
  testing::Test::RecordProperty("refused", refused);
  testing::Test::RecordProperty("unsure", unsure);
}

}  // namespace cylon::engine
