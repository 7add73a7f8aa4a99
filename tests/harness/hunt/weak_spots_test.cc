// Families of scenes toward what engines are known to do wrong: each shows it within a few scenes.
#include "harness/hunt/weak_spots.h"

#include "harness/hunt/examine.h"
#include "harness/process/engine_table.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <ostream>
#include <string>

namespace cylon::hunt {
namespace {

struct WeakSpot {
  const char* name;
  void (*make)(Dice&, core::Scene&);
  double step;
  std::int64_t steps;
  const char *engine, *oracle;
  Kind kind;
  std::uint64_t scenes;  // within which it shows
  friend std::ostream& operator<<(std::ostream& out, const WeakSpot& spot) { return out << spot.name; }
};

constexpr WeakSpot spots[] = {
    {"BulletClampsTurns", make_spin, 0.02, 1000, "bullet", "spin", Kind::coarse_step, 30},
    {"BulletBouncesTooLow", make_drop, 0.01, 60, "bullet/path=as-shipped", "rebound", Kind::fine_step, 30},
    {"BulletGivesEnergy", make_blow, 0.01, 60, "bullet/path=as-shipped", "energy", Kind::erratic, 30},
    {"OdeBrakesByAPyramid", make_slide, 0.01, 60, "ode", "slide", Kind::every_step, 30},
    {"OdeDrainsASpin", make_spin, 0.01, 1000, "ode", "energy", Kind::slow, 30},
    {"OdeDropsStacks", make_tower, 0.01, 40, "ode", "rest", Kind::erratic, 30},
    {"OdeLetsHittersThrough", make_cradle, 0.01, 60, "ode", "penetration", Kind::every_step, 30},
};

class WeakSpots : public testing::TestWithParam<WeakSpot> {};

TEST_P(WeakSpots, ShowWithinAFewScenes) {
  const WeakSpot& spot = GetParam();
  const process::EngineChoice engine =
      process::parse_engine(spot.engine, process::default_engines(binary_dir));
  std::string seen;
  for (std::uint64_t n = 0; n < spot.scenes; ++n) {
    Dice dice(1, n);
    Trial trial;
    spot.make(dice, trial.scene);
    trial.step = spot.step, trial.steps = spot.steps;
    for (const Fault& fault : examine(trial, engine, {.run_seconds = 20}).faults) {
      if (fault.oracle == spot.oracle && fault.kind == spot.kind) return;
      seen += std::to_string(n) + " " + fault.oracle + " " + std::string(name(fault.kind)) + '\n';
    }
  }
  ADD_FAILURE() << "not found; found were\n" << seen;
}

INSTANTIATE_TEST_SUITE_P(Known, WeakSpots, testing::ValuesIn(spots),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace cylon::hunt
